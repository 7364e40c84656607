# Drives lanes to and fro, a little less than a tool's width apart. After a while, or where it can't move over, it looks
# for another place.
def run(robot):
    while True:
        side = robot.choice([90, -90])
        for lane in range(12):
            before = robot.distance
            yield robot.forward(10)
            short = lane > 0 and robot.distance - before < 0.2
            yield robot.forward(-0.05)
            yield robot.turn(side)
            moved = yield robot.forward(0.85 * robot.tool_width)
            if short or not moved:
                break
            yield robot.turn(side)
            side = -side
        for bounce in range(4):
            yield robot.forward(-0.05)
            yield robot.turn(robot.randint(90, 270))
            yield robot.forward(10)

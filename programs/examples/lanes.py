# Drives lane after lane, a little less than a tool's width apart. Where it can't move over, it goes on in another direction.
def run(robot):
    side = 90
    short = 0
    while True:
        before = robot.distance
        yield robot.forward(10)
        short = short + 1 if robot.distance - before < 0.3 else 0
        yield robot.forward(-0.05)
        yield robot.turn(side)
        moved = yield robot.forward(0.85 * robot.tool_width)
        if not moved or short > 2:
            # The room ends here, or this corner is done.
            yield robot.forward(-0.05)
            yield robot.turn(robot.randint(30, 150))
            short = 0
        else:
            yield robot.turn(side)
        side = -side

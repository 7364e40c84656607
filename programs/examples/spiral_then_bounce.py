# Drives a growing spiral until it bumps, bounces a few times to get elsewhere, and starts a new spiral.
SPEED = 0.3

def spiral(robot):
    radius = 0.15
    while not (robot.bump or robot.cliff):
        robot.go(SPEED, 57.3 * SPEED / radius)
        # Wider by a tool's width in each round, less some overlap.
        radius = radius + 0.9 * robot.tool_width * SPEED * 0.015 / (6.28 * radius)
        yield

def run(robot):
    while True:
        yield from spiral(robot)
        for bounce in range(4):
            yield robot.forward(-0.06)
            yield robot.turn(100 + 80 * robot.random())
            yield robot.forward(1 + 4 * robot.random())

# Drives to the next obstacle, turns by a random angle, and so on: each line waits until its motion has ended.
def run(robot):
    while True:
        yield robot.forward(10)  # ends early at a bump
        yield robot.forward(-0.05)
        yield robot.turn(robot.choice([1, -1]) * robot.randint(60, 150))

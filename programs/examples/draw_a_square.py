# Drives a square of 60 cm and draws it on the floor.
SIDE = 0.6

def run(robot):
    for corner in range(4):
        x, y = robot.x, robot.y
        robot.text(x, y, corner + 1)
        if not (yield robot.forward(SIDE)):
            print("Something is in the way of side", corner + 1)
        robot.line(x, y, robot.x, robot.y, "blue")
        yield robot.turn(90)
    print("Back after", round(robot.time), "s")

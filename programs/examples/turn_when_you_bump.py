# Drives straight on; at a bump, backs off and turns.
turn_until = 0

def step(robot):
    global turn_until
    if robot.bump or robot.cliff:
        robot.go(-0.15)
        turn_until = robot.time + 0.4 + robot.random()
    elif robot.time < turn_until:
        robot.go(0, 120)
    else:
        robot.go(0.3)

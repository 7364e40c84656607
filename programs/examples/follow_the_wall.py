# Follows the wall on its right by the light bumper: a PD controller steers by how far the signal is off, and by how
# fast that changes. Around a room it turns left; once it has turned right by more than a circle, it has gone round
# something that stands alone, and looks for another wall.
TARGET = 1000  # signal to keep: about 3 cm from a light wall
P, D = 70, 22
state = "search"
last = 0
until = 0
met = 0

def step(robot):
    global state, last, until, met
    light = robot.light
    right, ahead = light[5], max(light[2:5])
    if robot.bump or robot.cliff:
        if state == "search":
            met = robot.turned
        state = "back"
        until = robot.time + 0.25
    if state == "search":
        robot.go(0.25)
        if ahead > 300 or right > 300:
            state = "follow"
            met = robot.turned
    elif state == "back":
        robot.go(-0.12, 60)
        if robot.time > until:
            state = "follow"
    elif state == "leave":
        robot.go(0, 90)
        if robot.time > until:
            state = "search"
    elif met - robot.turned > 400:
        state = "leave"
        until = robot.time + 1
    elif ahead > 500:
        robot.go(0.05, 80)  # an inner corner
    else:
        error = max(-1, min(1, (right - TARGET) / TARGET))
        change = (error - last) / 0.015
        last = error
        robot.go(0.22, max(-75, min(75, P * error + D * 0.05 * change)))

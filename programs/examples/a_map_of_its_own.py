# Keeps a map by odometry, always goes to the nearest place where it hasn't been, and drives home when there is none.
CELL = 0.16
AHEAD = [(1, 0), (0, 1), (-1, 0), (0, -1)]  # right, up, left, down: headings 0, 90, 180 and 270 degrees
known = {}  # "clean", "open" (seen from beside) or "blocked" for each cell

def cell_of(robot):
    return (round(robot.x / CELL), round(robot.y / CELL))

def way(start, wanted):
    """The shortest way over clean cells to one that is wanted, as directions; None if there is none."""
    queue, came = [start], {start: None}
    for cell in queue:
        if known.get(cell) == wanted or (wanted == "home" and cell == home):
            steps = []
            while came[cell] is not None:
                cell, direction = came[cell]
                steps.append(direction)
            return steps[::-1]
        for direction, (x, y) in enumerate(AHEAD):
            beside = (cell[0] + x, cell[1] + y)
            if beside not in came and known.get(beside, "blocked") != "blocked":
                came[beside] = (cell, direction)
                queue.append(beside)
    return None

def visit(robot, cell):
    known[cell] = "clean"
    robot.mark(cell[0] * CELL, cell[1] * CELL, "green")
    for x, y in AHEAD:
        if (cell[0] + x, cell[1] + y) not in known:
            known[(cell[0] + x, cell[1] + y)] = "open"

def go(robot, direction):
    """Drives to the next cell in that direction. Says whether it got there."""
    here = cell_of(robot)
    x, y = here[0] + AHEAD[direction][0], here[1] + AHEAD[direction][1]
    # Its heading and place aren't exact: aim at the cell's middle.
    yield robot.turn((90 * direction - robot.heading + 540) % 360 - 180)
    along = (x * CELL - robot.x) * AHEAD[direction][0] + (y * CELL - robot.y) * AHEAD[direction][1]
    near = max(robot.light[1:5]) > 20  # carefully: at a bump the wheels slip
    if (yield robot.forward(along, 0.12 if near else 0.3)):
        return True
    known[(x, y)] = "blocked"
    robot.mark(x * CELL, y * CELL, "red")
    yield robot.forward(-0.04)
    return False

def run(robot):
    global home
    home = cell_of(robot)
    visit(robot, home)
    steps = way(home, "open")
    while steps is not None:
        for direction in steps:
            if not (yield from go(robot, direction)):
                break
        visit(robot, cell_of(robot))
        steps = way(cell_of(robot), "open")
    print("Everything that I can reach is clean. Going home.")
    for direction in way(cell_of(robot), "home") or []:
        if not (yield from go(robot, direction)):
            break

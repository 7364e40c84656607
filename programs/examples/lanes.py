# Drives lanes up and down, side by side, over floor that is unswept on its own map. If there is none beside it,
# it drives to the nearest over swept floor; if there is none at all, it forgets its map, which has drifted, and starts again.
CELL = 0.16  # from lane to lane, m: a little less than the tool is wide
AHEAD = [(0, 1), (0, -1), (1, 0), (-1, 0)]  # up, down, right, left: lanes first
HEADING = [90, -90, 0, 180]
swept = set()
blocked = set()

def cell_of(robot):
    return (round(robot.x / CELL), round(robot.y / CELL))

def is_new(cell):
    return cell not in swept and cell not in blocked

def way(start):
    """The shortest way over swept cells to a new one: its first direction, and its cells; None if there is none."""
    queue, came = [start], {start: None}
    for cell in queue:
        if is_new(cell) and cell != start:
            cells = []
            while came[cell] is not None:
                cells.append(cell)
                cell, direction = came[cell]
            return direction, cells
        for direction, (x, y) in enumerate(AHEAD):
            beside = (cell[0] + x, cell[1] + y)
            if beside not in came and beside not in blocked:
                came[beside] = (cell, direction)
                queue.append(beside)
    return None

def drive(robot, direction, cells):
    """Straight on over those cells, and in a lane as long as the floor ahead is new."""
    x, y = AHEAD[direction]
    yield robot.turn((HEADING[direction] - robot.heading + 540) % 360 - 180)
    while True:
        here = cell_of(robot)
        swept.add(here)
        ahead = (here[0] + x, here[1] + y)
        if robot.bump or robot.cliff:
            blocked.add(ahead)
            robot.mark(ahead[0] * CELL, ahead[1] * CELL, "red")
            yield robot.forward(-0.04)
            return
        along = (here[0] * CELL - robot.x) * x + (here[1] * CELL - robot.y) * y
        if along <= 0.01 and ahead not in cells and not (direction < 2 and is_new(ahead)):
            robot.stop()
            yield
            return
        # Back to the middle of the lane: by how far it is to the left, and by its heading.
        off = (here[1] * CELL - robot.y) * x - (here[0] * CELL - robot.x) * y
        wrong = (HEADING[direction] - robot.heading + 540) % 360 - 180
        near = max(robot.light[1:5]) > 300  # carefully: at a bump the wheels slip
        robot.go(0.15 if near else 0.3, max(-60, min(60, 300 * off + 2 * wrong)))
        yield

def run(robot):
    while True:
        found = way(cell_of(robot))
        if found is None:
            print("All lanes are swept. Once more.")
            swept.clear()
            blocked.clear()
            robot.clear()
            yield robot.turn(90)
        else:
            yield from drive(robot, found[0], found[1])

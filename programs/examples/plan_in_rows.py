# A planner: row after row, to and fro. At the end of a row it hops to the nearest cell that is left, over floor only.
def hop(room, start, left):
    """The shortest way to a cell that is left, without its start; breadth first."""
    queue, came = [start], {start: None}
    for cell in queue:
        if cell in left:
            path = []
            while came[cell] is not None:
                path.append(cell)
                cell = came[cell]
            return path[::-1]
        x, y = cell
        for beside in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)):
            if beside not in came and room.is_free(*beside):
                came[beside] = cell
                queue.append(beside)
    return []

def plan(room):
    left = set(room.free)
    x, y = room.start
    ahead = 1
    yield x, y
    left.discard((x, y))
    while left:
        if (x + ahead, y) in left:
            path = [(x + ahead, y)]
        elif (x - ahead, y) in left:
            ahead = -ahead
            path = [(x + ahead, y)]
        else:
            path = hop(room, (x, y), left)
            if not path:
                return  # the rest can't be reached
            ahead = -ahead
        for x, y in path:
            yield x, y
            left.discard((x, y))

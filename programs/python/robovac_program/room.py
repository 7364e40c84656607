"""The room as a planner sees it."""


class Room:
    """A grid of cells; x counts to the right and y up, from 0."""

    def __init__(self, rows, cell, start):
        self.rows = rows
        self.height = len(rows)
        self.width = len(rows[0]) if rows else 0
        self.cell = cell
        self.start = (start[0], start[1])
        self.free = [(x, y) for y in range(self.height) for x in range(self.width) if self.is_free(x, y)]

    def is_free(self, x, y):
        """Whether that cell is floor; False outside the grid."""
        return 0 <= x < self.width and 0 <= y < self.height and self.rows[self.height - 1 - y][x] == "."

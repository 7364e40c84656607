//! What the robot knows of the room, and the counts of the smaller-block rule.

use robovac_core::grid::{Cell, Direction, Grid};
use std::ops::Range;

/// Value of an unseen cell.
pub(super) const UNSEEN: i32 = -1;
/// Value of a cell that has been seen but not visited.
pub(super) const SEEN: i32 = 0;
/// Value of a blocked cell; more than any number of visits.
pub(super) const BLOCKED: i32 = i32::MAX;

/// The robot's knowledge of the room, with the counts that the smaller-block rule compares.
#[derive(Debug, Clone)]
pub(super) struct SnakeMemory {
    pub values: Grid<i32>,
    /// Seen cells to be cleaned in every row.
    seen_in_row: Vec<u32>,
    /// Cells to be cleaned in every column, seen or not.
    left_in_column: Vec<u32>,
    /// Cells to be cleaned.
    pub left: usize,
    /// Columns and rows of the room.
    columns: Range<i32>,
    rows: Range<i32>,
}

impl SnakeMemory {
    pub fn new(free: &Grid<bool>) -> Self {
        let mut left_in_column = vec![0; free.width()];
        for row in free.values().chunks(free.width()) {
            row.iter().zip(&mut left_in_column).for_each(|(&is_free, count)| *count += u32::from(is_free));
        }
        Self {
            values: free.map(|&is_free| if is_free { UNSEEN } else { BLOCKED }),
            seen_in_row: vec![0; free.height()],
            left: free.count(),
            left_in_column,
            columns: 0..free.width() as i32,
            rows: 0..free.height() as i32,
        }
    }

    /// Of a room of which nothing is known: all counts as blocked until it is [opened](Self::open).
    pub fn blank(width: usize, height: usize) -> Self {
        let blank = Self::new(&Grid::filled(width, height, false));
        Self { columns: 0..0, rows: 0..0, ..blank }
    }

    /// A blocked cell turns out to be free.
    pub fn open(&mut self, cell: Cell) {
        if self.values.get(cell) != Some(&BLOCKED) {
            return;
        }
        self.values[cell] = UNSEEN;
        self.left += 1;
        self.left_in_column[cell.x as usize] += 1;
        (self.columns, self.rows) = (with(&self.columns, cell.x), with(&self.rows, cell.y));
        let is_beside = |next| (SEEN + 1..BLOCKED).contains(&self.value(next));
        if cell.neighbours().into_iter().any(is_beside) {
            self.see(cell);
        }
    }

    /// A free cell turns out to be blocked.
    pub fn block(&mut self, cell: Cell) {
        let Some(&value) = self.values.get(cell) else { return };
        if value <= SEEN {
            self.left -= 1;
            self.left_in_column[cell.x as usize] -= 1;
            self.seen_in_row[cell.y as usize] -= u32::from(value == SEEN);
        }
        self.values[cell] = BLOCKED;
    }

    /// Whether a cell is in the rows and columns of the room.
    pub fn is_inside(&self, cell: Cell) -> bool {
        self.columns.contains(&cell.x) && self.rows.contains(&cell.y)
    }

    /// The robot comes to `cell` and sees its neighbours.
    pub fn visit(&mut self, cell: Cell) {
        self.raise(cell);
        self.see_around(cell);
    }

    /// Adds one to the value of a free cell.
    pub fn raise(&mut self, cell: Cell) {
        let (column, row) = (cell.x as usize, cell.y as usize);
        let value = self.values[cell];
        if value <= SEEN {
            self.left -= 1;
            self.left_in_column[column] -= 1;
            self.seen_in_row[row] -= u32::from(value == SEEN);
        }
        self.values[cell] = value.max(SEEN) + 1;
    }

    /// Unseen cells beside `cell` are seen.
    pub fn see_around(&mut self, cell: Cell) {
        cell.neighbours().into_iter().for_each(|next| self.see(next));
    }

    /// An unseen cell is seen.
    pub fn see(&mut self, cell: Cell) {
        if self.value(cell) == UNSEEN {
            self.values[cell] = SEEN;
            self.seen_in_row[cell.y as usize] += 1;
        }
    }

    /// Whether a cell is still to be cleaned.
    pub fn is_left(&self, cell: Cell) -> bool {
        self.value(cell) <= SEEN
    }

    /// Value of a cell; outside all is blocked.
    pub fn value(&self, cell: Cell) -> i32 {
        self.values.get(cell).copied().unwrap_or(BLOCKED)
    }

    /// The cells to be cleaned on both sides, as `countNumberOfZeros` counts them: above and below, or left and right.
    pub fn blocks(&self, at: Cell, facing: Direction) -> [(Direction, u32); 2] {
        let split = |counts: &[u32], line: i32| {
            let (before, after) = counts.split_at(line as usize);
            (before.iter().sum::<u32>(), after[1..].iter().sum::<u32>())
        };
        if facing.is_horizontal() {
            let (below, above) = split(&self.seen_in_row, at.y);
            [(Direction::Up, above), (Direction::Down, below)]
        } else {
            let (left, right) = split(&self.left_in_column, at.x);
            [(Direction::Left, left), (Direction::Right, right)]
        }
    }

    /// The side with fewer cells to be cleaned, by `bothNeighbourHasSameValueWhereShouldIGo`.
    pub fn smaller_block(&self, at: Cell, facing: Direction) -> Direction {
        let [(first, a), (second, b)] = self.blocks(at, facing);
        let (line, lines) = if facing.is_horizontal() {
            (self.rows.end - 1 - at.y, self.rows.len() as i32)
        } else {
            (at.x - self.columns.start, self.columns.len() as i32)
        };
        let is_first = match (a, b) {
            // Facing along x a side without any such cell loses.
            (0, 1..) | (1.., 0) if facing.is_horizontal() => b == 0,
            _ if a == b => is_nearer_to_first_edge(line, lines),
            _ => a < b,
        };
        if is_first { first } else { second }
    }

    /// The values around the robot that aren't blocked.
    pub fn marks(&self, at: Cell) -> Vec<(Cell, u32)> {
        let open = at.neighbours().map(|cell| (cell, self.value(cell)));
        open.into_iter()
            .filter(|&(_, value)| value != BLOCKED)
            .map(|(cell, value)| (cell, value.max(SEEN) as u32))
            .collect()
    }
}

/// The program's test for the top and the left edge: whether line `line` of `lines` is nearer to the first.
fn is_nearer_to_first_edge(line: i32, lines: i32) -> bool {
    line < lines - line
}

/// The range that holds `line`, too.
fn with(range: &Range<i32>, line: i32) -> Range<i32> {
    if range.is_empty() { line..line + 1 } else { range.start.min(line)..range.end.max(line + 1) }
}

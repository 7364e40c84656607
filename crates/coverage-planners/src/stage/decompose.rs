//! Stage: boustrophedon cellular decomposition (Choset & Pignon 1998), here along the rows of a grid.
//!
//! A line sweeps over the room from below. Where it splits into more pieces, or pieces join, begin or end, its
//! connectivity changes; between two such critical points every piece sweeps out a *cell*. Cells of the decomposition
//! are called blocks here, as a cell is a square of the grid everywhere else.

use robovac_core::grid::{Cell, Grid};

/// Free cells of one row between two that aren't.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CellRun {
    /// The row.
    pub y: i32,
    /// First column.
    pub left: i32,
    /// Last column.
    pub right: i32,
}

impl CellRun {
    /// Whether a step up or down leads from one to the other, given that they lie in neighbouring rows.
    fn touches(self, other: Self) -> bool {
        self.left <= other.right && other.left <= self.right
    }

    /// The cell at one end.
    pub fn end(self, side: RunSide) -> Cell {
        Cell::new(if side == RunSide::Left { self.left } else { self.right }, self.y)
    }
}

/// One end of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunSide {
    /// Where x is least.
    Left,
    /// Where x is greatest.
    Right,
}

impl RunSide {
    /// Both.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// The other one.
    pub fn other(self) -> Self {
        if self == Self::Left { Self::Right } else { Self::Left }
    }
}

/// Runs in consecutive rows from the lowest up, each of which touches only the next; at least one.
pub type Block = Vec<CellRun>;

/// Cuts the free cells into blocks: at critical points, and where an end of the run jumps by more than `max_jump`
/// columns, as sweeping across a jump drives over cells twice.
///
/// ```
/// use robovac_core::grid::from_picture;
/// use coverage_planners::stage::decompose;
/// let free = from_picture(
///     "
///     ......
///     ..##..
///     ......", |c| c == '.').unwrap();
/// assert_eq!(decompose(&free, i32::MAX).len(), 4);
/// ```
pub fn decompose(free: &Grid<bool>, max_jump: i32) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    // Runs of the row below, with the block that each is in.
    let mut below: Vec<(CellRun, usize)> = Vec::new();
    for (y, row) in free.values().chunks(free.width()).enumerate() {
        let runs = runs_of(row, y as i32);
        let mut current = Vec::with_capacity(runs.len());
        let mut first_below = 0;
        for (i, &run) in runs.iter().enumerate() {
            first_below += below[first_below..].iter().take_while(|(b, _)| b.right < run.left).count();
            let mut touched = below[first_below..].iter().take_while(|(b, _)| b.left <= run.right);
            let only = touched.next().filter(|_| touched.next().is_none());
            let continues = only.filter(|(b, _)| {
                let is_shared = i.checked_sub(1).is_some_and(|before| runs[before].touches(*b))
                    || runs.get(i + 1).is_some_and(|after| after.touches(*b));
                let jump = (b.left - run.left).abs().max((b.right - run.right).abs());
                !is_shared && jump <= max_jump
            });
            let block = if let Some(&(_, block)) = continues {
                blocks[block].push(run);
                block
            } else {
                blocks.push(vec![run]);
                blocks.len() - 1
            };
            current.push((run, block));
        }
        below = current;
    }
    blocks
}

/// The runs of one row, from the left.
fn runs_of(row: &[bool], y: i32) -> Vec<CellRun> {
    let mut runs = Vec::new();
    let mut x = 0;
    while let Some(skipped) = row[x..].iter().position(|&free| free) {
        let left = x + skipped;
        let length = row[left..].iter().position(|&free| !free).unwrap_or(row.len() - left);
        x = left + length;
        runs.push(CellRun { y, left: left as i32, right: x as i32 - 1 });
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::{from_picture, picture};

    fn letters(text: &str, max_jump: i32) -> String {
        let free = from_picture(text, |c| c == '.').unwrap();
        let mut glyphs = free.map(|_| '#');
        for (letter, block) in ('a'..).zip(decompose(&free, max_jump)) {
            for run in block {
                (run.left..=run.right).for_each(|x| glyphs[Cell::new(x, run.y)] = letter);
            }
        }
        picture(&glyphs, |&c| c)
    }

    #[test]
    fn island_splits_and_joins_the_line() {
        assert_eq!(letters("....\n.##.\n....", 9), "dddd\nb##c\naaaa\n");
    }

    #[test]
    fn block_follows_a_slanted_wall_but_not_a_jump() {
        assert_eq!(letters("#...\n....\n.###", 1), "#bbb\nbbbb\na###\n");
        assert_eq!(letters("#...\n....\n.###", 3), "#aaa\naaaa\na###\n");
    }

    #[test]
    fn bay_beside_a_branch_starts_a_block() {
        assert_eq!(letters(".#.\n...\n.#.", 9), "d#e\nccc\na#b\n");
    }
}

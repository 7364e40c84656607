//! Marks: dark pixels that are connected, in any of 8 directions; and areas, connected by steps.

use robovac_core::grid::{Cell, Grid};

/// A mark, with the corners of its bounding box.
#[derive(Debug, Clone)]
pub(super) struct PixelMark {
    pub cells: Vec<Cell>,
    pub low: Cell,
    pub high: Cell,
}

impl PixelMark {
    /// Width and height, pixels.
    pub fn size(&self) -> [i32; 2] {
        [self.high.x - self.low.x + 1, self.high.y - self.low.y + 1]
    }
}

/// The marks that `is_meant`, row by row of their lowest pixels.
pub(super) fn marks(walls: &Grid<bool>, is_meant: impl Fn(&PixelMark) -> bool) -> Vec<PixelMark> {
    let mut seen = walls.map(|_| false);
    let mut found = Vec::new();
    for index in 0..walls.len() {
        let start = walls.cell(index);
        if !walls[start] || seen[start] {
            continue;
        }
        seen[start] = true;
        let mut mark = PixelMark { cells: vec![start], low: start, high: start };
        let mut next = 0;
        while let Some(&cell) = mark.cells.get(next) {
            next += 1;
            mark.low = Cell::new(mark.low.x.min(cell.x), mark.low.y.min(cell.y));
            mark.high = Cell::new(mark.high.x.max(cell.x), mark.high.y.max(cell.y));
            for beside in cell.block() {
                if walls.is_set(beside) && !seen[beside] {
                    seen[beside] = true;
                    mark.cells.push(beside);
                }
            }
        }
        if is_meant(&mark) {
            found.push(mark);
        }
    }
    found
}

/// All that steps connect to a cell without one that was seen; it is seen then.
pub(super) fn area(start: Cell, seen: &mut Grid<bool>) -> Vec<Cell> {
    seen[start] = true;
    let mut cells = vec![start];
    let mut next = 0;
    while let Some(&cell) = cells.get(next) {
        next += 1;
        for beside in cell.neighbours() {
            if seen.get(beside) == Some(&false) {
                seen[beside] = true;
                cells.push(beside);
            }
        }
    }
    cells
}

/// Removes marks.
pub(super) fn erase<'a>(walls: &mut Grid<bool>, marks: impl IntoIterator<Item = &'a PixelMark>) {
    for cell in marks.into_iter().flat_map(|mark| &mark.cells) {
        walls[*cell] = false;
    }
}

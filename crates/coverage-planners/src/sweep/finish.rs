//! Sweeps the floor that the links leave out.
//!
//! Scan lines lie where their distance puts them. Under the edge of a desk that lies between two lines, up to a line's
//! distance is left unswept, which the paper doesn't address. So after all links the robot drives along such edges,
//! from each to the nearest worthwhile one. This stage is ours, and comes after the paper's three.

use super::{
    SweepError,
    cover::Cover,
    linker::{WayLinker, WayStop},
};
use robovac_core::{
    geometry::Point,
    grid::{Cell, Direction, Grid},
};

/// Least length of an edge that is driven along, cells.
const LEAST_CELLS: usize = 2;
/// Most edges that are considered, longest first: a map full of specks could have millions.
const MAX_EDGES: usize = 10_000;
/// Strokes between two reports.
const REPORT_EVERY: usize = 64;

/// Ways to and along edges that add something, in the order in which they are driven from `at`. `report` receives the
/// share done, 0 to 1.
pub(super) fn finish(
    linker: &mut WayLinker<'_>,
    cover: &mut Cover,
    rows: &[i32],
    mut at: WayStop,
    report: &mut dyn FnMut(f64) -> Result<(), SweepError>,
) -> Result<Vec<Vec<Point>>, SweepError> {
    let mut edges = edges(linker.free, rows, |cell| linker.steps.is_open(cell, Direction::Right));
    let size = linker.cell;
    // Most edges lie along a scan line's floor.
    edges.retain(|edge| cover.gain(edge.0.centre(size), edge.1.centre(size)) >= cover.least_gain);
    // The order of equally long ones stays.
    edges.sort_by_key(|(first, last)| first.x - last.x);
    edges.truncate(MAX_EDGES);
    let all = edges.len().max(1);
    let mut ways = Vec::new();
    while let Some((index, is_turned)) = nearest(&edges, at.0) {
        if edges.len().is_multiple_of(REPORT_EVERY) {
            report(1.0 - edges.len() as f64 / all as f64)?;
        }
        let (first, last) = edges.swap_remove(index);
        let (from, to) = if is_turned { (last, first) } else { (first, last) };
        let ends = [from, to].map(|cell| (cell, cell.centre(size)));
        if cover.gain(ends[0].1, ends[1].1) < cover.least_gain {
            continue;
        }
        let mut way = linker.way(at, ends[0]).0;
        if way.is_empty() {
            continue;
        }
        way.push(ends[1].1);
        cover.sweep(&way);
        ways.push(way);
        at = ends[1];
    }
    Ok(ways)
}

/// The edge that begins or ends nearest to a cell, and whether it ends there.
fn nearest(edges: &[(Cell, Cell)], at: Cell) -> Option<(usize, bool)> {
    let off = |cell: Cell| (i64::from(cell.x) - i64::from(at.x)).pow(2) + (i64::from(cell.y) - i64::from(at.y)).pow(2);
    let ends = edges.iter().enumerate().map(|(index, &(first, last))| {
        let (to_first, to_last) = (off(first), off(last));
        (to_first.min(to_last), index, to_last < to_first)
    });
    ends.min().map(|(_, index, is_turned)| (index, is_turned))
}

/// First and last cell of every stretch of cells off the scan lines that can't be swept farther up or down.
fn edges(free: &Grid<bool>, rows: &[i32], is_joined: impl Fn(Cell) -> bool) -> Vec<(Cell, Cell)> {
    let mut found = Vec::new();
    let mut lines = rows.iter().rev().peekable();
    for y in 0..free.height() as i32 {
        while lines.next_if(|&&row| row < y).is_some() {}
        if lines.peek() == Some(&&y) {
            continue;
        }
        for side in [-1, 1] {
            let is_edge = |x: usize| {
                let cell = Cell::new(x as i32, y);
                free[cell] && !free.is_set(Cell::new(cell.x, y + side))
            };
            let mut x = 0;
            while x < free.width() {
                let first = x;
                while x < free.width() && is_edge(x) && (x == first || is_joined(Cell::new(x as i32 - 1, y))) {
                    x += 1;
                }
                if x >= first + LEAST_CELLS {
                    found.push((Cell::new(first as i32, y), Cell::new(x as i32 - 1, y)));
                }
                x = x.max(first + 1);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    #[test]
    fn edges_off_the_lines_are_found() {
        let free = from_picture("......\n......\n..###.\n......\n......", |c| c == '.').unwrap();
        let cells = |y, first, last| (Cell::new(first, y), Cell::new(last, y));
        assert_eq!(edges(&free, &[4, 2, 0], |_| true), [cells(1, 2, 4), cells(3, 2, 4)]);
        assert_eq!(edges(&free, &[4, 3, 2, 1, 0], |_| true), []);
        assert_eq!(edges(&free, &[3], |_| true).len(), 3);
        // Something narrower than a cell ends a stretch.
        assert_eq!(edges(&free, &[4, 2, 0], |cell| cell.x != 2), [cells(1, 3, 4), cells(3, 3, 4)]);
    }
}

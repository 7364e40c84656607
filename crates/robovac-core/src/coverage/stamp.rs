//! What a tool sweeps, as runs of cells.

use crate::{
    geometry::{Point, convex_pieces, edges},
    grid::Grid,
    math,
};
use std::ops::Range;

/// Half a thousandth of a cell more, for shapes whose edge passes through a centre but for rounding.
const HAIR: f64 = 5e-4;

/// A disc to be stamped onto a grid of `width` x `height` cells.
#[derive(Debug, Clone, Copy)]
pub(super) struct DiscStamp {
    /// Radius in cells.
    pub radius: f64,
    /// Columns of the grid.
    pub width: usize,
    /// Rows of the grid.
    pub height: usize,
}

impl DiscStamp {
    /// Calls `visit` with the range of indices of every row in which cells have their centre in the disc around
    /// (`x`, `y`), both in cells.
    #[inline]
    pub fn rows(&self, x: f64, y: f64, mut visit: impl FnMut(Range<usize>)) {
        let radius = self.radius + HAIR;
        let first = math::ceil(y - 0.5 - radius).max(0);
        let last = math::floor(y - 0.5 + radius).min(self.height as i32 - 1);
        for row in first..=last {
            let dy = f64::from(row) + 0.5 - y;
            let half = (radius * radius - dy * dy).max(0.0).sqrt();
            let left = math::ceil(x - 0.5 - half).max(0);
            let right = math::floor(x - 0.5 + half).min(self.width as i32 - 1);
            if left <= right {
                let start = row as usize * self.width + left as usize;
                visit(start..start + (right - left + 1) as usize);
            }
        }
    }
}

impl DiscStamp {
    /// Calls `visit` with the range of indices of every run of cells under `body`, as [`PolygonStamp::runs`].
    pub fn body_rows(
        &self,
        body: &PolygonStamp,
        at: (f64, f64),
        turn: (f64, f64),
        mut visit: impl FnMut(Range<usize>),
    ) {
        body.runs(at, turn, |(row, first, last)| {
            let (left, right) = (first.max(0), last.min(self.width as i32 - 1));
            if (0..self.height as i32).contains(&row) && left <= right {
                let start = row as usize * self.width + left as usize;
                visit(start..start + (right - left + 1) as usize);
            }
        });
    }
}

/// A polygon as runs of cells.
#[derive(Debug, Clone)]
pub(super) struct PolygonStamp {
    /// Convex pieces in the robot's frame, in cells.
    pieces: Vec<Vec<Point>>,
}

/// A run of cells: its row, its first and its last column, relative to another cell.
pub(super) type StampRun = (i32, i32, i32);

impl PolygonStamp {
    /// The polygon with these corners, m, on cells of `resolution` metres.
    pub fn new(corners: &[[f64; 2]], resolution: f64) -> Self {
        let corners: Vec<Point> = corners.iter().map(|&[x, y]| Point::new(x, y) / resolution).collect();
        Self { pieces: convex_pieces(&corners) }
    }

    /// Calls `visit` with every run of cells that have their centre in the polygon when its origin is at (`x`, `y`),
    /// in cells, at a heading with that sine and cosine. Runs of different pieces can share cells.
    pub fn runs(&self, (x, y): (f64, f64), (sin, cos): (f64, f64), mut visit: impl FnMut(StampRun)) {
        for piece in &self.pieces {
            let corners = piece.iter().map(|p| Point::new(x + cos * p.x - sin * p.y, y + sin * p.x + cos * p.y));
            let corners: Vec<Point> = corners.collect();
            let (low, high) = corners.iter().fold((f64::MAX, f64::MIN), |(low, high), p| (low.min(p.y), high.max(p.y)));
            for row in math::ceil(low - 0.5)..=math::floor(high - 0.5) {
                let centre = f64::from(row) + 0.5;
                let crossed = edges(&corners).filter(|(a, b)| (a.y <= centre) != (b.y <= centre));
                let at = crossed.map(|(a, b)| a.x + (centre - a.y) / (b.y - a.y) * (b.x - a.x));
                let (left, right) = at.fold((f64::MAX, f64::MIN), |(left, right), x| (left.min(x), right.max(x)));
                let (first, last) = (math::ceil(left - 0.5 - HAIR), math::floor(right - 0.5 + HAIR));
                if first <= last {
                    visit((row, first, last));
                }
            }
        }
    }

    /// The runs around a cell in whose centre the origin is, at that heading, rad.
    pub fn around(&self, heading: f64) -> Vec<StampRun> {
        let mut runs = Vec::new();
        self.runs((0.5, 0.5), math::sin_cos(heading), |run| runs.push(run));
        runs
    }
}

/// Cells around which all of `runs` lie in `free`: where a body fits.
pub(super) fn fitting(free: &Grid<bool>, runs: &[StampRun]) -> Grid<bool> {
    // The body overlaps a cell that isn't free from wherever its mirror image there reaches.
    let (width, height) = (free.width() as i32, free.height() as i32);
    let mut fits = free.clone();
    let mut close = |y: i32, first: i32, last: i32| {
        if (0..height).contains(&y) && first.max(0) <= last.min(width - 1) {
            let row = y as usize * free.width();
            fits.values_mut()[row + first.max(0) as usize..=row + last.min(width - 1) as usize].fill(false);
        }
    };
    for &(dy, first, last) in runs {
        for y in 0..height {
            if !(0..height).contains(&(y + dy)) {
                close(y, 0, width);
            }
            close(y, 0, -first - 1);
            close(y, width - last, width);
            lengths(free, y, false, |from, to| close(y - dy, from - last, to - first));
        }
    }
    fits
}

/// All cells in `runs` around any cell of `places`.
pub(super) fn spread(places: &Grid<bool>, runs: &[StampRun]) -> Grid<bool> {
    let (width, height) = (places.width() as i32, places.height() as i32);
    let mut swept = Grid::filled(places.width(), places.height(), false);
    for &(dy, first, last) in runs {
        for y in (0..height).filter(|y| (0..height).contains(&(y + dy))) {
            let row = (y + dy) as usize * places.width();
            lengths(places, y, true, |from, to| {
                let (from, to) = ((from + first).max(0), (to + last).min(width - 1));
                if from <= to {
                    swept.values_mut()[row + from as usize..=row + to as usize].fill(true);
                }
            });
        }
    }
    swept
}

/// Calls `visit` with first and last column of every stretch of cells in row `y` that are `value`.
fn lengths(grid: &Grid<bool>, y: i32, value: bool, mut visit: impl FnMut(i32, i32)) {
    let row = &grid.values()[y as usize * grid.width()..][..grid.width()];
    let mut x = 0;
    while let Some(skipped) = row[x..].iter().position(|&cell| cell == value) {
        let first = x + skipped;
        x = row[first..].iter().position(|&cell| cell != value).map_or(row.len(), |length| first + length);
        visit(first as i32, x as i32 - 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{from_picture, picture};

    /// An L of three cells, with the origin in the middle of its corner.
    const ELL: [[f64; 2]; 6] = [[-0.5, -0.5], [1.5, -0.5], [1.5, 0.5], [0.5, 0.5], [0.5, 1.5], [-0.5, 1.5]];

    #[test]
    fn a_body_fits_where_all_of_it_is_free() {
        let free = from_picture("....\n..#.\n....", |c| c == '.').unwrap();
        let runs = PolygonStamp::new(&ELL, 1.0).around(0.0);
        let fits = fitting(&free, &runs);
        assert_eq!(picture(&fits, |&f| if f { 'o' } else { '-' }), "----\no---\noo--\n");
        let swept = spread(&fits, &runs);
        assert_eq!(picture(&swept, |&f| if f { 'o' } else { '-' }), "o---\noo--\nooo-\n");
    }

    #[test]
    fn a_turned_body_covers_turned_cells() {
        let mut runs = PolygonStamp::new(&ELL, 1.0).around(math::FRAC_PI_2);
        runs.sort_unstable();
        runs.dedup();
        let cells: Vec<(i32, i32)> = runs.iter().flat_map(|&(y, a, b)| (a..=b).map(move |x| (x, y))).collect();
        let mut cells = cells;
        cells.sort_unstable();
        cells.dedup();
        assert_eq!(cells, [(-1, 0), (0, 0), (0, 1)]);
    }
}

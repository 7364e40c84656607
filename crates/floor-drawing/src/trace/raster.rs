//! Rasterises strokes and outlines.

use crate::{DrawingFlaw, FillRule};
use robovac_core::{
    geometry::Point,
    grid::Grid,
    math::{ceil, floor},
};
use std::ops::Range;

/// Most cells that all strokes together can cross or cover, with repetitions (ours): about a second's work.
const MAX_WORK: usize = 500_000_000;

/// A grid to draw on, in cells from its lower-left corner. Everything outside is clipped.
pub(super) struct RasterCanvas {
    pub cells: Grid<bool>,
    work: usize,
}

impl RasterCanvas {
    pub fn new(size: [i32; 2]) -> Self {
        Self { cells: Grid::filled(size[0].max(1) as usize, size[1].max(1) as usize, false), work: 0 }
    }

    /// Sets every cell that the segment crosses.
    pub fn segment(&mut self, a: Point, b: Point) -> Result<(), DrawingFlaw> {
        let [a, b] = [a, b].map(snapped);
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        let rows = clip(low.y, high.y, self.cells.height());
        let slope = if high.y > low.y { (high.x - low.x) / (high.y - low.y) } else { 0.0 };
        let at = |y: f64| low.x + (y - low.y) * slope;
        for row in rows {
            let ends = if high.y > low.y {
                [at(low.y.max(row as f64)), at(high.y.min((row + 1) as f64))]
            } else {
                [low.x, high.x]
            };
            let columns = clip(ends[0].min(ends[1]), ends[0].max(ends[1]), self.cells.width());
            self.set(row, columns)?;
        }
        Ok(())
    }

    /// Sets the cells that the outline covers: those whose centres it encloses and those that it crosses.
    pub fn fill(&mut self, outline: &[Point]) -> Result<(), DrawingFlaw> {
        for (a, b) in edges(outline) {
            self.segment(a, b)?;
        }
        self.paint(&[outline], FillRule::EvenOdd, true)
    }

    /// Gives the cells whose centres lie within several outlines a value.
    pub fn paint(&mut self, outlines: &[impl AsRef<[Point]>], rule: FillRule, value: bool) -> Result<(), DrawingFlaw> {
        let (width, height) = (self.cells.width(), self.cells.height());
        // Row, place in it, and whether the line goes up there.
        let mut crossings: Vec<(usize, f64, i32)> = Vec::new();
        for outline in outlines {
            let edges = edges(outline.as_ref()).map(|(a, b)| (snapped(a), snapped(b)));
            for (a, b) in edges.filter(|(a, b)| a.y != b.y) {
                let (low, high, way) = if a.y < b.y { (a, b, 1) } else { (b, a, -1) };
                let slope = (high.x - low.x) / (high.y - low.y);
                let rows = rows_between(low.y, high.y, height);
                crossings.extend(rows.map(|row| (row, low.x + (row as f64 + 0.5 - low.y) * slope, way)));
                if crossings.len() > MAX_WORK / 32 {
                    return Err(too_much());
                }
            }
        }
        crossings.sort_by(|one, other| one.0.cmp(&other.0).then(one.1.total_cmp(&other.1)));
        let mut winding = 0;
        for pair in crossings.windows(2) {
            winding += pair[0].2;
            let is_inside = match rule {
                FillRule::EvenOdd => winding % 2 != 0,
                FillRule::NonZero => winding != 0,
            };
            if is_inside && pair[0].0 == pair[1].0 {
                let columns = columns_between(pair[0].1, pair[1].1, width);
                self.give(pair[0].0, columns, value)?;
            }
        }
        Ok(())
    }

    fn set(&mut self, row: usize, columns: Range<usize>) -> Result<(), DrawingFlaw> {
        self.give(row, columns, true)
    }

    fn give(&mut self, row: usize, columns: Range<usize>, value: bool) -> Result<(), DrawingFlaw> {
        self.work += columns.len() + 1;
        if self.work > MAX_WORK {
            return Err(too_much());
        }
        let start = row * self.cells.width();
        self.cells.values_mut()[start + columns.start..start + columns.end].fill(value);
        Ok(())
    }
}

/// A point rounded to 1/65,536 of a cell: a wall on a line between cells belongs to the same cells, whatever the drawing's unit adds.
fn snapped(point: Point) -> Point {
    const STEPS: f64 = 65_536.0;
    point.map(|cells| (cells * STEPS).round() / STEPS)
}

/// The edges of a closed outline.
fn edges(outline: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    outline.iter().copied().zip(outline.iter().copied().cycle().skip(1))
}

/// The rows of `count` whose middles lie in [low, high).
fn rows_between(low: f64, high: f64, count: usize) -> Range<usize> {
    let at = |y: f64| ceil(y - 0.5).clamp(0, count as i32) as usize;
    at(low)..at(high)
}

/// The same of columns; none if `high` is below `low`.
fn columns_between(low: f64, high: f64, count: usize) -> Range<usize> {
    let Range { start, end } = rows_between(low, high, count);
    start..end.max(start)
}

fn too_much() -> DrawingFlaw {
    DrawingFlaw::TooMany { what: "cells crossed by strokes", most: MAX_WORK }
}

/// The cells of a row or column of `count` that contain the coordinates from `low` to `high`.
fn clip(low: f64, high: f64, count: usize) -> Range<usize> {
    let count = count as i32;
    let (first, last) = (floor(low).max(0), floor(high).min(count - 1));
    if first > last { 0..0 } else { first as usize..last as usize + 1 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::picture;

    fn drawn(size: [i32; 2], draw: impl Fn(&mut RasterCanvas)) -> String {
        let mut canvas = RasterCanvas::new(size);
        draw(&mut canvas);
        picture(&canvas.cells, |&is_set| if is_set { '#' } else { '.' })
    }

    #[test]
    fn a_line_sets_all_cells_that_it_crosses() {
        let line = drawn([6, 4], |canvas| canvas.segment(Point::new(0.5, 0.5), Point::new(5.5, 2.9)).unwrap());
        assert_eq!(line.trim(), "......\n...###\n.###..\n##....".trim());
        let far = drawn([3, 2], |canvas| canvas.segment(Point::new(-1e9, 0.5), Point::new(1e9, 0.5)).unwrap());
        assert_eq!(far.trim(), "...\n###");
        let outside = drawn([3, 2], |canvas| canvas.segment(Point::new(-5.0, 9.0), Point::new(-1.0, -3.0)).unwrap());
        assert!(!outside.contains('#'));
    }

    #[test]
    fn outlines_together_are_filled_by_their_rule() {
        let square = |a: f64, b: f64| [(a, a), (b, a), (b, b), (a, b)].map(|(x, y)| Point::new(x, y)).to_vec();
        let hole: Vec<Point> = square(2.0, 4.0).into_iter().rev().collect();
        let ring = "......\n.####.\n.#..#.\n.#..#.\n.####.\n......";
        let paint = |inner: Vec<Point>, rule| {
            drawn([6, 6], |canvas| canvas.paint(&[square(1.0, 5.0), inner.clone()], rule, true).unwrap())
        };
        assert_eq!(paint(hole.clone(), FillRule::EvenOdd).trim(), ring);
        assert_eq!(paint(hole, FillRule::NonZero).trim(), ring);
        assert_eq!(paint(square(2.0, 4.0), FillRule::EvenOdd).trim(), ring);
        assert_eq!(paint(square(2.0, 4.0), FillRule::NonZero).matches('#').count(), 16);
        let cleared = drawn([6, 6], |canvas| {
            canvas.paint(&[square(1.0, 5.0)], FillRule::NonZero, true).unwrap();
            canvas.paint(&[square(2.0, 4.0)], FillRule::NonZero, false).unwrap();
        });
        assert_eq!(cleared.trim(), ring);
    }

    #[test]
    fn an_outline_is_filled_up_to_its_border() {
        let corners = [(1.2, 1.2), (4.8, 1.2), (4.8, 4.8), (3.0, 2.6), (1.2, 4.8)].map(|(x, y)| Point::new(x, y));
        let filled = drawn([6, 6], |canvas| canvas.fill(&corners).unwrap());
        assert_eq!(filled.trim(), "......\n.#..#.\n.####.\n.####.\n.####.\n......");
    }
}

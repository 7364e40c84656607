//! The floor that a body sweeps while it moves straight.

use super::{
    HAIR, Outline,
    canvas::BitCanvas,
    sum::{ConvexPiece, Sum},
};
use crate::{
    geometry::Point,
    grid::{Cell, Grid},
};

/// Floor swept by an outline, at first at heading 0: a cell is swept once its centre has been under the body.
#[derive(Debug, Clone)]
pub struct Swath {
    canvas: BitCanvas,
    /// The outline's pieces mirrored: a moving body covers the points that its mirror image would touch.
    mirrored: Vec<ConvexPiece>,
    radius: f64,
}

impl Swath {
    /// Nothing swept, on `width` x `height` cells of `cell` metres.
    pub fn new(outline: &Outline, width: usize, height: usize, cell: f64) -> Self {
        let radius = if let Outline::Circle { radius } = outline { *radius } else { 0.0 };
        Self { canvas: BitCanvas::new(width, height, cell), mirrored: mirrored(outline, 0.0), radius }
    }

    /// Turns the body: from now on it sweeps at this heading, rad.
    pub fn face(&mut self, outline: &Outline, heading: f64) {
        self.mirrored = mirrored(outline, heading);
    }

    /// Sweeps with the body's origin straight from `from` to `to`.
    pub fn sweep(&mut self, from: Point, to: Point) {
        let line = [from, to];
        if self.mirrored.is_empty() {
            self.canvas.draw(&Sum::of_round(&line, self.radius, -HAIR));
        }
        for piece in &self.mirrored {
            self.canvas.draw(&Sum::of_polygons(&line, piece, -HAIR));
        }
    }

    /// Sweeps from all cells that are set, the body's origin in their centres and on the way between neighbours in a
    /// row, if `is_joined` says of the left one that the way is free.
    pub fn sweep_cells(&mut self, cells: &Grid<bool>, is_joined: impl Fn(Cell) -> bool) {
        let size = self.canvas.cell;
        for (y, row) in cells.values().chunks(cells.width()).enumerate() {
            let mut x = 0;
            while let Some(skipped) = row[x..].iter().position(|&is_set| is_set) {
                let at = |x: usize| Cell::new(x as i32, y as i32);
                let (first, mut last) = (x + skipped, x + skipped);
                while last + 1 < row.len() && row[last + 1] && is_joined(at(last)) {
                    last += 1;
                }
                self.sweep(at(first).centre(size), at(last).centre(size));
                x = last + 1;
            }
        }
    }

    /// Number of cells of `floor` that a straight move from `from` to `to` would sweep for the first time.
    pub fn gain(&self, floor: &Self, from: Point, to: Point) -> usize {
        let (canvas, line) = (&self.canvas, [from, to]);
        let count = |sum: &Sum| -> usize {
            let rows = canvas.rows(sum.rows()).map(|row| {
                let (low, high) = sum.across(canvas.centre(row));
                let (first, last) = canvas.between(low, high);
                let (first, last) = (first.max(0), last.min(canvas.width as i32 - 1));
                if first > last {
                    return 0;
                }
                floor.canvas.bits.count_without(&canvas.bits, row as usize, first as usize, last as usize)
            });
            rows.sum()
        };
        if self.mirrored.is_empty() {
            return count(&Sum::of_round(&line, self.radius, -HAIR));
        }
        self.mirrored.iter().map(|piece| count(&Sum::of_polygons(&line, piece, -HAIR))).sum()
    }

    /// Adds the floor swept by another body of the same room.
    pub fn add(&mut self, other: &Self) {
        self.canvas.bits.add(&other.canvas.bits);
    }

    /// Number of cells swept.
    pub fn count(&self) -> usize {
        self.canvas.bits.count()
    }
}

fn mirrored(outline: &Outline, heading: f64) -> Vec<ConvexPiece> {
    let mirror = |piece: Vec<Point>| ConvexPiece::new(piece.into_iter().map(|p| -p).collect());
    outline.pieces(heading).into_iter().map(mirror).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn swath_is_the_outline_drawn_out() {
        for outline in [Outline::octagon(0.36).unwrap(), Outline::circle(0.18).unwrap()] {
            let mut swath = Swath::new(&outline, 200, 150, 0.01);
            swath.sweep(Point::new(0.5, 0.5), Point::new(1.5, 0.9));
            let length = 1.16_f64.sqrt();
            let mut still = Swath::new(&outline, 200, 150, 0.01);
            still.sweep(Point::new(0.5, 0.5), Point::new(0.5, 0.5));
            // Perpendicular to its motion an octagon is at least as wide as from side to side, and at most as from
            // corner to corner.
            let area = swath.count() as f64 * 1e-4;
            let least = still.count() as f64 * 1e-4 + 0.36 * length;
            assert!(area > 0.99 * least && area < 1.09 * least, "{area} {least}");
            let mut points = Swath::new(&outline, 200, 150, 0.01);
            for i in 0..=2000 {
                let at = Point::new(0.5 + f64::from(i) / 2000.0, 0.5 + f64::from(i) / 5000.0);
                points.sweep(at, at);
            }
            assert!(swath.count().abs_diff(points.count()) < 30, "{} {}", swath.count(), points.count());
        }
    }
}

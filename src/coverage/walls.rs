//! Walls, and how far a body is from them.

use crate::{
    geometry::{Point, Vector},
    grid::{Cell, Grid},
};

/// The obstacles of a floor as squares of a fine grid; the outside is wall.
#[derive(Debug, Clone)]
pub struct Walls {
    /// Distance from each fine cell's centre to the nearest wall, m, exact up to three cells more than the body's radius;
    /// 0 in walls.
    pub clearance: Grid<f32>,
    /// Side of a fine cell, m.
    pub resolution: f64,
    /// Radius of the body, m.
    pub body_radius: f64,
}

impl Walls {
    /// Whether a disc of `radius` metres around `point` touches no wall. `radius` is at most a cell more than the body's.
    #[inline]
    pub fn has_room(&self, point: Point, radius: f64) -> bool {
        self.has_room_around_cell(point, radius) || self.nearest(point, radius).is_none()
    }

    /// Like [`Walls::has_room`], but may say no where there is room: only looks at the room around the cell's centre,
    /// which is at most 0.71 cells away.
    #[inline]
    pub fn has_room_around_cell(&self, point: Point, radius: f64) -> bool {
        let around = self.clearance.get(self.cell_at(point)).map_or(0.0, |&c| f64::from(c));
        around > radius + 0.7072 * self.resolution
    }

    /// The nearest point of a wall less than `reach` metres from `point`, and its distance; exact.
    pub fn nearest(&self, point: Point, reach: f64) -> Option<(Point, f64)> {
        let size = self.resolution;
        let low = self.cell_at(point - Vector::new(reach, reach));
        let high = self.cell_at(point + Vector::new(reach, reach));
        let mut best: Option<(Point, f64)> = None;
        for y in low.y..=high.y {
            for x in low.x..=high.x {
                if self.clearance.get(Cell::new(x, y)).is_some_and(|&c| c > 0.0) {
                    continue;
                }
                let (left, bottom) = (f64::from(x) * size, f64::from(y) * size);
                let wall = Point::new(point.x.clamp(left, left + size), point.y.clamp(bottom, bottom + size));
                let distance = (wall - point).norm();
                if distance < reach && best.is_none_or(|(_, nearest)| distance < nearest) {
                    best = Some((wall, distance));
                }
            }
        }
        best
    }

    fn cell_at(&self, point: Point) -> Cell {
        Cell::at(point, self.resolution)
    }
}

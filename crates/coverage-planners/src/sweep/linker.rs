//! Collision-free paths between two positions.

use crate::stage::{Detours, is_straight_free};
use robovac_core::{
    cspace::Motion,
    geometry::Point,
    grid::{Cell, Grid},
};

/// A place, and the FREE cell that it belongs to.
pub(super) type WayStop = (Cell, Point);

/// Finds ways between places.
pub(super) struct WayLinker<'a> {
    /// Cells that the robot can reach.
    pub free: &'a Grid<bool>,
    /// Free motion to the nanometre.
    pub motion: &'a Motion,
    /// Detours around obstacles.
    pub detours: Detours<'a>,
    /// Side of a cell, m.
    pub cell: f64,
}

impl WayLinker<'_> {
    /// The way from a place in a cell to a place in another. The straight way collides if the line between the cells'
    /// centres leaves the FREE cells (the check of the paper's map). Where it doesn't, it is driven between the
    /// places themselves if that is free to the nanometre, or else by the centres.
    pub fn way(&mut self, from: WayStop, to: WayStop) -> (Vec<Point>, bool) {
        let mut line = CornerLine::default();
        line.extend(&[from.1]);
        let collides = !is_straight_free(self.free, from.0, to.0);
        if collides {
            let Some(corners) = self.detours.find(from.0, to.0) else { return (Vec::new(), true) };
            let centres: Vec<Point> = corners.into_iter().map(|corner| corner.centre(self.cell)).collect();
            line.extend(&centres);
        } else if from.0.y != to.0.y && !self.motion.is_free(from.1, to.1) {
            line.extend(&[from.0, to.0].map(|cell| cell.centre(self.cell)));
        }
        line.extend(&[to.1]);
        (line.corners, collides)
    }
}

/// Corners of a line, without those at which it doesn't turn.
#[derive(Default)]
pub(super) struct CornerLine {
    /// m.
    pub corners: Vec<Point>,
}

impl CornerLine {
    /// Goes on along these points.
    pub fn extend(&mut self, points: &[Point]) {
        for &point in points {
            let last = self.corners.last().copied();
            if last.is_some_and(|last| (point - last).norm() < 1e-9) {
                continue;
            }
            if let [.., before, last] = self.corners[..] {
                let (there, on) = (last - before, point - last);
                if there.perp(&on).abs() <= 1e-9 * there.norm() * on.norm() && there.dot(&on) > 0.0 {
                    self.corners.pop();
                }
            }
            self.corners.push(point);
        }
    }
}

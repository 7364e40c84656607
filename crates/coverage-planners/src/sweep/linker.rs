//! Collision-free paths between two positions.

use crate::stage::{Detours, is_straight_free};
use robovac_core::{
    cspace::{FreeSteps, Motion},
    geometry::Point,
    grid::{Cell, Grid},
};

/// A place, and the FREE cell that it belongs to: the way between it and the cell's centre is free.
pub(super) type WayStop = (Cell, Point);

/// Finds ways between places. All their pieces are free to the nanometre.
pub(super) struct WayLinker<'a> {
    /// Cells that the robot can reach.
    pub free: &'a Grid<bool>,
    /// The steps between them.
    pub steps: &'a FreeSteps,
    /// Free motion.
    pub motion: &'a Motion,
    /// Detours around obstacles.
    pub detours: Detours<'a>,
    /// Side of a cell, m.
    pub cell: f64,
}

impl WayLinker<'_> {
    /// The way from a place to another, and whether the straight one collides. A detour leads by centres of cells.
    pub fn way(&mut self, from: WayStop, to: WayStop) -> (Vec<Point>, bool) {
        let mut line = CornerLine::default();
        if self.motion.is_free(from.1, to.1) {
            line.extend(&[from.1, to.1]);
            return (line.corners, false);
        }
        let Self { free, steps, motion, cell, .. } = *self;
        // Free squares tell most of it in whole numbers.
        let is_clear = |a: Cell, b: Cell| {
            steps.is_straight_free(a, b)
                || (is_straight_free(free, a, b) && motion.is_free(a.centre(cell), b.centre(cell)))
        };
        let Some(corners) = self.detours.find_taut(from.0, to.0, is_clear) else { return (Vec::new(), true) };
        let mut way = vec![from.1];
        way.extend(corners.into_iter().map(|corner| corner.centre(cell)));
        way.push(to.1);
        // The centres at the ends are needed only if the places don't see what comes next.
        if way.len() > 3 && motion.is_free(way[0], way[2]) {
            way.remove(1);
        }
        if way.len() > 3 && motion.is_free(way[way.len() - 3], way[way.len() - 1]) {
            way.remove(way.len() - 2);
        }
        line.extend(&way);
        (line.corners, true)
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

//! Counts how often each part of the floor has been swept.

use super::{
    ReachableFloor,
    stamp::{DiscStamp, PolygonStamp},
};
use crate::{
    geometry::{Point, Pose, difference},
    grid::Grid,
    math,
    robot::{Body, Tool},
};
use std::ops::Range;

/// Counts passes of the tool over every fine cell.
///
/// A cell counts as visited again when the tool comes back to it after it had travelled more than its own diameter
/// since it last touched the cell; so neither standing still nor turning on the spot counts.
#[derive(Debug, Clone)]
pub struct CoverageTracker {
    stamp: DiscStamp,
    /// The body, if it is the tool, and the distance of its farthest point, m.
    body: Option<PolygonStamp>,
    reach: f64,
    /// Place of a tool that isn't in the middle.
    aside: Option<Point>,
    resolution: f64,
    /// Passes per fine cell, at most 255.
    visits: Grid<u8>,
    /// Number of the last stamp that touched the cell, 0 for none.
    touched: Vec<u32>,
    /// Number of the last stamp; starts above `memory`, as if all cells had been left long ago.
    stamps: u32,
    /// Stamps after which a touched cell counts as left.
    memory: u32,
    last: Option<Pose>,
    covered: usize,
    passes: u64,
    /// Cells in the lowest and highest row that changed since they were last taken.
    dirty: Option<(usize, usize)>,
}

impl CoverageTracker {
    /// A tracker for a floor on which nothing has been swept.
    pub fn new(floor: &ReachableFloor) -> Self {
        let grid = &floor.floor;
        let (mut body, mut reach, mut aside) = (None, 0.0, None);
        match (floor.tool, floor.body) {
            (Tool::Body, Body::Polygon(corners)) => {
                body = Some(PolygonStamp::new(&corners, floor.resolution));
                reach = floor.walls.body_radius;
            }
            (Tool::Disc(at), _) if at != [0.0, 0.0] => {
                aside = Some(Point::from(at));
                reach = math::hypot(at[0], at[1]);
            }
            _ => {}
        }
        let radius = floor.tool_radius.max(if body.is_some() { reach } else { 0.0 }) / floor.resolution;
        // Stamps are half a cell apart: 4 radii of them are a diameter.
        let memory = (4.0 * radius).ceil() as u32 + 1;
        Self {
            stamp: DiscStamp { radius, width: grid.width(), height: grid.height() },
            body,
            reach,
            aside,
            resolution: floor.resolution,
            visits: Grid::filled(grid.width(), grid.height(), 0),
            touched: vec![0; grid.len()],
            stamps: memory,
            memory,
            last: None,
            covered: 0,
            passes: 0,
            dirty: None,
        }
    }

    /// Sweeps with the tool while the robot moves straight from its last pose to `pose`, or sets it down there. The
    /// heading matters only if the tool isn't a disc in the middle.
    #[inline]
    pub fn sweep_to(&mut self, floor: &ReachableFloor, pose: Pose) {
        let Some(last) = self.last else {
            self.put_down(floor, pose);
            return;
        };
        let spacing = 0.5 * self.resolution;
        let way = pose.position() - last.position();
        if self.reach > 0.0 {
            return self.turn_to(floor, last, pose);
        }
        let distance_squared = way.norm_squared();
        if distance_squared < spacing * spacing {
            return;
        }
        let steps = (distance_squared.sqrt() / spacing).floor();
        let stride = way * (spacing / distance_squared.sqrt());
        let mut at = last;
        for _ in 0..steps as u32 {
            (at.x, at.y) = (at.x + stride.x, at.y + stride.y);
            self.put_down(floor, at);
        }
    }

    /// As [`Self::sweep_to`], and to the very end, for a robot that stops or turns there.
    pub fn sweep_up_to(&mut self, floor: &ReachableFloor, pose: Pose) {
        self.sweep_to(floor, pose);
        let Some(last) = self.last.filter(|&last| last != pose) else { return };
        // A stamp stands for half a cell of way: less than half of that counts with the one before.
        self.stamps -= u32::from((pose.position() - last.position()).norm() < 0.25 * self.resolution);
        self.put_down(floor, pose);
    }

    /// The same for a tool that turning moves, too.
    fn turn_to(&mut self, floor: &ReachableFloor, last: Pose, pose: Pose) {
        let (way, turn) = (pose.position() - last.position(), difference(last.heading, pose.heading));
        let steps = ((way.norm() + turn.abs() * self.reach) / (0.5 * self.resolution)).floor();
        for step in 1..=steps as u32 {
            let share = f64::from(step) / steps;
            let at = last.position() + way * share;
            self.put_down(floor, Pose { x: at.x, y: at.y, heading: last.heading + turn * share });
        }
    }

    /// Takes over what was swept before, where it is reachable here, from an earlier tracker over the same grid. It counts as swept
    /// once, under the tool, too: what was swept again then, no later distance or time accounts for. Does nothing if the grids differ.
    pub fn take_over(&mut self, floor: &ReachableFloor, earlier: &Self) {
        if !earlier.is_over(self.visits.width(), self.visits.height(), self.resolution) {
            return;
        }
        let Self { visits, covered, passes, dirty, .. } = self;
        let cells = visits.values_mut().iter_mut().zip(floor.floor.values()).zip(earlier.visits.values());
        for ((count, &is_reachable), &before) in cells {
            if is_reachable && before > 0 {
                *covered += usize::from(*count == 0);
                *passes += u64::from(*count == 0);
                *count = (*count).max(before);
            }
        }
        *dirty = Some((0, visits.len().saturating_sub(1)));
    }

    /// Lifts the tool: at the next place it is set down instead of sweeping there.
    pub fn lift(&mut self) {
        self.last = None;
    }

    fn put_down(&mut self, floor: &ReachableFloor, at: Pose) {
        self.last = Some(at);
        self.stamps += 1;
        let Self { stamp, body, aside, resolution, visits, touched, stamps, memory, covered, passes, dirty, .. } = self;
        let (now, reachable, counts) = (*stamps, floor.floor.values(), visits.values_mut());
        let sweep = |range: Range<usize>| {
            let (low, high) = dirty.unwrap_or((range.start, range.start));
            *dirty = Some((low.min(range.start), high.max(range.start)));
            let cells = reachable[range.clone()].iter().zip(&mut touched[range.clone()]).zip(&mut counts[range]);
            for ((&is_reachable, touched), count) in cells {
                let is_new_pass = is_reachable && now - *touched > *memory;
                *touched = now;
                if is_new_pass {
                    *covered += usize::from(*count == 0);
                    *count = count.saturating_add(1);
                    *passes += 1;
                }
            }
        };
        let (x, y) = (at.x / *resolution, at.y / *resolution);
        match (body, aside) {
            (Some(body), _) => stamp.body_rows(body, (x, y), math::sin_cos(at.heading), sweep),
            (None, Some(aside)) => {
                let tool = at.to_world(*aside);
                stamp.rows(tool.x / *resolution, tool.y / *resolution, sweep);
            }
            (None, None) => stamp.rows(x, y, sweep),
        }
    }

    /// Swept share of the reachable floor, 0 to 1.
    pub fn coverage(&self, floor: &ReachableFloor) -> f64 {
        self.covered as f64 / floor.floor_cells as f64
    }

    /// Share of another floor over the same grid that was swept here, 0 to 1; 0 if the grids differ.
    pub fn coverage_on(&self, floor: &ReachableFloor) -> f64 {
        if !self.is_over(floor.floor.width(), floor.floor.height(), floor.resolution) {
            return 0.0;
        }
        let cells = floor.floor.values().iter().zip(self.visits.values());
        cells.filter(|&(&is_reachable, &visits)| is_reachable && visits > 0).count() as f64 / floor.floor_cells as f64
    }

    fn is_over(&self, width: usize, height: usize, resolution: f64) -> bool {
        (self.visits.width(), self.visits.height()) == (width, height)
            && self.resolution.to_bits() == resolution.to_bits()
    }

    /// Passes beyond the first, as a share of the swept floor: 0.3 means that 30 % were swept twice on average.
    pub fn overlap(&self) -> f64 {
        if self.covered == 0 { 0.0 } else { (self.passes - self.covered as u64) as f64 / self.covered as f64 }
    }

    /// Passes per fine cell, at most 255.
    pub fn visits(&self) -> &Grid<u8> {
        &self.visits
    }

    /// Memory size, bytes.
    pub fn bytes(&self) -> usize {
        self.touched.len() * (size_of::<u8>() + size_of::<u32>())
    }

    /// The lowest and highest row that changed since the last call.
    pub fn take_dirty_rows(&mut self) -> Option<(usize, usize)> {
        self.dirty.take().map(|(low, high)| (low / self.stamp.width, high / self.stamp.width))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{floor_plan::Sketch, robot::model};

    #[test]
    fn a_robot_that_stood_still_while_the_room_changed_has_swept_nothing_again() {
        let floor =
            ReachableFloor::new(&Sketch::open(2.0, 2.0, 0.05).finish("", ""), model("roomba600").unwrap(), None)
                .unwrap();
        let mut earlier = CoverageTracker::new(&floor);
        earlier.sweep_to(&floor, Pose::new(0.5, 0.5, 0.0));
        earlier.sweep_to(&floor, Pose::new(1.5, 0.5, 0.0));
        let mut tracker = CoverageTracker::new(&floor);
        tracker.sweep_to(&floor, Pose::new(1.5, 0.5, 0.0));
        tracker.take_over(&floor, &earlier);
        assert_eq!((tracker.overlap(), tracker.visits().values()), (earlier.overlap(), earlier.visits().values()));
    }
}

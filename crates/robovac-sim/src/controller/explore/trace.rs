//! Walls that have been followed already.

use crate::mapping::TiledLayer;
use robovac_core::{geometry::Pose, grid::Cell, math};
use std::collections::VecDeque;

/// Side of its cells, m.
const SIDE: f64 = 0.05;
/// Distance within which a place counts as the same, m.
const REACH: f64 = 0.15;
/// Sectors of headings.
const SECTORS: f64 = 8.0;
/// Least distance driven before a place can count as visited again, m.
const LATER: f64 = 1.0;
/// Distance between marks, m.
const SPACING: f64 = 0.05;

/// Places where the robot followed a wall, with its direction.
#[derive(Debug, Clone, Default)]
pub(super) struct WallTrace {
    /// A bit for each sector of headings.
    marks: TiledLayer<u8>,
    /// The last marks, oldest first, which aren't in `marks` yet.
    recent: VecDeque<Pose>,
    /// Uninterrupted distance over marked places, m.
    overlap: f64,
}

impl WallTrace {
    /// Records that the robot follows a wall at `pose`; returns for how far it has been following a known one, m.
    pub fn follow(&mut self, pose: Pose) -> f64 {
        let step = self.recent.back().map(|last| (pose.position() - last.position()).norm());
        if step.is_none_or(|step| step >= SPACING) {
            self.overlap = if self.has(pose) { self.overlap + step.unwrap_or(0.0) } else { 0.0 };
            self.recent.push_back(pose);
            if self.recent.len() > (LATER / SPACING) as usize {
                self.recent.pop_front().into_iter().for_each(|pose| self.mark(pose));
            }
        }
        self.overlap
    }

    /// It no longer follows a wall.
    pub fn stop(&mut self) {
        for pose in std::mem::take(&mut self.recent) {
            self.mark(pose);
        }
        self.overlap = 0.0;
    }

    /// Whether it has followed a wall at `pose` with about this heading.
    pub fn has(&self, pose: Pose) -> bool {
        self.marks.get(Cell::at(pose.position(), SIDE)) & sectors(pose.heading, 1) != 0
    }

    /// Whether it has followed a wall at `pose`, with any heading.
    pub fn has_any(&self, pose: Pose) -> bool {
        self.marks.get(Cell::at(pose.position(), SIDE)) != 0
    }

    fn mark(&mut self, pose: Pose) {
        let (middle, reach) = (Cell::at(pose.position(), SIDE), (REACH / SIDE).ceil() as i32);
        for y in middle.y - reach..=middle.y + reach {
            for x in middle.x - reach..=middle.x + reach {
                let cell = Cell::new(x, y);
                if (cell.centre(SIDE) - pose.position()).norm() <= REACH {
                    self.marks.update(cell, |bits| bits | sectors(pose.heading, 0));
                }
            }
        }
    }
}

/// The bit of a heading's sector, with those of `beside` sectors to either side.
fn sectors(heading: f64, beside: i32) -> u8 {
    let sector = math::floor(heading * SECTORS / math::TAU + 0.5);
    (sector - beside..=sector + beside).fold(0, |bits, sector| bits | 1 << sector.rem_euclid(SECTORS as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_is_closed_where_it_is_driven_the_same_way_again() {
        let mut trace = WallTrace::default();
        // A circle of 0.5 m radius, twice.
        let closed = (0..1300).find(|i| {
            let angle = 0.01 * f64::from(*i);
            let heading = robovac_core::geometry::normalize(angle + math::FRAC_PI_2);
            trace.follow(Pose::new(0.5 * math::cos(angle), 0.5 * math::sin(angle), heading)) > 0.5
        });
        let way = 0.005 * f64::from(closed.unwrap());
        assert!((math::PI + 0.3..math::PI + 0.6).contains(&way), "{way} m");
    }

    #[test]
    fn the_way_back_along_the_other_wall_of_a_corridor_is_new() {
        let mut trace = WallTrace::default();
        for i in 0..60 {
            trace.follow(Pose::new(0.05 * f64::from(i), 0.0, 0.0));
        }
        trace.stop();
        let back = Pose::new(1.0, 0.1, math::PI);
        assert!(!trace.has(back) && trace.has_any(back) && trace.has(Pose::new(1.0, 0.1, -0.3)));
    }
}

//! Directions of walls around key frames. Most walls of a building are parallel or at right angles to each other; so those around a
//! robot tell its heading, however far it has come since the last place that it knew.

use crate::mapping::{multiscan::WallLine, pose_ekf::quarter};
use robovac_core::{geometry::Pose, math};

/// Length of wall, summed over scans, from which a key frame's direction counts, m, and how well its walls have to agree, from 0
/// to 1.
const LEAST: f64 = 2.0;
const AGREE: f64 = 0.9;
/// Number of key frames by which the building's direction is known: there the heading hardly drifted.
const FIRST: usize = 6;
/// Largest difference from the building's direction that is an error and not another direction, rad.
const MOST: f64 = 0.08;

/// The directions of the walls around every key frame, and that of the building.
#[derive(Debug, Clone, Default)]
pub(super) struct WallAxes {
    /// Cosines and sines of four times the directions as seen from the key frame, weighted by length, and the weights.
    frames: Vec<[f64; 3]>,
    /// Direction of the building's walls, rad, modulo a right angle.
    building: Option<f64>,
}

impl WallAxes {
    /// Begins with the next key frame.
    pub fn add_frame(&mut self) {
        self.frames.push([0.0; 3]);
    }

    /// Adds the walls of a scan that was taken at a heading of `turn` to a key frame, rad.
    pub fn add(&mut self, frame: usize, turn: f64, walls: &[WallLine]) {
        for wall in walls {
            let (sin, cos) = math::sin_cos(4.0 * (turn + wall.direction));
            for (sum, value) in self.frames[frame].iter_mut().zip([cos, sin, 1.0]) {
                *sum += wall.length * value;
            }
        }
    }

    /// Direction of a key frame's walls as seen from it, rad, modulo a right angle; `None` if there are few, or they disagree.
    fn seen(&self, frame: usize) -> Option<f64> {
        let [cos, sin, all] = self.frames[frame];
        (all > LEAST && math::hypot(cos, sin) > AGREE * all).then(|| 0.25 * math::atan2(sin, cos))
    }

    /// The heading of a key frame by its walls, rad; `None` if they don't tell, or the building isn't known yet.
    pub fn heading(&mut self, frame: usize, poses: &[Pose]) -> Option<f64> {
        let (seen, now) = (self.seen(frame)?, poses[frame].heading);
        let Some(building) = self.building else {
            if frame + 1 >= FIRST {
                let all = (0..=frame)
                    .filter_map(|frame| Some(math::sin_cos(4.0 * (poses[frame].heading + self.seen(frame)?))));
                let (sin, cos) = all.fold((0.0, 0.0), |(sines, cosines), (sin, cos)| (sines + sin, cosines + cos));
                self.building = Some(0.25 * math::atan2(sin, cos));
            }
            return None;
        };
        let off = quarter(now + seen - building);
        (off.abs() < MOST).then_some(now - off)
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.frames)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::geometry::normalize;

    fn wall(direction: f64, length: f64) -> WallLine {
        WallLine { direction, deviation: 0.01, length }
    }

    /// Key frames in a building whose walls are at 0.3 rad; the last one's heading is off by `off`, and its walls are at `aside`.
    fn corrected(off: f64, aside: f64) -> Option<f64> {
        let mut axes = WallAxes::default();
        let mut poses = Vec::new();
        let mut heading = None;
        for frame in 0..=FIRST {
            let is_last = frame == FIRST;
            let true_heading = 0.7 * frame as f64;
            poses.push(Pose::new(0.0, 0.0, true_heading + if is_last { off } else { 0.0 }));
            axes.add_frame();
            let at = 0.3 - true_heading + if is_last { aside } else { 0.0 };
            // Seen from a scan that was turned against the key frame.
            axes.add(frame, 0.2, &[wall(at - 0.2, 3.0), wall(at - 0.2 + math::FRAC_PI_2, 2.0)]);
            heading = axes.heading(frame, &poses);
            assert_eq!(heading.is_some(), is_last && aside == 0.0);
        }
        heading.map(|heading| normalize(heading - 0.7 * FIRST as f64))
    }

    #[test]
    fn walls_tell_by_how_much_a_heading_is_off() {
        for off in [0.0, 0.015, -0.03] {
            assert!(corrected(off, 0.0).unwrap().abs() < 1e-9);
        }
        assert_eq!(corrected(0.0, 0.4), None, "a wing at another angle");
    }

    #[test]
    fn walls_that_disagree_tell_nothing() {
        let mut axes = WallAxes::default();
        axes.add_frame();
        axes.add(0, 0.0, &[wall(0.0, 2.0), wall(0.6, 2.0)]);
        assert_eq!(axes.seen(0), None);
        axes.add(0, 0.0, &[wall(0.0, 90.0)]);
        assert!(axes.seen(0).is_some());
    }
}

//! Directions of walls around key frames. Most walls of a building are parallel or at right angles to each other; so those around a
//! robot tell its heading, however far it has come since the last place that it knew. Not all buildings are so straight: from one
//! key frame to the next the heading hardly drifts, so what differs there are the walls.

use crate::mapping::{multiscan::WallLine, pose_ekf::quarter};
use robovac_core::{geometry::Pose, math};

/// Length of wall, summed over scans, from which a key frame's direction counts, m, and how well its walls have to agree, from 0
/// to 1.
const LEAST: f64 = 6.0;
const AGREE: f64 = 0.9;
/// Standard deviation of a direction, rad: by walls that aren't quite at right angles, as those of real buildings, and by short
/// pieces of wall, times their length in m (ours).
const ASKEW: f64 = 0.006;
const SHORT: f64 = 0.1;
/// Length of wall from which a direction is as good as it gets, m; median difference between neighbouring key frames, rad, above
/// which a building's walls aren't straight enough to tell headings, and number of differences by which that is known (ours:
/// generated flats have 0.0014 to 0.0024 rad).
const LONG: f64 = 20.0;
const CROOKED: (f64, usize) = (0.0027, 12);
/// Number of key frames with walls by which the building's direction is known: there the heading hardly drifted.
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
    /// The last direction by long walls, with its key frame, and how much such directions differ between neighbours, rad.
    last: Option<(usize, f64)>,
    differences: Vec<f64>,
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

    /// Direction of a key frame's walls as seen from it, modulo a right angle, and its standard deviation, rad; `None` if there are
    /// few, or they disagree.
    fn seen(&self, frame: usize) -> Option<[f64; 2]> {
        let [cos, sin, all] = self.frames[frame];
        let tells = all > LEAST && math::hypot(cos, sin) > AGREE * all;
        tells.then(|| [0.25 * math::atan2(sin, cos), math::hypot(ASKEW, SHORT / all)])
    }

    /// The heading of a key frame that is complete by its walls, and its standard deviation, rad; `None` if they don't tell, or it
    /// isn't known that the building is straight.
    pub fn heading(&mut self, frame: usize, poses: &[Pose]) -> Option<[f64; 2]> {
        let ([seen, deviation], now) = (self.seen(frame)?, poses[frame].heading);
        self.compare(frame, now + seen);
        let Some(building) = self.building else {
            let (mut count, mut cosines, mut sines) = (0, 0.0, 0.0);
            for (frame, pose) in poses.iter().enumerate().take(frame + 1) {
                if let Some([seen, deviation]) = self.seen(frame) {
                    let (sin, cos) = math::sin_cos(4.0 * (pose.heading + seen));
                    let weight = 1.0 / (deviation * deviation);
                    (count, cosines, sines) = (count + 1, cosines + weight * cos, sines + weight * sin);
                }
            }
            self.building = (count >= FIRST).then(|| 0.25 * math::atan2(sines, cosines));
            return None;
        };
        let off = quarter(now + seen - building);
        (off.abs() < MOST && self.is_straight()).then_some([now - off, deviation])
    }

    /// Compares a key frame's direction with that of the one before it, if both see long walls.
    fn compare(&mut self, frame: usize, direction: f64) {
        if self.frames[frame][2] < LONG {
            return;
        }
        if let Some((last, before)) = self.last.replace((frame, direction))
            && last + 1 == frame
        {
            let difference = quarter(direction - before).abs();
            let at = self.differences.partition_point(|&other| other < difference);
            self.differences.insert(at, difference);
        }
    }

    /// Whether enough has been seen of the building to know that its walls are parallel or at right angles.
    pub fn is_straight(&self) -> bool {
        let (most, least) = CROOKED;
        self.differences.len() >= least && self.differences[self.differences.len() / 2] < most
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.frames) + size_of_val(&*self.differences)
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
        const LAST: usize = CROOKED.1 + 2;
        let mut axes = WallAxes::default();
        let mut poses = Vec::new();
        let mut heading = None;
        for frame in 0..=LAST {
            let is_last = frame == LAST;
            let true_heading = 0.7 * frame as f64;
            poses.push(Pose::new(0.0, 0.0, true_heading + if is_last { off } else { 0.0 }));
            axes.add_frame();
            let at = 0.3 - true_heading + if is_last { aside } else { 0.0 };
            // Seen from a scan that was turned against the key frame.
            axes.add(frame, 0.2, &[wall(at - 0.2, 30.0), wall(at - 0.2 + math::FRAC_PI_2, 20.0)]);
            heading = axes.heading(frame, &poses);
            assert_eq!(heading.is_some(), frame >= CROOKED.1 && (!is_last || aside == 0.0), "{frame}");
        }
        heading.map(|[heading, deviation]| {
            assert!((0.006..0.007).contains(&deviation), "{deviation}");
            normalize(heading - 0.7 * LAST as f64)
        })
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
        axes.add(0, 0.0, &[wall(0.0, 8.0), wall(0.6, 8.0)]);
        assert_eq!(axes.seen(0), None);
        axes.add(0, 0.0, &[wall(0.0, 360.0)]);
        assert!(axes.seen(0).is_some());
    }

    #[test]
    fn short_pieces_of_wall_say_little_of_the_building() {
        let mut axes = WallAxes::default();
        let poses = [Pose::new(0.0, 0.0, 0.0); 60];
        for frame in 0..60 {
            axes.add_frame();
            // Where there is little to see, that is seen askew.
            let walls = if frame % 3 == 0 { wall(0.04, 7.0) } else { wall(0.0, 60.0) };
            axes.add(frame, 0.0, &[walls]);
            if let Some([heading, deviation]) = axes.heading(frame, &poses) {
                assert!((heading + walls.direction).abs() < 0.007, "frame {frame}: {heading}");
                assert!(deviation < if frame % 3 == 0 { 0.016 } else { 0.007 });
            }
        }
        assert!(axes.building.is_some() && axes.is_straight());
    }

    #[test]
    fn a_crooked_building_tells_no_heading() {
        for (crooked, drifts) in [(0.0, 0.0), (0.0, 0.001), (0.006, 0.0)] {
            let mut axes = WallAxes::default();
            let mut poses = Vec::new();
            let mut last = None;
            for frame in 0..60 {
                poses.push(Pose::new(0.0, 0.0, drifts * frame as f64));
                axes.add_frame();
                // Walls that lean to one side and to the other.
                axes.add(frame, 0.0, &[wall(crooked * math::sin(frame as f64), 40.0)]);
                last = axes.heading(frame, &poses);
            }
            assert_eq!((axes.is_straight(), last.is_some()), (crooked == 0.0, crooked == 0.0), "{crooked} {drifts}");
        }
    }
}

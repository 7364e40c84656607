//! Follows a path by an external pose estimate, which can jump when it is corrected.

use robovac_core::{
    geometry::{Point, Pose, difference},
    math,
    robot::{Drive, RobotModel},
};

/// Distance from a corner at which it counts as reached, m.
const REACHED: f64 = 0.03;
/// Distance off the line beyond which the robot drives straight to the corner instead of back to the line, m.
const ASTRAY: f64 = 0.25;
/// Heading correction per metre off the line, rad/m, and its limit, rad.
const STEER: (f64, f64) = (5.0, 0.6);
/// Turn rate per radian of heading error, 1/s.
const TURN_GAIN: f64 = 5.0;
/// Slowest turn on the spot, rad/s.
const LEAST_TURN: f64 = 0.2;
/// Heading errors at which a turn on the spot begins and ends, rad.
const TURNS: (f64, f64) = (0.6, 0.08);
/// Slowest speed, m/s.
const LEAST_SPEED: f64 = 0.05;

/// A line to drive along.
#[derive(Debug, Clone)]
pub(in crate::controller) struct Route {
    /// Start of the present piece: a corner, or the robot's position.
    from: Point,
    line: Vec<Point>,
    /// Index of the corner that it drives to.
    next: usize,
    is_turning: bool,
}

impl Route {
    /// From the robot's position along `line`, m, in the frame of the poses for [`Route::steer`].
    pub(in crate::controller) fn new(from: Point, line: Vec<Point>) -> Self {
        Self { from, line, next: 0, is_turning: true }
    }

    /// Remaining length, m.
    pub(in crate::controller) fn left(&self, at: Point) -> f64 {
        let rest = self.rest();
        let corners = std::iter::once(&at).chain(rest);
        corners.zip(rest).map(|(a, b)| (b - a).norm()).sum()
    }

    /// Remaining corners.
    pub(in crate::controller) fn rest(&self) -> &[Point] {
        self.line.get(self.next..).unwrap_or_default()
    }

    /// Whether it drives ahead rather than turning on the spot.
    pub(in crate::controller) fn is_driving(&self) -> bool {
        !self.is_turning
    }

    /// The drive command at `pose`, at most at `speed` m/s; `None` at the end of the line.
    ///
    /// It turns on the spot where a corner is sharp, and slows down before it.
    pub(in crate::controller) fn steer(&mut self, pose: Pose, robot: &RobotModel, speed: f64) -> Option<Drive> {
        let at = pose.position();
        let (to, along, left) = loop {
            let to = *self.line.get(self.next)?;
            let piece = to - self.from;
            let along = if piece.norm() > REACHED { piece.normalize() } else { pose.direction() };
            let left = (to - at).dot(&along);
            if left > REACHED && piece.norm() > REACHED {
                break (to, along, left);
            }
            self.from = to;
            self.next += 1;
        };
        let off = along.perp(&(at - self.from));
        let (along, off) = if off.abs() > ASTRAY {
            self.from = at;
            ((to - at).normalize(), 0.0)
        } else {
            (along, off)
        };
        let wanted = math::atan2(along.y, along.x) + (-STEER.0 * off).clamp(-STEER.1, STEER.1);
        let error = difference(pose.heading, wanted);
        self.is_turning = error.abs() > if self.is_turning { TURNS.1 } else { TURNS.0 };
        let most = robot.turn_rate();
        if self.is_turning {
            let rate = (TURN_GAIN * error).clamp(-most, most);
            let rate = if rate.abs() < LEAST_TURN { LEAST_TURN * error.signum() } else { rate };
            return Some(Drive::from_twist(0.0, rate, robot.wheel_base));
        }
        // Slow enough to stop before the corner, and slower with larger heading errors.
        let braking = (2.0 * 0.8 * robot.acceleration * left).sqrt();
        let speed = speed.min(braking).max(LEAST_SPEED) * (1.0 - 0.7 * (error.abs() / TURNS.0).min(1.0));
        Some(Drive::from_twist(speed, (TURN_GAIN * error).clamp(-0.8 * most, 0.8 * most), robot.wheel_base))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        geometry::Vector,
        robot::{advance_sideways, model},
    };

    fn drive(route: &mut Route, mut pose: Pose, jump: Option<(u32, Vector)>) -> (Pose, f64, u32) {
        let (robot, mut off, mut step) = (model("roomba600").unwrap(), 0.0_f64, 0);
        while let Some(drive) = route.steer(pose, robot, 0.3) {
            pose = advance_sideways(pose, [0.015 * drive.left, 0.015 * drive.right, 0.0], robot.wheel_base);
            if let Some((_, by)) = jump.filter(|(at, _)| *at == step) {
                pose = Pose::new(pose.x + by.x, pose.y + by.y, pose.heading);
            }
            // The line of these tests: along x to 1, then along y.
            off = off.max(if pose.x < 0.95 { pose.y.abs() } else { (pose.x - 1.0).abs() });
            step += 1;
            assert!(step < 3000, "it doesn't arrive: {pose}");
        }
        (pose, off, step)
    }

    fn corner() -> Route {
        Route::new(Point::origin(), vec![Point::new(1.0, 0.0), Point::new(1.0, 0.8)])
    }

    #[test]
    fn it_turns_at_corners_and_stays_on_the_line() {
        let (end, off, steps) = drive(&mut corner(), Pose::new(0.0, 0.0, 2.0), None);
        assert!((end.position() - Point::new(1.0, 0.8)).norm() < 0.05 && off < 0.05, "{end}, {off} m off");
        assert!(steps < 900, "{steps} steps");
    }

    #[test]
    fn a_pose_that_jumps_leads_back_to_the_line_or_straight_to_the_corner() {
        for by in [Vector::new(0.0, 0.1), Vector::new(0.1, -0.4), Vector::new(-0.3, 0.5)] {
            let (end, ..) = drive(&mut corner(), Pose::new(0.0, 0.0, 0.0), Some((100, by)));
            assert!((end.position() - Point::new(1.0, 0.8)).norm() < 0.06, "{by}: {end}");
        }
    }

    #[test]
    fn what_is_left_is_measured_along_the_line() {
        let mut route = corner();
        assert!((route.left(Point::origin()) - 1.8).abs() < 1e-12);
        drive(&mut route, Pose::new(0.0, 0.0, 0.0), None);
        assert_eq!(route.left(Point::new(1.0, 0.8)), 0.0);
    }
}

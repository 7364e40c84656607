//! Time of a path by the robot's motion model: straight pieces from rest to rest, and turns on the spot between them.

use super::{curves::CurveTimes, free_space::FreeSpace};
use robovac_core::{geometry::Point, geometry::Vector, math, robot::RobotModel};

/// Angles below which no turn is made, rad; the same as in the metrics of driven walks.
const NO_TURN: f64 = 1e-9;

/// Before the start, the robot comes from so far away, m: too near for a curve.
const BEFORE_START: f64 = 1e-3;

/// Speeds and accelerations of a robot, ready for use.
#[derive(Debug, Clone)]
pub(super) struct MotionTimes {
    speed: f64,
    acceleration: f64,
    turn_speed: f64,
    half_base: f64,
    /// For a robot that rounds corners.
    curves: Option<CurveTimes>,
    /// What stops, turns and curves count.
    stops: f64,
}

impl MotionTimes {
    /// Of a robot that stops at every corner, or drives curves where they fit.
    pub fn of(robot: &RobotModel, curves: Option<CurveTimes>) -> Self {
        Self {
            speed: robot.cruise_speed,
            acceleration: robot.acceleration,
            turn_speed: robot.turn_wheel_speed,
            half_base: 0.5 * robot.wheel_base,
            curves,
            stops: 1.0,
        }
    }

    /// The same with only a share of the time for stops, turns and curves: what a search minimises, not the robot's time.
    pub fn with_stops(self, share: f64) -> Self {
        Self { stops: share, ..self }
    }

    /// Whether the robot rounds corners.
    pub fn has_curves(&self) -> bool {
        self.curves.is_some()
    }

    /// Seconds for a straight piece: from rest to rest, like [`RobotModel::straight_time`]; for a robot that rounds corners, at
    /// full speed.
    #[inline]
    pub fn straight(&self, metres: f64) -> f64 {
        let cruise = metres / self.speed;
        if self.curves.is_some() {
            return cruise;
        }
        let whole = profile(metres, self.speed, self.acceleration);
        if self.stops < 1.0 { cruise + self.stops * (whole - cruise) } else { whole }
    }

    /// Seconds for the corner `at` on the way from `a` to `b`: a turn on the spot, like [`RobotModel::turn_time`]; for a robot
    /// that rounds corners, what it takes longer than straight on at full speed. Its curve must fit into `space`.
    #[inline]
    pub fn corner(&self, a: Point, at: Point, b: Point, space: Option<&FreeSpace>) -> f64 {
        let (from, to): (Vector, Vector) = (at - a, b - at);
        let angle = math::atan2(from.perp(&to).abs(), from.dot(&to));
        if angle <= NO_TURN {
            return 0.0;
        }
        let whole = match &self.curves {
            Some(curves) => curves.seconds(angle, at, [-from, to], space),
            None => profile(angle * self.half_base, self.turn_speed, self.acceleration),
        };
        self.stops * whole
    }

    /// Where a robot at `start` that looks along `heading` would come from.
    pub fn before_start(start: Point, heading: Vector) -> Point {
        start - heading * BEFORE_START
    }

    /// Seconds along a path of a robot that looks along `heading` at its start.
    pub fn path(&self, path: &[Point], heading: Vector, space: Option<&FreeSpace>) -> f64 {
        let [start, second, ..] = *path else { return 0.0 };
        let straight: f64 = path.windows(2).map(|pair| self.straight((pair[1] - pair[0]).norm())).sum();
        let corners: f64 = path.windows(3).map(|three| self.corner(three[0], three[1], three[2], space)).sum();
        straight + corners + self.corner(Self::before_start(start, heading), start, second, space)
    }
}

#[inline]
fn profile(distance: f64, speed: f64, acceleration: f64) -> f64 {
    let ramps = speed * speed / acceleration;
    if distance >= ramps { distance / speed + speed / acceleration } else { 2.0 * (distance / acceleration).sqrt() }
}

/// Length of a path, m.
pub(super) fn length(path: &[Point]) -> f64 {
    path.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    #[test]
    fn times_are_those_of_the_motion_model() {
        let robot = model("roomba600").unwrap();
        let times = MotionTimes::of(robot, None);
        for metres in [0.0, 0.01, 0.1, 0.2, 3.0] {
            assert!((times.straight(metres) - robot.straight_time(metres)).abs() < 1e-12);
        }
        for angle in [0.01, 0.7, 3.1] {
            let behind = Point::new(0.3 + 2.0 * math::cos(angle), 2.0 * math::sin(angle));
            let corner = times.corner(Point::origin(), Point::new(0.3, 0.0), behind, None);
            assert!((corner - robot.turn_time(angle)).abs() < 1e-9);
        }
        let path = [Point::new(0.0, 0.0), Point::new(1.0, 0.0), Point::new(1.0, 2.0)];
        let quarter = robot.turn_time(math::FRAC_PI_2);
        let expected = robot.straight_time(1.0) + robot.straight_time(2.0) + 2.0 * quarter;
        assert!((times.path(&path, Vector::new(0.0, 1.0), None) - expected).abs() < 1e-9);
        assert_eq!(length(&path), 3.0);
        let tenth = times.with_stops(0.1).path(&path, Vector::new(0.0, 1.0), None);
        let cruise = 3.0 / robot.cruise_speed;
        assert!((tenth - cruise - 0.1 * (expected - cruise)).abs() < 1e-9);
    }
}

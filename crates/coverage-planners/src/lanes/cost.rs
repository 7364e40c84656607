//! Time of a path by the robot's motion model: straight pieces from rest to rest, and turns on the spot between them.

use robovac_core::{geometry::Point, geometry::Vector, math, robot::RobotModel};

/// Angles below which no turn is made, rad; the same as in the metrics of driven walks.
const NO_TURN: f64 = 1e-9;

/// Speeds and accelerations of a robot, ready for use.
#[derive(Debug, Clone, Copy)]
pub(super) struct MotionTimes {
    speed: f64,
    acceleration: f64,
    turn_speed: f64,
    half_base: f64,
}

impl MotionTimes {
    pub fn of(robot: &RobotModel) -> Self {
        Self {
            speed: robot.cruise_speed,
            acceleration: robot.acceleration,
            turn_speed: robot.turn_wheel_speed,
            half_base: 0.5 * robot.wheel_base,
        }
    }

    /// Seconds for a straight piece, like [`RobotModel::straight_time`].
    #[inline]
    pub fn straight(&self, metres: f64) -> f64 {
        profile(metres, self.speed, self.acceleration)
    }

    /// Seconds for the turn between two directions, which needn't have length 1, like [`RobotModel::turn_time`].
    #[inline]
    pub fn turn(&self, from: Vector, to: Vector) -> f64 {
        let angle = math::atan2(from.perp(&to).abs(), from.dot(&to));
        if angle > NO_TURN { profile(angle * self.half_base, self.turn_speed, self.acceleration) } else { 0.0 }
    }

    /// Seconds along a chain of points, with the turns at its inner ones.
    pub fn chain(&self, points: &[Point]) -> f64 {
        let straight: f64 = points.windows(2).map(|pair| self.straight((pair[1] - pair[0]).norm())).sum();
        let turns: f64 = points.windows(3).map(|three| self.turn(three[1] - three[0], three[2] - three[1])).sum();
        straight + turns
    }

    /// Seconds along a path of a robot that looks along `heading` at its start.
    pub fn path(&self, path: &[Point], heading: Vector) -> f64 {
        let first = match path {
            [a, b, ..] => self.turn(heading, b - a),
            _ => 0.0,
        };
        first + self.chain(path)
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
        let times = MotionTimes::of(robot);
        for metres in [0.0, 0.01, 0.1, 0.2, 3.0] {
            assert!((times.straight(metres) - robot.straight_time(metres)).abs() < 1e-12);
        }
        for angle in [0.01, 0.7, 3.1] {
            let to = Vector::new(2.0 * math::cos(angle), 2.0 * math::sin(angle));
            assert!((times.turn(Vector::new(0.3, 0.0), to) - robot.turn_time(angle)).abs() < 1e-9);
        }
        let path = [Point::new(0.0, 0.0), Point::new(1.0, 0.0), Point::new(1.0, 2.0)];
        let quarter = robot.turn_time(math::FRAC_PI_2);
        let expected = robot.straight_time(1.0) + robot.straight_time(2.0) + 2.0 * quarter;
        assert!((times.path(&path, Vector::new(0.0, 1.0)) - expected).abs() < 1e-9);
        assert_eq!(length(&path), 3.0);
    }
}

//! How fast a robot may drive if it is to stop before a wheel gets over an edge that its cliff sensors have seen.

use crate::{math, robot::RobotModel};

/// Time from an edge under a sensor to brakes that grip, s: one reading.
const REACTION_S: f64 = 0.015;
/// Floor that must be left under the wheel, m.
const MARGIN: f64 = 0.002;
/// Floor that must be left around the circle on which the wheels turn, m: brakes come in while the robot still rolls.
const TURN_MARGIN: f64 = 0.025;
/// Least way back from an edge, m.
const LEAST_BACK: f64 = 0.06;
/// Slowest speed that is worth driving, m/s.
const LEAST: f64 = 0.08;
/// Directions of edges that are looked at, from straight ahead to alongside.
const DIRECTIONS: u32 = 18;

/// The fastest speed straight ahead, m/s, at most the model's cruise speed.
///
/// A straight edge of any direction is first seen by the sensor that reaches farthest towards it. From there to the edge
/// the wheel on that side has a certain way, in which the robot must react and brake. Where the edge is a corner of the
/// drop-off, one side sensor alone may see it: its lead over the wheels must do. Without cliff sensors there is nothing to
/// be careful about.
pub(super) fn safe_speed(robot: &RobotModel) -> f64 {
    let half_base = 0.5 * robot.wheel_base;
    let mut way = robot.sensors.cliffs.iter().flatten().map(|[x, _]| x - MARGIN).fold(f64::INFINITY, f64::min);
    for i in 0..DIRECTIONS {
        let angle = math::FRAC_PI_2 * f64::from(i) / f64::from(DIRECTIONS);
        let (sin, cos) = (math::sin(angle), math::cos(angle));
        for mirror in [1.0, -1.0] {
            let reach = robot.sensors.cliffs.iter().flatten().map(|[x, y]| x * cos + mirror * y * sin);
            let seen = reach.fold(f64::NEG_INFINITY, f64::max);
            if seen > f64::NEG_INFINITY {
                way = way.min((seen - half_base * sin - MARGIN) / cos);
            }
        }
    }
    if way.is_infinite() {
        return robot.cruise_speed;
    }
    // v * reaction + v^2 / (2 a) = way.
    let a = robot.acceleration;
    let speed = a * ((REACTION_S * REACTION_S + 2.0 * way.max(0.0) / a).sqrt() - REACTION_S);
    speed.clamp(LEAST, robot.cruise_speed.max(LEAST))
}

/// How far to go back from where an edge was first seen, m: so far that a turn on the spot gets no wheel over it, from
/// wherever a single side sensor saw it.
pub(super) fn off_edge(robot: &RobotModel) -> f64 {
    let lead = robot.sensors.cliffs.iter().flatten().map(|[x, _]| *x).fold(f64::INFINITY, f64::min);
    (0.5 * robot.wheel_base - lead + TURN_MARGIN).max(LEAST_BACK)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::{MODELS, model};

    #[test]
    fn a_roomba_need_not_slow_down_and_nobody_exceeds_its_cruise_speed() {
        let roomba = model("roomba600").unwrap();
        assert_eq!(safe_speed(roomba), roomba.cruise_speed);
        assert!(MODELS.iter().all(|robot| safe_speed(robot) <= robot.cruise_speed));
    }

    #[test]
    fn sensors_beside_the_wheels_leave_no_way_to_brake() {
        let mut robot = model("roomba600").unwrap().clone();
        robot.sensors.cliffs = [Some([0.03, 0.12]), Some([0.05, 0.02]), Some([0.05, -0.02]), Some([0.03, -0.12])];
        assert!(safe_speed(&robot) < 0.7 * robot.cruise_speed, "{}", safe_speed(&robot));
    }
}

//! The speed at which a robot can stop before a wheel passes an edge that its cliff sensors have detected.

use robovac_core::{math, robot::RobotModel};

/// Time from detecting an edge to braking, s: one reading.
const REACTION_S: f64 = 0.015;
/// Least floor left under the wheel, m.
const MARGIN: f64 = 0.002;
/// Least floor left around the circle on which the wheels turn, m: braking starts while the robot still rolls.
const TURN_MARGIN: f64 = 0.025;
/// Least way back from an edge, m.
const LEAST_BACK: f64 = 0.06;
/// Least useful speed, m/s.
const LEAST: f64 = 0.08;
/// Directions of corners that are tested to either side of straight ahead, and their distance, rad.
const DIRECTIONS: (i32, f64) = (16, 5.0 * math::PI / 180.0);
/// Positions of corners that are tested to either side of the middle, as shares of the half wheel base.
const PLACES: i32 = 32;

/// The fastest speed straight ahead, m/s, at most the model's cruise speed.
///
/// Drop-offs are assumed to have right-angled corners, of any direction and anywhere ahead; straight edges are no
/// worse. A corner is first detected by one of the sensors, possibly late by a side sensor. From there to the moment
/// when a wheel gets over the edge the robot has a certain way, in which it must react and brake. Without cliff sensors
/// it is the cruise speed. So DVR-1 drives ahead with 0.277 m/s instead of the printed 0.30, as its cliff sensors sit
/// where we drew them (see its model) and its wheels brake by 0.8 m/s², both our figures.
pub(crate) fn safe_speed(robot: &RobotModel) -> f64 {
    let half_base = 0.5 * robot.wheel_base;
    let mut way = f64::INFINITY;
    for direction in -DIRECTIONS.0..=DIRECTIONS.0 {
        let middle = f64::from(direction) * DIRECTIONS.1;
        let sides = [middle - 0.5 * math::FRAC_PI_2, middle + 0.5 * math::FRAC_PI_2];
        let sides = sides.map(|angle| (math::cos(angle), math::sin(angle)));
        for place in -PLACES..=PLACES {
            let at = 1.5 * half_base * f64::from(place) / f64::from(PLACES);
            let seen = robot.sensors.cliffs.iter().flatten().map(|[x, y]| x - inside(sides, y - at));
            let seen = seen.fold(f64::NEG_INFINITY, f64::max);
            for wheel in [half_base, -half_base] {
                let over = -inside(sides, wheel - at);
                if over > f64::NEG_INFINITY && seen > f64::NEG_INFINITY {
                    way = way.min(seen - over - MARGIN);
                }
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

/// How far ahead of a corner's tip a point is that lies `aside` to the left of it when it gets over one of the corner's sides,
/// given as (cosine, sine) of their directions; infinite if it passes them both.
fn inside(sides: [(f64, f64); 2], aside: f64) -> f64 {
    if aside == 0.0 {
        return 0.0;
    }
    let crossed = sides.iter().filter(|(_, sin)| sin * aside > 0.0);
    crossed.map(|(cos, sin)| aside / sin * cos).fold(f64::INFINITY, f64::min)
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
    use robovac_core::robot::{MODELS, model};

    #[test]
    fn the_robots_that_ship_need_not_creep_and_nobody_exceeds_its_cruise_speed() {
        for robot in MODELS {
            let speed = safe_speed(robot);
            assert!(speed > 0.75 * robot.cruise_speed && speed <= robot.cruise_speed, "{}: {speed} m/s", robot.id);
        }
    }

    #[test]
    fn sensors_beside_the_wheels_leave_no_way_to_brake() {
        let mut robot = model("roomba600").unwrap().clone();
        robot.sensors.cliffs = [Some([0.03, 0.12]), Some([0.05, 0.02]), Some([0.05, -0.02]), Some([0.03, -0.12])];
        assert!(safe_speed(&robot) < 0.7 * robot.cruise_speed, "{}", safe_speed(&robot));
    }
}

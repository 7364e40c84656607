//! Paths that are driven smoothly as poses for other programs.

use super::Waypoint;
use robovac_core::{
    geometry::{Pose, difference},
    robot::RobotModel,
    trajectory::{DriveLimits, Trajectory},
};

/// Longest time from one place that is looked at to the next, s: a robot that speeds up by 1 m/s² strays from an even motion by
/// 0.3 mm meanwhile.
const LOOK_S: f64 = 0.05;
/// Farthest that a place that was left out may be from where an even motion between its neighbours has the robot at that time, m and rad.
const NEAR: (f64, f64) = (5e-4, 0.01);

/// Places along a trajectory for `robot`: as few as keep an even motion from each to the next within 1 mm and 1 degree of it, at
/// all times. So the chords of a curve are as near to it, too. Empty for a robot that isn't a differential drive.
pub fn waypoints_along(trajectory: &Trajectory, robot: &RobotModel) -> Vec<Waypoint> {
    let Some(limits) = DriveLimits::of(robot) else { return Vec::new() };
    let looks = looks(trajectory, &limits);
    let Some(&first) = looks.first() else { return Vec::new() };
    let (mut kept, mut from) = (vec![first], 0);
    for to in 2..looks.len() {
        let is_even = |&between: &Waypoint| is_near(&looks[from], &looks[to], &between);
        // A stop to turn begins and ends a piece, so that moves and turns stay apart.
        let is_stop = is_turn(&looks[to - 2..to]) != is_turn(&looks[to - 1..=to]);
        if is_stop || !looks[from + 1..to].iter().all(is_even) {
            from = to - 1;
            kept.push(looks[from]);
        }
    }
    kept.extend(looks.last().filter(|_| looks.len() > 1));
    kept
}

/// Whether nothing but the heading changes between two places.
fn is_turn(pair: &[Waypoint]) -> bool {
    matches!(pair, [a, b] if a.distance == b.distance)
}

/// All knots, with further places between distant ones, each later than the one before.
fn looks(trajectory: &Trajectory, limits: &DriveLimits) -> Vec<Waypoint> {
    let mut looks: Vec<Waypoint> = Vec::with_capacity(trajectory.knots().len());
    for (index, knot) in trajectory.knots().iter().enumerate() {
        let Some(last) = looks.last().copied() else {
            looks.push(Waypoint { pose: knot.pose, distance: knot.distance_m, time: knot.time_s });
            continue;
        };
        let lasts = knot.time_s - last.time;
        if lasts <= 0.0 {
            continue;
        }
        let pieces = (lasts / LOOK_S).ceil();
        for piece in 1..pieces as u32 {
            let time = last.time + lasts * f64::from(piece) / pieces;
            if let Some((_, now)) = trajectory.moment(time, limits, index - 1) {
                looks.push(Waypoint { pose: now.pose, distance: now.distance_m, time });
            }
        }
        looks.push(Waypoint { pose: knot.pose, distance: knot.distance_m, time: knot.time_s });
    }
    looks
}

/// Whether `between` is near an even motion from one place to another.
fn is_near(from: &Waypoint, to: &Waypoint, between: &Waypoint) -> bool {
    let even = evenly(from, to, between.time);
    let off = (even.position() - between.pose.position()).norm();
    off <= NEAR.0 && difference(even.heading, between.pose.heading).abs() <= NEAR.1
}

/// The pose at a time of an even motion from one place to another.
fn evenly(from: &Waypoint, to: &Waypoint, time: f64) -> Pose {
    let share = (time - from.time) / (to.time - from.time);
    let at = from.pose.position() + (to.pose.position() - from.pose.position()) * share;
    Pose::new(at.x, at.y, from.pose.heading + share * difference(from.pose.heading, to.pose.heading))
}

/// Lanes of the Roomba with rounded corners, and every fifth a turn on the spot.
#[cfg(test)]
pub(super) fn lanes(count: usize) -> Trajectory {
    use robovac_core::{
        geometry::Point,
        robot::model,
        trajectory::{RoundedLine, Rounding},
    };
    let x = |i: usize| if i.div_ceil(2).is_multiple_of(2) { 0.0 } else { 2.0 };
    let line: Vec<Point> = (0..2 * count).map(|i| Point::new(x(i), 0.3 * (i / 2) as f64)).collect();
    let rounding = |i: usize| if i.is_multiple_of(5) { Rounding::Stop } else { Rounding::Alone(0.14) };
    let roundings: Vec<Rounding> = (0..line.len()).map(rounding).collect();
    let limits = model("roomba600").and_then(DriveLimits::of).expect("a differential drive");
    Trajectory::new(&RoundedLine::new(&line, 0.3, &roundings), &limits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    #[test]
    fn places_are_few_and_an_even_motion_between_them_is_near() {
        let robot = model("roomba600").unwrap();
        let limits = DriveLimits::of(robot).unwrap();
        let trajectory = lanes(4);
        let places = waypoints_along(&trajectory, robot);
        assert!(places.len() < trajectory.knots().len() / 2, "{} of {}", places.len(), trajectory.knots().len());
        let last = places.last().unwrap();
        assert!((last.time - trajectory.duration_s()).abs() < 1e-12);
        assert!((last.distance - trajectory.length_m()).abs() < 1e-12);
        for pair in places.windows(2) {
            assert!(pair[1].time > pair[0].time);
            assert!(pair[1].distance > pair[0].distance || pair[1].pose.position() == pair[0].pose.position());
            for i in 0..=50 {
                let time = pair[0].time + f64::from(i) / 50.0 * (pair[1].time - pair[0].time);
                let (_, truth) = trajectory.moment(time, &limits, 0).unwrap();
                let even = evenly(&pair[0], &pair[1], time);
                assert!((even.position() - truth.pose.position()).norm() < 1e-3, "{time} s");
                assert!(difference(even.heading, truth.pose.heading).abs() < 1_f64.to_radians(), "{time} s");
            }
        }
        assert!(waypoints_along(&trajectory, model("octagon").unwrap()).is_empty());
        assert!(waypoints_along(&Trajectory::default(), robot).is_empty());
    }
}

//! Where a trajectory is, and how fast, at any time.

use super::{DriveLimits, Trajectory};
use crate::geometry::{Pose, difference};

/// What a trajectory wants at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlannedMoment {
    /// Pose.
    pub pose: Pose,
    /// Way since the start, m.
    pub distance_m: f64,
    /// Speed of the middle between the wheels, m/s.
    pub speed: f64,
    /// Turn rate, rad/s, positive to the left.
    pub turn_rate: f64,
}

impl Trajectory {
    /// The moment at `time_s` seconds, and the index of the last knot before it, which is looked for from the knot `after` on.
    /// Turns on the spot are as fast as `limits` allow. `None` without knots.
    ///
    /// Between two knots the place is on the chord, which is nearer than 0.1 mm to the curve.
    pub fn moment(&self, time_s: f64, limits: &DriveLimits, after: usize) -> Option<(usize, PlannedMoment)> {
        let knots = self.knots();
        let last = knots.len().checked_sub(1)?;
        let mut at = after.min(last);
        while at + 2 < knots.len() && knots[at + 1].time_s <= time_s {
            at += 1;
        }
        let [a, b] = [knots[at], knots[(at + 1).min(last)]];
        let lasts = b.time_s - a.time_s;
        let since = (time_s - a.time_s).clamp(0.0, lasts);
        let turn = difference(a.pose.heading, b.pose.heading);
        let length = b.distance_m - a.distance_m;
        if lasts <= 0.0 {
            return Some((
                at,
                PlannedMoment { pose: b.pose, distance_m: b.distance_m, speed: b.speed, turn_rate: 0.0 },
            ));
        }
        if length <= 0.0 {
            let (share, turn_rate) = turned(limits, turn, since, lasts);
            let pose = Pose::new(a.pose.x, a.pose.y, a.pose.heading + share * turn);
            return Some((at, PlannedMoment { pose, distance_m: a.distance_m, speed: 0.0, turn_rate }));
        }
        // Constant acceleration; the curvature is linear in the way.
        let acceleration = (b.speed - a.speed) / lasts;
        let speed = a.speed + acceleration * since;
        let done = (0.5 * (a.speed + speed) * since / length).clamp(0.0, 1.0);
        let place = a.pose.position() + (b.pose.position() - a.pose.position()) * done;
        let curvature = a.curvature + (b.curvature - a.curvature) * done;
        let turned = done * length * 0.5 * (a.curvature + curvature);
        let pose = Pose::new(place.x, place.y, a.pose.heading + turned);
        let distance_m = a.distance_m + done * length;
        Some((at, PlannedMoment { pose, distance_m, speed, turn_rate: speed * curvature }))
    }
}

/// The share of a turn on the spot by `turn` that is done after `since` of `lasts` seconds, and the turn rate.
fn turned(limits: &DriveLimits, turn: f64, since: f64, lasts: f64) -> (f64, f64) {
    let DriveLimits { wheel_speed, acceleration, half_base, .. } = *limits;
    let ramp = (wheel_speed / acceleration).min(0.5 * lasts);
    let way = |time: f64| match time {
        _ if time < ramp => 0.5 * acceleration * time * time,
        _ => 0.5 * acceleration * ramp * ramp + acceleration * ramp * (time - ramp),
    };
    let whole = 2.0 * way(0.5 * lasts);
    let is_first_half = since < 0.5 * lasts;
    let done = if is_first_half { way(since) } else { whole - way(lasts - since) };
    let wheel = acceleration * since.min(lasts - since).min(ramp);
    (if whole > 0.0 { done / whole } else { 1.0 }, (wheel / half_base).copysign(turn))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        geometry::Point,
        robot::model,
        trajectory::{RoundedLine, Rounding},
    };

    #[test]
    fn a_moment_moves_as_fast_as_it_says() {
        let limits = DriveLimits::of(model("roomba600").unwrap()).unwrap();
        let line = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.3, 1.2]].map(|[x, y]| Point::new(x, y));
        let roundings = [Rounding::Stop, Rounding::Alone(0.15), Rounding::Stop, Rounding::Stop];
        let trajectory = Trajectory::new(&RoundedLine::new(&line, 0.5, &roundings), &limits);
        let (mut at, mut before) = trajectory.moment(0.0, &limits, 0).unwrap();
        let step = 1e-3;
        let count = (trajectory.duration_s() / step) as u32;
        for i in 1..=count {
            let now = f64::from(i) * step;
            let (index, moment) = trajectory.moment(now, &limits, at).unwrap();
            assert!(index >= at && trajectory.knots()[index].time_s <= now);
            let moved = (moment.pose.position() - before.pose.position()).norm();
            assert!((moved - 0.5 * step * (moment.speed + before.speed)).abs() < 1e-5, "{now} s: {moved}");
            assert!((moved - (moment.distance_m - before.distance_m)).abs() < 1e-5);
            let turned = difference(before.pose.heading, moment.pose.heading);
            assert!((turned - 0.5 * step * (moment.turn_rate + before.turn_rate)).abs() < 2e-4, "{now} s: {turned}");
            (at, before) = (index, moment);
        }
        let end = trajectory.knots().last().unwrap();
        let (_, moment) = trajectory.moment(1e9, &limits, 0).unwrap();
        assert_eq!((moment.pose, moment.speed, moment.distance_m), (end.pose, 0.0, trajectory.length_m()));
        assert_eq!(Trajectory::default().moment(0.0, &limits, 0), None);
    }
}

//! Drives a planned trajectory by dead reckoning.

use super::{Controller, FollowPath};
use robovac_core::{
    geometry::{Pose, difference},
    robot::{Drive, RobotModel, SensorReadings},
    trajectory::{DriveLimits, Knot, Trajectory},
};
use std::sync::Arc;

/// Correction of the speed per metre behind, 1/s; of the turn rate per metre driven and metre beside, 1/m², and per radian, 1/s.
const GAINS: [f64; 3] = [3.0, 60.0, 5.0];
/// Most correction of the turn rate, rad/s.
const MOST_STEER: f64 = 2.0;
/// How far behind the clock slows down, m, and how much farther it stands still.
const BEHIND: [f64; 2] = [0.02, 0.01];
/// Farthest behind or ahead, m, beside, m, and off the heading, rad; beyond, it stops and turns to the next corner.
const LOST: [f64; 3] = [0.04, 0.03, 0.7];
/// The same for going over to the trajectory on a straight piece: beside, m, off the heading, rad, and speed, m/s.
const ON_PATH: [f64; 3] = [0.01, 0.05, 0.06];
/// Way back from an edge or an obstacle that is certain in a curve, m.
const KNOWN_IN_CURVE: f64 = 0.04;

/// Follows a trajectory: speeds and turn rates as planned, with a correction by the place and heading where the robot should be
/// (Kanayama et al., A stable tracking control method for an autonomous mobile robot, ICRA 1990). The clock waits for a robot
/// that falls behind.
///
/// Bumps, edges and whatever else takes it off the path are left to a [`FollowPath`] on the same line, until this drives
/// straight along a piece of the trajectory again.
#[derive(Debug, Clone)]
pub struct FollowSmoothly {
    /// Keeps the estimate, and drives while the trajectory can't be followed.
    inner: FollowPath,
    trajectory: Arc<Trajectory>,
    limits: DriveLimits,
    top_wheel_speed: f64,
    /// Where the robot should be: time since the trajectory's start, s, and index of the knot that was passed last.
    time_s: f64,
    at: usize,
    is_tracking: bool,
    /// The last estimate.
    last: Pose,
}

impl FollowSmoothly {
    /// Follows `trajectory`, which rounds corners of the line of `inner`. `None` for a robot that isn't a differential drive.
    pub fn new(robot: &RobotModel, inner: FollowPath, trajectory: Arc<Trajectory>) -> Option<Self> {
        let limits = DriveLimits::of(robot)?;
        Some(Self {
            is_tracking: trajectory.knots().len() > 1,
            last: inner.pose(),
            inner,
            trajectory,
            limits,
            top_wheel_speed: robot.max_wheel_speed,
            time_s: 0.0,
            at: 0,
        })
    }

    /// What drives while the trajectory can't be followed.
    pub(super) fn path(&self) -> &FollowPath {
        &self.inner
    }

    /// The same, to be changed.
    pub(super) fn path_mut(&mut self) -> &mut FollowPath {
        &mut self.inner
    }

    /// Something else drives from now on.
    pub(super) fn pause(&mut self) {
        if self.is_tracking {
            self.leave();
        }
    }

    /// The knot passed last and the next one.
    fn stretch(&self) -> Option<[Knot; 2]> {
        let knots = self.trajectory.knots();
        Some([*knots.get(self.at)?, *knots.get(self.at + 1)?])
    }

    /// Whether the robot must react to something; if so, it leaves the trajectory.
    fn is_interrupted(&mut self, sensed: &SensorReadings) -> bool {
        let Some([a, b]) = self.stretch() else { return false };
        let is_turn = a.distance_m == b.distance_m;
        // On a dock, whose ramp is black, all cliff sensors report an edge.
        let sees_edge = sensed.sees_cliff() && !sensed.battery.on_dock;
        let is_stopped = sensed.wheel_dropped() || sees_edge;
        if !is_stopped && (is_turn || !(sensed.bumped() || sensed.virtual_wall)) {
            return false;
        }
        self.is_tracking = false;
        let heading = is_turn.then_some(b.pose.heading);
        // The way back is along the heading: in a curve, only a little of it is the way that it has come.
        let pose = self.inner.pose();
        let is_straight = a.curvature == 0.0 && b.curvature == 0.0;
        let known = if is_straight { self.straight_behind(pose) } else { KNOWN_IN_CURVE };
        let began = pose.position() - pose.direction() * known;
        let corner = self.corner_ahead(pose);
        self.inner.take_over(corner, began, heading);
        true
    }

    /// Length of the straight way that it has come, m.
    fn straight_behind(&self, pose: Pose) -> f64 {
        let is_along = |knot: &&Knot| {
            knot.curvature == 0.0 && difference(knot.pose.heading, pose.heading).abs() < ON_PATH[1] + LOST[1]
        };
        let knots = self.trajectory.knots()[..=self.at].iter().rev().take_while(is_along);
        knots.map(|knot| (knot.pose.position() - pose.position()).norm()).fold(0.0, f64::max)
    }

    /// Number of the corner to drive to: in the second half of a curve the one after it.
    fn corner_ahead(&self, pose: Pose) -> usize {
        let knots = &self.trajectory.knots()[self.at..];
        let Some(next) = knots.get(1) else { return 0 };
        let mut curve = knots.iter().filter(|knot| knot.corner == next.corner).map(|knot| knot.curvature.abs());
        let end = knots.iter().take_while(|knot| knot.corner == next.corner).last();
        let is_leaving = next.curvature != 0.0
            && curve.all(|other| other <= next.curvature.abs())
            && end.is_some_and(|end| difference(pose.heading, end.pose.heading).abs() < 1.0);
        next.corner + usize::from(is_leaving)
    }

    /// Gives the trajectory up for now: stops, and drives to the next corner.
    fn leave(&mut self) -> Drive {
        self.is_tracking = false;
        let corner = self.corner_ahead(self.inner.pose());
        self.inner.take_over_at_rest(corner);
        Drive::STOP
    }

    /// One step along the trajectory.
    fn track(&mut self, dt_s: f64) -> Drive {
        let pose = self.inner.pose();
        let Some((_, now)) = self.trajectory.moment(self.time_s, &self.limits, self.at) else { return self.leave() };
        let behind = now.pose.position() - pose.position();
        let ahead = pose.direction();
        let (along, beside) = (ahead.dot(&behind), ahead.perp(&behind));
        let askew = difference(pose.heading, now.pose.heading);
        if along.abs() > LOST[0] || beside.abs() > LOST[1] || askew.abs() > LOST[2] {
            return self.leave();
        }
        self.time_s += dt_s * (1.0 - (along - BEHIND[0]) / BEHIND[1]).clamp(0.0, 1.0);
        // Speeds are reached one step later.
        let Some((at, next)) = self.trajectory.moment(self.time_s, &self.limits, self.at) else { return self.leave() };
        self.at = at;
        if self.time_s >= self.trajectory.duration_s() {
            self.inner.finish();
            return Drive::STOP;
        }
        let speed = next.speed + GAINS[0] * along;
        let steer = GAINS[1] * next.speed * beside + GAINS[2] * askew;
        let turn_rate = next.turn_rate + steer.clamp(-MOST_STEER, MOST_STEER);
        let drive = Drive::from_twist(speed, turn_rate, 2.0 * self.limits.half_base);
        let fastest = drive.left.abs().max(drive.right.abs());
        if fastest > self.top_wheel_speed { drive.times(self.top_wheel_speed / fastest) } else { drive }
    }

    /// Takes the trajectory up again if the robot drives along one of its straight pieces, as fast as planned.
    fn rejoin(&mut self, dt_s: f64) {
        let Some(corner) = self.inner.straight_to() else { return };
        let pose = self.inner.pose();
        let speed = (pose.position() - self.last.position()).norm() / dt_s;
        let knots = self.trajectory.knots();
        let first = knots.partition_point(|knot| knot.corner < corner);
        let pieces = knots.windows(2).enumerate().skip(first.saturating_sub(1));
        for (index, pair) in pieces.take_while(|(_, pair)| pair[0].corner <= corner) {
            let [a, b] = [pair[0], pair[1]];
            let length = b.distance_m - a.distance_m;
            if length <= 0.0 || a.curvature != 0.0 || b.curvature != 0.0 || b.corner != corner {
                continue;
            }
            let from = pose.position() - a.pose.position();
            let along = a.pose.direction();
            let (done, beside) = (from.dot(&along), along.perp(&from));
            let askew = difference(a.pose.heading, pose.heading);
            if !(0.0..length).contains(&done) || beside.abs() > ON_PATH[0] || askew.abs() > ON_PATH[1] {
                continue;
            }
            let planned = (a.speed * a.speed + (b.speed * b.speed - a.speed * a.speed) * done / length).sqrt();
            if (planned - speed).abs() < ON_PATH[2] && planned > 0.0 {
                (self.at, self.is_tracking) = (index, true);
                self.time_s = a.time_s + 2.0 * done / (a.speed + planned);
            }
            return;
        }
    }
}

impl Controller for FollowSmoothly {
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive {
        let drive = if self.is_tracking && !self.is_interrupted(sensed) {
            self.inner.watch_pose(sensed);
            self.track(dt_s)
        } else {
            let drive = self.inner.step(sensed, dt_s);
            self.rejoin(dt_s);
            drive
        };
        self.last = self.inner.pose();
        drive
    }

    fn is_done(&self) -> bool {
        self.inner.is_done()
    }

    fn estimate(&self) -> Option<Pose> {
        self.inner.estimate()
    }

    fn activity(&self) -> &'static str {
        if self.is_tracking { "" } else { self.inner.activity() }
    }

    fn corner(&self) -> Option<usize> {
        match self.stretch() {
            Some([_, b]) if self.is_tracking && !self.is_done() => Some(b.corner),
            _ => self.inner.corner(),
        }
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}

//! Drives a planned line by dead reckoning.

use super::{Controller, parts::safe_speed};
use crate::contact::Footprint;
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Pose, Vector, difference},
    math,
    robot::{Drive, Odometry, OdometryModel, RobotModel, SensorReadings, WheelLayout},
};
use std::sync::Arc;

/// A turn or a straight piece counts as done when this much wheel travel is left, m.
const CLOSE_ENOUGH: f64 = 0.001;
/// Way back from a wall, m.
const BACK_OFF: f64 = 0.03;
/// Way back from an edge, m, enough that turning on the spot brings no wheel over it; never more than the robot has
/// driven since it last turned.
const BACK_FROM_EDGE: f64 = 0.1;
/// How long to wait for a person or pet in the way, s, and the least rest of a piece for which to wait, m.
const WAIT: (f64, f64) = (3.0, 0.3);
/// Way back from an edge detected while turning, m.
const SHY: f64 = 0.04;
/// Time with one wheel over an edge after which it gives up, s.
const HUNG_S: f64 = 10.0;
/// Most waits.
const MOST_WAITS: u32 = 3;
/// Shift of the line away from the side that was bumped, m.
const NUDGE: f64 = 0.015;
/// Bumps after which the rest of a straight piece is given up.
const MOST_BUMPS: u32 = 4;
/// Readings without a count after which the wheels count as at rest.
const STILL: u32 = 3;
/// Heading correction per metre off the line, rad/m, and its limit, rad.
const STEER: (f64, f64) = (6.0, 0.5);
/// Turn rate per radian of heading error, 1/s.
const TURN_GAIN: f64 = 6.0;
/// Least heading error that is corrected on the way by packets of distance and angle, rad: their whole degrees don't show
/// smaller turns, so that it would turn again and again.
const UNSEEN: f64 = 0.035;

/// A bump where a wall of the known room is nearer than this to the body, at the estimated pose, is no surprise, m.
const EXPECTED: f64 = 0.02;

/// Speed back to the line per metre off it, 1/s, for a robot that moves in all directions.
const SIDESTEP: f64 = 3.0;

/// Follows a line of corners: turns on the spot towards the next corner, drives straight to it, and so on. An
/// omnidirectional robot keeps its heading instead.
///
/// It steers by its own estimate of the pose, from odometry. A wall where the line should be free means that the
/// estimate is off: the robot backs off, shifts the piece of line away from the side that it bumped, and tries again; a
/// frontal bump or the fourth one ends the piece, but if much of it is left, it waits up to three times, as the
/// obstacle can be a person or pet. An edge or the beam of a virtual wall ends the piece at once. So it always comes to
/// the end of the line.
#[derive(Debug, Clone)]
pub struct FollowPath {
    robot: RobotModel,
    model: OdometryModel,
    odometry: Odometry,
    /// With distance and angle, which are reported four times a second: the pose since the last report, by counts.
    since_report: Option<Odometry>,
    line: Arc<[Point]>,
    /// Index in `line` of the corner that the robot drives to.
    next: usize,
    phase: FollowPhase,
    bumps: u32,
    waits: u32,
    /// How long one wheel has hung over an edge, s.
    hung_s: f64,
    /// Where the robot last turned or started.
    began: Point,
    /// Shift of the present piece to the left of its direction, m.
    shift: f64,
    /// Fastest speed straight ahead, m/s.
    cruise: f64,
    is_careful: bool,
    /// Seconds after which the present piece is given up, so that slip and walls don't hold the robot for ever.
    patience: f64,
    /// The encoders' last counts, and how many readings ago they changed.
    counts: [u16; 3],
    still: u32,
    /// Heading that a robot that moves in all directions keeps, rad.
    heading: f64,
    /// The room, if contacts with its walls are part of the path.
    known: Option<(Arc<ReachableFloor>, Footprint)>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum FollowPhase {
    /// Wait until the wheels stand still: turning before would carry the robot off the line.
    Stop,
    /// Turn on the spot to this heading.
    Turn(f64),
    /// Turned; wait until the wheels stand still.
    Settle,
    Drive,
    /// Reverse from this point, so far.
    BackOff(Point, f64, AfterBump),
    /// Give way for so many seconds.
    Wait(f64),
    Done,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum AfterBump {
    TryAgain,
    Wait,
    GiveUp,
}

impl FollowPath {
    /// Follows `line`, metres, with the robot at `start`.
    pub fn new(robot: &RobotModel, odometry: OdometryModel, start: Pose, line: Arc<[Point]>) -> Self {
        let mut follower = Self {
            robot: robot.clone(),
            model: odometry,
            cruise: robot.cruise_speed,
            is_careful: false,
            odometry: Odometry::new(robot, odometry, start),
            since_report: odometry.is_by_packets().then(|| Odometry::new(robot, OdometryModel::Arc, start)),
            line,
            next: 0,
            phase: FollowPhase::Done,
            bumps: 0,
            waits: 0,
            hung_s: 0.0,
            began: start.position(),
            shift: 0.0,
            patience: 0.0,
            counts: [0; 3],
            still: 0,
            heading: start.heading,
            known: None,
        };
        follower.next_piece();
        follower
    }

    /// For rooms with stairs: no faster than it can stop before an edge that its cliff sensors detect, and always in
    /// the direction of these sensors.
    pub fn carefully(mut self) -> Self {
        self.cruise = safe_speed(&self.robot);
        self.is_careful = true;
        self
    }

    /// A follower of another line from here, with the same estimate of the pose.
    pub(super) fn onto(&self, line: Arc<[Point]>) -> Self {
        let mut other = Self { line, next: 0, ..self.clone() };
        other.next_piece();
        other
    }

    /// Takes a reading while something else drives.
    pub(super) fn watch(&mut self, sensed: &SensorReadings) {
        self.watch_pose(sensed);
    }

    /// Corrects its estimate of the pose; the wheels are at rest.
    pub(super) fn relocate(&mut self, pose: Pose) {
        self.odometry = Odometry::new(&self.robot, self.model, pose);
        self.since_report = self.since_report.is_some().then(|| Odometry::new(&self.robot, OdometryModel::Arc, pose));
    }

    /// Drives on to the corner that was next, from wherever it is.
    pub(super) fn resume(&mut self) {
        if self.phase != FollowPhase::Done {
            self.next -= 1;
            self.next_piece();
        }
    }

    /// The robot.
    pub(super) fn robot(&self) -> &RobotModel {
        &self.robot
    }

    /// Continues by itself on the way to corner number `corner`, from `began` on, with the wheels turning: on the straight piece
    /// there, or turning on the spot to `heading` before it.
    pub(super) fn take_over(&mut self, corner: usize, began: Point, heading: Option<f64>) {
        self.next = corner.saturating_sub(1);
        self.next_piece();
        self.began = began;
        if self.phase != FollowPhase::Done {
            self.phase = heading.map_or(FollowPhase::Drive, FollowPhase::Turn);
        }
    }

    /// The same after a stop: it turns to the corner, and drives there.
    pub(super) fn take_over_at_rest(&mut self, corner: usize) {
        self.next = corner.saturating_sub(1);
        self.next_piece();
    }

    /// The end was reached.
    pub(super) fn finish(&mut self) {
        self.next = self.line.len();
        self.phase = FollowPhase::Done;
    }

    /// Number of the corner to which it drives on the straight piece itself, if it does.
    pub(super) fn straight_to(&self) -> Option<usize> {
        (self.phase == FollowPhase::Drive && self.shift == 0.0).then_some(self.next)
    }

    /// For a path that may touch: a bump where the room has a wall doesn't mean that the estimate is off, and the robot
    /// slides along.
    pub fn knowing(mut self, floor: &Arc<ReachableFloor>) -> Self {
        self.known = Some((Arc::clone(floor), Footprint::new(&self.robot)));
        self
    }

    /// Whether the known room has a wall beside the body.
    fn expects_contact(&mut self) -> bool {
        let pose = self.pose();
        self.known.as_mut().is_some_and(|(floor, footprint)| footprint.is_near_walls(&floor.walls, pose, EXPECTED))
    }

    fn next_piece(&mut self) {
        self.next += 1;
        // Between two corners in one place there is no direction to drive in.
        while self.next < self.line.len() && self.line[self.next] == self.line[self.next - 1] {
            self.next += 1;
        }
        self.bumps = 0;
        self.waits = 0;
        self.shift = 0.0;
        self.phase = FollowPhase::Done;
        if self.next < self.line.len() {
            let length = (self.line[self.next] - self.pose().position()).norm();
            self.patience = 15.0 + 3.0 * self.robot.straight_time(length);
            self.phase = FollowPhase::Stop;
        }
    }

    /// Its estimate of the pose.
    pub(super) fn pose(&self) -> Pose {
        self.since_report.as_ref().unwrap_or(&self.odometry).pose()
    }

    /// Takes a reading into the estimate.
    pub(super) fn watch_pose(&mut self, sensed: &SensorReadings) {
        self.odometry.update(sensed);
        if let Some(since_report) = &mut self.since_report {
            if sensed.moved.is_some() {
                *since_report = Odometry::new(&self.robot, OdometryModel::Arc, self.odometry.pose());
            }
            since_report.update(sensed);
        }
    }

    fn watch_wheels(&mut self, sensed: &SensorReadings) {
        let counts = [sensed.left_counts, sensed.right_counts, sensed.lateral_counts];
        self.still = if counts == self.counts { self.still + 1 } else { 0 };
        self.counts = counts;
    }

    fn is_resting(&self) -> bool {
        self.still >= STILL
    }

    fn moves_sideways(&self) -> bool {
        self.robot.wheels == WheelLayout::Omnidirectional && !self.is_careful
    }

    fn face_next_corner(&mut self) {
        if self.moves_sideways() {
            self.began = self.pose().position();
            self.phase = FollowPhase::Drive;
            return;
        }
        let pose = self.pose();
        let (from, to) = self.piece();
        // Close to a corner its bearing is inaccurate; the direction of the line is used.
        let aim = to - pose.position();
        let aim = if aim.norm() > 2.0 * NUDGE + BACK_OFF { aim } else { to - from };
        self.phase = FollowPhase::Turn(math::atan2(aim.y, aim.x));
    }

    /// Ends of the present piece, shifted.
    fn piece(&self) -> (Point, Point) {
        let (from, to) = (self.line[self.next - 1], self.line[self.next]);
        let along = (to - from).normalize();
        let left = Vector::new(-along.y, along.x) * self.shift;
        (from + left, to + left)
    }

    fn turn(&mut self, heading: f64) -> Drive {
        let error = difference(self.pose().heading, heading);
        let travel = 0.5 * self.robot.wheel_base * error;
        if travel.abs() < CLOSE_ENOUGH {
            self.phase = FollowPhase::Settle;
            return Drive::STOP;
        }
        let wheel = self.braking_speed(travel.abs()).min(self.robot.turn_wheel_speed) * travel.signum();
        Drive::wheels(-wheel, wheel)
    }

    fn drive(&mut self) -> Drive {
        let pose = self.pose();
        let (from, to) = self.piece();
        let along = (to - from).normalize();
        let left_over = (to - pose.position()).dot(&along);
        if left_over < CLOSE_ENOUGH {
            self.next_piece();
            return Drive::STOP;
        }
        let off_line = along.perp(&(pose.position() - from));
        if self.moves_sideways() {
            let speed = self.braking_speed(left_over).min(self.cruise);
            let aside = (-SIDESTEP * off_line).clamp(-0.5 * speed, 0.5 * speed);
            return self.glide(along * speed + Vector::new(-along.y, along.x) * aside);
        }
        let correction = (-STEER.0 * off_line).clamp(-STEER.1, STEER.1);
        let heading = math::atan2(along.y, along.x) + correction;
        let speed = self.braking_speed(left_over).min(self.cruise);
        // Limited by the speed, so that the robot doesn't oscillate where it stops.
        let sharpest = speed / self.robot.wheel_base;
        let error = difference(pose.heading, heading);
        let is_unseen = self.since_report.is_some() && error.abs() < UNSEEN;
        let turn_rate = if is_unseen { 0.0 } else { (TURN_GAIN * error).clamp(-sharpest, sharpest) };
        Drive::from_twist(speed, turn_rate, self.robot.wheel_base)
    }

    /// Moves at a velocity in the plane, m/s, without turning.
    fn glide(&self, velocity: Vector) -> Drive {
        let pose = self.pose();
        let ahead = pose.direction();
        let turn_rate = TURN_GAIN * difference(pose.heading, self.heading);
        let drive = Drive::from_twist(velocity.dot(&ahead), turn_rate.clamp(-0.5, 0.5), self.robot.wheel_base);
        Drive { lateral: ahead.perp(&velocity), ..drive }
    }

    /// The speed from which the robot can stop within `distance` metres, with a margin of a tenth.
    fn braking_speed(&self, distance: f64) -> f64 {
        (2.0 * 0.9 * self.robot.acceleration * distance).sqrt()
    }

    fn bumped(&mut self, sensed: &SensorReadings) {
        self.bumps += 1;
        if self.moves_sideways() {
            // The bumper's sides are those of the body, not of the line: it tries one side, then the other, farther
            // each time.
            let side = if self.bumps.is_multiple_of(2) { -1.0 } else { 1.0 };
            self.shift = side * NUDGE * f64::from(self.bumps.div_ceil(2));
            let then = if self.bumps >= MOST_BUMPS { AfterBump::GiveUp } else { AfterBump::TryAgain };
            self.phase = FollowPhase::BackOff(self.pose().position(), BACK_OFF, then);
            return;
        }
        let at = self.pose().position();
        let frontal = sensed.bump_left && sensed.bump_right;
        let is_early = (self.line[self.next] - at).norm() > WAIT.1;
        let then = match frontal || self.bumps >= MOST_BUMPS {
            false => AfterBump::TryAgain,
            true if is_early && self.waits < MOST_WAITS => AfterBump::Wait,
            true => AfterBump::GiveUp,
        };
        self.shift += if sensed.bump_left { -NUDGE } else { NUDGE };
        self.phase = FollowPhase::BackOff(at, BACK_OFF, then);
    }

    /// Reacts to an edge or a virtual wall ahead: back over the way that it has come.
    fn turned_back(&mut self) {
        let at = self.pose().position();
        let way = BACK_FROM_EDGE.min((at - self.began).norm());
        self.phase = FollowPhase::BackOff(at, way, AfterBump::GiveUp);
    }

    /// Reacts to an edge that a wheel approaches in a turn: a little back, then the turn again.
    fn shied(&mut self) {
        self.bumps += 1;
        let then = if self.bumps >= MOST_BUMPS { AfterBump::GiveUp } else { AfterBump::TryAgain };
        self.phase = FollowPhase::BackOff(self.pose().position(), SHY, then);
    }

    fn back_off(&mut self, from: Point, way: f64, then: AfterBump) -> Drive {
        let left_over = way - (self.pose().position() - from).norm();
        if left_over < CLOSE_ENOUGH {
            match then {
                AfterBump::TryAgain => self.phase = FollowPhase::Stop,
                AfterBump::Wait => {
                    self.waits += 1;
                    self.patience += WAIT.0;
                    (self.bumps, self.shift) = (0, 0.0);
                    self.phase = FollowPhase::Wait(WAIT.0);
                }
                AfterBump::GiveUp => self.next_piece(),
            }
            return Drive::STOP;
        }
        let speed = self.braking_speed(left_over).min(0.5 * self.cruise);
        if self.moves_sideways() {
            let (start, end) = self.piece();
            return self.glide((start - end).normalize() * speed);
        }
        Drive::from_twist(-speed, 0.0, self.robot.wheel_base)
    }
}

impl Controller for FollowPath {
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive {
        self.watch_pose(sensed);
        if sensed.wheel_dropped() {
            // A lifted robot has both wheels dropped; with one over an edge it can't get away.
            let is_held = sensed.wheel_drop_left && sensed.wheel_drop_right;
            self.hung_s = if is_held { 0.0 } else { self.hung_s + dt_s };
            if self.hung_s > HUNG_S {
                self.phase = FollowPhase::Done;
            }
            return Drive::STOP;
        }
        self.hung_s = 0.0;
        // On a dock, whose ramp is black, all cliff sensors report an edge.
        let sees_edge = sensed.sees_cliff() && !sensed.battery.on_dock;
        let is_surprised = sensed.bumped() && !self.expects_contact();
        match self.phase {
            FollowPhase::Drive if sees_edge || sensed.virtual_wall => self.turned_back(),
            FollowPhase::Turn(_) if sees_edge => self.shied(),
            FollowPhase::Drive if is_surprised => self.bumped(sensed),
            _ => {}
        }
        self.patience -= dt_s;
        if self.patience < 0.0 && self.phase != FollowPhase::Done {
            self.next_piece();
        }
        self.watch_wheels(sensed);
        match self.phase {
            FollowPhase::Stop => {
                if self.is_resting() {
                    self.face_next_corner();
                }
                Drive::STOP
            }
            FollowPhase::Settle => {
                if self.is_resting() {
                    self.began = self.pose().position();
                    self.phase = FollowPhase::Drive;
                }
                Drive::STOP
            }
            FollowPhase::Turn(heading) => self.turn(heading),
            FollowPhase::Drive => self.drive(),
            FollowPhase::BackOff(from, way, then) => self.back_off(from, way, then),
            FollowPhase::Wait(left) => {
                self.phase = if left > dt_s { FollowPhase::Wait(left - dt_s) } else { FollowPhase::Stop };
                Drive::STOP
            }
            FollowPhase::Done => Drive::STOP,
        }
    }

    fn is_done(&self) -> bool {
        self.phase == FollowPhase::Done
    }

    fn estimate(&self) -> Option<Pose> {
        Some(self.pose())
    }

    fn activity(&self) -> &'static str {
        match self.phase {
            FollowPhase::BackOff(..) => "backing up",
            FollowPhase::Wait(_) => "waiting, the path is blocked",
            _ => "",
        }
    }

    fn corner(&self) -> Option<usize> {
        Some(self.next)
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}

//! The messages of a simulated run, for a bag or a node.

use super::{
    frames::{BASE, LASER, MAP, ODOM, compose, frame_of},
    message::{self, BatteryState, BumperState, Velocity, velocity, velocity_of},
    topic::{self, Stamped, Topic},
};
use coverage_planners::sweep::{Waypoint, waypoints, waypoints_along};
use robovac_core::{
    coverage::with_objects,
    floor_plan::FloorPlan,
    geometry::{Point, Pose},
    robot::{Odometry, OdometryModel, RobotModel},
    trajectory::Trajectory,
};
use robovac_sim::Run;
use std::sync::Arc;

/// Least simulated time between two messages of the battery and of a map that the robot makes, s.
const BATTERY_S: f64 = 1.0;
const MAP_S: f64 = 10.0;
/// Rounding of times, s: seconds since 1970 have no more digits.
const EPSILON_S: f64 = 1e-5;
/// Source of events.
const NAME: &str = "robovac";

/// Times and rates of messages.
#[derive(Debug, Clone, Copy)]
pub struct Pace {
    /// The run's start in the stamps, s.
    pub epoch_s: f64,
    /// Least simulated time between two messages of odometry, frames, commands, and contacts that don't change, s.
    pub odometry_s: f64,
}

impl Pace {
    /// For files: ten poses a second, from 0; a half hour of a Roomba takes 35 MB.
    pub const FILE: Self = Self { epoch_s: 0.0, odometry_s: 0.1 };
    /// For nodes: what planners of local paths expect, from 0.
    pub const LIVE: Self = Self { epoch_s: 0.0, odometry_s: 0.045 };
}

/// Where a run takes place.
#[derive(Debug, Clone, Copy)]
pub struct SourceMap<'a> {
    /// The room; its origin gives the frame of the map.
    pub plan: &'a FloorPlan,
    /// The robot.
    pub robot: &'a RobotModel,
    /// Corners of its planned path in the room, m; empty without one.
    pub path: &'a [Point],
    /// How it is driven smoothly; `None` with a stop at each corner.
    pub smooth: Option<&'a Trajectory>,
}

impl SourceMap<'_> {
    /// The robot's places along its path, from `heading` rad: all stops, or places along the trajectory.
    pub(crate) fn places(&self, heading: f64) -> Vec<Waypoint> {
        self.smooth.map_or_else(
            || waypoints(self.path, heading, self.robot),
            |trajectory| waypoints_along(trajectory, self.robot),
        )
    }

    pub(crate) fn plan_of(&self, stops: &[Waypoint], epoch_s: f64) -> super::Cdr {
        let at = |stop: &Waypoint| (epoch_s + stop.time, compose(self.plan.origin, stop.pose));
        message::path(epoch_s, &stops.iter().map(at).collect::<Vec<_>>())
    }
}

/// Turns a run into messages: call [`RunTopics::step`] after every step, and take the messages.
pub struct RunTopics {
    robot: RobotModel,
    pace: Pace,
    origin: Pose,
    start: Pose,
    /// From where it started.
    odometry: Odometry,
    out: Vec<Stamped>,
    /// Time of the last odometry, with the pose there and the true one.
    told: Option<(f64, [Pose; 2])>,
    battery_s: f64,
    map_s: f64,
    command: Option<Velocity>,
    contacts: Option<(BumperState, [bool; 4])>,
    has_dropped: Option<bool>,
    scan: Option<Arc<[f32]>>,
    /// Steps before the last event that was told, and how many of that step.
    events: (u64, usize),
}

impl RunTopics {
    /// The messages of `run`, which has just begun in `source`. Those of its first moment can be taken at once.
    pub fn new(source: &SourceMap<'_>, run: &Run, pace: Pace) -> Self {
        let (robot, start) = (source.robot, run.floor().start);
        let mut topics = Self {
            robot: robot.clone(),
            pace,
            origin: source.plan.origin,
            start,
            odometry: Odometry::new(robot, OdometryModel::Arc, Pose::new(0.0, 0.0, 0.0)),
            out: Vec::new(),
            told: None,
            battery_s: f64::NEG_INFINITY,
            map_s: f64::NEG_INFINITY,
            command: None,
            contacts: None,
            has_dropped: None,
            scan: None,
            events: (0, 0),
        };
        topics.begin(source, run);
        topics
    }

    fn begin(&mut self, source: &SourceMap<'_>, run: &Run) {
        let began = self.now(run);
        if let Some(laser) = self.robot.sensors.laser {
            let at = Pose::new(laser.at[0], laser.at[1], 0.0);
            self.put(&topic::TF_STATIC, began, message::transforms(began, &[(BASE, LASER, at)]));
        }
        let room = message::occupancy_grid(began, &with_objects(source.plan), self.origin);
        self.put(if run.mapper().is_some() { &topic::TRUE_MAP } else { &topic::MAP }, began, room);
        if !source.path.is_empty() {
            let places = source.places(self.start.heading);
            self.put(&topic::PLAN, began, source.plan_of(&places, began));
        }
        self.tell(run);
    }

    /// Takes the run's next step.
    pub fn step(&mut self, run: &Run) {
        self.odometry.update(run.sensors());
        self.tell(run);
    }

    /// The robot.
    pub fn robot(&self) -> &RobotModel {
        &self.robot
    }

    /// The messages since the last call, in the order of their times.
    pub fn take(&mut self) -> std::vec::Drain<'_, Stamped> {
        self.out.drain(..)
    }

    /// The map at the end of a run, if the robot makes one.
    pub fn finish(&mut self, run: &Run) {
        self.map_s = f64::NEG_INFINITY;
        self.tell_map(run);
    }

    /// The time in the stamps.
    fn now(&self, run: &Run) -> f64 {
        self.pace.epoch_s + run.time_s()
    }

    fn tell(&mut self, run: &Run) {
        let now = self.now(run);
        let sensed = run.sensors();
        let is_due = self.told.is_none_or(|(at, _)| now - at >= self.pace.odometry_s - EPSILON_S);
        let contacts = (BumperState::of(sensed), sensed.cliff);
        let flags = |(bumper, cliff): (BumperState, [bool; 4])| (bumper.pressed, bumper.light, cliff);
        if is_due || self.contacts.map(flags) != Some(flags(contacts)) {
            self.tell_contacts(now, contacts);
        }
        if self.robot.sensors.wheel_drops {
            let dropped = sensed.wheel_dropped();
            if self.has_dropped.replace(dropped) != Some(dropped) {
                self.put(&topic::WHEEL_DROP, now, message::flag(dropped));
            }
        }
        if is_due {
            let command = velocity_of(run.commanded(), self.robot.wheel_base);
            if self.command.replace(command) != Some(command) {
                self.put(&topic::CMD_VEL, now, message::twist(command));
            }
            self.tell_poses(run);
        }
        if let Some((laser, scan)) = self.robot.sensors.laser.zip(sensed.laser.as_ref())
            // A new scan is another list.
            && self.scan.as_ref().is_none_or(|last| !Arc::ptr_eq(last, scan))
        {
            self.scan = Some(Arc::clone(scan));
            self.put(&topic::SCAN, now, message::laser_scan(now, &laser, scan));
        }
        if now - self.battery_s >= BATTERY_S - EPSILON_S
            && let Some(battery) = BatteryState::of(sensed)
        {
            self.battery_s = now;
            self.put(&topic::BATTERY, now, message::battery(now, &battery));
        }
        self.tell_map(run);
        self.tell_events(run);
    }

    fn tell_contacts(&mut self, now: f64, contacts: (BumperState, [bool; 4])) {
        self.contacts = Some(contacts);
        let sensors = &self.robot.sensors;
        let (has_bumper, has_cliffs) =
            (sensors.bumper.is_some() || sensors.light_bumper.is_some(), sensors.cliffs.iter().any(Option::is_some));
        if has_bumper {
            self.put(&topic::BUMPER, now, message::bumper(now, &contacts.0));
        }
        if has_cliffs {
            self.put(&topic::CLIFF, now, message::cliff(now, contacts.1));
        }
    }

    fn tell_poses(&mut self, run: &Run) {
        let now = self.now(run);
        let poses = [self.odometry.pose(), compose(self.origin, run.pose())];
        let speeds =
            self.told.map_or([[0.0; 3]; 2], |(at, before)| [0, 1].map(|i| velocity(before[i], poses[i], now - at)));
        self.told = Some((now, poses));
        let [pose, truth] = poses;
        self.put(&topic::ODOM, now, message::odometry(now, ODOM, pose, speeds[0]));
        self.put(&topic::TRUE_POSE, now, message::odometry(now, MAP, truth, speeds[1]));
        // What the robot estimates beyond odometry is where odometry began.
        let estimate = run.estimate().unwrap_or(self.start);
        let began = compose(self.origin, frame_of(estimate, pose));
        self.put(&topic::TF, now, message::transforms(now, &[(MAP, ODOM, began), (ODOM, BASE, pose)]));
    }

    fn tell_map(&mut self, run: &Run) {
        let now = self.now(run);
        if now - self.map_s < MAP_S - EPSILON_S {
            return;
        }
        if let Some(map) = run.mapper().and_then(|mapper| mapper.map().to_plan("")) {
            self.map_s = now;
            // Its origin is in the room.
            let origin = compose(self.origin, map.origin);
            self.put(&topic::MAP, now, message::occupancy_grid(now, &map, origin));
        }
    }

    fn tell_events(&mut self, run: &Run) {
        let (step, told) = self.events;
        let new = run.events().iter().filter(|event| event.step >= step);
        let skipped = new.clone().take_while(|event| event.step == step).count().min(told);
        let texts: Vec<_> = new.skip(skipped).map(|event| (event.step, event.what.to_string())).collect();
        for (at, text) in texts {
            self.events = if at == self.events.0 { (at, self.events.1 + 1) } else { (at, 1) };
            let now = self.now(run);
            self.put(&topic::LOG, now, message::log(now, NAME, &text, false));
        }
    }

    fn put(&mut self, topic: &'static Topic, time_s: f64, message: super::Cdr) {
        self.out.push(topic.stamped(time_s, message));
    }
}

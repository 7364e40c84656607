//! Follows a planned line, and goes to its dock in between.
//!
//! A planned run knows the room, and so the place of its dock. When the battery is low it drives there over the reachable
//! floor, takes the last half metre by the beams (behaviour `dock`), charges, drives back to where it stopped, and goes on.
//!
//! The dock also is a landmark (004, section 4.3): a robot on its contacts knows its pose, whatever its wheels say. So a
//! robot that was picked up and put down elsewhere, which doesn't know where it is, searches for its dock first, and then
//! goes on where it was lifted. The thesis leaves the search open, as "simple heuristics": ours are those of `dock`.

use super::{
    Controller, FollowPath, Follower, Setup, dock,
    parts::{GO_HOME, LEAVE_HOME, LIFTED},
};
use crate::docking::{berth, could_touch};
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Pose},
    registry::{ParamKind, ParamSpec, Params},
    robot::{Drive, RobotModel, SensorReadings},
};
use std::sync::Arc;

/// Distances before the dock at which it turns towards it, m: the first one with free floor up to the last one.
const BEFORE: [f64; 5] = [0.7, 0.6, 0.5, 0.4, 0.3];
const CLOSE: f64 = 0.15;
/// Charge at which a robot leaves a dock that it came to only to know where it is, above that for going there.
const ENOUGH: f64 = 0.02;

/// A follower that recharges.
pub struct Recharge {
    follower: Follower,
    floor: Arc<ReachableFloor>,
    /// Pose on the dock, and the place before it from which it is in sight.
    berth: Pose,
    before: Point,
    seed: u64,
    /// Shares of the charge at which it goes and leaves.
    low: f64,
    full: f64,
    state: RechargeState,
    /// Where it left the line.
    left: Point,
}

/// What it does instead of following the line.
enum RechargeState {
    None,
    /// Drives to the place before the dock.
    Go(FollowPath),
    /// Drives onto it by the beams, after searching for them if need be.
    Dock(Box<dyn Controller>),
    /// Charges up to this share.
    Charge(f64),
    /// Drives back to where it left the line.
    Return(FollowPath),
    /// Was lifted; waits to be put down.
    Lifted,
}

impl Recharge {
    /// A follower that uses the nearest of `docks`, m; `None` if the robot can't dock, or reaches none.
    pub fn new(follower: &Follower, floor: &Arc<ReachableFloor>, docks: &[Pose], seed: u64) -> Option<Self> {
        let robot = follower.path().robot();
        if !can_dock(robot) {
            return None;
        }
        let start = floor.start.position();
        let reached = docks.iter().filter_map(|&dock| {
            let berth = berth(dock, robot);
            let ahead = |way: f64| berth.to_world(Point::new(-way, 0.0));
            let before = BEFORE.into_iter().map(ahead).find(|&at| floor.is_straight_free(at, ahead(CLOSE)))?;
            Some((berth, before))
        });
        let (berth, before) = reached.min_by(|(_, a), (_, b)| (a - start).norm().total_cmp(&(b - start).norm()))?;
        let floor = Arc::clone(floor);
        let (low, full) = (share(&GO_HOME), share(&LEAVE_HOME));
        Some(Self {
            follower: follower.clone(),
            floor,
            berth,
            before,
            seed,
            low,
            full,
            state: RechargeState::None,
            left: start,
        })
    }

    /// The same with other shares of the charge at which it goes and leaves, percent.
    pub fn between(self, low: f64, full: f64) -> Self {
        Self { low: low / 100.0, full: full / 100.0, ..self }
    }

    /// The way between two places over reachable floor, for a robot that isn't exactly where it seems.
    fn way(&self, from: Point, to: Point) -> Vec<Point> {
        let place = |at: Point| self.floor.place_for(Pose::new(at.x, at.y, 0.0), |_| true).position();
        self.floor.way(place(from), place(to)).unwrap_or_else(|| vec![to])
    }

    fn go(&self) -> RechargeState {
        let here = self.follower.path().pose().position();
        let mut line = vec![here];
        line.extend(self.way(here, self.before));
        // It ends facing the dock.
        let nearer = self.before + (self.berth.position() - self.before) * 0.5;
        line.push(nearer);
        RechargeState::Go(self.follower.path().onto(line.into()))
    }

    fn dock(&self) -> RechargeState {
        let params = Params::defaults(dock::INFO.params);
        RechargeState::Dock((dock::BUILD)(&Setup {
            robot: self.follower.path().robot(),
            params: &params,
            seed: self.seed,
        }))
    }

    fn come_back(&self) -> RechargeState {
        let mut line = vec![self.follower.path().pose().position(), self.before];
        line.extend(self.way(self.before, self.left));
        RechargeState::Return(self.follower.path().onto(line.into()))
    }

    /// Starts the next state, if it is time.
    fn decide(&mut self, sensed: &SensorReadings) {
        let (share, on_dock) = (sensed.battery.share(), sensed.battery.on_dock);
        if sensed.wheel_drop_left && sensed.wheel_drop_right {
            if matches!(self.state, RechargeState::None) {
                self.left = self.follower.path().pose().position();
                self.follower.pause();
            }
            self.state = RechargeState::Lifted;
            return;
        }
        let next = match &self.state {
            RechargeState::Lifted => self.dock(),
            RechargeState::None if share < self.low && !self.follower.is_done() => {
                self.left = self.follower.path().pose().position();
                self.follower.pause();
                self.go()
            }
            RechargeState::Go(trip) if trip.is_done() => self.dock(),
            RechargeState::Dock(dock) if dock.is_done() && on_dock => {
                // An estimate that can be right is kept: it is more accurate than the contacts.
                if !could_touch(self.berth, self.follower.path().pose()) {
                    self.follower.path_mut().relocate(self.berth);
                }
                let until = if share < self.low + ENOUGH { self.full } else { 0.0 };
                RechargeState::Charge(until)
            }
            // Pushed off the dock.
            RechargeState::Charge(_) if !on_dock => self.dock(),
            // Charge is reported in whole mAh.
            RechargeState::Charge(until) if share >= until - 0.001 => self.come_back(),
            RechargeState::Return(trip) if trip.is_done() => {
                self.follower.path_mut().resume();
                RechargeState::None
            }
            _ => return,
        };
        self.state = next;
    }
}

/// Whether it has receivers for the beams, contacts and a gauge.
fn can_dock(robot: &RobotModel) -> bool {
    robot.sensors.infrared && robot.battery.charge_ma > 0.0 && robot.battery.has_gauge
}

/// The default of a parameter of behaviours, as a share.
fn share(spec: &ParamSpec) -> f64 {
    match spec.kind {
        ParamKind::Number { default, .. } => default / 100.0,
        _ => 0.0,
    }
}

impl Controller for Recharge {
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive {
        self.decide(sensed);
        if !matches!(self.state, RechargeState::None) {
            self.follower.path_mut().watch(sensed);
        }
        match &mut self.state {
            RechargeState::None => self.follower.step(sensed, dt_s),
            RechargeState::Go(trip) | RechargeState::Return(trip) => trip.step(sensed, dt_s),
            RechargeState::Dock(dock) => dock.step(sensed, dt_s),
            RechargeState::Charge(_) | RechargeState::Lifted => Drive::STOP,
        }
    }

    fn is_done(&self) -> bool {
        matches!(self.state, RechargeState::None) && self.follower.is_done()
    }

    fn estimate(&self) -> Option<Pose> {
        self.follower.estimate()
    }

    fn activity(&self) -> &'static str {
        match &self.state {
            RechargeState::None => self.follower.activity(),
            RechargeState::Go(_) => "driving back to its dock",
            RechargeState::Dock(dock) => dock.activity(),
            RechargeState::Charge(_) => "charging",
            RechargeState::Return(_) => "driving back to its path",
            RechargeState::Lifted => LIFTED,
        }
    }

    fn corner(&self) -> Option<usize> {
        self.follower.corner()
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        let Self { follower, floor, berth, before, seed, low, full, state, left } = self;
        let state = match state {
            RechargeState::None => RechargeState::None,
            RechargeState::Go(trip) => RechargeState::Go(trip.clone()),
            RechargeState::Dock(dock) => RechargeState::Dock(dock.boxed_clone()),
            RechargeState::Charge(until) => RechargeState::Charge(*until),
            RechargeState::Return(trip) => RechargeState::Return(trip.clone()),
            RechargeState::Lifted => RechargeState::Lifted,
        };
        Box::new(Self {
            follower: follower.clone(),
            floor: Arc::clone(floor),
            berth: *berth,
            before: *before,
            seed: *seed,
            low: *low,
            full: *full,
            state,
            left: *left,
        })
    }
}

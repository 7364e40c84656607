//! A whole run: one robot, one controller, one floor.

use super::{Event, Input, Life, Noise, RunObserver, STEP_S, SimRobot, SlipLevel, What, World, event::Signs};
use crate::controller::{Controller, drive_on, interlock::Blocked};
use robovac_core::{
    coverage::{CoverageTracker, ReachableFloor},
    geometry::{Point, Pose, difference},
    robot::{Drive, Odometry, OdometryModel, RobotModel, RobotPort, SensorReadings},
};
use std::{any::Any, collections::VecDeque, sync::Arc};

/// Most points of the trail, and their distance, m.
const TRAIL: (usize, f64) = (600, 0.04);
/// Most events that are stored.
const MOST_EVENTS: usize = 100;

/// Parameters of a run.
#[derive(Debug, Clone)]
pub struct RunSetup {
    /// The floor, with the start.
    pub floor: Arc<ReachableFloor>,
    /// Objects of the room other than walls.
    pub world: Arc<World>,
    /// The robot.
    pub robot: RobotModel,
    /// Slip and noise.
    pub conditions: Conditions,
    /// Seed of everything random.
    pub seed: u64,
}

/// Errors of a robot's wheels and sensors, and its battery.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Conditions {
    /// Level of wheel slip.
    pub slip: SlipLevel,
    /// Levels of noise.
    pub noise: Noise,
    /// Whether the wheels turn only at the speeds that the motor controller can keep.
    pub quantised: bool,
    /// Charge of the battery at the start, percent, 0 to 100.
    pub start_charge_percent: u8,
    /// Whether empty batteries are replaced. Otherwise the run ends there.
    pub spare_batteries: bool,
}

/// Perfect wheels and sensors, any speed, a full battery.
impl Default for Conditions {
    fn default() -> Self {
        Self {
            slip: SlipLevel::None,
            noise: Noise::default(),
            quantised: false,
            start_charge_percent: 100,
            spare_batteries: false,
        }
    }
}

/// The state of a run after a number of steps. A clone is a key frame.
pub struct Run {
    floor: Arc<ReachableFloor>,
    world: Arc<World>,
    life: Life,
    robot: SimRobot,
    controller: Box<dyn Controller>,
    tracker: CoverageTracker,
    steps: u64,
    distance_m: f64,
    turning_rad: f64,
    bumps: u32,
    falls: u32,
    trail: RecentTrail,
    /// The robot's estimated pose if its controller has none, and its estimated trail.
    odometry: Option<Odometry>,
    observer: Option<Box<dyn RunObserver>>,
    estimated_trail: RecentTrail,
    events: VecDeque<Event>,
}

impl Run {
    /// A robot at the start, driven by `controller`.
    pub fn new(setup: &RunSetup, mut controller: Box<dyn Controller>) -> Self {
        let floor = Arc::clone(&setup.floor);
        controller.start_at(floor.start);
        let mut tracker = CoverageTracker::new(&floor);
        tracker.sweep_to(&floor, floor.start);
        let world = Arc::clone(&setup.world);
        let life = Life::new(&world, &floor, setup.seed);
        let robot = SimRobot::new(&setup.robot, floor.start, setup.conditions, setup.seed);
        let robot = if floor.is_for_path { robot.with_exact_contact() } else { robot };
        let trail = RecentTrail(vec![floor.start.position()]);
        let keeps_track = controller.estimate().is_some();
        let odometry = (!keeps_track).then(|| Odometry::new(&setup.robot, OdometryModel::Arc, floor.start));
        Self {
            floor,
            world,
            life,
            robot,
            controller,
            tracker,
            steps: 0,
            distance_m: 0.0,
            turning_rad: 0.0,
            bumps: 0,
            falls: 0,
            estimated_trail: trail.clone(),
            trail,
            odometry,
            observer: None,
            events: VecDeque::new(),
        }
    }

    /// The same on floor that `earlier`, a run in the same room before it was changed, has already swept.
    pub fn after(mut self, earlier: &Self) -> Self {
        self.tracker.take_over(&self.floor, &earlier.tracker);
        self.life.take_over(&earlier.life);
        self
    }

    /// Without light bumper and laser, for a controller that reads neither: faster, and moves alike.
    pub fn without_sight(mut self) -> Self {
        self.robot = self.robot.without_sight();
        self
    }

    /// Adds an observer.
    pub fn observed(mut self, observer: Box<dyn RunObserver>) -> Self {
        self.observer = Some(observer);
        self
    }

    /// The observer, if it is of that type.
    pub fn observer<O: RunObserver>(&self) -> Option<&O> {
        let observer: &dyn Any = self.observer.as_deref()?;
        observer.downcast_ref()
    }

    /// The robot's controller.
    pub fn controller(&self) -> &dyn Controller {
        &*self.controller
    }

    /// Advances by [`STEP_S`]; does nothing once the run is finished, and while it waits.
    pub fn step(&mut self) {
        if self.is_finished() || self.waits() {
            return;
        }
        let (before, had_fallen) = (self.robot.pose(), self.robot.has_fallen());
        let (signs, was_empty) = (Signs::of(self.robot.sensors()), self.robot.is_empty());
        let activity = self.controller.activity();
        drive_on(&mut self.robot, &mut *self.controller, STEP_S, |_, _| false);
        let Self { life, robot, world, floor, .. } = self;
        robot.step(&floor.walls, world, life);
        let pose = robot.pose();
        self.steps += 1;
        self.tell(signs, activity);
        if self.robot.is_empty() && !was_empty {
            self.note(What::BatteryEmpty);
        }
        if self.robot.has_fallen() && !had_fallen {
            self.falls += 1;
            self.note(What::Fell);
        }
        self.update_estimate();
        if self.robot.is_lifted() || had_fallen {
            return;
        }
        self.distance_m += (pose.position() - before.position()).norm();
        self.turning_rad += difference(before.heading, pose.heading).abs();
        self.bumps += u32::from(self.robot.sensors().bumped() && !signs.bumped());
        self.tracker.sweep_to(&self.floor, pose);
        self.trail.extend(pose.position());
    }

    /// Applies an input of a person, before the next step.
    pub fn apply(&mut self, input: Input) {
        match input {
            Input::Command(command) => self.controller.command(command),
            Input::Lift => {
                self.robot.lift();
                self.note(What::Lifted);
            }
            Input::PutDown(pose) => {
                let (movers, body) = (self.life.movers(), self.floor.walls.body_radius);
                let is_free = |at: Point| movers.iter().all(|&(centre, radius)| (at - centre).norm() > radius + body);
                self.robot.put_down(self.floor.place_for(pose, is_free));
                self.tracker.lift();
                self.trail.0.clear();
                self.note(What::PutDown);
            }
            Input::Clean(planner) => {
                let Self { observer, controller, .. } = self;
                if let Some(next) = observer.as_mut().and_then(|observer| observer.cleaner(planner, &**controller)) {
                    self.controller = next;
                    self.odometry = None;
                }
            }
        }
    }

    /// Whether the robot was picked up.
    pub fn is_lifted(&self) -> bool {
        self.robot.is_lifted()
    }

    /// The latest events, oldest first.
    pub fn events(&self) -> &VecDeque<Event> {
        &self.events
    }

    /// Number of falls down a drop-off.
    pub fn falls(&self) -> u32 {
        self.falls
    }

    /// Whether the robot lies below a drop-off.
    pub fn has_fallen(&self) -> bool {
        self.robot.has_fallen()
    }

    /// Remaining share of the dirt, 0 to 1; 0 if there was none.
    pub fn dirt_left(&self) -> f64 {
        self.life.dirt_left()
    }

    /// Moving and consumable objects in the room.
    pub fn life(&self) -> &Life {
        &self.life
    }

    /// Objects of the room other than walls.
    pub fn world(&self) -> &Arc<World> {
        &self.world
    }

    /// Adds the events since `before`, when the controller's activity was `activity`.
    fn tell(&mut self, before: Signs, activity: &'static str) {
        let now = Signs::of(self.robot.sensors());
        if now != before {
            let mut news = [None; 8];
            let mut count = 0;
            What::between(before, now, |what| {
                news[count] = Some(what);
                count += 1;
            });
            news.into_iter().flatten().for_each(|what| self.note(what));
        }
        let now = self.controller.activity();
        // Usually it is the same text.
        if !std::ptr::eq(now, activity) && now != activity && !now.is_empty() {
            self.note(What::Began(now));
        }
    }

    fn note(&mut self, what: What) {
        if self.events.len() == MOST_EVENTS {
            self.events.pop_front();
        }
        self.events.push_back(Event { step: self.steps, what });
    }

    /// Updates the estimated pose.
    fn update_estimate(&mut self) {
        if let Some(odometry) = &mut self.odometry {
            odometry.update(self.robot.sensors());
        }
        if let Some(observer) = &mut self.observer {
            observer.observe(self.robot.sensors());
        }
        if let Some(estimate) = self.estimate() {
            self.estimated_trail.extend(estimate.position());
        }
    }

    /// Whether the controller is done or the battery empty, and the robot is at rest.
    #[inline]
    pub fn is_finished(&self) -> bool {
        let speed = self.robot.speed();
        (self.controller.is_done() || self.robot.is_empty()) && speed.is_stop()
    }

    /// Whether its controller doesn't know its next command yet; see [`Controller::waits`].
    #[inline]
    pub fn waits(&self) -> bool {
        self.controller.waits()
    }

    /// Steps taken.
    #[inline]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Simulated time, s.
    #[inline]
    pub fn time_s(&self) -> f64 {
        self.steps as f64 * STEP_S
    }

    /// The robot's true pose.
    pub fn pose(&self) -> Pose {
        self.robot.pose()
    }

    /// The controller's activity, in a few words, or that the battery is empty.
    pub fn activity(&self) -> &'static str {
        if self.robot.is_empty() { "battery empty" } else { self.controller.activity() }
    }

    /// The blocked part of a person's commands, with reasons; `None` for autonomous controllers.
    pub fn blocked(&self) -> Option<Blocked> {
        self.controller.blocked()
    }

    /// The estimated pose: of the observer, of the controller, or else by wheel counts.
    pub fn estimate(&self) -> Option<Pose> {
        let observed = self.observer.as_ref().and_then(|observer| observer.estimate(&*self.controller));
        observed.or_else(|| self.controller.estimate()).or(self.odometry.as_ref().map(Odometry::pose))
    }

    /// Index of the corner of its line that the controller drives to, if it follows one.
    pub fn corner(&self) -> Option<usize> {
        self.controller.corner()
    }

    /// Distance between the robot's true and estimated position, m.
    pub fn pose_error_m(&self) -> Option<f64> {
        self.estimate().map(|estimate| (estimate.position() - self.pose().position()).norm())
    }

    /// The latest sensor reading.
    pub fn sensors(&self) -> &SensorReadings {
        self.robot.sensors()
    }

    /// The wheel speeds that the robot was last commanded.
    pub fn commanded(&self) -> Drive {
        self.robot.commanded()
    }

    /// Distance driven, m.
    pub fn distance_m(&self) -> f64 {
        self.distance_m
    }

    /// Sum of all turning, rad.
    pub fn turning_rad(&self) -> f64 {
        self.turning_rad
    }

    /// Number of bumps.
    pub fn bumps(&self) -> u32 {
        self.bumps
    }

    /// Swept share of the reachable floor, 0 to 1.
    pub fn coverage(&self) -> f64 {
        self.tracker.coverage(&self.floor)
    }

    /// The swept floor.
    pub fn tracker(&self) -> &CoverageTracker {
        &self.tracker
    }

    /// The swept floor, to take its changes.
    pub fn tracker_mut(&mut self) -> &mut CoverageTracker {
        &mut self.tracker
    }

    /// The floor that the robot drives on.
    pub fn floor(&self) -> &Arc<ReachableFloor> {
        &self.floor
    }

    /// The robot's recent trail, oldest first, m.
    pub fn trail(&self) -> &[Point] {
        &self.trail.0
    }

    /// The recent estimated trail, oldest first, m.
    pub fn estimated_trail(&self) -> &[Point] {
        &self.estimated_trail.0
    }

    /// Approximate memory of a clone, bytes.
    pub fn bytes(&self) -> usize {
        let own = self.tracker.bytes() + self.life.bytes() + 2 * TRAIL.0 * size_of::<Point>();
        own + self.controller.bytes() + self.observer.as_ref().map_or(0, |observer| observer.bytes())
    }

    /// A digest that is equal only for equal states, to the last bit (FNV-1a).
    pub fn digest(&self) -> u64 {
        let pose = self.robot.pose();
        let bits = [pose.x, pose.y, pose.heading, self.distance_m, self.turning_rad].map(f64::to_bits);
        let counts = [self.steps, u64::from(self.bumps), u64::from(self.falls), u64::from(self.robot.has_fallen())];
        let words = bits.into_iter().chain(counts).chain(self.life.words());
        let bytes = words.flat_map(u64::to_le_bytes).chain(self.tracker.visits().values().iter().copied());
        bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    }
}

/// The latest points of a growing line.
#[derive(Clone)]
struct RecentTrail(Vec<Point>);

impl RecentTrail {
    fn extend(&mut self, at: Point) {
        let Self(points) = self;
        if points.last().is_none_or(|last| (at - last).norm_squared() > TRAIL.1 * TRAIL.1) {
            if points.len() == TRAIL.0 {
                points.drain(..TRAIL.0 / 4);
            }
            points.push(at);
        }
    }
}

impl Clone for Run {
    fn clone(&self) -> Self {
        Self {
            floor: Arc::clone(&self.floor),
            world: Arc::clone(&self.world),
            life: self.life.clone(),
            robot: self.robot.clone(),
            controller: self.controller.boxed_clone(),
            tracker: self.tracker.clone(),
            trail: self.trail.clone(),
            odometry: self.odometry.clone(),
            observer: self.observer.as_ref().map(|observer| observer.boxed_clone()),
            estimated_trail: self.estimated_trail.clone(),
            events: self.events.clone(),
            ..*self
        }
    }
}

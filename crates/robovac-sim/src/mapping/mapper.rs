//! Builds the map and estimates the robot's pose on it.

use super::{
    Mark, Marks, OccupancyMap, PoseCovariance,
    memo::ReadingMemory,
    multiscan::Multiscan,
    observation::SensorModel,
    paint::paint,
    pose_ekf::PoseEkf,
    reckoning::{Reckoning, Rolling, WheelErrors},
};
use nalgebra::{Matrix3, Vector3};
use robovac_core::{
    geometry::Pose,
    math,
    rng::{normal, seeded},
    robot::{OdometryModel, RobotModel, SensorReadings},
};

/// Stream of its random numbers.
const STREAM: u64 = 60;
/// Dirt sensor values up to this are the brush's own noise (ours).
const DIRTY: u8 = 24;
/// Poses that represent its estimate.
const PARTICLES: usize = 24;
/// Way and turn after which the pose is corrected, m and rad (ours: as long as odometry is good to a few millimetres).
const STRETCH: (f64, f64) = (0.5, 1.6);
/// Readings after which a bumper that is pressed again is a new contact: switches bounce.
const BOUNCE: u32 = 10;
/// What a robot that was picked up may have been moved by, as a standard deviation: m and rad.
const LIFTED: (f64, f64) = (1.0, 1.8);
/// How exactly a dock is met again, as a standard deviation: m and rad; and the way after which it counts as again, m (ours).
const DOCK: [f64; 2] = [0.01, 0.03];
const UNDOCKED: f64 = 0.5;
/// Ways after which all readings are gone over again, m, and how much less sure the filter then is of the wheels than it was:
/// it is to hear the same evidence twice (ours).
const LOOKS: [f64; 3] = [10.0, 25.0, 60.0];
const AGAIN: f64 = 3.0;

/// Side of the map's cells, m (ours: half of the thesis', which are as wide as a shoe).
pub const RESOLUTION: f64 = 0.05;

/// How a mapper keeps track of the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Tracking {
    /// By wheel counts alone.
    Odometry,
    /// By wheel counts, corrected by what bumper and light bumper meet.
    #[default]
    Corrected,
}

impl Tracking {
    /// All ways, with their names in links and on the command line.
    pub const ALL: [(Self, &'static str); 2] = [(Self::Odometry, "odometry"), (Self::Corrected, "corrected")];

    /// The way of that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(way, _)| way)
    }

    /// Name in links and on the command line.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// What a mapper is made from.
#[derive(Debug, Clone)]
pub struct MapperSetup {
    /// The robot that carries it.
    pub robot: RobotModel,
    /// Where it stands, in the frame that the map is to have.
    pub start: Pose,
    /// How it keeps track.
    pub tracking: Tracking,
    /// How wheel counts become motion.
    pub odometry: OdometryModel,
    /// Seed of its random numbers.
    pub seed: u64,
}

/// Makes a map of what a robot meets, and keeps track of the robot on it.
#[derive(Debug, Clone)]
pub struct Mapper {
    setup: MapperSetup,
    sensors: SensorModel,
    rolling: Rolling,
    /// The way since the last correction, and what was seen on it.
    way: Reckoning,
    scan: Multiscan,
    ekf: PoseEkf,
    map: OccupancyMap,
    marks: Marks,
    /// Readings since the bumper was pressed.
    untouched: u32,
    is_lifted: bool,
    is_lost: bool,
    /// Way since the start, and how long it was when the robot stood on its dock last; no dock counts if it didn't start on
    /// one. m.
    travelled: f64,
    docked: Option<f64>,
    /// Readings so far, as long as they may be looked at again, and how often they have been.
    memory: Option<ReadingMemory>,
    looks: usize,
}

impl Mapper {
    /// Nothing known but where it starts.
    pub fn new(setup: MapperSetup) -> Self {
        Self {
            sensors: SensorModel::new(&setup.robot),
            rolling: Rolling::new(&setup.robot, setup.odometry),
            way: Reckoning::new(&setup.robot, setup.odometry, WheelErrors::default()),
            scan: Multiscan::default(),
            ekf: PoseEkf::new(setup.start),
            map: OccupancyMap::new(RESOLUTION),
            marks: Marks::new(RESOLUTION),
            untouched: BOUNCE,
            is_lifted: false,
            is_lost: false,
            travelled: 0.0,
            docked: None,
            memory: (setup.tracking == Tracking::Corrected).then(ReadingMemory::default),
            looks: 0,
            setup,
        }
    }

    /// The same with a map that was made before, on which it has yet to find itself: until [`Mapper::relocate`], it is lost. What
    /// corrects its pose then is what it meets from there on, as that is kept finer than the cells of a map.
    pub fn knowing(mut self, map: OccupancyMap, marks: Marks) -> Self {
        (self.map, self.marks) = (map, marks);
        (self.memory, self.is_lost) = (None, true);
        self
    }

    /// Takes the next reading.
    pub fn update(&mut self, sensed: &SensorReadings) {
        if let Some(memory) = &mut self.memory {
            memory.add(sensed);
        }
        self.take(sensed);
        if self.memory.is_some() && LOOKS.get(self.looks).is_some_and(|&way| self.travelled > way) {
            self.look_again();
        }
    }

    /// Lets go of where it was: it is at `pose` now, as sure of it as `spread` says. The map is kept.
    pub fn relocate(&mut self, pose: Pose, spread: &PoseCovariance) {
        self.memory = None;
        self.ekf.relocate(pose, spread);
        self.begin_stretch();
        self.is_lost = false;
    }

    /// Whether it was picked up and hasn't been told since where it is. Until [`Mapper::relocate`] does, the map is left
    /// alone. By odometry alone it never knows.
    pub fn is_lost(&self) -> bool {
        self.is_lost
    }

    /// Whether it stood on a dock before it had gone anywhere.
    pub fn began_on_dock(&self) -> bool {
        self.docked.is_some()
    }

    /// What it is made from.
    pub fn setup(&self) -> &MapperSetup {
        &self.setup
    }

    /// Its estimated pose.
    pub fn pose(&self) -> Pose {
        self.ekf.after(&self.way)
    }

    /// How sure it is of that.
    pub fn pose_covariance(&self) -> PoseCovariance {
        let covariance = self.covariance();
        let variance = |i: usize| covariance[(i, i)].max(0.0);
        PoseCovariance {
            position: [variance(0), covariance[(0, 1)], variance(1)],
            heading: variance(2).sqrt().min(math::PI),
        }
    }

    /// Poses that it holds possible, with their weights, which add up to 1: drawn from its estimate, always in the same
    /// way, so that they move as that does.
    pub fn particles(&self) -> Vec<(Pose, f64)> {
        let (pose, weight) = (self.pose(), 1.0 / PARTICLES as f64);
        let covariance = self.covariance() + Matrix3::identity() * 1e-12;
        let Some(root) = covariance.cholesky() else { return vec![(pose, 1.0)] };
        let mut rng = seeded(self.setup.seed, STREAM);
        let draw = |_| {
            let off = root.l() * Vector3::from_fn(|_, _| normal(&mut rng));
            (Pose::new(pose.x + off.x, pose.y + off.y, pose.heading + off.z), weight)
        };
        (0..PARTICLES).map(draw).collect()
    }

    /// The map so far.
    pub fn map(&self) -> &OccupancyMap {
        &self.map
    }

    /// What was cleaned, and where dirt was found.
    pub fn marks(&self) -> &Marks {
        &self.marks
    }

    /// What the wheels are taken for: right wheel's size less the left one's, and the wheel base less the nominal one,
    /// both as shares.
    pub fn wheels(&self) -> [f64; 2] {
        let wheels = self.ekf.wheels();
        [wheels.unequal, wheels.base]
    }

    /// Roughly the memory that it takes, bytes.
    pub fn bytes(&self) -> usize {
        let memory = self.memory.as_ref().map_or(0, ReadingMemory::bytes);
        self.ekf.bytes() + self.map.bytes() + self.marks.bytes() + memory
    }

    fn take(&mut self, sensed: &SensorReadings) {
        let rolled = self.rolling.take(sensed);
        if sensed.wheel_drop_left && sensed.wheel_drop_right {
            self.is_lifted = true;
            self.memory = None;
            return;
        }
        if self.is_lifted {
            self.put_down();
        }
        let corrects = self.setup.tracking == Tracking::Corrected;
        let contact = self.sensors.contact(sensed, rolled[0] + rolled[1] > 0.0);
        let is_new_contact = contact.is_some() && self.untouched >= BOUNCE;
        self.untouched = if contact.is_some() { 0 } else { self.untouched.saturating_add(1) };
        let contact = contact.map(|contact| self.sensors.aside(contact, rolled[1] - rolled[0]));
        let is_stride = self.way.roll(rolled, contact.filter(|_| corrects).map(|contact| contact.direction));
        if sensed.battery.on_dock && corrects {
            self.dock();
        }
        if self.is_lost || !(is_stride || is_new_contact) {
            return;
        }
        let mut seen = self.sensors.observe(sensed);
        if !is_new_contact {
            // It slides along what it touched.
            seen.contact = None;
        }
        let pose = self.pose();
        paint(&mut self.map, pose, &seen, &self.sensors);
        let radius = 0.5 * self.setup.robot.tool_width;
        self.marks.note(pose.position(), radius, Mark::Cleaned);
        if sensed.dirt > DIRTY {
            self.marks.note(pose.position(), radius, Mark::Dirty);
        }
        if !corrects {
            return;
        }
        self.scan.add(self.way.at, &seen, &self.sensors);
        if is_new_contact || self.way.way > STRETCH.0 || self.way.turned > STRETCH.1 {
            self.correct();
        }
    }

    /// Ends the stretch: looks at what was seen from its end.
    fn correct(&mut self) {
        self.way.settle();
        let features = std::mem::take(&mut self.scan).features(&self.way, &self.sensors);
        self.ekf.advance(&self.way);
        self.ekf.correct(&features);
        self.ekf.learn_axes(&features.walls);
        self.ekf.draw(&features.points);
        self.begin_stretch();
    }

    /// It stands on its dock. If it began there, that is where it is.
    fn dock(&mut self) {
        let travelled = self.travelled + self.way.way;
        let is_again = self.docked.is_some_and(|last| travelled - last > UNDOCKED);
        if is_again && !self.is_lost {
            self.correct();
            self.ekf.meet(self.setup.start, DOCK);
        }
        if self.docked.is_some() || travelled < UNDOCKED {
            self.docked = Some(travelled);
        }
    }

    /// It was picked up and stands again, somewhere.
    fn put_down(&mut self) {
        self.is_lifted = false;
        self.is_lost = self.setup.tracking == Tracking::Corrected;
        let square = LIFTED.0 * LIFTED.0;
        self.way.settle();
        self.ekf.advance(&self.way);
        self.ekf.loosen(&PoseCovariance { position: [square, 0.0, square], heading: LIFTED.1 });
        self.begin_stretch();
    }

    fn begin_stretch(&mut self) {
        self.travelled += self.way.way;
        self.way = Reckoning::new(&self.setup.robot, self.setup.odometry, self.ekf.wheels());
        self.scan = Multiscan::default();
    }

    /// Goes over all readings again with what is known of the wheels by now.
    fn look_again(&mut self) {
        let Some(memory) = self.memory.take() else { return };
        let mut fresh = Self::new(self.setup.clone());
        fresh.memory = None;
        fresh.ekf.know_wheels(&self.ekf, AGAIN);
        fresh.begin_stretch();
        memory.readings().for_each(|sensed| fresh.take(&sensed));
        fresh.looks = self.looks + 1;
        fresh.memory = (fresh.looks < LOOKS.len()).then_some(memory);
        *self = fresh;
    }

    /// Covariance of the present pose: x, y and heading.
    fn covariance(&self) -> Matrix3<f64> {
        let mut way = self.way.clone();
        way.settle();
        let mut ekf = self.ekf.bare();
        ekf.advance(&way);
        ekf.pose_covariance()
    }
}

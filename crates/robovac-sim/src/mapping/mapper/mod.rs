//! Builds the map and estimates the robot's pose on it.

mod by_scan;
mod setup;

pub use setup::{MapperSetup, Tracking};

use super::{
    CellMark, Marks, OccupancyMap, PoseCovariance,
    memo::ReadingMemory,
    multiscan::Multiscan,
    observation::{ContactPoint, Observation, SensorModel},
    paint::{paint, paint_wall},
    pose_ekf::PoseEkf,
    reckoning::{Reckoning, Rolling, WheelErrors},
};
use crate::{RandomStream, docking::berth};
use by_scan::ByScan;
use nalgebra::{Matrix3, Vector3};
use robovac_core::{
    geometry::{Pose, Vector, difference},
    math,
    rng::normal,
    robot::{Body, SensorReadings},
};

/// Dirt sensor values up to this are noise of the brush (ours).
const DIRTY: u8 = 24;
/// Number of poses that represent its estimate.
const PARTICLES: usize = 24;
/// Distance and turn between two corrections, m and rad (ours: as long as odometry is accurate to a few millimetres).
const STRETCH: (f64, f64) = (0.5, 1.6);
/// The same for a robot with nothing but a bumper, m: long enough for several contacts with a wall.
const BY_CONTACTS: f64 = 2.2;
/// Uncertainty of a contact's direction where a wall of the room is in it, rad.
const BY_WALL: f64 = 0.1;
/// Readings after which another press of the bumper is a new contact, as switches bounce.
const BOUNCE: u32 = 10;
/// Possible displacement of a robot that was picked up, as a standard deviation: m and rad.
const LIFTED: (f64, f64) = (1.0, 1.8);
/// Accuracy of a dock's position, as a standard deviation: m and rad; and the least distance driven before it is met
/// again, m (ours).
const DOCK: [f64; 2] = [0.01, 0.03];
const UNDOCKED: f64 = 0.5;
/// Distances driven after which all readings are processed again, m, and factor by which the filter's uncertainty of
/// the wheels is increased before, as it gets the same evidence twice (ours).
const LOOKS: [f64; 3] = [10.0, 25.0, 60.0];
const AGAIN: f64 = 3.0;
/// Side of the map's cells, m (ours: half of the thesis').
pub const RESOLUTION: f64 = 0.05;

/// Makes a map from a robot's readings, and tracks the robot on it.
#[derive(Debug, Clone)]
pub struct Mapper {
    setup: MapperSetup,
    sensors: SensorModel,
    rolling: Rolling,
    /// Motion and observations since the last correction.
    way: Reckoning,
    scan: Multiscan,
    by_scan: Option<ByScan>,
    ekf: PoseEkf,
    map: OccupancyMap,
    marks: Marks,
    /// Readings since the bumper was pressed.
    untouched: u32,
    /// Direction towards the last wall that contacts have shown, rad.
    wall: Option<f64>,
    is_lifted: bool,
    is_lost: bool,
    /// Distance driven since the start, and at the last visit to the dock, m; no dock counts if it didn't start on one.
    travelled: f64,
    docked: Option<f64>,
    /// Its pose on its dock, once it has been there and knew where it was.
    berth: Option<Pose>,
    /// Readings so far, while they can be processed again, and how often they have been.
    memory: Option<ReadingMemory>,
    looks: usize,
}

impl Mapper {
    /// A mapper that knows only its start.
    pub fn new(setup: MapperSetup) -> Self {
        Self {
            sensors: SensorModel::new(&setup.robot),
            rolling: Rolling::new(&setup.robot, setup.odometry),
            way: Reckoning::new(&setup.robot, setup.odometry, WheelErrors::default()),
            scan: Multiscan::default(),
            by_scan: setup.robot.sensors.laser.map(ByScan::new),
            ekf: PoseEkf::new(setup.start),
            map: OccupancyMap::new(RESOLUTION),
            marks: Marks::new(RESOLUTION),
            untouched: BOUNCE,
            wall: None,
            is_lifted: false,
            is_lost: false,
            travelled: 0.0,
            docked: None,
            berth: None,
            // Scans need no second look.
            memory: (setup.tracking == Tracking::Corrected && setup.robot.sensors.laser.is_none())
                .then(ReadingMemory::default),
            looks: 0,
            setup,
        }
    }

    /// The same with an existing map, on which it must relocalise: it is lost until [`Mapper::relocate`]. From then on
    /// its pose is corrected by new observations, which are stored at a finer resolution than the cells of a map.
    pub fn knowing(mut self, map: OccupancyMap, marks: Marks) -> Self {
        self.by_scan = self.by_scan.map(|by_scan| by_scan.knowing(&map, &marks));
        (self.map, self.marks) = (map, marks);
        (self.memory, self.is_lost) = (None, true);
        self
    }

    /// The same with a dock on the map, by which it knows its place when it comes there.
    pub fn knowing_dock(mut self, dock: Pose) -> Self {
        self.berth = Some(berth(dock, &self.setup.robot));
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

    /// Sets the pose to `pose`, with the uncertainty `spread`. The map is kept.
    pub fn relocate(&mut self, pose: Pose, spread: &PoseCovariance) {
        self.memory = None;
        self.ekf.relocate(pose, spread);
        if let Some(by_scan) = &mut self.by_scan {
            by_scan.relocate(pose);
        }
        self.begin_stretch();
        self.is_lost = false;
    }

    /// Whether it was picked up and not relocalised since. Until [`Mapper::relocate`] the map doesn't change. Always
    /// false with odometry alone.
    pub fn is_lost(&self) -> bool {
        self.is_lost
    }

    /// Its pose on its dock, if it knows the dock.
    pub fn berth(&self) -> Option<Pose> {
        self.berth
    }

    /// Its parameters.
    pub fn setup(&self) -> &MapperSetup {
        &self.setup
    }

    /// Its estimated pose.
    pub fn pose(&self) -> Pose {
        let is_blocked = self.by_scan.as_ref().is_some_and(ByScan::is_blocked);
        if is_blocked { self.ekf.pose() } else { self.ekf.after(&self.way) }
    }

    /// Covariance of the pose.
    pub fn pose_covariance(&self) -> PoseCovariance {
        let covariance = self.covariance();
        let variance = |i: usize| covariance[(i, i)].max(0.0);
        PoseCovariance {
            position: [variance(0), covariance[(0, 1)], variance(1)],
            heading: variance(2).sqrt().min(math::PI),
        }
    }

    /// Possible poses with their weights, which add up to 1: drawn from its estimate with fixed random numbers, so that
    /// they move with the estimate.
    pub fn particles(&self) -> Vec<(Pose, f64)> {
        let (pose, weight) = (self.pose(), 1.0 / PARTICLES as f64);
        let covariance = self.covariance() + Matrix3::identity() * 1e-12;
        let Some(root) = covariance.cholesky() else { return vec![(pose, 1.0)] };
        let mut rng = RandomStream::LoopClosure.seeded(self.setup.seed);
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

    /// Cleaned floor, and places where dirt was found.
    pub fn marks(&self) -> &Marks {
        &self.marks
    }

    /// Estimated errors of the wheels: right wheel's size less the left one's, and the wheel base less the nominal one,
    /// both as shares.
    pub fn wheels(&self) -> [f64; 2] {
        let wheels = self.ekf.wheels();
        [wheels.unequal, wheels.base]
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        let memory = self.memory.as_ref().map_or(0, ReadingMemory::bytes);
        let scans = self.by_scan.as_ref().map_or(0, ByScan::bytes);
        self.ekf.bytes() + self.map.bytes() + self.marks.bytes() + memory + scans
    }

    fn take(&mut self, sensed: &SensorReadings) {
        let corrects = self.setup.tracking == Tracking::Corrected;
        let mut rolled = self.rolling.take(sensed);
        let ahead = 0.5 * (rolled[0] + rolled[1]);
        // Turning on the spot, one wheel's count comes before the other's, which is no way ahead.
        let is_ahead = ahead > 0.0 && (self.setup.robot.body == Body::Round || rolled[0].min(rolled[1]) > 0.0);
        if corrects && sensed.laser.is_some() && is_ahead && !sensed.stasis {
            // The castor stands: the wheels spin.
            rolled = [rolled[0] - ahead, rolled[1] - ahead, rolled[2]];
        }
        if sensed.wheel_drop_left && sensed.wheel_drop_right {
            self.is_lifted = true;
            self.memory = None;
            return;
        }
        if self.is_lifted {
            self.put_down();
        }
        if sensed.battery.on_dock && corrects {
            self.moor();
        }
        let contact = self.sensors.contact(sensed, rolled[0] + rolled[1] > 0.0);
        let is_new_contact = contact.is_some() && self.untouched >= BOUNCE;
        self.untouched = if contact.is_some() { 0 } else { self.untouched.saturating_add(1) };
        let contact = contact.map(|contact| self.by_walls(self.sensors.aside(contact, rolled[1] - rolled[0])));
        // With a laser, contacts of bodies that aren't round aren't needed, and their direction isn't known.
        let slides = corrects && (sensed.laser.is_none() || self.setup.robot.body == Body::Round);
        let is_stride = self.way.roll(rolled, contact.filter(|_| slides).map(|contact| contact.direction));
        if sensed.laser.is_some() && self.by_scan.is_some() {
            if contact.is_some() {
                self.way.touch([rolled[0], rolled[1]]);
            }
            self.take_scan(sensed, is_stride);
            return;
        }
        if sensed.battery.on_dock && corrects {
            self.dock();
        }
        if self.is_lost || !(is_stride || is_new_contact) {
            return;
        }
        let mut seen = self.sensors.observe(sensed);
        let switches = seen.contact.filter(|_| is_new_contact);
        // If it isn't new, it slides along the obstacle.
        seen.contact = if self.sensors.is_bumper_alone() { contact.filter(|_| is_new_contact) } else { switches };
        let pose = self.pose();
        paint(&mut self.map, pose, &seen, &self.sensors);
        let radius = 0.5 * self.setup.robot.tool_width;
        self.marks.note(pose.position(), radius, CellMark::Cleaned);
        if sensed.dirt > DIRTY {
            self.marks.note(pose.position(), radius, CellMark::Dirty);
        }
        if !corrects {
            return;
        }
        self.scan.add(self.way.at, &Observation { contact: switches, ..seen }, &self.sensors);
        let is_due = if self.sensors.is_bumper_alone() {
            self.way.way > BY_CONTACTS
        } else {
            is_new_contact || self.way.way > STRETCH.0 || self.way.turned > STRETCH.1
        };
        if is_due {
            self.correct();
        }
    }

    /// A contact of a robot with nothing but a bumper, in the direction of a wall that its switches allow: the last one that it
    /// has followed, or one along the axes of the room.
    fn by_walls(&self, contact: ContactPoint) -> ContactPoint {
        if !self.sensors.is_bumper_alone() {
            return contact;
        }
        let heading = self.pose().heading;
        let walls = self.wall.into_iter().chain(self.ekf.axes()).map(|wall| difference(heading, wall));
        let wall = walls.into_iter().find(|&direction| contact.allows(direction));
        wall.map_or(contact, |direction| ContactPoint { direction, deviation: BY_WALL })
    }

    /// Ends the stretch: corrects the pose by its observations.
    fn correct(&mut self) {
        self.way.settle();
        let features = std::mem::take(&mut self.scan).features(&self.way, &self.sensors);
        self.ekf.advance(&self.way);
        self.ekf.correct(&features);
        self.ekf.learn_axes(&features.walls);
        self.ekf.draw(&features.points);
        self.ekf.draw(&features.between);
        if self.sensors.is_bumper_alone() {
            let (pose, ahead) = (self.ekf.pose(), self.ekf.pose().direction());
            for point in features.points.iter().chain(&features.between).filter(|point| point.is_oriented) {
                let [x, y] = [point.normal.x, point.normal.y];
                let normal = Vector::new(ahead.x * x - ahead.y * y, ahead.y * x + ahead.x * y);
                paint_wall(&mut self.map, pose.to_world(point.at), normal);
                self.wall = Some(math::atan2(-normal.y, -normal.x));
            }
        }
        self.begin_stretch();
    }

    /// It is on its dock: a landmark (004, section 4.3). A robot that is lost knows its place there, and one that isn't
    /// remembers the place of the dock.
    fn moor(&mut self) {
        match self.berth {
            Some(berth) if self.is_lost => {
                let square = DOCK[0] * DOCK[0];
                self.relocate(berth, &PoseCovariance { position: [square, 0.0, square], heading: DOCK[1] });
            }
            None if !self.is_lost => self.berth = Some(self.pose()),
            _ => {}
        }
    }

    /// It is on its dock, whose pose is known if it began there.
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

    /// It was picked up and put down at an unknown place.
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

    /// Processes all readings again with the present estimate of the wheels.
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

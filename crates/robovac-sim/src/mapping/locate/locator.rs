//! The particle filter on a known map.

use super::{
    DistanceField,
    landmark::{DARK, Landmarks},
    likelihood::Reading,
    particles::{BestPlace, Particle, Particles, moved, scattered},
    scan_reading::{ScanReading, ScanSearch},
};
use crate::{
    RandomStream,
    docking::{berth, could_touch},
    mapping::{OccupancyMap, PoseCovariance, scan::Match},
};
use rand::RngExt;
use robovac_core::{
    geometry::{Point, Pose, difference},
    math,
    rng::Rng,
    robot::{Odometry, OdometryModel, RobotModel, SensorReadings},
};
use std::sync::Arc;

/// Distance and turn between two updates, m and rad.
const STRIDE: (f64, f64) = (0.06, 0.15);
/// Poses drawn at once in a global search, and number of draws.
const DRAWS: (usize, u32) = (20_000, 10);
/// While it isn't sure, poses drawn in every so many-th update.
const AGAIN: (usize, u32) = (6000, 6);
/// Weight of these, as a share of all.
const CHANCE: f64 = 0.03;
/// Fewest and most particles.
const COUNT: (usize, usize) = (400, 8000);
/// Particles for each possible place.
const PER_PLACE: usize = 40;
/// Errors of motion: rad per square root of a metre, rad per rad, m per square root of a metre.
const MOTION: (f64, f64, f64) = (0.02, 0.03, 0.01);
/// Particles for each pose that fits a scan, with their deviation from it, m and rad, and updates between searches while
/// it isn't sure, and while it is.
const PER_MATCH: usize = 60;
const SCATTER: (f64, f64) = (0.05, 0.03);
const SEARCH_AGAIN: [u32; 2] = [15, 60];
/// How likely something holds the body while the wheels turn, before a scan tells: other sensors couldn't. And the shares of
/// the way for which it is asked.
const HELD: f64 = 0.02;
const HELD_AFTER: [f64; 2] = [0.0, 0.5];
/// Errors of its motion in addition, m and rad, among which scans choose.
const STIR: (f64, f64) = (0.008, 0.01);
/// Share of a reading's weight that counts, as readings of one wall are correlated.
const TEMPER: f64 = 0.35;
/// Weights of the latest fit in the short and the long average.
const MEMORY: (f64, f64) = (0.1, 0.01);
/// Decrease of the mean log fit at which it must be elsewhere.
const LOST: f64 = 1.5;
/// The same for scans, which count for more and vary with what is in sight.
const LOST_BY_SCAN: f64 = 12.0;
/// Least log fit that these averages take into account, and that of scans.
const WORST: f64 = -12.0;
const WORST_BY_SCAN: f64 = -40.0;
/// Particles for each dock on which the robot can be, with their deviation from its pose there, m and rad.
const PER_DOCK: usize = 200;
const MOORED: (f64, f64) = (0.01, 0.03);
/// It is sure if this share of the weight is in one place.
const SURE: f64 = 0.85;
/// And for this many updates.
const SURE_LOOKS: u32 = 30;

/// Parameters of a locator.
#[derive(Debug, Clone)]
pub struct LocatorSetup {
    /// The robot.
    pub robot: RobotModel,
    /// How wheel counts are converted to motion.
    pub odometry: OdometryModel,
    /// Seed of its random numbers.
    pub seed: u64,
}

/// Localises a robot on a known map, and tracks it there.
#[derive(Debug, Clone)]
pub struct Locator {
    setup: LocatorSetup,
    field: Arc<DistanceField>,
    /// Search by the scans of a laser.
    scans: Option<Arc<ScanSearch>>,
    /// The latest scan.
    scan: Option<Arc<[f32]>>,
    /// Places where the robot can stand, those of them near obstacles, and those near docks.
    places: Arc<[Point]>,
    near: Arc<[Point]>,
    lit: Arc<[Point]>,
    docks: Landmarks,
    on_dock: bool,
    rng: Rng,
    odometry: Odometry,
    /// Odometry at the last update.
    looked: Pose,
    bumped: bool,
    lifted: bool,
    /// Remaining draws of a global search.
    draws: u32,
    /// Updates since the search, and those with nearly all weight in one place.
    looks: u32,
    agreed: u32,
    particles: Particles,
    /// Average fits of the latest readings: short and long.
    fits: Option<(f64, f64)>,
    estimate: Option<Estimate>,
}

#[derive(Debug, Clone, Copy)]
struct Estimate {
    pose: Pose,
    covariance: PoseCovariance,
    /// Odometry at the time of the estimate.
    odometry: Pose,
}

impl Locator {
    /// A robot anywhere on `map`; `None` if the map has no walls or no room for it.
    pub fn new(map: &OccupancyMap, setup: LocatorSetup) -> Option<Self> {
        let field = DistanceField::new(map)?;
        let radius = setup.robot.radius;
        let slack = 0.5 * map.resolution();
        let places: Arc<[Point]> = field.places(radius - slack).into();
        let reach = radius + setup.robot.sensors.light_bumper.map_or(0.05, |light| light.range);
        let near: Arc<[Point]> = places.iter().copied().filter(|&at| field.distance(at) < reach).collect();
        if near.is_empty() {
            return None;
        }
        let origin = Pose::new(0.0, 0.0, 0.0);
        Some(Self {
            odometry: Odometry::new(&setup.robot, setup.odometry, origin),
            field: Arc::new(field),
            scans: setup.robot.sensors.laser.and_then(|laser| ScanSearch::new(map, &setup.robot, laser)).map(Arc::new),
            scan: None,
            places,
            near,
            lit: Arc::default(),
            docks: Landmarks::new(&[], &setup.robot),
            on_dock: false,
            rng: RandomStream::Localisation.seeded(setup.seed),
            looked: origin,
            bumped: false,
            lifted: false,
            draws: DRAWS.1,
            looks: 0,
            agreed: 0,
            particles: Particles::default(),
            fits: None,
            estimate: None,
            setup,
        })
    }

    /// The same with docks on the map, which are landmarks.
    pub fn knowing_docks(mut self, docks: &[Pose]) -> Self {
        self.docks = Landmarks::new(docks, &self.setup.robot);
        self.lit = self.places.iter().copied().filter(|&place| self.docks.is_near(place)).collect();
        self
    }

    /// Takes the next reading.
    pub fn update(&mut self, sensed: &SensorReadings) {
        self.odometry.update(sensed);
        if sensed.wheel_dropped() {
            self.lifted |= sensed.wheel_drop_left && sensed.wheel_drop_right;
            return;
        }
        if std::mem::take(&mut self.lifted) {
            self.forget();
        }
        let was_on_dock = std::mem::replace(&mut self.on_dock, sensed.battery.on_dock);
        if self.on_dock && !was_on_dock && !self.docks.docks.is_empty() {
            self.moor();
            return;
        }
        let scan = sensed.laser.as_ref().filter(|_| self.scans.is_some());
        if let Some(scan) = scan {
            // Between two scans the robot moves on.
            if self.scan.as_ref().is_some_and(|last| Arc::ptr_eq(last, scan)) {
                return;
            }
            self.scan = Some(Arc::clone(scan));
        }
        let now = self.odometry.pose();
        let gone = (now.position() - self.looked.position()).norm();
        let turned = difference(self.looked.heading, now.heading).abs();
        let is_new = sensed.bumped() && !self.bumped;
        self.bumped = sensed.bumped();
        if gone < STRIDE.0 && turned < STRIDE.1 && !is_new {
            return;
        }
        self.looks = self.looks.wrapping_add(1);
        let scan = self.scans.clone().zip(scan);
        let scan = scan.and_then(|(scans, scan)| scans.reading(scan).map(|scan| (scans, scan)));
        let held = match &scan {
            Some((scans, scan)) => self.held(scans, scan, now),
            None if self.scans.is_some() => HELD,
            None => 0.0,
        };
        self.advance(now, (gone, turned), held);
        if let Some((scans, scan)) = scan {
            self.draw_by_scan(&scans, &scan);
            self.weigh(|field, pose| scans.fit(&scan, field, pose));
            self.polish(&scans, &scan);
            return;
        }
        let reading = Reading::new(&self.setup.robot, sensed);
        let (docks, seen) = (self.docks.clone(), self.docks.seen(sensed));
        let fit = |field: &DistanceField, pose: Pose| {
            reading.fit(field, pose) + seen.map_or(0.0, |seen| docks.fit(seen, field, pose))
        };
        self.draw(&reading, seen.is_some_and(|seen| seen != DARK), &fit);
        self.weigh(fit);
    }

    /// Forgets everything except the map.
    pub fn forget(&mut self) {
        self.particles.0.clear();
        self.draws = DRAWS.1;
        self.agreed = 0;
        self.fits = None;
        self.estimate = None;
        self.looked = self.odometry.pose();
    }

    /// Its estimated pose; `None` before the first contact, or scan.
    pub fn pose(&self) -> Option<Pose> {
        let Estimate { pose, odometry, .. } = self.estimate?;
        Some(moved(pose, odometry, self.odometry.pose()))
    }

    /// Covariance of the possible poses; `None` while there are none.
    pub fn pose_covariance(&self) -> Option<PoseCovariance> {
        self.estimate.map(|estimate| estimate.covariance)
    }

    /// Whether hardly any other place is possible.
    pub fn is_sure(&self) -> bool {
        self.agreed >= SURE_LOOKS
    }

    /// Possible poses with their weights, which add up to 1.
    pub fn particles(&self) -> Vec<(Pose, f64)> {
        self.particles.0.iter().map(|p| p.pose).zip(self.particles.weights()).collect()
    }

    /// How likely something holds the body while the wheels turn: by how much better a scan fits where the robot was than
    /// where it should be by now.
    fn held(&self, scans: &ScanSearch, scan: &ScanReading, now: Pose) -> f64 {
        let Some(Estimate { pose, odometry, .. }) = self.estimate else { return HELD };
        let expected = moved(pose, odometry, now);
        let fit = |pose| scans.fit(scan, &self.field, pose);
        let held = HELD_AFTER.map(|share| fit(between(pose, expected, share))).into_iter().fold(f64::MIN, f64::max);
        let odds = HELD / (1.0 - HELD) * math::exp((held - fit(expected)).clamp(-50.0, 50.0));
        odds / (1.0 + odds)
    }

    /// Moves all particles by the wheels' motion, each with its own errors; so large a share is held.
    fn advance(&mut self, now: Pose, (gone, turned): (f64, f64), held: f64) {
        let from = std::mem::replace(&mut self.looked, now);
        let (mut heading, mut along) = (MOTION.0 * gone.sqrt() + MOTION.1 * turned, MOTION.2 * gone.sqrt());
        if self.scans.is_some() {
            (heading, along) = (heading + STIR.1, along + STIR.0);
        }
        for particle in &mut self.particles.0 {
            let mut pose = moved(particle.pose, from, now);
            if held > 0.0 && self.rng.random_bool(held) {
                let share = self.rng.random_range(0.0..1.0);
                pose = between(particle.pose, pose, share);
            }
            particle.pose = scattered(pose, (along, heading), &mut self.rng);
        }
    }

    /// It has come onto a dock.
    fn moor(&mut self) {
        let robot = &self.setup.robot;
        let berths: Vec<Pose> = self.docks.docks.iter().map(|&dock| berth(dock, robot)).collect();
        // An estimate that can be right is kept: it is more accurate than the contacts.
        let can_be = |pose| berths.iter().any(|&berth| could_touch(berth, pose));
        if self.is_sure() && self.pose().is_some_and(can_be) {
            return;
        }
        self.particles.0.clear();
        for berth in &berths {
            for _ in 0..PER_DOCK {
                self.particles.scatter(*berth, MOORED, &mut self.rng);
            }
        }
        (self.draws, self.fits, self.looked) = (0, None, self.odometry.pose());
        self.judge();
        self.agreed = if berths.len() == 1 { SURE_LOOKS } else { 0 };
    }

    /// During a search, draws poses that fit the reading, wherever an obstacle is near, or a dock if its beams are seen.
    fn draw(&mut self, reading: &Reading, is_lit: bool, fit: &impl Fn(&DistanceField, Pose) -> f64) {
        let count = match self.draws {
            0 if !self.is_sure() && self.looks.is_multiple_of(AGAIN.1) => AGAIN.0,
            0 => 0,
            _ => DRAWS.0,
        };
        let is_lit = is_lit && !self.lit.is_empty();
        if count == 0 || !(is_lit || reading.meets_something()) {
            return;
        }
        let places = if is_lit { Arc::clone(&self.lit) } else { Arc::clone(&self.near) };
        let is_searching = self.draws > 0;
        let share = if is_searching { COUNT.1 / 2 } else { COUNT.1 / 16 };
        self.draws = self.draws.saturating_sub(1);
        let reach = if reading.meets_something() { self.setup.robot.radius + reading.reach() } else { f64::INFINITY };
        let half = 0.5 * self.field.resolution();
        let mut drawn = Particles::default();
        for _ in 0..count {
            let at = places[self.rng.random_range(0..places.len())];
            let [x, y] = [0.0; 2].map(|_: f64| self.rng.random_range(-half..half));
            let at = Point::new(at.x + x, at.y + y);
            if self.field.distance(at) > reach {
                continue;
            }
            let heading = self.rng.random_range(-math::PI..math::PI);
            let pose = Pose::new(at.x, at.y, heading);
            let fit = fit(&self.field, pose);
            if fit > -8.0 {
                drawn.0.push(Particle { pose, weight: fit });
            }
        }
        let drawn = drawn.resampled(share.min(drawn.0.len()), &mut self.rng);
        self.particles.join(drawn, (!is_searching).then_some(CHANCE));
    }

    /// During a search, draws poses around those that fit a scan.
    fn draw_by_scan(&mut self, scans: &ScanSearch, scan: &ScanReading) {
        let is_searching = self.draws > 0;
        // Without wheel drops, only a scan tells that it was carried elsewhere.
        let is_due = is_searching || self.looks.is_multiple_of(SEARCH_AGAIN[usize::from(self.is_sure())]);
        let found = if is_due { scans.search(scan, &self.field) } else { Vec::new() };
        if found.is_empty() {
            return;
        }
        self.draws = 0;
        let mut drawn = Particles::default();
        for Match { pose, .. } in found {
            for _ in 0..PER_MATCH {
                drawn.scatter(pose, SCATTER, &mut self.rng);
            }
        }
        self.particles.join(drawn, (!is_searching).then_some(CHANCE));
    }

    /// Moves the particles of the best place to where the scan fits best.
    fn polish(&mut self, scans: &ScanSearch, scan: &ScanReading) {
        let Some(Estimate { pose, covariance, .. }) = self.estimate else { return };
        let Some(best) = scans.polished(scan, pose, &covariance) else { return };
        self.particles.shift(pose, best);
        if let Some(estimate) = &mut self.estimate {
            estimate.pose = best;
        }
    }

    fn weigh(&mut self, fit: impl Fn(&DistanceField, Pose) -> f64) {
        if self.particles.0.is_empty() {
            return;
        }
        let fits: Vec<f64> = self.particles.0.iter().map(|p| fit(&self.field, p.pose)).collect();
        let before = self.particles.weights();
        let worst = if self.scans.is_some() { WORST_BY_SCAN } else { WORST };
        let mean: f64 = fits.iter().zip(&before).map(|(fit, weight)| fit.max(worst) * weight).sum();
        for (particle, fit) in self.particles.0.iter_mut().zip(&fits) {
            particle.weight += TEMPER * fit;
        }
        if self.draws == 0 {
            self.remember(mean);
        }
        if self.particles.0.is_empty() {
            return;
        }
        let weights = self.particles.weights();
        let effective = 1.0 / weights.iter().map(|w| w * w).sum::<f64>();
        if effective < 0.5 * weights.len() as f64 {
            let places = self.particles.possible_places(&weights);
            let count = (PER_PLACE * places).clamp(COUNT.0, COUNT.1);
            self.particles = self.particles.resampled(count, &mut self.rng);
        }
        self.judge();
    }

    /// Detects that readings fit so much worse that the robot must be elsewhere.
    fn remember(&mut self, fit: f64) {
        let (mut short, mut long) = self.fits.unwrap_or((fit, fit));
        short += MEMORY.0 * (fit - short);
        long += MEMORY.1 * (fit - long);
        self.fits = Some((short, long));
        let lost = if self.scans.is_some() { LOST_BY_SCAN } else { LOST };
        if short < long - lost {
            self.forget();
        }
    }

    /// Computes the estimate: the mean around the best place.
    fn judge(&mut self) {
        let Some(BestPlace { pose, covariance, share }) = self.particles.best_place() else { return };
        self.agreed = if share >= SURE && self.draws == 0 { self.agreed + 1 } else { 0 };
        self.estimate = Some(Estimate { pose, covariance, odometry: self.odometry.pose() });
    }

    /// Places where the robot can stand, as centres of cells.
    pub fn places(&self) -> &[Point] {
        &self.places
    }
}

/// The pose that is a share of the way from one to another.
fn between(from: Pose, to: Pose, share: f64) -> Pose {
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    Pose::new(from.x + share * dx, from.y + share * dy, from.heading + share * difference(from.heading, to.heading))
}

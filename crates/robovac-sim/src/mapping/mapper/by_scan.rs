//! Mapping with a laser scanner: each scan corrects the pose, shows what the wheels can't, and finds the place of a robot
//! that is lost.

use super::{DIRTY, Mapper, MapperSetup, RESOLUTION, Tracking, UNDOCKED};
use crate::{
    docking::dock_at,
    mapping::{
        Marks, OccupancyMap, PoseCovariance,
        locate::{Locator, LocatorSetup},
        scan::{Holds, ScanMapper, paint_place},
    },
};
use nalgebra::Vector3;
use robovac_core::{
    geometry::{Pose, difference},
    robot::{Body, Laser, SensorReadings},
};
use std::sync::Arc;

/// Motion below which a scan shows nothing new, m and rad.
const STILL: (f64, f64) = (0.004, 0.004);
/// Least number of points of a scan that can contradict a pose, and the share that agrees below which they do.
const TELLING: usize = 15;
const MISFIT: f64 = 0.45;
/// Share of agreeing points below which a scan contradicts the map, unless that share of those with a surface near agree, as
/// in a room that is new; and number of such scans in a row after which the robot must be elsewhere; and scans for which
/// only one place must be possible before it is there.
const CONTRADICTS: f64 = 0.2;
const NEW: f64 = 0.6;
const MISFITS: u32 = 25;
const SURE: u32 = 50;
/// Motion by which a scan tells whether the body is held, m, the information that it needs along the way, 1/m², and the share of the wheels' motion below which it is.
const TELLS: f64 = 0.008;
const TELLING_ALONG: f64 = 2e4;
const HELD: f64 = 0.4;
/// Squared innovation from which a motion was other than the wheels tell: by chance it is more once in a thousand scans.
const SURPRISING: f64 = 16.0;
/// Window for a pose that fits better, m and rad, by how much it must, and its uncertainty.
const WINDOW: [f64; 2] = [0.3, 0.35];
const BETTER: f64 = 0.2;
const FOUND: [f64; 2] = [0.02, 0.02];

/// What a mapper knows by its scans.
#[derive(Debug, Clone)]
pub(super) struct ByScan {
    laser: ScanMapper,
    /// Whether the body stood still between the last two scans although the wheels turned.
    is_blocked: bool,
    /// Scans in a row that contradict the map.
    misfits: u32,
    /// The search for a place on the map that the scans fit, and scans for which it had one.
    finder: Option<Box<Locator>>,
    sure: u32,
}

impl ByScan {
    pub fn new(laser: Laser) -> Self {
        let laser = ScanMapper::new(laser);
        Self { laser, is_blocked: false, misfits: 0, finder: None, sure: 0 }
    }

    /// The same with an existing map.
    pub fn knowing(self, map: &OccupancyMap, marks: &Marks) -> Self {
        Self { laser: self.laser.knowing(map, marks), ..self }
    }

    pub fn relocate(&mut self, pose: Pose) {
        self.finder = None;
        self.laser.relocate(pose);
    }

    pub fn is_blocked(&self) -> bool {
        self.is_blocked
    }

    pub fn bytes(&self) -> usize {
        self.laser.bytes()
    }
}

impl Mapper {
    /// Takes the scan of a reading, if it is a new one.
    pub(super) fn take_scan(&mut self, sensed: &SensorReadings, is_stride: bool) {
        let Some(ByScan { laser, .. }) = &mut self.by_scan else { return };
        if sensed.battery.on_dock && self.travelled + self.way.way < UNDOCKED {
            self.docked = Some(0.0);
        }
        let fresh = laser.fresh(sensed);
        let corrects = self.setup.tracking == Tracking::Corrected;
        if self.is_lost {
            self.find_place(sensed, fresh.is_some());
            return;
        }
        if let Some(scan) = fresh {
            if !corrects {
                laser.paint(&mut self.map, self.ekf.after(&self.way), &scan);
            } else if laser.is_empty() || self.way.way > STILL.0 || self.way.turned > STILL.1 {
                self.match_scan(&scan);
            }
        }
        if is_stride {
            let (pose, is_dirty) = (self.pose(), sensed.dirt > DIRTY);
            paint_place(&mut self.map, &mut self.marks, pose, &self.setup.robot, is_dirty);
            if let Some(by_scan) = &mut self.by_scan {
                by_scan.laser.pass(pose, is_dirty);
            }
        }
    }

    /// Lost, it searches the place on its map that the scans fit.
    fn find_place(&mut self, sensed: &SensorReadings, is_fresh: bool) {
        let Some(by_scan) = &mut self.by_scan else { return };
        if by_scan.finder.is_none() && is_fresh {
            let MapperSetup { robot, odometry, seed, .. } = self.setup.clone();
            let docks: Vec<Pose> = self.berth.iter().map(|&berth| dock_at(berth, &robot)).collect();
            let locator = Locator::new(&self.map, LocatorSetup { robot, odometry, seed });
            by_scan.finder = locator.map(|locator| Box::new(locator.knowing_docks(&docks)));
            by_scan.sure = 0;
        }
        let Some(finder) = &mut by_scan.finder else { return };
        finder.update(sensed);
        if is_fresh {
            by_scan.sure = if finder.is_sure() { by_scan.sure + 1 } else { 0 };
        }
        if by_scan.sure >= SURE
            && let Some((pose, spread)) = finder.pose().zip(finder.pose_covariance())
        {
            self.relocate(pose, &spread);
        }
    }

    /// Ends the stretch: corrects the pose by a scan, and adds it to the map.
    fn match_scan(&mut self, scan: &Arc<[f32]>) {
        let Some(ByScan { laser, is_blocked, misfits, .. }) = &mut self.by_scan else { return };
        let [ahead, turning] = self.way.motion();
        if *is_blocked {
            self.way = self.way.held();
        }
        self.way.settle();
        let points = laser.points(scan);
        self.way.doubt(&Holds::beside(&self.setup.robot, &points).before(self.way.at.heading));
        let before = self.ekf.pose();
        self.ekf.advance(&self.way);
        let is_first = laser.is_empty();
        let surfaces = laser.surfaces(self.ekf.pose());
        let walls = laser.walls(scan);
        let pushes = self.setup.robot.body != Body::Round;
        if pushes && !*is_blocked && self.ekf.surprise(&surfaces.compare(self.ekf.pose(), &points)) > SURPRISING {
            self.ekf.loosen(&self.way.wrong());
        }
        let mut fit = self.ekf.match_scan(&points, (&walls, laser.is_straight()), &surfaces);
        if fit.points >= TELLING
            && fit.share() < MISFIT
            && let Some((pose, better)) = laser.search(self.ekf.pose(), &points, WINDOW)
            && better.share() > fit.share() + BETTER
        {
            let [position, heading] = FOUND;
            let square = position * position;
            self.ekf.relocate(pose, &PoseCovariance { position: [square, 0.0, square], heading });
            fit = better;
        }
        self.ekf.learn_axes(&walls);
        let is_new = fit.agreeing as f64 >= NEW * fit.met as f64;
        let contradicts = fit.points >= TELLING && fit.share() < CONTRADICTS && !is_new;
        *misfits = if contradicts { *misfits + 1 } else { 0 };
        if *misfits >= MISFITS {
            // It was carried elsewhere.
            *misfits = 0;
            self.is_lost = true;
        }
        let after = self.ekf.pose();
        let turned = 0.5 * self.setup.robot.wheel_base * difference(before.heading, after.heading);
        let moved = (after.position() - before.position()).norm() + turned.abs();
        let rolled = ahead.abs() + turning.abs();
        // In a corridor, a scan doesn't tell how far along it the body has moved.
        let along = Vector3::new(after.direction().x, after.direction().y, 0.0);
        let tells = turning.abs() > ahead.abs() || (along.transpose() * fit.information * along)[0] > TELLING_ALONG;
        if rolled > TELLS || !tells {
            *is_blocked = tells && moved < HELD * rolled;
        }
        if let Some(pose) = laser.add(self.ekf.pose(), scan, (&points, &walls), &fit) {
            self.ekf.shift(pose);
        }
        if laser.is_outdated() {
            (self.map, self.marks) = laser.repaint(RESOLUTION, &self.setup.robot);
        }
        if is_first || !fit.is_doubtful() {
            laser.paint(&mut self.map, self.ekf.pose(), scan);
        }
        self.begin_stretch();
    }
}

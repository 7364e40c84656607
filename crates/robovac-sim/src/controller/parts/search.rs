//! Relocalisation of a kidnapped robot on its own map: it follows walls until only one pose is left
//! ([`locate`](crate::mapping::locate)). If it knows its dock and sees the beams, it drives there: on the dock it knows its
//! place (004, section 4.3).

use super::{Behaviour, Obstruction, Pilot};
use crate::{
    controller::{Setup, dock::Dock},
    docking::dock_at,
    mapping::{
        Mapper,
        locate::{Locator, LocatorSetup},
    },
};
use robovac_core::{
    geometry::Pose,
    robot::{Drive, SensorReadings},
};

/// Time limit for relocalising, s (ours).
const SEARCH_S: f64 = 900.0;
/// Time for which only one place must be possible, s (ours). On an incomplete map the first place that fits is often
/// wrong: in the furnished flat, kidnapped after ten minutes of exploring, 6 of 20 robots relocalised at a wrong place
/// without this, and none with it.
const SURE_S: f64 = 30.0;

/// State of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::controller) enum Searched {
    /// In progress.
    Looking,
    /// The mapper has been relocalised.
    Found,
    /// The time limit has passed.
    InVain,
}

/// The search, and the behaviour that drives the robot meanwhile.
#[derive(Clone)]
pub(in crate::controller) struct RelocaliseSearch {
    /// Follows walls, and goes to the dock if that is known.
    driver: Dock,
    knows_dock: bool,
    locator: Option<Box<Locator>>,
    /// Remaining time, s.
    patience: f64,
    /// Time for which only one place has been possible, s.
    sure_s: f64,
}

impl RelocaliseSearch {
    /// No search.
    pub(in crate::controller) fn new(setup: &Setup<'_>) -> Self {
        Self { driver: Dock::new(setup), knows_dock: false, locator: None, patience: 0.0, sure_s: 0.0 }
    }

    /// Starts to relocalise on the map of `mapper`; `false` if the map has neither obstacles nor a dock.
    pub(in crate::controller) fn begin(&mut self, pilot: &mut Pilot, mapper: &Mapper) -> bool {
        let setup = mapper.setup();
        let docks: Vec<Pose> = mapper.berth().iter().map(|&berth| dock_at(berth, &setup.robot)).collect();
        let setup = LocatorSetup { robot: setup.robot.clone(), odometry: setup.odometry, seed: setup.seed };
        let locator = Locator::new(mapper.map(), setup);
        self.locator = locator.map(|locator| Box::new(locator.knowing_docks(&docks)));
        (self.patience, self.sure_s) = (SEARCH_S, 0.0);
        self.knows_dock = !docks.is_empty();
        self.driver.follow_walls(pilot, self.knows_dock);
        self.locator.is_some() || self.knows_dock
    }

    /// Takes the next reading, after `mapper` has; relocalises `mapper` as soon as the place is certain.
    pub(in crate::controller) fn watch(&mut self, mapper: &mut Mapper, sensed: &SensorReadings, dt_s: f64) -> Searched {
        self.patience -= dt_s;
        self.driver.watch(sensed, dt_s);
        if !mapper.is_lost() {
            // Its dock or its laser has told.
            self.locator = None;
            return Searched::Found;
        }
        if let Some(locator) = &mut self.locator {
            locator.update(sensed);
            self.sure_s = if locator.is_sure() { self.sure_s + dt_s } else { 0.0 };
            let is_sure = self.sure_s >= SURE_S;
            if let Some((pose, spread)) = locator.pose().zip(locator.pose_covariance()).filter(|_| is_sure) {
                mapper.relocate(pose, &spread);
                self.locator = None;
                return Searched::Found;
            }
        } else if !self.knows_dock {
            return Searched::InVain;
        }
        if self.patience < 0.0 { Searched::InVain } else { Searched::Looking }
    }

    /// Drives on.
    pub(in crate::controller) fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        self.driver.roam(pilot, sensed, dt_s)
    }

    /// Reacts to an obstruction.
    pub(in crate::controller) fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        self.driver.on_obstruction(pilot, obstruction);
    }

    /// The locator.
    pub(in crate::controller) fn locator(&self) -> Option<&Locator> {
        self.locator.as_deref()
    }
}

//! Relocalisation of a kidnapped robot on its own map: it follows walls until only one pose is left
//! ([`locate`](crate::mapping::locate)).

use super::{Behaviour, Obstruction, Pilot};
use crate::{
    controller::{Setup, wall_follow::WallFollow},
    mapping::{
        Mapper,
        locate::{Locator, LocatorSetup},
    },
};
use robovac_core::robot::{Drive, SensorReadings};

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
    walls: WallFollow,
    locator: Option<Box<Locator>>,
    /// Remaining time, s.
    patience: f64,
    /// Time for which only one place has been possible, s.
    sure_s: f64,
}

impl RelocaliseSearch {
    /// No search.
    pub(in crate::controller) fn new(setup: &Setup<'_>) -> Self {
        Self { walls: WallFollow::usual(setup), locator: None, patience: 0.0, sure_s: 0.0 }
    }

    /// Starts to relocalise on the map of `mapper`; `false` if the map has no obstacles.
    pub(in crate::controller) fn begin(&mut self, pilot: &mut Pilot, mapper: &Mapper) -> bool {
        let setup = mapper.setup();
        let setup = LocatorSetup { robot: setup.robot.clone(), odometry: setup.odometry, seed: setup.seed };
        self.locator = Locator::new(mapper.map(), setup).map(Box::new);
        (self.patience, self.sure_s) = (SEARCH_S, 0.0);
        self.walls.begin(pilot);
        self.locator.is_some()
    }

    /// Takes the next reading, after `mapper` has; relocalises `mapper` as soon as the place is certain.
    pub(in crate::controller) fn watch(&mut self, mapper: &mut Mapper, sensed: &SensorReadings, dt_s: f64) -> Searched {
        self.patience -= dt_s;
        if !mapper.is_lost() {
            // Its laser has told.
            self.locator = None;
            return Searched::Found;
        }
        let Some(locator) = &mut self.locator else { return Searched::InVain };
        locator.update(sensed);
        self.sure_s = if locator.is_sure() { self.sure_s + dt_s } else { 0.0 };
        let is_sure = self.sure_s >= SURE_S;
        if let Some((pose, spread)) = locator.pose().zip(locator.pose_covariance()).filter(|_| is_sure) {
            mapper.relocate(pose, &spread);
            self.locator = None;
            return Searched::Found;
        }
        if self.patience < 0.0 { Searched::InVain } else { Searched::Looking }
    }

    /// Drives on.
    pub(in crate::controller) fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        self.walls.roam(pilot, sensed, dt_s)
    }

    /// Reacts to an obstruction.
    pub(in crate::controller) fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        self.walls.on_obstruction(pilot, obstruction);
    }

    /// The locator.
    pub(in crate::controller) fn locator(&self) -> Option<&Locator> {
        self.locator.as_deref()
    }
}

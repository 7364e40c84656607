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

/// How long it tries to relocalise, s (ours).
const SEARCH_S: f64 = 900.0;
/// How long there has to be only one place, s (ours). On a map that isn't complete the first that fits is often wrong: in the
/// furnished flat, put down anywhere after ten minutes of exploring, 6 of 20 robots found themselves elsewhere without this, and
/// none with it.
const SURE_S: f64 = 30.0;

/// How a search stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::controller) enum Searched {
    /// It goes on.
    Looking,
    /// The mapper knows where it is again.
    Found,
    /// It took too long.
    InVain,
}

/// The search, and what drives the robot meanwhile.
#[derive(Clone)]
pub(in crate::controller) struct RelocaliseSearch {
    walls: WallFollow,
    locator: Option<Box<Locator>>,
    /// How long it goes on looking, s.
    patience: f64,
    /// For how long there has been only one place, s.
    sure_s: f64,
}

impl RelocaliseSearch {
    /// None yet.
    pub(in crate::controller) fn new(setup: &Setup<'_>) -> Self {
        Self { walls: WallFollow::usual(setup), locator: None, patience: 0.0, sure_s: 0.0 }
    }

    /// Starts to look for itself on the map of `mapper`; `false` if there is nothing on it to find oneself by.
    pub(in crate::controller) fn begin(&mut self, pilot: &mut Pilot, mapper: &Mapper) -> bool {
        let setup = mapper.setup();
        let setup = LocatorSetup { robot: setup.robot.clone(), odometry: setup.odometry, seed: setup.seed };
        self.locator = Locator::new(mapper.map(), setup).map(Box::new);
        (self.patience, self.sure_s) = (SEARCH_S, 0.0);
        self.walls.begin(pilot);
        self.locator.is_some()
    }

    /// Takes the next reading, which `mapper` has had before; tells it where it is as soon as that is sure.
    pub(in crate::controller) fn watch(&mut self, mapper: &mut Mapper, sensed: &SensorReadings, dt_s: f64) -> Searched {
        self.patience -= dt_s;
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

    /// Something is in the way.
    pub(in crate::controller) fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        self.walls.on_obstruction(pilot, obstruction);
    }

    /// What looks for it.
    pub(in crate::controller) fn locator(&self) -> Option<&Locator> {
        self.locator.as_deref()
    }
}

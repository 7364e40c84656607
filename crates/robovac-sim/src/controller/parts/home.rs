//! Docks on a low battery and resumes cleaning, on robots that can.

use super::{
    pilot::{Move, Pilot},
    reactive::Behaviour,
};
use crate::controller::{Setup, dock::Dock};
use rand::RngExt;
use robovac_core::{
    math,
    registry::{ParamKind, ParamSpec},
    robot::SensorReadings,
};

/// Distance from the dock before it turns round, m.
const LEAVE: f64 = 0.5;

/// Charge at which it returns to the dock.
pub(in crate::controller) const GO_HOME: ParamSpec = ParamSpec {
    id: "home_at",
    label: "Recharge below",
    help: "Battery charge at which it returns to its dock, if it has infrared receivers; 0 for never.",
    kind: ParamKind::Number { min: 0.0, max: 90.0, step: 1.0, default: 15.0, unit: "%" },
};

/// Charge at which it leaves again.
pub(in crate::controller) const LEAVE_HOME: ParamSpec = ParamSpec {
    id: "leave_at",
    label: "Resume at",
    help: "Battery charge at which it leaves its dock and resumes cleaning.",
    kind: ParamKind::Number { min: 5.0, max: 100.0, step: 1.0, default: 95.0, unit: "%" },
};

/// Watches the battery.
#[derive(Debug, Clone)]
pub(super) struct Home {
    /// Shares of the charge at which it returns and leaves.
    low: f64,
    full: f64,
    dock: Dock,
    phase: HomePhase,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum HomePhase {
    /// The behaviour is active.
    Away,
    Going,
    Charging,
    Leaving,
}

impl Home {
    /// With the parameters of `setup`; `None` without them or for a robot without receivers, contacts or gauge.
    pub(super) fn new(setup: &Setup<'_>) -> Option<Self> {
        let share = |id| setup.params.number(id) / 100.0;
        let (low, battery) = (share(GO_HOME.id), setup.robot.battery);
        let is_able = setup.robot.sensors.infrared && battery.charge_ma > 0.0 && battery.has_gauge;
        // A robot that left below the charge for returning would never get away.
        let full = share(LEAVE_HOME.id).max(low + 0.02).min(1.0);
        (is_able && low > 0.0).then(|| Self { low, full, dock: Dock::new(setup), phase: HomePhase::Away })
    }

    /// Takes a reading; returns whether the robot must stand still to charge, and whether the behaviour starts again.
    pub(super) fn watch(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> (bool, bool) {
        let share = sensed.battery.share();
        if self.phase == HomePhase::Going {
            self.dock.watch(sensed, dt_s);
        }
        match self.phase {
            HomePhase::Away if share < self.low && !pilot.is_busy() => {
                self.phase = HomePhase::Going;
                self.dock.begin(pilot);
            }
            HomePhase::Going if self.dock.is_done() => {
                self.phase = HomePhase::Charging;
                pilot.go(&[]);
            }
            HomePhase::Charging if !sensed.battery.on_dock => {
                // Pushed off the dock, or kidnapped.
                self.phase = HomePhase::Going;
                self.dock.begin(pilot);
            }
            // Charge is reported in whole mAh.
            HomePhase::Charging if share >= self.full - 0.001 => {
                self.phase = HomePhase::Leaving;
                let turn = math::PI * pilot.rng.random_range(0.7..1.3);
                // The floor behind a robot on its dock is the way it came.
                pilot.assume_way_back(LEAVE);
                pilot.go(&[Move::Back(LEAVE), Move::Turn(turn)]);
            }
            HomePhase::Leaving if !pilot.is_busy() => {
                self.phase = HomePhase::Away;
                return (false, true);
            }
            _ => {}
        }
        (self.phase == HomePhase::Charging, false)
    }

    /// The controller that replaces the behaviour, if any.
    pub(super) fn driver(&mut self) -> Option<&mut Dock> {
        (self.phase == HomePhase::Going).then_some(&mut self.dock)
    }

    /// Its activity; `None` while the behaviour is active.
    pub(super) fn activity(&self) -> Option<&'static str> {
        match self.phase {
            HomePhase::Away => None,
            HomePhase::Going => Some(self.dock.activity()),
            HomePhase::Charging => Some("charging"),
            HomePhase::Leaving => Some("leaving the dock"),
        }
    }

    /// Starts over: the robot was moved.
    pub(super) fn begin(&mut self, pilot: &mut Pilot) {
        match self.phase {
            HomePhase::Away => {}
            HomePhase::Leaving => self.phase = HomePhase::Away,
            HomePhase::Going | HomePhase::Charging => {
                self.phase = HomePhase::Going;
                self.dock.begin(pilot);
            }
        }
    }
}

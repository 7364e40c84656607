//! A behaviour as a controller: common reflexes around its own rules.

use super::{home::Home, obstruction::Obstruction, pilot::Pilot};
use crate::{
    controller::{Controller, Intent, Joystick, Setup, interlock::Blocked},
    mapping::Mapper,
};
use robovac_core::{
    geometry::Pose,
    robot::{Drive, SensorReadings},
};

/// What is a behaviour's own: how it drives on free floor, and what it does when something is in the way.
pub(in crate::controller) trait Behaviour {
    /// Starts, or starts over: the robot was moved, or another habit hands over.
    fn begin(&mut self, _: &mut Pilot) {}

    /// Sees every reading, whatever is under way.
    fn watch(&mut self, _: &SensorReadings, _dt_s: f64) {}

    /// Takes what a person wants.
    fn command(&mut self, _: Joystick) {}

    /// What it doesn't obey.
    fn blocked(&self) -> Option<Blocked> {
        None
    }

    /// The map that it makes, if it makes one.
    fn mapper(&self) -> Option<&Mapper> {
        None
    }

    /// What it is going for on that map.
    fn intent(&self) -> Option<Intent<'_>> {
        None
    }

    /// Learns where it starts, in the frame that its map is to have.
    fn start_at(&mut self, _: Pose) {}

    /// Drives on; called while no motions of the pilot are under way. It may order some instead.
    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive;

    /// Decides what to do about something in the way.
    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction);

    /// Whether it has nothing left to do.
    fn is_done(&self) -> bool {
        false
    }

    /// What it is doing while no motions are under way.
    fn activity(&self) -> &'static str;

    /// A copy in the same state.
    fn boxed_clone(&self) -> Box<dyn Behaviour>;
}

/// A habit with a pilot, and with a home to go to if its parameters and the robot say so.
pub(in crate::controller) struct Reactive {
    pilot: Pilot,
    behaviour: Box<dyn Behaviour>,
    home: Option<Home>,
    is_lifted: bool,
}

impl Reactive {
    pub(in crate::controller) fn boxed(setup: &Setup<'_>, behaviour: impl Behaviour + 'static) -> Box<dyn Controller> {
        let (mut pilot, mut behaviour) = (Pilot::new(setup), Box::new(behaviour));
        behaviour.begin(&mut pilot);
        Box::new(Self { pilot, behaviour, home: Home::new(setup), is_lifted: false })
    }

    /// Whether the robot is to stand still whatever the habit wants.
    fn watch(&mut self, sensed: &SensorReadings, dt_s: f64) -> bool {
        let Self { pilot, behaviour, home, is_lifted } = self;
        pilot.sense(sensed, dt_s);
        behaviour.watch(sensed, dt_s);
        if sensed.wheel_dropped() {
            *is_lifted = true;
            return true;
        }
        if *is_lifted {
            *is_lifted = false;
            pilot.reset();
            behaviour.begin(pilot);
            if let Some(home) = home {
                home.begin(pilot);
            }
        }
        let Some(home) = home.as_mut().filter(|_| !behaviour.is_done()) else { return false };
        let (is_charged, is_back) = home.watch(pilot, sensed, dt_s);
        if is_back {
            behaviour.begin(pilot);
        }
        is_charged
    }
}

impl Controller for Reactive {
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive {
        if self.watch(sensed, dt_s) {
            return Drive::STOP;
        }
        let Self { pilot, behaviour, home, .. } = self;
        let driver: &mut dyn Behaviour = match home.as_mut().and_then(Home::driver) {
            Some(dock) => dock,
            None => &mut **behaviour,
        };
        if let Some(obstruction) = pilot.obstruction(sensed) {
            driver.on_obstruction(pilot, obstruction);
        }
        if let Some(drive) = pilot.perform(sensed, dt_s) {
            return drive;
        }
        if driver.is_done() {
            return Drive::STOP;
        }
        let drive = driver.roam(pilot, sensed, dt_s);
        if pilot.is_busy() { pilot.perform(sensed, dt_s).unwrap_or(drive) } else { drive }
    }

    fn is_done(&self) -> bool {
        self.behaviour.is_done()
    }

    fn activity(&self) -> &'static str {
        if self.is_lifted {
            return "lifted, waiting to be put down";
        }
        let home = self.home.as_ref().and_then(Home::activity);
        match (home, self.pilot.activity()) {
            (Some(charging @ ("charging" | "leaving the dock")), _) => charging,
            (Some(home), "") => home,
            (None, "") => self.behaviour.activity(),
            (_, busy) => busy,
        }
    }

    fn command(&mut self, command: Joystick) {
        self.behaviour.command(command);
    }

    fn blocked(&self) -> Option<Blocked> {
        self.behaviour.blocked()
    }

    fn mapper(&self) -> Option<&Mapper> {
        self.behaviour.mapper()
    }

    fn intent(&self) -> Option<Intent<'_>> {
        self.behaviour.intent()
    }

    fn start_at(&mut self, start: Pose) {
        self.behaviour.start_at(start);
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        let Self { pilot, behaviour, home, is_lifted } = self;
        Box::new(Self {
            pilot: pilot.clone(),
            behaviour: behaviour.boxed_clone(),
            home: home.clone(),
            is_lifted: *is_lifted,
        })
    }
}

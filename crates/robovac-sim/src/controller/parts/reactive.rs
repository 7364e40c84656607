//! A behaviour as a controller: common reflexes around its own rules.

use super::{LIFTED, home::Home, obstruction::Obstruction, pilot::Pilot};
use crate::{
    controller::{Controller, Intent, Joystick, Setup, interlock::Blocked},
    mapping::Mapper,
};
use robovac_core::{
    geometry::Pose,
    robot::{Drive, SensorReadings},
};

/// The specific part of a behaviour: driving on free floor, and reactions to obstructions.
pub(in crate::controller) trait Behaviour {
    /// Starts, or starts over: after the robot was moved, or when another behaviour hands over.
    fn begin(&mut self, _: &mut Pilot) {}

    /// Takes every reading, even during motions.
    fn watch(&mut self, _: &SensorReadings, _dt_s: f64) {}

    /// Takes a joystick command.
    fn command(&mut self, _: Joystick) {}

    /// The blocked part of commands.
    fn blocked(&self) -> Option<Blocked> {
        None
    }

    /// The map that it makes, if it makes one.
    fn mapper(&self) -> Option<&Mapper> {
        None
    }

    /// Its goal on that map.
    fn intent(&self) -> Option<Intent<'_>> {
        None
    }

    /// Sets its start in the frame that its map is to have.
    fn start_at(&mut self, _: Pose) {}

    /// Continues driving; called while the pilot has no motions. It can order some instead.
    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive;

    /// Reacts to an obstruction.
    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction);

    /// Whether it is done.
    fn is_done(&self) -> bool {
        false
    }

    /// Its activity while the pilot has no motions.
    fn activity(&self) -> &'static str;

    /// A copy in the same state.
    fn boxed_clone(&self) -> Box<dyn Behaviour>;
}

/// A behaviour with a pilot, and with a dock to return to if its parameters and the robot allow it.
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

    /// Whether the robot must stand still regardless of the behaviour.
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
            return LIFTED;
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

//! A behaviour as a controller: common reflexes around its own rules.

use super::{hit::Hit, home::Home, pilot::Pilot};
use crate::{
    controller::{Command, Controller, Intent, Setup, interlock::Blocked},
    mapping::Mapper,
};
use robovac_core::{
    geometry::Pose,
    robot::{Drive, Sensors},
};

/// What is a behaviour's own: how it drives on free floor, and what it does when something is in the way.
pub(in crate::controller) trait Habit {
    /// Starts, or starts over: the robot was moved, or another habit hands over.
    fn begin(&mut self, _: &mut Pilot) {}

    /// Sees every reading, whatever is under way.
    fn watch(&mut self, _: &Sensors, _dt_s: f64) {}

    /// Takes what a person wants.
    fn command(&mut self, _: Command) {}

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
    fn roam(&mut self, pilot: &mut Pilot, sensed: &Sensors, dt_s: f64) -> Drive;

    /// Decides what to do about something in the way.
    fn hit(&mut self, pilot: &mut Pilot, hit: Hit);

    /// Whether it has nothing left to do.
    fn is_done(&self) -> bool {
        false
    }

    /// What it is doing while no motions are under way.
    fn activity(&self) -> &'static str;

    /// A copy in the same state.
    fn boxed_clone(&self) -> Box<dyn Habit>;
}

/// A habit with a pilot, and with a home to go to if its parameters and the robot say so.
pub(in crate::controller) struct Driven {
    pilot: Pilot,
    habit: Box<dyn Habit>,
    home: Option<Home>,
    is_lifted: bool,
}

impl Driven {
    pub(in crate::controller) fn boxed(setup: &Setup<'_>, habit: impl Habit + 'static) -> Box<dyn Controller> {
        let (mut pilot, mut habit) = (Pilot::new(setup), Box::new(habit));
        habit.begin(&mut pilot);
        Box::new(Self { pilot, habit, home: Home::new(setup), is_lifted: false })
    }

    /// Whether the robot is to stand still whatever the habit wants.
    fn watch(&mut self, sensed: &Sensors, dt_s: f64) -> bool {
        let Self { pilot, habit, home, is_lifted } = self;
        pilot.sense(sensed, dt_s);
        habit.watch(sensed, dt_s);
        if sensed.wheel_dropped() {
            *is_lifted = true;
            return true;
        }
        if *is_lifted {
            *is_lifted = false;
            pilot.reset();
            habit.begin(pilot);
            if let Some(home) = home {
                home.begin(pilot);
            }
        }
        let Some(home) = home.as_mut().filter(|_| !habit.is_done()) else { return false };
        let (is_charged, is_back) = home.watch(pilot, sensed, dt_s);
        if is_back {
            habit.begin(pilot);
        }
        is_charged
    }
}

impl Controller for Driven {
    fn step(&mut self, sensed: &Sensors, dt_s: f64) -> Drive {
        if self.watch(sensed, dt_s) {
            return Drive::STOP;
        }
        let Self { pilot, habit, home, .. } = self;
        let driver: &mut dyn Habit = match home.as_mut().and_then(Home::driver) {
            Some(dock) => dock,
            None => &mut **habit,
        };
        if let Some(hit) = pilot.hit(sensed) {
            driver.hit(pilot, hit);
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
        self.habit.is_done()
    }

    fn activity(&self) -> &'static str {
        if self.is_lifted {
            return "lifted, waiting to be put down";
        }
        let home = self.home.as_ref().and_then(Home::activity);
        match (home, self.pilot.activity()) {
            (Some(charging @ ("charging" | "leaving the dock")), _) => charging,
            (Some(home), "") => home,
            (None, "") => self.habit.activity(),
            (_, busy) => busy,
        }
    }

    fn command(&mut self, command: Command) {
        self.habit.command(command);
    }

    fn blocked(&self) -> Option<Blocked> {
        self.habit.blocked()
    }

    fn mapper(&self) -> Option<&Mapper> {
        self.habit.mapper()
    }

    fn intent(&self) -> Option<Intent<'_>> {
        self.habit.intent()
    }

    fn start_at(&mut self, start: Pose) {
        self.habit.start_at(start);
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        let Self { pilot, habit, home, is_lifted } = self;
        Box::new(Self { pilot: pilot.clone(), habit: habit.boxed_clone(), home: home.clone(), is_lifted: *is_lifted })
    }
}

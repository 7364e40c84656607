//! A behaviour as a controller: the reflexes that all have, around what is its own.

use super::{hit::Hit, pilot::Pilot};
use crate::{
    controller::{Controller, Setup},
    robot::{Drive, Sensors},
};

/// What is a behaviour's own: how it drives on free floor, and what it does when something is in the way.
pub(in crate::controller) trait Habit {
    /// Starts, or starts over: somebody has put the robot elsewhere, or another habit hands over.
    fn begin(&mut self, _: &mut Pilot) {}

    /// Lets time pass, whatever is under way.
    fn tick(&mut self, _dt_s: f64) {}

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

/// A habit with a pilot.
pub(in crate::controller) struct Driven {
    pilot: Pilot,
    habit: Box<dyn Habit>,
    is_lifted: bool,
}

impl Driven {
    pub(in crate::controller) fn boxed(setup: &Setup<'_>, habit: impl Habit + 'static) -> Box<dyn Controller> {
        let (mut pilot, mut habit) = (Pilot::new(setup), Box::new(habit));
        habit.begin(&mut pilot);
        Box::new(Self { pilot, habit, is_lifted: false })
    }
}

impl Controller for Driven {
    fn step(&mut self, sensed: &Sensors, dt_s: f64) -> Drive {
        let Self { pilot, habit, is_lifted } = self;
        pilot.sense(sensed, dt_s);
        if sensed.wheel_dropped() {
            *is_lifted = true;
            return Drive::STOP;
        }
        if *is_lifted {
            *is_lifted = false;
            pilot.reset();
            habit.begin(pilot);
        }
        habit.tick(dt_s);
        if let Some(hit) = pilot.hit(sensed) {
            habit.hit(pilot, hit);
        }
        if let Some(drive) = pilot.perform(sensed, dt_s) {
            return drive;
        }
        if habit.is_done() {
            return Drive::STOP;
        }
        let drive = habit.roam(pilot, sensed, dt_s);
        if pilot.is_busy() { pilot.perform(sensed, dt_s).unwrap_or(drive) } else { drive }
    }

    fn is_done(&self) -> bool {
        self.habit.is_done()
    }

    fn activity(&self) -> &'static str {
        if self.is_lifted {
            return "waiting to be put down";
        }
        match self.pilot.activity() {
            "" => self.habit.activity(),
            busy => busy,
        }
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(Self { pilot: self.pilot.clone(), habit: self.habit.boxed_clone(), is_lifted: self.is_lifted })
    }
}

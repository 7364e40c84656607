//! The controller that repeats what a program commanded.

use super::{CommandLog, LogEnd};
use crate::controller::Controller;
use robovac_core::robot::{Drive, SensorReadings};
use std::{
    cell::{Ref, RefCell, RefMut},
    rc::Rc,
};

/// A log that grows while a run repeats it.
#[derive(Debug, Clone, Default)]
pub struct SharedLog(Rc<RefCell<CommandLog>>);

impl SharedLog {
    /// Shares `log`.
    pub fn new(log: CommandLog) -> Self {
        Self(Rc::new(RefCell::new(log)))
    }

    /// The log as it is now.
    pub fn get(&self) -> Ref<'_, CommandLog> {
        self.0.borrow()
    }

    /// The log, to be changed.
    pub fn get_mut(&self) -> RefMut<'_, CommandLog> {
        self.0.borrow_mut()
    }
}

/// Drives as a program did. Its state is a position in the log, which all copies share: so they are cheap, and all of
/// them know when the log has grown.
#[derive(Debug, Clone)]
pub struct Logged {
    log: SharedLog,
    /// Steps so far.
    step: u32,
    /// Index of the next change.
    next: usize,
    drive: Drive,
}

impl Logged {
    /// Repeats `log` from its beginning.
    pub fn new(log: SharedLog) -> Self {
        Self { log, step: 0, next: 0, drive: Drive::STOP }
    }

    /// How the program has ended by now, if it has.
    fn end(&self) -> Option<LogEnd> {
        let log = self.log.get();
        log.end().filter(|_| self.step >= log.until())
    }
}

impl Controller for Logged {
    fn step(&mut self, _: &SensorReadings, _: f64) -> Drive {
        if self.end().is_some() {
            self.drive = Drive::STOP;
        } else {
            let log = self.log.get();
            if let Some(change) = log.changes().get(self.next).filter(|change| change.step <= self.step) {
                self.drive = change.drive();
                self.next += 1;
            }
        }
        self.step = self.step.saturating_add(1);
        self.drive
    }

    fn is_done(&self) -> bool {
        self.end().is_some()
    }

    fn waits(&self) -> bool {
        let log = self.log.get();
        log.end().is_none() && self.step >= log.until()
    }

    fn activity(&self) -> &'static str {
        match self.end() {
            None => "following its program",
            Some(LogEnd::Done) => "",
            Some(LogEnd::Failed) => "stopped, as its program failed",
        }
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}

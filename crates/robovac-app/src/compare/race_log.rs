//! What the user's program does in a race.

use robovac_sim::program::{LogError, LogPart, SharedLog};

/// The log of the program in the latest race.
#[derive(Default)]
pub(super) struct RaceLog {
    /// Key of what it depends on.
    key: String,
    log: SharedLog,
    /// Number of the log.
    number: u32,
    /// Whether its job was handed out.
    is_taken: bool,
    /// Why the program failed, for users; empty if it didn't.
    failure: String,
}

impl RaceLog {
    /// The log for what has that key; a new one if that is another than before.
    pub fn of(&mut self, key: &str) -> SharedLog {
        if self.key != key {
            *self = Self { key: key.to_owned(), number: self.number + 1, ..Self::default() };
        }
        self.log.clone()
    }

    /// Number of a log that nobody makes yet, returned once.
    pub fn take(&mut self) -> Option<u32> {
        let is_new = self.number > 0 && !std::mem::replace(&mut self.is_taken, true);
        is_new.then_some(self.number)
    }

    /// Takes a part of the log with that number; of an older one, it is left out and the result is false.
    pub fn extend(&mut self, number: u32, part: &[u8]) -> Result<bool, LogError> {
        if number != self.number {
            return Ok(false);
        }
        self.log.get_mut().extend(LogPart::from_bytes(part)?)?;
        Ok(true)
    }

    /// The program that makes the log with that number has failed.
    pub fn fail(&mut self, number: u32, message: &str) {
        if number == self.number {
            message.clone_into(&mut self.failure);
        }
    }

    /// Why the program failed, for users; empty if it didn't.
    pub fn failure(&self) -> &str {
        &self.failure
    }
}

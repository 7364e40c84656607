//! What a user's program commanded, for a run that repeats it while the program goes on elsewhere.

use robovac_sim::program::{LogEnd, LogError, LogPart, SharedLog};

/// The log of the program that drives a run, and its version.
#[derive(Default)]
pub(crate) struct LoggedProgram {
    pub log: SharedLog,
    /// Changes when the program has to be run again: from the start, or from a person's last input on.
    pub version: u32,
}

impl LoggedProgram {
    /// Begins with an empty log.
    pub fn restart(&mut self) {
        *self = Self { log: SharedLog::default(), version: self.version.wrapping_add(1) };
    }

    /// Forgets what the program did after a person's input at `step`.
    pub fn cut(&mut self, step: u64) {
        self.log.get_mut().truncate(short(step));
        self.version = self.version.wrapping_add(1);
    }

    /// Takes a part of the log of that version, for a run that was shown up to the step `shown`; of an older one, it is left
    /// out and the result is false.
    pub fn extend(&self, version: u32, shown: u64, part: &[u8]) -> Result<bool, LogError> {
        if version != self.version {
            return Ok(false);
        }
        // What was shown isn't changed behind the user's back.
        self.log.get_mut().extend_beyond(short(shown), LogPart::from_bytes(part)?)?;
        Ok(true)
    }

    /// The program of that version has failed, and is heard no more.
    pub fn fail(&self, version: u32) {
        if version == self.version {
            self.log.get_mut().finish(LogEnd::Failed);
        }
    }
}

fn short(step: u64) -> u32 {
    u32::try_from(step).unwrap_or(u32::MAX)
}

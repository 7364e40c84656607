//! The moment of a run in a link: who opens it sees the run as it was when the link was made.

use super::Session;
use crate::explore::SessionState;
use robovac_sim::experiment::SettingsError;

/// Key in links.
pub(super) const MOMENT: &str = "moment";
/// What a value ends with if time stands still.
const PAUSED: &str = ",paused";
/// Latest moment, s: simulating up to it takes seconds.
const LATEST_S: f64 = 86_400.0;

/// A moment of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moment {
    time_s: f64,
    is_paused: bool,
}

impl Moment {
    /// Whether it is that before the robot has started.
    pub(super) fn is_start(self) -> bool {
        self.time_s <= 0.0
    }

    pub(super) fn parse(value: &str) -> Result<Self, SettingsError> {
        let (time, is_paused) = value.strip_suffix(PAUSED).map_or((value, false), |time| (time, true));
        match time.parse() {
            Ok(time_s) if (0.0..=LATEST_S).contains(&time_s) => Ok(Self { time_s, is_paused }),
            _ => Err(SettingsError::Invalid {
                kind: "the moment",
                value: value.to_owned(),
                expected: "seconds from 0 to 86400, e.g. 83.2 or 83.2,paused",
            }),
        }
    }
}

impl Session {
    /// The shown moment as a pair for a link; empty while a run that plays hasn't started. `None` if a link can't lead to it: what
    /// was done by hand isn't in links, nor what was swept before the room was changed, nor what a user's program has done.
    pub fn moment_pair(&self) -> Option<String> {
        let state = self.state();
        let paused = if state == SessionState::Playing { "" } else { PAUSED };
        let Some(recording) = self.recording.as_ref().filter(|_| state != SessionState::Planning) else {
            return Some(String::new());
        };
        let run = recording.run();
        match run.steps() {
            _ if self.before.is_some() => None,
            0 if self.playing => Some(String::new()),
            0 => Some(format!("{MOMENT}=0{PAUSED}")),
            steps if self.program_drives() || recording.inputs().iter().any(|&(step, _)| step <= steps) => None,
            _ => Some(format!("{MOMENT}={:.3}{paused}", run.time_s())),
        }
    }

    /// Goes to the moment of a link, as soon as there is a plan.
    pub(super) fn go_to(&mut self, moment: Moment) {
        self.playing = !moment.is_paused;
        self.awaited = Some(moment);
        self.go_to_awaited();
    }

    /// Goes to the moment that is waited for. A run that begins again, with rounded corners, goes there, too.
    pub(super) fn go_to_awaited(&mut self) {
        if let (Some(moment), Some(recording)) = (self.awaited, &mut self.recording) {
            recording.seek_ahead(moment.time_s);
        }
    }
}

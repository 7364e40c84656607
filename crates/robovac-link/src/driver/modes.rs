//! Commanded and actual mode.

use super::{Actuators, ConnectionPhase, Driver, Happening, MODE_S, ModeLoss, SETTLE_S, STOP};
use roomba_oi::{Command, Mode};

impl Driver {
    /// Whether the robot was commanded to Safe or Full and is there.
    pub fn is_armed(&self) -> bool {
        self.phase == ConnectionPhase::Connected && self.target > Mode::Passive && self.target_reached
    }

    /// Puts the robot in `mode`. [`Mode::Safe`] and [`Mode::Full`] take control, [`Mode::Passive`] gives it up; the
    /// robot stands still in each case.
    pub fn put_in(&mut self, now: f64, mode: Mode) {
        self.dropped = None;
        self.halt(now);
        self.aim(mode, now);
        self.tell_mode(now);
    }

    /// Sets the target mode, whose command was sent.
    pub(super) fn aim(&mut self, mode: Mode, now: f64) {
        (self.target, self.target_since, self.target_told, self.target_reached) = (mode, now, now, false);
        self.was_in_control |= mode > Mode::Passive;
    }

    pub(super) fn tell_mode(&mut self, now: f64) {
        self.target_told = now;
        let command = match self.target {
            Mode::Off => Command::Stop,
            Mode::Passive => Command::Start,
            Mode::Safe => Command::Safe,
            Mode::Full => Command::Full,
        };
        // It has no data that could be invalid.
        let _ = self.send(now, command);
    }

    pub(super) fn watch_mode(&mut self, now: f64) {
        // Off and modes above Full are never reported, so the offset of the mode byte must be corrected.
        match (self.mode_offset, self.readings.mode) {
            (1, 1) => self.mode_offset = 0,
            (0, 4) => self.mode_offset = 1,
            _ => {}
        }
        let Some(mode) = self.mode() else { return };
        let since = now - self.target_since;
        if since < SETTLE_S {
            return;
        }
        if mode <= Mode::Passive {
            self.actuators = Actuators::default();
        }
        if self.target <= Mode::Passive && mode > Mode::Passive {
            // The command to give control up was lost and the robot can even be driving; it is repeated until it
            // arrives.
            if now - self.target_told > MODE_S {
                self.push(now, &STOP);
                self.tell_mode(now);
            }
            return;
        }
        if mode == self.target {
            self.target_reached = true;
        } else if self.target > Mode::Passive && (self.target_reached || since > 3.0 * MODE_S) {
            self.drop_to(now, mode);
        } else if !self.target_reached && now - self.target_told > MODE_S && since < 10.0 {
            self.tell_mode(now);
        }
    }

    pub(super) fn drop_to(&mut self, now: f64, mode: Mode) {
        let drop = ModeLoss::new(self.target, self.target_reached, [&self.before, &self.readings]);
        self.happened(now, Happening::Line(drop.to_string()));
        self.dropped = Some(drop);
        self.wheels.stop();
        self.aim(mode.min(Mode::Passive), now);
    }

    /// Why the robot left Safe or Full, until the next mode command.
    pub fn dropped(&self) -> Option<&ModeLoss> {
        self.dropped.as_ref()
    }

    /// The reported mode.
    pub fn mode(&self) -> Option<Mode> {
        self.has_read.then(|| Mode::from_report(self.readings.mode, self.mode_offset)).flatten()
    }

    /// The target mode.
    pub fn target(&self) -> Mode {
        self.target
    }

    /// Offset of its mode byte: 0 or 1.
    pub fn mode_offset(&self) -> u8 {
        self.mode_offset
    }
}

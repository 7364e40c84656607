//! Commands sent to the robot.

use super::{Actuators, ConnectionPhase, Driver, Finding, Happening, STOP, Step, happened};
use robovac_core::robot::Drive;
use roomba_oi::{Command, CommandDecoder, CommandRefusal, MAX_WRITTEN, Mode, Motors};

/// Longest possible list of packets, bytes.
const LONGEST_LIST: usize = 255;

impl Driver {
    /// Sets wheel speeds for 200 ms; no effect unless armed.
    pub fn drive(&mut self, now: f64, wanted: Drive) {
        if self.is_armed() && !self.is_stalled {
            self.wheels.drive(now, wanted);
            self.turn_wheels(now);
        }
    }

    /// Sets duty cycles of the wheels in 1/255, right and left, for 200 ms; no effect unless armed. The robot's controller
    /// of speeds is out of it, and its reports don't confirm them.
    pub fn drive_by_power(&mut self, now: f64, right: i16, left: i16) -> Result<(), CommandRefusal> {
        if !self.is_armed() || self.is_stalled {
            return Ok(());
        }
        if (right, left) == (0, 0) {
            self.stop(now);
            return Ok(());
        }
        self.send(now, Command::DrivePwm { right, left })?;
        self.wheels.by_power(now);
        Ok(())
    }

    /// Stops the wheels at once, in every mode.
    pub fn stop(&mut self, now: f64) {
        self.wheels.stop();
        if self.phase == ConnectionPhase::Closed {
            return;
        }
        self.push(now, &STOP);
        // A query that is waiting must not be sent after the stop.
        if self.question.take().is_some() {
            let _ = self.send(now, Command::PauseResume { state: 1 });
        }
    }

    /// Stops wheels, brushes and vacuum.
    pub fn halt(&mut self, now: f64) {
        self.stop(now);
        self.stop_brushes(now);
    }

    /// Stops brushes and vacuum.
    pub fn stop_brushes(&mut self, now: f64) {
        if self.phase != ConnectionPhase::Closed {
            let _ = self.send(now, Command::Motors(Motors::default()));
        }
    }

    /// Stops everything, including the robot's own programs: as Passive ignores wheel commands, the robot is put in
    /// Safe for a moment, where it stands still.
    pub fn freeze(&mut self, now: f64) {
        let is_by_itself = self.phase != ConnectionPhase::Closed && self.target <= Mode::Passive;
        if is_by_itself {
            let _ = self.send(now, Command::Safe);
        }
        self.halt(now);
        if is_by_itself {
            let _ = self.send(now, Command::Start);
        }
    }

    /// Stops everything and ends the interface: the robot is in Off, where it charges and sleeps.
    pub fn leave(&mut self, now: f64) {
        if self.phase != ConnectionPhase::Closed {
            self.halt(now);
            if self.poll.is_wanted {
                // Fills up a list with a garbled length, which would swallow the next command, even a stop.
                self.push(now, &[0; LONGEST_LIST]);
                self.halt(now);
            }
            for command in [Command::PauseResume { state: 0 }, Command::Start, Command::Stop] {
                let _ = self.send(now, command);
            }
        }
        self.phase = ConnectionPhase::Closed;
        self.diagnosis.step = Step::Idle;
        self.firmware = None;
    }

    pub(super) fn turn_wheels(&mut self, now: f64) {
        if !matches!(self.phase, ConnectionPhase::Connected | ConnectionPhase::Lost) {
            return;
        }
        let tells = self.has_read && self.subscriptions().tells_speeds;
        let reported = (self.is_armed() && tells && !self.is_stalled)
            .then_some((self.readings.requested_right, self.readings.requested_left));
        let before = self.wheels.sent();
        if let Some((right, left)) = self.wheels.due(now, reported) {
            self.filter.asked(right, left);
            if before != (right, left) {
                self.link_stats.asked(now, (right, left));
            }
            let _ = self.send(now, Command::DriveDirect { right, left });
        }
    }

    /// Sends a command that affects neither mode nor wheels, or refuses an invalid one.
    pub fn send(&mut self, now: f64, command: Command<'_>) -> Result<(), CommandRefusal> {
        let mut buffer = [0; MAX_WRITTEN];
        let bytes = command.encode(&mut buffer)?;
        self.push(now, bytes);
        Ok(())
    }

    /// Presses a button, which starts the robot's own program; ends control.
    pub fn press(&mut self, now: f64, command: Command<'_>) {
        self.halt(now);
        let _ = self.send(now, command);
        self.aim(Mode::Passive, now);
        self.dropped = None;
    }

    /// Restarts the robot (7), which reports its firmware, and starts the diagnosis again.
    pub fn restart(&mut self, now: f64) {
        self.halt(now);
        let _ = self.send(now, Command::Reset);
        self.aim(Mode::Passive, now);
        self.has_read = false;
        self.begin(now);
        self.diagnosis.finding = Finding::Nothing;
        self.diagnosis.boots = 1;
        let _ = self.parser.expect(&[]);
    }

    /// Brushes, vacuum and lights as commanded.
    pub fn actuators(&self) -> &Actuators {
        &self.actuators
    }

    pub(super) fn push(&mut self, now: f64, bytes: &[u8]) {
        if self.is_replay {
            return;
        }
        self.bytes[1] += bytes.len() as u64;
        self.tx.extend_from_slice(bytes);
        let mut decoder = CommandDecoder::default();
        for &byte in bytes {
            if let Some(Ok(command)) = decoder.push(byte).map(|received| received.command) {
                self.actuators.take(command);
            }
        }
        self.happened(now, Happening::Sent(bytes.to_vec()));
    }

    pub(super) fn happened(&mut self, now: f64, happening: Happening) {
        happened(&mut self.happenings, now, happening);
    }
}

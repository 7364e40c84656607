//! Commands sent to the robot.

use super::{ConnectionPhase, Driver, Finding, Happening, STOP, Step, distance_angle_poll::subscriptions, happened};
use robovac_core::robot::Drive;
use roomba_oi::{Command, CommandRefusal, MAX_WRITTEN, Mode, Motors};

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
        let tells = self.has_read && subscriptions(self.baud).tells_speeds;
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

    pub(super) fn push(&mut self, now: f64, bytes: &[u8]) {
        if self.is_replay {
            return;
        }
        self.bytes[1] += bytes.len() as u64;
        self.tx.extend_from_slice(bytes);
        self.happened(now, Happening::Sent(bytes.to_vec()));
    }

    pub(super) fn happened(&mut self, now: f64, happening: Happening) {
        happened(&mut self.happenings, now, happening);
    }
}

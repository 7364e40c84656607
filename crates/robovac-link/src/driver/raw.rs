//! Raw bytes, typed by the user or from a recording.

use super::{ConnectionPhase, Driver, Happening, PendingQuery, Step};
use roomba_oi::{Command, CommandDecoder, Mode, Opcode};
use thiserror::Error;

/// Reasons for refusing typed bytes.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum RawRefusal {
    /// The robot would take the next commands, even a stop, as the rest of this one.
    #[error(
        "These bytes end in the middle of {0}: the robot would read the next bytes, even a stop command, as the rest \
         of it. Complete it."
    )]
    Incomplete(Opcode),
    /// The robot would change to another baud rate.
    #[error("After a change of baud rate, this page could neither receive from the robot nor stop it.")]
    Baud,
}

impl Driver {
    /// Sends raw bytes. A motion command in them holds until the next stop; for a query the stream is paused until the
    /// answer has arrived.
    pub fn send_raw(&mut self, now: f64, bytes: &[u8]) -> Result<(), RawRefusal> {
        let mut decoder = CommandDecoder::default();
        for &byte in bytes {
            if let Some(Ok(Command::Baud { .. })) = decoder.push(byte).map(|received| received.command) {
                return Err(RawRefusal::Baud);
            }
        }
        if let Some((opcode, _)) = decoder.waiting() {
            return Err(RawRefusal::Incomplete(opcode));
        }
        self.question = PendingQuery::of(bytes, now);
        if self.question.is_some() {
            self.link_stats.pause();
            let _ = self.send(now, Command::PauseResume { state: 0 });
        } else {
            self.push_raw(now, bytes);
        }
        Ok(())
    }

    pub(super) fn push_raw(&mut self, now: f64, bytes: &[u8]) {
        let mut decoder = CommandDecoder::default();
        for &byte in bytes {
            let Some(Ok(command)) = decoder.push(byte).map(|received| received.command) else { continue };
            match command {
                Command::DriveDirect { right, left } => {
                    self.filter.asked(right, left);
                    self.wheels.by_hand(now, right, left);
                }
                Command::Drive { .. } | Command::DrivePwm { .. } => self.wheels.by_other_hand(),
                _ => {}
            }
            if let Some(mode) = self.mode().and_then(|mode| mode.after_command(command.opcode()))
                && Some(mode) != self.mode()
            {
                self.aim(mode, now);
            }
        }
        self.push(now, bytes);
    }

    /// Switches to replay: own bytes are discarded, and sent bytes are reported by [`Self::was_sent`].
    pub fn replay(&mut self) {
        self.is_replay = true;
    }

    /// Takes bytes as sent, in a replay.
    pub fn was_sent(&mut self, now: f64, bytes: &[u8]) {
        self.bytes[1] += bytes.len() as u64;
        self.happened(now, Happening::Sent(bytes.to_vec()));
        let mut decoder = CommandDecoder::default();
        for &byte in bytes {
            let Some(Ok(command)) = decoder.push(byte).map(|received| received.command) else { continue };
            self.actuators.take(command);
            let mode = match command {
                Command::DriveDirect { right, left } => {
                    self.filter.asked(right, left);
                    if (right, left) != self.wheels.sent() {
                        self.link_stats.asked(now, (right, left));
                    }
                    self.wheels.by_hand(now, right, left);
                    continue;
                }
                Command::SensorReadings { packet: 35 }
                    if matches!(self.phase, ConnectionPhase::Diagnosing | ConnectionPhase::Waiting) =>
                {
                    self.diagnosis.go(Step::Asking, now);
                    self.classifier.clear();
                    continue;
                }
                Command::Safe => Mode::Safe,
                Command::Full => Mode::Full,
                Command::Start | Command::Clean | Command::Spot | Command::SeekDock | Command::Power => Mode::Passive,
                _ => continue,
            };
            if mode != self.target {
                self.dropped = None;
                self.aim(mode, now);
            }
        }
    }
}

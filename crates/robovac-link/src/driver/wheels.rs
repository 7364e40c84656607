//! Motion commands, with the timeout that stops the robot.
//!
//! The interface has no timeout: a robot executes its last command for ever. So wheel speeds hold for [`DEAD_MAN_S`]
//! only, a stop is repeated until the robot reports it, and speeds are sent again to a robot that reports others.

use robovac_core::robot::Drive;
use roomba_oi::{Command, motion::MAX_SPEED_MM_S};

/// Time for which wheel speeds hold unless they are renewed, s.
pub const DEAD_MAN_S: f64 = 0.2;
/// Interval at which speeds are sent again in case they were lost, s.
const REFRESH_S: f64 = 0.06;
/// Times between repeated stops, s.
const STOP_EVERY_S: f64 = 0.03;
/// Least number of times a stop is sent.
const LEAST_STOPS: u32 = 3;
/// Time after which the robot should report a command, s: three frames and the transmission.
const ECHO_S: f64 = 0.12;

/// The wheel commands.
#[derive(Debug, Clone)]
pub struct WheelCommand {
    /// Speeds of the right and left wheel, mm/s.
    wanted: (i16, i16),
    renewed_at: f64,
    /// The last sent speeds, and their time.
    sent: (i16, i16),
    sent_at: f64,
    /// Time of the last change of the sent speeds.
    changed_at: f64,
    stops_due: u32,
    /// Speeds were sent as raw bytes, and hold until the next stop.
    is_by_hand: bool,
    /// They were sent as radius or duty cycles: the robot moves and isn't corrected.
    is_other: bool,
}

impl Default for WheelCommand {
    fn default() -> Self {
        let never = f64::NEG_INFINITY;
        Self {
            wanted: (0, 0),
            renewed_at: never,
            sent: (0, 0),
            sent_at: never,
            changed_at: never,
            stops_due: 0,
            is_by_hand: false,
            is_other: false,
        }
    }
}

impl WheelCommand {
    /// Sets wheel speeds for [`DEAD_MAN_S`].
    pub fn drive(&mut self, now: f64, wanted: Drive) {
        let Command::DriveDirect { right, left } = crate::sensors::drive_command(wanted) else { return };
        if (right, left) == (0, 0) && self.wanted != (0, 0) {
            self.stops_due = LEAST_STOPS;
        }
        (self.wanted, self.renewed_at, self.is_by_hand, self.is_other) = ((right, left), now, false, false);
    }

    /// Stops. A pending transmission is due at once.
    pub fn stop(&mut self) {
        self.wanted = (0, 0);
        (self.is_by_hand, self.is_other) = (false, false);
        self.stops_due = LEAST_STOPS;
        self.sent_at = f64::NEG_INFINITY;
    }

    /// Speeds were sent as raw bytes, right and left.
    pub fn by_hand(&mut self, now: f64, right: i16, left: i16) {
        let within = |v: i16| v.clamp(-MAX_SPEED_MM_S, MAX_SPEED_MM_S);
        self.wanted = (within(right), within(left));
        (self.sent, self.sent_at, self.changed_at) = (self.wanted, now, now);
        self.is_by_hand = self.wanted != (0, 0);
        (self.is_other, self.stops_due) = (false, 0);
    }

    /// Another motion command was sent as raw bytes.
    pub fn by_other_hand(&mut self) {
        (self.is_by_hand, self.is_other, self.stops_due) = (true, true, 0);
    }

    /// Duty cycles were sent, which hold for [`DEAD_MAN_S`].
    pub fn by_power(&mut self, now: f64) {
        (self.wanted, self.sent) = ((0, 0), (0, 0));
        (self.is_by_hand, self.is_other, self.stops_due, self.renewed_at) = (false, true, 0, now);
    }

    /// Whether the robot is commanded to move.
    pub fn is_moving(&self) -> bool {
        self.wanted != (0, 0) || self.is_other
    }

    /// Whether it moves by radius or duty cycles.
    pub fn is_other(&self) -> bool {
        self.is_other
    }

    /// The last sent speeds of the right and left wheel, mm/s.
    pub fn sent(&self) -> (i16, i16) {
        self.sent
    }

    /// The speeds, right and left, to be sent now, if any. `reported` are those in the robot's latest report, if known.
    pub fn due(&mut self, now: f64, reported: Option<(i16, i16)>) -> Option<(i16, i16)> {
        if self.is_moving() && !self.is_by_hand && now - self.renewed_at > DEAD_MAN_S {
            self.stop();
        }
        if self.is_other {
            return None;
        }
        let since = now - self.sent_at;
        let is_deaf = now - self.changed_at > ECHO_S && reported.is_some_and(|reported| reported != self.wanted);
        let is_due = if self.wanted == self.sent {
            let repeats = self.stops_due > 0 || is_deaf;
            (repeats && since >= STOP_EVERY_S) || (self.is_moving() && !self.is_by_hand && since >= REFRESH_S)
        } else {
            true
        };
        if !is_due {
            return None;
        }
        if self.wanted != self.sent {
            self.changed_at = now;
        }
        (self.sent, self.sent_at) = (self.wanted, now);
        if !self.is_moving() {
            self.stops_due = self.stops_due.saturating_sub(1);
        }
        Some(self.wanted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_that_nobody_renews_end_in_three_stops() {
        let mut wheels = WheelCommand::default();
        wheels.drive(0.0, Drive::wheels(0.1, 0.2));
        let mut sent = Vec::new();
        for ms in 0..400 {
            let now = f64::from(ms) * 1e-3;
            if let Some(speeds) = wheels.due(now, None) {
                sent.push((ms, speeds));
            }
        }
        assert_eq!(sent[0], (0, (200, 100)));
        let stop = sent.iter().position(|(_, speeds)| *speeds == (0, 0)).unwrap();
        assert!((200..=202).contains(&sent[stop].0), "{sent:?}");
        assert_eq!(sent.len() - stop, 3, "{sent:?}");
        assert!(sent[stop..].iter().all(|(_, speeds)| *speeds == (0, 0)));
    }

    #[test]
    fn a_robot_that_did_not_hear_the_stop_is_told_until_it_has() {
        let mut wheels = WheelCommand::default();
        wheels.drive(0.0, Drive::wheels(0.1, 0.1));
        assert!(wheels.due(0.0, None).is_some());
        wheels.stop();
        let count = |wheels: &mut WheelCommand, from: i32, to: i32, reported| {
            (from..to).filter(|&ms| wheels.due(f64::from(ms) * 1e-3, Some(reported)).is_some()).count()
        };
        assert!(count(&mut wheels, 1, 1000, (100, 100)) > 20);
        assert_eq!(count(&mut wheels, 1100, 2000, (0, 0)), 0);
    }
}

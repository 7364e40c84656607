//! Valid ranges of commands, and builders that check them.

use super::{
    command::{BAUD_RATES, Command, Note},
    motion::{MAX_RADIUS_MM, MAX_SPEED_MM_S, STRAIGHT, STRAIGHT_TOO},
    packet::PacketId,
};
use thiserror::Error;

/// Songs that a robot stores. The specification says "four songs" and numbers them 0 to 4; robots of the 500 and 700 series
/// are known to take 0 to 3.
pub const SONGS: u8 = 4;

/// Greatest duty cycle of Drive PWM.
pub const MAX_PWM: i16 = 255;

/// Greatest duty cycle of brushes and vacuum.
pub const MAX_MOTOR_PWM: i8 = 127;

/// Why a command is not written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum CommandRefusal {
    /// A value that no robot takes.
    #[error("{what} is {value}, but must be {least} to {most}")]
    OutOfRange {
        /// Whose value.
        what: &'static str,
        /// The value.
        value: i32,
        /// Least value that robots take.
        least: i32,
        /// Greatest value that robots take.
        most: i32,
    },
    /// A packet that doesn't exist.
    #[error("there is no packet {0}; packets are 0 to 58, 100, 101, 106 and 107")]
    UnknownPacket(u8),
    /// A rate that opcode 129 has no code for.
    #[error("{0} baud isn't a supported rate")]
    UnknownBaudRate(u32),
    /// The caller's buffer.
    #[error("the command needs {needed} bytes, but the buffer has {got}")]
    BufferTooSmall {
        /// Bytes of the command.
        needed: usize,
        /// Bytes of the buffer.
        got: usize,
    },
}

fn within(
    what: &'static str,
    value: impl Into<i32>,
    least: impl Into<i32>,
    most: impl Into<i32>,
) -> Result<(), CommandRefusal> {
    let (value, least, most) = (value.into(), least.into(), most.into());
    if (least..=most).contains(&value) { Ok(()) } else { Err(CommandRefusal::OutOfRange { what, value, least, most }) }
}

fn speed(what: &'static str, value: impl Into<i32>) -> Result<(), CommandRefusal> {
    within(what, value, -MAX_SPEED_MM_S, MAX_SPEED_MM_S)
}

fn known_packets(packets: &[u8]) -> Result<(), CommandRefusal> {
    within("number of packets", packets.len().try_into().unwrap_or(i32::MAX), 0, 255)?;
    match packets.iter().find(|&&id| PacketId::from_byte(id).is_none()) {
        Some(&id) => Err(CommandRefusal::UnknownPacket(id)),
        None => Ok(()),
    }
}

impl<'a> Command<'a> {
    /// Whether every value is one that robots take; names the first that isn't.
    pub fn check(&self) -> Result<(), CommandRefusal> {
        match *self {
            Self::Baud { code } => within("baud code", code, 0, BAUD_RATES.len() as i32 - 1),
            Self::Drive { velocity, radius } => {
                speed("velocity in mm/s", velocity)?;
                if matches!(radius, STRAIGHT | STRAIGHT_TOO) {
                    return Ok(());
                }
                within("radius in mm", radius, -MAX_RADIUS_MM, MAX_RADIUS_MM)
            }
            Self::Song { number, notes } => {
                within("song number", number, 0, SONGS - 1)?;
                within("number of notes", notes.len().try_into().unwrap_or(i32::MAX), 1, 16)
            }
            Self::Play { number } => within("song number", number, 0, SONGS - 1),
            Self::SensorReadings { packet } => known_packets(&[packet]),
            Self::PwmMotors { main_brush, side_brush, vacuum } => {
                within("duty cycle of the main brush", main_brush, -MAX_MOTOR_PWM, MAX_MOTOR_PWM)?;
                within("duty cycle of the side brush", side_brush, -MAX_MOTOR_PWM, MAX_MOTOR_PWM)?;
                within("duty cycle of the vacuum", vacuum, 0, MAX_MOTOR_PWM)
            }
            Self::DriveDirect { right, left } => {
                speed("right wheel speed in mm/s", right)?;
                speed("left wheel speed in mm/s", left)
            }
            Self::DrivePwm { right, left } => {
                within("right duty cycle", right, -MAX_PWM, MAX_PWM)?;
                within("left duty cycle", left, -MAX_PWM, MAX_PWM)
            }
            Self::Stream { packets } | Self::QueryList { packets } => known_packets(packets),
            Self::PauseResume { state } => within("state of the stream", state, 0, 1),
            Self::DigitsRaw { segments } => segments.iter().try_for_each(|&bits| within("segments", bits, 0, 127)),
            Self::DigitsAscii { text } => text.iter().try_for_each(|&byte| within("character", byte, 32, 126)),
            Self::Schedule { times, .. } => times.iter().try_for_each(|&[hour, minute]| time_of_day(hour, minute)),
            Self::DayTime { day, time: [hour, minute] } => {
                within("day of the week", day, 0, 6)?;
                time_of_day(hour, minute)
            }
            // Nothing to check: no data, or bits that can all be set.
            _ => Ok(()),
        }
    }

    /// The same with every speed, radius and duty cycle brought into its range. Names rather than amounts - songs,
    /// packets, baud codes - have no nearest value and aren't changed; [`Self::check`] refuses invalid ones.
    pub fn clamped(self) -> Self {
        let speed = |v: i16| v.clamp(-MAX_SPEED_MM_S, MAX_SPEED_MM_S);
        let duty = |v: i8| v.max(-MAX_MOTOR_PWM);
        match self {
            Self::Drive { velocity, radius: radius @ (STRAIGHT | STRAIGHT_TOO) } => {
                Self::Drive { velocity: speed(velocity), radius }
            }
            Self::Drive { velocity, radius } => {
                Self::Drive { velocity: speed(velocity), radius: radius.clamp(-MAX_RADIUS_MM, MAX_RADIUS_MM) }
            }
            Self::DriveDirect { right, left } => Self::DriveDirect { right: speed(right), left: speed(left) },
            Self::DrivePwm { right, left } => {
                Self::DrivePwm { right: right.clamp(-MAX_PWM, MAX_PWM), left: left.clamp(-MAX_PWM, MAX_PWM) }
            }
            Self::PwmMotors { main_brush, side_brush, vacuum } => Self::PwmMotors {
                main_brush: duty(main_brush),
                side_brush: duty(side_brush),
                vacuum: vacuum.min(MAX_MOTOR_PWM.cast_unsigned()),
            },
            other => other,
        }
    }

    /// Drives along an arc, or refuses.
    pub fn drive(velocity_mm_s: i16, radius_mm: i16) -> Result<Self, CommandRefusal> {
        Self::Drive { velocity: velocity_mm_s, radius: radius_mm }.checked()
    }

    /// Wheel speeds in m/s as the nearest Drive Direct: each wheel is limited to 0.5 m/s and rounded to whole mm/s.
    /// Values that aren't finite give 0.
    pub fn wheels(left_m_s: f64, right_m_s: f64) -> Self {
        // A cast saturates.
        let speed = |m_s: f64| if m_s.is_finite() { libm::round(m_s * 1000.0) as i16 } else { 0 };
        Self::DriveDirect { right: speed(right_m_s), left: speed(left_m_s) }.clamped()
    }

    /// A song of 1 to 16 notes, or refuses.
    ///
    /// ```
    /// use roomba_oi::Command;
    /// let refused = Command::song(4, &[[69, 32]]).unwrap_err();
    /// assert_eq!(refused.to_string(), "song number is 4, but must be 0 to 3");
    /// ```
    pub fn song(number: u8, notes: &'a [Note]) -> Result<Self, CommandRefusal> {
        Self::Song { number, notes }.checked()
    }

    /// Plays a stored song, or refuses.
    pub fn play(number: u8) -> Result<Self, CommandRefusal> {
        Self::Play { number }.checked()
    }

    /// Changes the baud rate, or refuses one that robots don't have.
    pub fn baud(bits_per_second: u32) -> Result<Self, CommandRefusal> {
        let code = BAUD_RATES.iter().position(|&rate| rate == bits_per_second);
        code.map(|code| Self::Baud { code: code as u8 }).ok_or(CommandRefusal::UnknownBaudRate(bits_per_second))
    }

    /// Requests a stream of these packets, or refuses those that don't exist.
    pub fn stream(packets: &'a [u8]) -> Result<Self, CommandRefusal> {
        Self::Stream { packets }.checked()
    }

    /// Requests these packets once, or refuses those that don't exist.
    pub fn query_list(packets: &'a [u8]) -> Result<Self, CommandRefusal> {
        Self::QueryList { packets }.checked()
    }

    /// Four characters for the digits; shorter texts are filled up with blanks, longer ones and others than ASCII refused.
    pub fn digits(text: &str) -> Result<Self, CommandRefusal> {
        let mut padded = [b' '; 4];
        within("number of characters", text.len().try_into().unwrap_or(i32::MAX), 0, padded.len() as i32)?;
        for (to, from) in padded.iter_mut().zip(text.bytes()) {
            *to = from;
        }
        Self::DigitsAscii { text: padded }.checked()
    }

    /// Itself, if [`Self::check`] has nothing against it.
    pub fn checked(self) -> Result<Self, CommandRefusal> {
        self.check().map(|()| self)
    }
}

fn time_of_day(hour: u8, minute: u8) -> Result<(), CommandRefusal> {
    within("hour", hour, 0, 23)?;
    within("minute", minute, 0, 59)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(command: Command<'_>) -> String {
        command.check().unwrap_err().to_string()
    }

    #[test]
    fn refusals_name_value_and_range() {
        assert_eq!(refused(Command::Baud { code: 12 }), "baud code is 12, but must be 0 to 11");
        assert_eq!(
            refused(Command::Drive { velocity: 501, radius: 1 }),
            "velocity in mm/s is 501, but must be -500 to 500"
        );
        assert_eq!(
            refused(Command::Drive { velocity: 0, radius: 2001 }),
            "radius in mm is 2001, but must be -2000 to 2000"
        );
        assert_eq!(refused(Command::Song { number: 0, notes: &[] }), "number of notes is 0, but must be 1 to 16");
        assert_eq!(
            refused(Command::PwmMotors { main_brush: 0, side_brush: -128, vacuum: 0 }),
            "duty cycle of the side brush is -128, but must be -127 to 127"
        );
        assert_eq!(
            refused(Command::Stream { packets: &[7, 59] }),
            "there is no packet 59; packets are 0 to 58, 100, 101, 106 and 107"
        );
        assert_eq!(refused(Command::DayTime { day: 3, time: [24, 0] }), "hour is 24, but must be 0 to 23");
        assert_eq!(Command::digits("ABCDE").unwrap_err().to_string(), "number of characters is 5, but must be 0 to 4");
        assert_eq!(Command::digits("é").unwrap_err().to_string(), "character is 195, but must be 32 to 126");
        assert_eq!(Command::baud(9601), Err(CommandRefusal::UnknownBaudRate(9601)));
        assert_eq!(Command::Safe.encode(&mut []), Err(CommandRefusal::BufferTooSmall { needed: 1, got: 0 }));
    }

    #[test]
    fn a_controller_never_asks_for_too_much() {
        let drive = |left, right| Command::wheels(left, right);
        assert_eq!(drive(0.2004, -0.1), Command::DriveDirect { right: -100, left: 200 });
        assert_eq!(drive(9.0, -1e300), Command::DriveDirect { right: -500, left: 500 });
        assert_eq!(drive(f64::NAN, f64::INFINITY), Command::DriveDirect { right: 0, left: 0 });
    }
}

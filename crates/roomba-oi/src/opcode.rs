//! Table of commands: opcode, data bytes, allowed modes, mode afterwards.

use super::mode::Mode;
use core::fmt;

/// How many data bytes follow an opcode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DataLength {
    /// Always that many.
    Fixed(usize),
    /// A count n, then n packet ids (Stream, Query List).
    Ids,
    /// A number, a count n, then n pairs of note and duration (Song).
    Notes,
}

/// The mode in which a command leaves the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModeAfter {
    /// As it was.
    Same,
    /// This one.
    Is(Mode),
}

/// Writes the enum and its table from one list, so that they can't disagree.
macro_rules! opcodes {
    ($($(#[$doc:meta])+ $variant:ident = $code:literal, $name:literal, $data:expr, from $least:ident, then $after:expr;)+) => {
        /// First byte of a command (Create 2 specification of 2016; the older ones have no 7 and no 173).
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[repr(u8)]
        pub enum Opcode { $($(#[$doc])+ $variant = $code,)+ }

        impl Opcode {
            /// All of them, in the order of their numbers.
            pub const ALL: &[Self] = &[$(Self::$variant,)+];

            /// The opcode with that number. Those of the Create 1 that later robots lack (147, 151 to 158) are unknown.
            pub const fn from_byte(byte: u8) -> Option<Self> {
                match byte { $($code => Some(Self::$variant),)+ _ => None }
            }

            /// Name in the specification.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)+ }
            }

            /// Data bytes that follow.
            pub const fn data_length(self) -> DataLength {
                match self { $(Self::$variant => $data,)+ }
            }

            /// The least mode that allows it: with it all those above (Off < Passive < Safe < Full).
            pub const fn least_mode(self) -> Mode {
                match self { $(Self::$variant => Mode::$least,)+ }
            }

            /// The mode after it, where it is allowed.
            pub const fn mode_after(self) -> ModeAfter {
                match self { $(Self::$variant => $after,)+ }
            }
        }
    };
}

use DataLength::{Fixed, Ids, Notes};
use ModeAfter::{Is, Same};

opcodes! {
    /// Restarts the robot as if its battery had been changed; takes about 5 s, and one robot of the 600 series was seen to
    /// stay in its boot loader.
    Reset = 7, "Reset", Fixed(0), from Off, then Is(Mode::Off);
    /// Starts the interface; the only way out of Off.
    Start = 128, "Start", Fixed(0), from Off, then Is(Mode::Passive);
    /// Changes the baud rate; the sender then waits for 100 ms.
    Baud = 129, "Baud", Fixed(1), from Passive, then Same;
    /// The old name of Safe.
    Control = 130, "Control", Fixed(0), from Passive, then Is(Mode::Safe);
    /// Obeys drive commands, and stops by itself at cliffs, dropped wheels and on a charger.
    Safe = 131, "Safe", Fixed(0), from Passive, then Is(Mode::Safe);
    /// Obeys drive commands, whatever it senses.
    Full = 132, "Full", Fixed(0), from Passive, then Is(Mode::Full);
    /// Puts the robot to sleep.
    Power = 133, "Power", Fixed(0), from Passive, then Is(Mode::Passive);
    /// Cleans a spot, or pauses the cycle that runs.
    Spot = 134, "Spot", Fixed(0), from Passive, then Is(Mode::Passive);
    /// Cleans, or pauses the cycle that runs.
    Clean = 135, "Clean", Fixed(0), from Passive, then Is(Mode::Passive);
    /// Cleans until the battery is empty, or pauses the cycle that runs.
    Max = 136, "Max", Fixed(0), from Passive, then Is(Mode::Passive);
    /// Drives along an arc: velocity, radius.
    Drive = 137, "Drive", Fixed(4), from Safe, then Same;
    /// Switches brushes and vacuum.
    Motors = 138, "Motors", Fixed(1), from Safe, then Same;
    /// Lights around the Clean button.
    Leds = 139, "LEDs", Fixed(3), from Safe, then Same;
    /// Stores a song.
    Song = 140, "Song", Notes, from Passive, then Same;
    /// Plays a stored song.
    Play = 141, "Play", Fixed(1), from Safe, then Same;
    /// Asks for one packet or group.
    SensorReadings = 142, "Sensors", Fixed(1), from Passive, then Same;
    /// Looks for the dock.
    SeekDock = 143, "Seek Dock", Fixed(0), from Passive, then Is(Mode::Passive);
    /// Brushes and vacuum with chosen duty cycles.
    PwmMotors = 144, "PWM Motors", Fixed(3), from Safe, then Same;
    /// Drives with chosen wheel speeds, right wheel first.
    DriveDirect = 145, "Drive Direct", Fixed(4), from Safe, then Same;
    /// Drives with chosen duty cycles, right wheel first.
    DrivePwm = 146, "Drive PWM", Fixed(4), from Safe, then Same;
    /// Asks for a frame with these packets every 15 ms.
    Stream = 148, "Stream", Ids, from Passive, then Same;
    /// Asks for several packets or groups, once.
    QueryList = 149, "Query List", Ids, from Passive, then Same;
    /// Pauses the stream or lets it go on; the robot keeps the list.
    PauseResume = 150, "Pause/Resume Stream", Fixed(1), from Passive, then Same;
    /// Lights of the schedule display.
    SchedulingLeds = 162, "Scheduling LEDs", Fixed(2), from Safe, then Same;
    /// Segments of the four digits.
    DigitsRaw = 163, "Digit LEDs Raw", Fixed(4), from Safe, then Same;
    /// Characters on the four digits.
    DigitsAscii = 164, "Digit LEDs ASCII", Fixed(4), from Safe, then Same;
    /// Presses buttons for 1/6 s; what a button does may change the mode.
    Buttons = 165, "Buttons", Fixed(1), from Passive, then Same;
    /// Sets the weekly schedule.
    Schedule = 167, "Schedule", Fixed(15), from Passive, then Same;
    /// Sets the clock.
    DayTime = 168, "Set Day/Time", Fixed(3), from Passive, then Same;
    /// Ends the interface with a tune.
    Stop = 173, "Stop", Fixed(0), from Passive, then Is(Mode::Off);
}

impl Opcode {
    /// Bytes of the whole command that begins with `head`, opcode included; `None` while its count hasn't arrived.
    pub fn command_length(self, head: &[u8]) -> Option<usize> {
        let count = |at: usize| head.get(at).map(|&n| usize::from(n));
        match self.data_length() {
            Fixed(length) => Some(1 + length),
            Ids => count(1).map(|n| 2 + n),
            Notes => count(2).map(|n| 3 + 2 * n),
        }
    }

    /// Whether a robot in that mode takes the command; otherwise it ignores it.
    pub fn allowed_in(self, mode: Mode) -> bool {
        mode >= self.least_mode()
    }
}

/// Name in the specification.
impl fmt::Display for Opcode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_ascending_and_found() {
        assert!(Opcode::ALL.windows(2).all(|pair| (pair[0] as u8) < pair[1] as u8));
        for byte in 0..=255_u8 {
            let listed = Opcode::ALL.iter().copied().find(|&op| op as u8 == byte);
            assert_eq!(Opcode::from_byte(byte), listed);
        }
    }

    #[test]
    fn a_length_that_has_not_arrived_is_unknown() {
        assert_eq!(Opcode::Song.command_length(&[140, 0]), None);
        assert_eq!(Opcode::Song.command_length(&[140, 0, 255]), Some(513));
        assert_eq!(Opcode::Stream.command_length(&[148]), None);
        assert_eq!(Opcode::Stream.command_length(&[148, 0]), Some(2));
        assert_eq!(Opcode::Schedule.command_length(&[167]), Some(16));
    }
}

//! What of the robot is on, by the commands that it was sent.

use roomba_oi::{Buttons, Command, Motors};

/// Stops wheels, brushes and vacuum, and leaves the mode in which a host drives. The wheels twice: bytes can get lost on the
/// line, and a command that lacks some takes the first bytes of the next one.
pub const STOP: [u8; 13] = [145, 0, 0, 0, 0, 145, 0, 0, 0, 0, 138, 0, 128];

/// Stops the wheels and keeps the mode, for a host that may be back at once.
pub const HALT: [u8; 10] = [145, 0, 0, 0, 0, 145, 0, 0, 0, 0];

/// [`STOP`], and then the same from Safe, which ends what the robot does by itself, such as cleaning.
pub const STOP_ALL: [u8; 22] = [145, 0, 0, 0, 0, 145, 0, 0, 0, 0, 138, 0, 128, 131, 145, 0, 0, 0, 0, 138, 0, 128];

/// What a host switched on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ActiveOutputs {
    /// The wheels were told to turn.
    pub wheels: bool,
    /// Brushes or vacuum were told to run.
    pub motors: bool,
    /// The host drives: Safe or Full was commanded, or nothing is known yet.
    pub is_host_driven: bool,
}

impl ActiveOutputs {
    /// Of a robot about which nothing is known.
    pub const UNKNOWN: Self = Self { wheels: true, motors: true, is_host_driven: true };
    /// Of a robot that was stopped, or runs a program of its own.
    pub const OWN: Self = Self { wheels: false, motors: false, is_host_driven: false };

    /// Whether anything is on that nobody but the host will switch off.
    pub fn is_on(&self) -> bool {
        self.wheels || self.motors
    }

    /// Takes note of a command.
    pub fn sent(&mut self, command: &Command<'_>) {
        match *command {
            Command::Drive { .. } | Command::DriveDirect { .. } | Command::DrivePwm { .. } => {
                self.wheels = starts(command);
            }
            Command::Motors(_) | Command::PwmMotors { .. } => self.motors = starts(command),
            Command::Control | Command::Safe | Command::Full => self.is_host_driven = true,
            // That it stops the wheels isn't documented.
            Command::Start => self.is_host_driven = false,
            Command::Stop
            | Command::Reset
            | Command::Power
            | Command::Clean
            | Command::Max
            | Command::Spot
            | Command::SeekDock => *self = Self::OWN,
            _ => {}
        }
    }
}

/// Whether a command can set anything in motion: wheels, brushes, or a program of the robot's own.
pub fn starts(command: &Command<'_>) -> bool {
    match *command {
        Command::Drive { velocity, .. } => velocity != 0,
        Command::DriveDirect { right, left } | Command::DrivePwm { right, left } => (right, left) != (0, 0),
        Command::Motors(motors) => motors != Motors::default(),
        Command::PwmMotors { main_brush, side_brush, vacuum } => main_brush != 0 || side_brush != 0 || vacuum != 0,
        Command::Buttons(buttons) => buttons != Buttons::default(),
        Command::Clean | Command::Max | Command::Spot | Command::SeekDock => true,
        _ => false,
    }
}

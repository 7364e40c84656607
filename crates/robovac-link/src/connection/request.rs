//! User requests to a robot.

use robovac_core::robot::OdometryModel;
use roomba_oi::Command;
use serde::{Deserialize, Serialize};

/// User requests to a robot. In JavaScript, `{ do: "arm", full: false }` and the like.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(tag = "do", rename_all = "snake_case")]
pub enum Request {
    /// Finds out anew who is there.
    Connect,
    /// Stops the robot, ends the interface and lets the line go.
    Disconnect,
    /// Takes control: Safe, or Full.
    Arm {
        /// Full, without the robot's own safety features.
        full: bool,
    },
    /// Gives control back: Passive.
    Disarm,
    /// Stops wheels, brushes and whatever drives. Always allowed.
    Stop,
    /// Drives by hand, within the interlocks of the manual mode; has to be repeated within 200 ms.
    Drive {
        /// Forward, -1 to 1.
        forward: f64,
        /// To the left, -1 to 1.
        left: f64,
    },
    /// Presses a button of the robot.
    Press {
        /// Which.
        button: PressedButton,
    },
    /// Sends bytes as they are.
    Raw {
        /// Some bytes, 256 at most.
        bytes: Vec<u8>,
    },
    /// Stores a song and plays it.
    Song {
        /// 0 to 3.
        number: u8,
        /// 1 to 16 of note and duration in 1/64 s.
        notes: Vec<[u8; 2]>,
    },
    /// Sets the lights around the Clean button.
    Leds {
        /// Bits: debris, spot, dock, check.
        lamps: u8,
        /// Of the Clean button: 0 green to 255 red.
        colour: u8,
        /// Its brightness, 0 to 255.
        intensity: u8,
    },
    /// Shows four characters.
    Digits {
        /// Up to four printable characters.
        text: String,
    },
    /// Sets the lights of the schedule.
    ScheduleLeds {
        /// Bits from Sunday on.
        weekdays: u8,
        /// Bits: colon, PM, AM, clock, schedule.
        lamps: u8,
    },
    /// Switches brushes and vacuum.
    Motors {
        /// Bits: side brush, vacuum, main brush, side brush clockwise, main brush outward.
        bits: u8,
    },
    /// Begins a calibration.
    Calibrate {
        /// Which.
        what: Calibration,
    },
    /// Answers what a calibration asks: what was measured, or 1 for yes and 0 for no.
    Answer {
        /// Degrees or metres, as asked.
        value: f64,
    },
    /// Leaves unanswered what a calibration asks.
    Skip,
    /// Uses what an earlier calibration of this robot found.
    UseCalibration {
        /// Packets 43 and 44 are swapped.
        swapped: bool,
        /// True distance over what encoders say.
        distance_factor: f64,
        /// True wheel base over 235 mm.
        base_factor: f64,
    },
    /// Chooses what tells the robot where it is: counts, or packets of distance and angle.
    Odometry {
        /// Its name, as in links.
        model: OdometryModel,
    },
    /// Restarts the robot so that it tells its firmware (7). Not done unless asked for: one robot stayed in its
    /// bootloader.
    Identify,
}

/// Buttons on the page that stand for those of the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum PressedButton {
    /// Cleans.
    Clean,
    /// Cleans a spot.
    Spot,
    /// Looks for the dock.
    Dock,
    /// Goes to sleep.
    Power,
}

impl PressedButton {
    /// What presses it.
    pub(super) fn command(self) -> Command<'static> {
        match self {
            Self::Clean => Command::Clean,
            Self::Spot => Command::Spot,
            Self::Dock => Command::SeekDock,
            Self::Power => Command::Power,
        }
    }
}

/// What can be calibrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Calibration {
    /// Turns 10 degrees to the left: settles which encoder is which.
    Nudge,
    /// Turns round once: settles the wheel base.
    Spin,
    /// Drives a metre: settles the wheels' size.
    Metre,
    /// Drives a square of a metre, to see how far both are right.
    Square,
}

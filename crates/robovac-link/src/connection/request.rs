//! User requests to a robot.

use robovac_core::robot::OdometryModel;
use roomba_oi::Command;
use serde::{Deserialize, Serialize};

/// User requests to a robot. In JavaScript, `{ do: "arm", full: false }` and the like.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(tag = "do", rename_all = "snake_case")]
pub enum Request {
    /// Starts the diagnosis again.
    Connect,
    /// Stops the robot, ends the interface and releases the line.
    Disconnect,
    /// Takes control, in Safe or Full.
    Arm {
        /// Full, without the robot's own safety features.
        full: bool,
    },
    /// Gives control up: Passive.
    Disarm,
    /// Stops wheels, brushes and programs. Always allowed.
    Stop,
    /// Drives by hand, within the interlocks of the manual mode; to be repeated within 200 ms.
    Drive {
        /// Forward, -1 to 1.
        forward: f64,
        /// To the left, -1 to 1.
        left: f64,
    },
    /// Presses a button of the robot.
    Press {
        /// The button.
        button: PressedButton,
    },
    /// Sends raw bytes.
    Raw {
        /// At most 256 bytes.
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
        /// Colour of the Clean button: 0 green to 255 red.
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
        /// Bits, the lowest for Sunday.
        weekdays: u8,
        /// Bits: colon, PM, AM, clock, schedule.
        lamps: u8,
    },
    /// Switches brushes and vacuum.
    Motors {
        /// Bits: side brush, vacuum, main brush, side brush clockwise, main brush outward.
        bits: u8,
    },
    /// Sets duty cycles of brushes and vacuum, in 1/128.
    PwmMotors {
        /// -127 to 127; inward positive.
        main_brush: i8,
        /// -127 to 127; counter-clockwise positive.
        side_brush: i8,
        /// 0 to 127.
        vacuum: u8,
    },
    /// Drives with duty cycles of the wheels, in 1/255, whatever is in the way; to be repeated within 200 ms.
    DrivePwm {
        /// -255 to 255.
        right: i16,
        /// -255 to 255.
        left: i16,
    },
    /// Sets the robot's clock.
    Clock {
        /// 0 Sunday to 6 Saturday.
        day: u8,
        /// 0 to 23.
        hour: u8,
        /// 0 to 59.
        minute: u8,
    },
    /// Sets the weekly schedule, by which the robot cleans by itself.
    Schedule {
        /// Bits, the lowest for Sunday; none for no schedule.
        days: u8,
        /// Hour and minute, from Sunday to Saturday.
        times: [[u8; 2]; 7],
    },
    /// Starts a calibration.
    Calibrate {
        /// The calibration.
        what: Calibration,
    },
    /// Answers a calibration's question: the measured value, or 1 for yes and 0 for no.
    Answer {
        /// Degrees or metres, as requested.
        value: f64,
    },
    /// Skips a calibration's question.
    Skip,
    /// Uses the result of an earlier calibration of this robot.
    UseCalibration {
        /// Packets 43 and 44 are swapped.
        swapped: bool,
        /// True distance divided by the encoders' distance.
        distance_factor: f64,
        /// True wheel base divided by 235 mm.
        base_factor: f64,
    },
    /// Chooses the odometry model: by counts, or by packets of distance and angle.
    Odometry {
        /// Its name, as in links.
        model: OdometryModel,
    },
    /// Restarts the robot so that it reports its firmware (7). Only on request, as one robot stayed in its bootloader.
    Identify,
}

impl Request {
    /// Whether it is for the robot, rather than for the connection or its pose.
    pub(super) fn is_for_robot(&self) -> bool {
        !matches!(
            self,
            Self::Connect
                | Self::Disconnect
                | Self::Stop
                | Self::Answer { .. }
                | Self::Skip
                | Self::UseCalibration { .. }
                | Self::Odometry { .. }
        )
    }
}

/// Buttons of the robot on the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum PressedButton {
    /// Cleans.
    Clean,
    /// Cleans a spot.
    Spot,
    /// Cleans until its battery is empty.
    Max,
    /// Seeks the dock.
    Dock,
    /// Powers off.
    Power,
}

impl PressedButton {
    /// The command that presses it.
    pub(super) fn command(self) -> Command<'static> {
        match self {
            Self::Clean => Command::Clean,
            Self::Spot => Command::Spot,
            Self::Max => Command::Max,
            Self::Dock => Command::SeekDock,
            Self::Power => Command::Power,
        }
    }
}

/// Kinds of calibrations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Calibration {
    /// Turns 10 degrees to the left: determines the sides of the encoders.
    Nudge,
    /// Turns round once: determines the wheel base.
    Spin,
    /// Drives a metre: determines the wheel diameter.
    Metre,
    /// Drives a square of one metre to the left, to check both.
    Square,
    /// The same to the right: both squares together tell errors of the wheel base from those of the wheels' sizes.
    SquareRight,
}

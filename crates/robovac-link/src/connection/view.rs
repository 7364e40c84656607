//! View model of the Robot tab.

use super::{Caption, TransportView};
use crate::dashboard::RoombaView;
use serde::Serialize;

/// Snapshot of a connection, taken 20 times a second.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[expect(clippy::struct_excessive_bools)]
pub struct ConnectionView {
    /// `closed`, `diagnosing`, `waiting` (no answer; it keeps trying), `connected` or `lost` (the line is open, but
    /// frames no longer arrive).
    #[cfg_attr(feature = "types", ts(type = "\"closed\" | \"diagnosing\" | \"waiting\" | \"connected\" | \"lost\""))]
    pub phase: &'static str,
    /// The diagnosis of the device on the line.
    pub diagnosis: DiagnosisView,
    /// `Passive`, `Safe` or `Full`; empty while unknown.
    #[cfg_attr(feature = "types", ts(type = "\"\" | \"Off\" | \"Passive\" | \"Safe\" | \"Full\""))]
    pub mode: &'static str,
    /// Whether the robot's mode byte is one too high.
    pub mode_offset: bool,
    /// The program or person that drives.
    pub ride: Option<DriveSessionView>,
    /// The robot's sensor readings; `None` before the first one and when not connected.
    pub readings: Option<RoombaView>,
    /// The robot's estimated pose: x, y in m, heading in rad.
    pub pose: [f64; 3],
    /// Id of its odometry model.
    pub odometry: &'static str,
    /// Path driven, m.
    pub distance_m: f64,
    /// Brushes and vacuum that run by command, as the bits of a request for motors.
    pub motors: u8,
    /// Their duty cycles in 1/128: main brush, side brush, vacuum.
    pub duty: [i8; 3],
    /// Lights that are on by command.
    pub lights: LightsView,
    /// Requested wheel speeds that were sent last, left and right, m/s.
    pub wheels: [f64; 2],
    /// Whether the robot is driven by this program, or is about to be.
    pub is_moving: bool,
    /// Whether it has driven at half its speed for a while because the page responds slowly.
    pub is_slowed: bool,
    /// Whether it moves otherwise: by its own program, by raw bytes, or pushed.
    pub moves_alone: bool,
    /// Its activity.
    pub doing: Caption,
    /// The line below its bytes.
    pub transport: TransportView,
    /// Name and state of the line.
    pub line: Caption,
    /// Whether a line is open or expected to return.
    pub is_open: bool,
    /// Whether this is a recording, which has no line.
    pub is_recording: bool,
    /// Statistics of the line.
    pub statistics: Statistics,
    /// Time until the robot falls asleep, s; `None` unless it is Passive and off the dock.
    pub sleeps_in_s: Option<f64>,
    /// Time in Safe or Full, without charging, s.
    pub awake_s: Option<f64>,
    /// A sentence on these, if relevant; empty otherwise.
    pub clock: String,
    /// Why it left Safe or Full.
    pub drop: Option<DropView>,
    /// The calibration in progress, or its result.
    pub calibration: CalibrationView,
    /// Firmware reported by the robot.
    pub firmware: Option<String>,
    /// The latest message.
    pub notice: Option<Notice>,
    /// Which requests are allowed now.
    pub can: ConnectionActions,
}

/// Lights that are on by command; all dark while the robot has them for itself.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct LightsView {
    /// Bits: debris, spot, dock, check.
    pub lamps: u8,
    /// Colour of the Clean button, 0 green to 255 red, and its brightness, 0 to 255.
    pub clean_light: [u8; 2],
    /// The four digits.
    pub digits: String,
    /// Bits, the lowest for Sunday.
    pub weekdays: u8,
    /// Bits: colon, PM, AM, clock, schedule.
    pub schedule: u8,
}

/// Diagnosis of the device on the line.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DiagnosisView {
    /// Current test: `listening`, `asking`, `waking`, `slow` (19200 baud), `create1` (57600 baud), `done`.
    pub step: &'static str,
    /// Finding: `nothing` (yet), `silence`, `stream`, `charging`, `booting`, `bootloader`, `garbage`, `text`,
    /// `no_stream`, `robot`.
    #[cfg_attr(
        feature = "types",
        ts(
            type = "\"\" | \"nothing\" | \"silence\" | \"stream\" | \"charging\" | \"booting\" | \"bootloader\" | \"garbage\" | \"text\" | \"no_stream\" | \"robot\""
        )
    )]
    pub finding: &'static str,
    /// One sentence on it.
    pub text: String,
    /// Advice; empty for none.
    pub remedy: String,
    /// Tests so far and their results, in order.
    pub log: Vec<String>,
    /// Whether it is shown, which is while not connected.
    pub is_shown: bool,
    /// Its picture: a file in `www/connection/pictures/`, without `.svg`.
    pub picture: &'static str,
    /// The test or finding with advice, in words.
    pub caption: Caption,
}

/// The program or person that drives the robot.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DriveSessionView {
    /// Name of the algorithm.
    pub title: String,
    /// Its activity.
    pub activity: &'static str,
    /// Time since it began, s.
    pub time_s: f64,
    /// Whether a person drives with a joystick.
    pub manual: bool,
    /// Why forward, left, right and backward are blocked, if a person drives.
    pub blocked: [Option<&'static str>; 4],
    /// Index of the planned line's corner that it drives to.
    pub corner: Option<usize>,
    /// Whether it is done.
    pub done: bool,
    /// Why it was ended early; empty if it wasn't.
    pub ended: String,
}

/// Statistics of the line.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Statistics {
    /// Baud rate.
    pub baud: u32,
    /// Accepted frames.
    pub frames: u64,
    /// Frames with a wrong checksum.
    pub bad_checksums: u64,
    /// Headers without a frame.
    pub false_headers: u64,
    /// Frames with a right checksum but impossible values.
    pub implausible: u64,
    /// Frames accepted one frame late, after a jump of a value.
    pub late: u64,
    /// Lines of text.
    pub texts: u64,
    /// Other bytes.
    pub noise: u64,
    /// Bytes received and sent.
    pub bytes: [u64; 2],
    /// Current frames per second.
    pub rate_hz: f64,
    /// Time since the last frame, ms.
    pub age_ms: f64,
    /// Median of the last delays from a command to the robot's report of it, ms.
    pub latency_ms: Option<f64>,
    /// The longest time without a frame, ms.
    pub longest_gap_ms: f64,
    /// Bytes of the subscription, and of the slot of 15 ms into which they must fit.
    pub slot: [usize; 2],
}

/// Why the robot left Safe or Full.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DropView {
    /// The mode before.
    pub from: &'static str,
    /// One sentence.
    pub text: String,
    /// What to do, or why control can't be taken back.
    pub remedy: String,
    /// Whether control can be taken back at once.
    pub can_rearm: bool,
}

/// A calibration.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct CalibrationView {
    /// `nudge`, `spin`, `metre`, `square` or `square_right`; empty for none.
    #[cfg_attr(
        feature = "types",
        ts(type = "\"\" | \"nudge\" | \"spin\" | \"metre\" | \"square\" | \"square_right\"")
    )]
    pub what: &'static str,
    /// `none`, `moving`, `asking`, `done` or `failed`.
    #[cfg_attr(feature = "types", ts(type = "\"none\" | \"moving\" | \"asking\" | \"done\" | \"failed\""))]
    pub step: &'static str,
    /// Progress, question or result.
    pub text: String,
    /// What the question asks for, as measured on the floor of a virtual robot; empty for others.
    pub measured: String,
    /// Unit of the answer: `yes` for yes or no, `deg`, `m`; empty for no question.
    #[cfg_attr(feature = "types", ts(type = "\"\" | \"yes\" | \"deg\" | \"m\""))]
    pub asks: &'static str,
    /// Suggested answer.
    pub suggestion: f64,
    /// Whether the encoders are swapped, as in use now.
    pub swapped: bool,
    /// True distance divided by the encoders' distance, as in use now.
    pub distance_factor: f64,
    /// True wheel base divided by 235 mm, as in use now.
    pub base_factor: f64,
}

/// A message.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Notice {
    /// Number of the message, which increases.
    pub number: u32,
    /// `notice` or `error`.
    #[cfg_attr(feature = "types", ts(type = "\"notice\" | \"error\""))]
    pub kind: &'static str,
    /// The message for users.
    pub text: String,
}

/// Which requests are allowed.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct ConnectionActions {
    /// Connect again.
    pub connect: bool,
    /// Disconnect.
    pub disconnect: bool,
    /// Take control.
    pub arm: bool,
    /// Give control up.
    pub disarm: bool,
    /// Drive, run programs, calibrate, play songs, switch motors and lights.
    pub drive: bool,
    /// Drive by hand: no program is driving.
    pub steer: bool,
    /// Start a program.
    pub ride: bool,
    /// Press buttons, send raw bytes.
    pub press: bool,
}

/// A line of traffic.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Traffic {
    /// Time, s.
    pub time_s: f64,
    /// Its kind.
    pub kind: TrafficKind,
    /// As bytes.
    pub hex: String,
    /// In words.
    pub text: String,
    /// Number of consecutive events that it represents: frames come 64 times a second.
    pub times: u32,
}

/// Kinds of traffic.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum TrafficKind {
    /// A command to the robot.
    Sent,
    /// A frame from it.
    Frame,
    /// A frame that was refused.
    Refused,
    /// A frame that counts only if the next one confirms it.
    Held,
    /// Text from it.
    Text,
    /// An answer to a query, or other bytes.
    Bytes,
    /// An event of the line itself.
    Line,
}

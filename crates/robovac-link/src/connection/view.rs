//! View model of the Robot tab.

use super::{Caption, TransportView};
use crate::dashboard::RoombaView;
use serde::Serialize;

/// Snapshot of a connection, for 20 looks a second.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[expect(clippy::struct_excessive_bools)]
pub struct ConnectionView {
    /// `closed`, `diagnosing`, `waiting` (nobody answers, and it goes on trying), `connected` or `lost` (the line is open, but
    /// nothing comes any more).
    #[cfg_attr(feature = "types", ts(type = "\"closed\" | \"diagnosing\" | \"waiting\" | \"connected\" | \"lost\""))]
    pub phase: &'static str,
    /// What was found out about who is there.
    pub diagnosis: DiagnosisView,
    /// `Passive`, `Safe` or `Full`; empty while unknown.
    #[cfg_attr(feature = "types", ts(type = "\"\" | \"Off\" | \"Passive\" | \"Safe\" | \"Full\""))]
    pub mode: &'static str,
    /// Whether the robot's mode byte is one too high.
    pub mode_offset: bool,
    /// What drives.
    pub ride: Option<DriveSessionView>,
    /// What the robot's sensors report; none before the first reading, and when nobody is connected.
    pub readings: Option<RoombaView>,
    /// The robot's estimated pose: x, y in m, heading in rad.
    pub pose: [f64; 3],
    /// Id of the odometry model that this is by.
    pub odometry: &'static str,
    /// Path driven, m.
    pub distance_m: f64,
    /// Requested wheel speeds that were sent last, left and right, m/s.
    pub wheels: [f64; 2],
    /// Whether the robot drives at this program's word, or is about to.
    pub is_moving: bool,
    /// Whether it moves otherwise: by its own program, by bytes that were sent, or pushed by somebody.
    pub moves_alone: bool,
    /// What it is doing.
    pub doing: Caption,
    /// The line below its bytes.
    pub transport: TransportView,
    /// Its name and state.
    pub line: Caption,
    /// Whether a line is open, or waited for.
    pub is_open: bool,
    /// Whether a recording is shown, which has no line.
    pub is_recording: bool,
    /// How the line is.
    pub statistics: Statistics,
    /// Until the robot falls asleep, s; none unless it is Passive and off the dock.
    pub sleeps_in_s: Option<f64>,
    /// How long it has been in Safe or Full, where it doesn't charge, s.
    pub awake_s: Option<f64>,
    /// A sentence on these, when they matter; empty otherwise.
    pub clock: String,
    /// Why it isn't in Safe or Full any more.
    pub drop: Option<DropView>,
    /// The calibration that is going on, or its result.
    pub calibration: CalibrationView,
    /// What the robot said of its firmware.
    pub firmware: Option<String>,
    /// The latest message.
    pub notice: Option<Notice>,
    /// Which requests are allowed now.
    pub can: ConnectionActions,
}

/// What was found out about who is there.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DiagnosisView {
    /// What is being tried: `listening`, `asking`, `waking`, `slow` (19200 baud), `create1` (57600 baud), `done`.
    pub step: &'static str,
    /// What was found: `nothing` (yet), `silence`, `stream`, `charging`, `booting`, `bootloader`, `garbage`, `text`, `robot`.
    #[cfg_attr(
        feature = "types",
        ts(
            type = "\"\" | \"nothing\" | \"silence\" | \"stream\" | \"charging\" | \"booting\" | \"bootloader\" | \"garbage\" | \"text\" | \"no_stream\" | \"robot\""
        )
    )]
    pub finding: &'static str,
    /// One sentence on it.
    pub text: String,
    /// What to do about it; empty if nothing.
    pub remedy: String,
    /// What was tried so far, and what came of it, in order.
    pub log: Vec<String>,
    /// Whether it is shown: nobody is connected.
    pub is_shown: bool,
    /// Picture of it: `listening`, `asleep`, `awake`, `dock`, `boot`, `speed` or `unplugged`.
    pub picture: &'static str,
    /// What is being tried or was found, and what to do about it.
    pub caption: Caption,
}

/// What drives the robot.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DriveSessionView {
    /// Name of the algorithm.
    pub title: String,
    /// What it is doing.
    pub activity: &'static str,
    /// Time since it began, s.
    pub time_s: f64,
    /// Whether it is a person with a joystick.
    pub manual: bool,
    /// Why forward, left, right and backward are not obeyed, if somebody drives by hand.
    pub blocked: [Option<&'static str>; 4],
    /// Corner of the planned line that it drives to.
    pub corner: Option<usize>,
    /// Whether it has come to its end.
    pub done: bool,
    /// Why it was ended before it was done; empty if it wasn't.
    pub ended: String,
}

/// How the line is.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Statistics {
    /// Baud rate.
    pub baud: u32,
    /// Frames that were believed.
    pub frames: u64,
    /// Frames with a wrong checksum.
    pub bad_checksums: u64,
    /// Headers without a frame.
    pub false_headers: u64,
    /// Frames with a right checksum and values that can't be.
    pub implausible: u64,
    /// Frames that were believed a frame late, as something in them jumped.
    pub late: u64,
    /// Lines of text.
    pub texts: u64,
    /// Bytes that belong to nothing.
    pub noise: u64,
    /// Bytes received and sent.
    pub bytes: [u64; 2],
    /// Frames a second, lately.
    pub rate_hz: f64,
    /// Time since the last frame, ms.
    pub age_ms: f64,
    /// Time from a command until the robot reports it, ms; median of the last ones.
    pub latency_ms: Option<f64>,
    /// The longest time without a frame, ms.
    pub longest_gap_ms: f64,
    /// Bytes of the subscription and of the slot of 15 ms that they have to fit in.
    pub slot: [usize; 2],
}

/// Why the robot left Safe or Full.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DropView {
    /// Mode that it was in.
    pub from: &'static str,
    /// One sentence.
    pub text: String,
    /// What to do, or why it can't be taken back.
    pub remedy: String,
    /// Whether control can be taken back at once.
    pub can_rearm: bool,
}

/// A calibration.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct CalibrationView {
    /// `nudge`, `spin`, `metre` or `square`; empty for none.
    #[cfg_attr(feature = "types", ts(type = "\"\" | \"nudge\" | \"spin\" | \"metre\" | \"square\""))]
    pub what: &'static str,
    /// `none`, `moving`, `asking`, `done` or `failed`.
    #[cfg_attr(feature = "types", ts(type = "\"none\" | \"moving\" | \"asking\" | \"done\" | \"failed\""))]
    pub step: &'static str,
    /// What is going on, what is asked, or what was found.
    pub text: String,
    /// Unit of the answer: `yes` for yes or no, `deg`, `m`; empty if nothing is asked.
    #[cfg_attr(feature = "types", ts(type = "\"\" | \"yes\" | \"deg\" | \"m\""))]
    pub asks: &'static str,
    /// The likeliest answer.
    pub suggestion: f64,
    /// What is in use now: swapped encoders, distance factor, wheel base factor.
    pub swapped: bool,
    /// True distance over what encoders say.
    pub distance_factor: f64,
    /// True wheel base over 235 mm.
    pub base_factor: f64,
}

/// A message.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Notice {
    /// Grows with every message.
    pub number: u32,
    /// `notice` or `error`.
    #[cfg_attr(feature = "types", ts(type = "\"notice\" | \"error\""))]
    pub kind: &'static str,
    /// Sentences for users.
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
    /// Give it back.
    pub disarm: bool,
    /// Drive, ride, calibrate, play, switch motors and lights.
    pub drive: bool,
    /// Drive by hand: no program drives.
    pub steer: bool,
    /// Start a program.
    pub ride: bool,
    /// Press buttons, send raw bytes.
    pub press: bool,
}

/// Something that went over the line.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Traffic {
    /// When, s.
    pub time_s: f64,
    /// What it is.
    pub kind: TrafficKind,
    /// As bytes.
    pub hex: String,
    /// In words.
    pub text: String,
    /// How many of them in a row this stands for: frames come 64 times a second.
    pub times: u32,
}

/// What went over the line.
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
    /// Text from it.
    Text,
    /// An answer to a question, or bytes that are nothing.
    Bytes,
    /// Something about the line itself.
    Line,
}

//! The host's driver for a robot: identifies it, keeps it in Safe mode, reads its sensors, and guarantees that it
//! stops.
//!
//! It has no clock and does no I/O. The caller passes received bytes to [`Driver::feed`], calls [`Driver::tick`] about
//! every 10 ms, and executes [`Driver::take_line`] and [`Driver::take_tx`] at once. Times are in seconds of any one
//! clock.
//!
//! # What keeps a robot from moving on
//!
//! - No motion command is sent before the driver is armed; arming selects Safe unless Full is requested.
//! - Wheel speeds hold for 200 ms unless they are renewed ([`DEAD_MAN_S`]).
//! - A robot that is silent for 250 ms, leaves its mode, or reports speeds other than commanded is sent stop commands
//!   until it confirms; three times where it can't confirm, at 19200 baud.

mod actuators;
mod commands;
mod connect;
mod diagnosis;
mod distance_angle_poll;
mod filter;
mod known;
mod line_classifier;
mod link_stats;
mod mode_loss;
mod modes;
mod question;
mod raw;
mod reckoned_counts;
mod refusal;
mod wheels;

pub use actuators::{Actuators, CLEANING_MOTORS};
pub use diagnosis::{Diagnosis, Finding, Step};
pub use filter::{Filter, FrameVerdict};
pub use link_stats::LinkStats;
pub use mode_loss::ModeLoss;
pub use raw::RawRefusal;
pub use refusal::FrameRefusal;
pub use wheels::{DEAD_MAN_S, WheelCommand};

use self::{
    distance_angle_poll::DistanceAnglePoll,
    line_classifier::LineClassifier,
    question::{Next, PendingQuery},
    reckoned_counts::ReckonedCounts,
};
use robovac_core::robot::{DistanceAngle, Drive, RobotPort, SensorReadings};
use roomba_oi::{Command, FRAMING, HEADER, Mode, PacketSet, Readings, Said, StreamEvent, StreamParser};
use std::collections::VecDeque;

/// Nominal time between two frames, s.
pub const FRAME_S: f64 = 0.015;
/// Time without a frame after which an armed robot is sent a stop command, s.
const STALL_S: f64 = 0.25;
/// Time without a frame after which the robot counts as lost, s.
const LOST_S: f64 = 1.0;
/// Interval of requests for the stream of a lost robot, s.
const REVIVE_S: f64 = 0.5;
/// Time after which an unreached mode is commanded again, s; after three times as long it is given up.
const MODE_S: f64 = 0.25;
/// Time after a mode command before which frames are ignored, as they can be older, s.
const SETTLE_S: f64 = 0.06;
/// Quiet time after which no frame is in transit, s.
const QUIET_S: f64 = 0.03;
/// Time over which bursts of frames are smoothed, s.
const LUMP_S: f64 = 0.04;
/// Most events kept until they are fetched.
const MOST_HAPPENINGS: usize = 2000;

/// Request to the transport.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum LineRequest {
    /// Change the baud rate, by reopening the line if necessary.
    Baud(u32),
    /// Pull the BRC wire low (`true`: RTS asserted) or release it.
    Brc(bool),
    /// Have the bridge stop the robot that another client drives.
    Stop,
}

/// Phase of a connection.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ConnectionPhase {
    /// There is no line.
    #[default]
    Closed,
    /// The device is being identified.
    Diagnosing,
    /// No answer; it queries from time to time.
    Waiting,
    /// Sensors are being streamed.
    Connected,
    /// Frames stopped; the stream is requested repeatedly.
    Lost,
}

/// An event on the line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Happening {
    /// Bytes to the robot.
    Sent(Vec<u8>),
    /// An accepted frame.
    Frame(Vec<u8>),
    /// A refused frame, with the reason.
    Refused(Vec<u8>, FrameRefusal),
    /// Text from the robot.
    Text(String),
    /// The answer to a query, as bytes and in words.
    Answer(Vec<u8>, String),
    /// An event of the line itself.
    Line(String),
}

/// The host's side of a line to a robot.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Default)]
pub struct Driver {
    phase: ConnectionPhase,
    diagnosis: Diagnosis,
    classifier: LineClassifier,
    baud: u32,
    parser: StreamParser,
    filter: Filter,
    link_stats: LinkStats,
    poll: DistanceAnglePoll,
    readings: Readings,
    sensors: SensorReadings,
    /// Packets of the last accepted frame.
    contained: PacketSet,
    /// Readings of the previous frame.
    before: Readings,
    has_read: bool,
    /// Seconds between the last two frames by the robot's clock, until taken; and the time of that clock.
    fresh: Option<f64>,
    robot_time: Option<f64>,
    mode_offset: u8,
    /// The last commanded mode, its time, and whether it was reached.
    target: Mode,
    target_since: f64,
    target_told: f64,
    target_reached: bool,
    dropped: Option<ModeLoss>,
    wheels: WheelCommand,
    actuators: Actuators,
    /// Whether encoder packets 43 and 44 are swapped on this robot.
    swapped: bool,
    question: Option<PendingQuery>,
    /// Whether the robot has the packets of a Create 1 only, and its counts then.
    is_older: bool,
    reckoned: ReckonedCounts,
    /// Whether the robot was controlled on this line.
    was_in_control: bool,
    /// Whether the line has neither a baud rate to try nor a BRC wire, as a bridge or a robot's own USB port.
    is_rate_fixed: bool,
    /// Whether it only listens: another program drives the robot, and has its sensors streamed.
    is_watching: bool,
    is_replay: bool,
    is_stalled: bool,
    revived_at: f64,
    last_byte_at: f64,
    firmware: Option<String>,
    tx: Vec<u8>,
    line: VecDeque<LineRequest>,
    happenings: VecDeque<(f64, Happening)>,
    bytes: [u64; 2],
}

impl Driver {
    /// Without a line.
    pub fn new() -> Self {
        Self::default()
    }

    // ---- the line

    /// The line is open at 115200 baud: starts the diagnosis. The first command is a stop, as an earlier program can
    /// have been interrupted while driving, or in the middle of a command.
    pub fn open(&mut self, now: f64) {
        let (firmware, swapped, bytes) = (self.firmware.take(), self.swapped, self.bytes);
        let (is_rate_fixed, is_replay, was_in_control) = (self.is_rate_fixed, self.is_replay, self.was_in_control);
        let is_watching = self.is_watching;
        let happenings = std::mem::take(&mut self.happenings);
        let poll = self.poll.anew();
        *self = Self {
            poll,
            firmware,
            swapped,
            bytes,
            happenings,
            is_rate_fixed,
            is_watching,
            is_replay,
            was_in_control,
            baud: 115_200,
            last_byte_at: now,
            ..Self::default()
        };
        // Zeros complete an interrupted command; by themselves they do nothing.
        self.push(now, &[0; LONGEST]);
        self.push(now, &STOP);
        self.begin(now);
    }

    /// Sets whether the line has neither a baud rate to try nor a BRC wire, as a bridge or a robot's own USB port.
    pub fn fix_rate(&mut self, is_fixed: bool) {
        self.is_rate_fixed = is_fixed;
    }

    /// Sets whether it only listens: nothing is sent but a [stop](LineRequest::Stop), and the stream that another program
    /// requested is taken for its own.
    pub fn watch(&mut self, is_watching: bool) {
        self.is_watching = is_watching;
    }

    /// Starts the diagnosis again, on a line whose rate can have changed.
    pub fn open_again(&mut self, now: f64) {
        let baud = self.baud;
        self.open(now);
        self.line.push_back(LineRequest::Brc(false));
        if baud != self.baud {
            self.set_rate(now, self.baud);
        }
    }

    /// The line is gone. Pending bytes are discarded.
    pub fn closed(&mut self, now: f64, why: &str) {
        self.tx.clear();
        self.line.clear();
        (self.wheels, self.actuators) = (WheelCommand::default(), Actuators::default());
        self.question = None;
        self.phase =
            if self.phase == ConnectionPhase::Closed { ConnectionPhase::Closed } else { ConnectionPhase::Lost };
        self.diagnosis.step = Step::Idle;
        self.fresh = None;
        self.happened(now, Happening::Line(why.to_owned()));
    }

    /// Bytes to be sent now.
    pub fn take_tx(&mut self) -> Vec<u8> {
        let bytes = std::mem::take(&mut self.tx);
        if self.is_watching { Vec::new() } else { bytes }
    }

    /// Request to the line, to be executed before the next bytes are sent.
    pub fn take_line(&mut self) -> Option<LineRequest> {
        if self.is_watching {
            self.line.retain(|request| *request == LineRequest::Stop);
        }
        self.line.pop_front()
    }

    /// Stops a robot that another client of the bridge drives.
    pub fn stop_other(&mut self) {
        self.line.push_back(LineRequest::Stop);
    }

    /// Takes received bytes, up to the end of the next accepted frame, and returns their number. There can be a reading
    /// to [take](Self::take_reading) then; call it again with the rest.
    pub fn feed(&mut self, now: f64, bytes: &[u8]) -> usize {
        self.last_byte_at = now;
        for (index, &byte) in bytes.iter().enumerate() {
            self.bytes[0] += 1;
            if matches!(self.phase, ConnectionPhase::Diagnosing | ConnectionPhase::Waiting) {
                self.classifier.push(&[byte]);
            }
            if let Some(question) = self.question.as_mut().filter(|question| question.is_sent()) {
                question.hear(byte);
            } else if let Some(Believed { moved, contained }) = self.take_byte(now, byte) {
                self.contained = contained;
                self.reading_arrived(now, moved);
                return index + 1;
            } else if self.poll.take_news() {
                self.mind_telling(now, true);
            }
        }
        bytes.len()
    }

    /// The completed frame, if it is accepted.
    fn take_byte(&mut self, now: f64, byte: u8) -> Option<Believed> {
        let Self { parser, filter, poll, readings, before, firmware, happenings, phase, diagnosis, .. } = self;
        let mut read = None;
        parser.feed(&[byte], &mut |event| {
            let happening = match event {
                StreamEvent::Frame(frame) => {
                    // During the diagnosis, frames belong to another program's stream.
                    let is_ours = match phase {
                        ConnectionPhase::Closed => false,
                        ConnectionPhase::Diagnosing | ConnectionPhase::Waiting => diagnosis.step == Step::Subscribing,
                        ConnectionPhase::Connected | ConnectionPhase::Lost => true,
                    };
                    let bytes = whole(frame.content());
                    match is_ours.then(|| filter.judge(now, frame)) {
                        None => Happening::Refused(bytes, FrameRefusal::NotRequested),
                        Some(verdict @ (FrameVerdict::Believed | FrameVerdict::Late)) => {
                            before.clone_from(readings);
                            let contained = frame.apply(readings);
                            let moved = poll.take(frame, readings, now, verdict == FrameVerdict::Late);
                            read = Some(Believed { moved, contained });
                            Happening::Frame(bytes)
                        }
                        Some(verdict @ (FrameVerdict::Waits | FrameVerdict::Jumps)) => {
                            poll.hold(frame, verdict == FrameVerdict::Jumps);
                            Happening::Refused(bytes, FrameRefusal::Unconfirmed)
                        }
                        Some(FrameVerdict::Impossible) => Happening::Refused(bytes, FrameRefusal::Impossible),
                    }
                }
                StreamEvent::Refused { bytes, error } => Happening::Refused(bytes.to_vec(), error.into()),
                StreamEvent::Text(text) => said(firmware, text.line),
            };
            happened(happenings, now, happening);
        });
        read
    }

    fn reading_arrived(&mut self, now: f64, moved: Option<DistanceAngle>) {
        self.has_read = true;
        self.sensors = SensorReadings { moved, ..crate::sensors::to_sensors(&self.readings) };
        // The robot's clock advances by one frame; if it falls too far behind, frames were lost.
        let before = self.robot_time.unwrap_or(now - FRAME_S);
        let time = (before + FRAME_S).max(now - LUMP_S);
        (self.fresh, self.robot_time) = (Some(time - before), Some(time));
        if self.is_older {
            self.reckon_counts(time - before, moved);
        } else if self.swapped {
            std::mem::swap(&mut self.sensors.left_counts, &mut self.sensors.right_counts);
        }
        self.link_stats.arrived(now, (self.readings.requested_right, self.readings.requested_left));
        self.is_stalled = false;
        if self.diagnosis.step == Step::Subscribing {
            self.diagnosis.finding = Finding::Robot;
            self.diagnosis.note("Receiving sensor data.".to_owned());
            self.diagnosis.go(Step::Done, now);
        }
        if self.phase == ConnectionPhase::Lost {
            self.happened(now, Happening::Line("Receiving data from the robot again.".to_owned()));
        }
        self.phase = ConnectionPhase::Connected;
        self.watch_mode(now);
        self.turn_wheels(now);
        self.mind_telling(now, true);
    }

    /// Counts for a robot that has none.
    fn reckon_counts(&mut self, seconds: f64, moved: Option<DistanceAngle>) {
        let (right, left) = self.wheels.sent();
        self.reckoned.roll(seconds, [left, right]);
        if let Some(moved) = moved {
            self.reckoned.report(moved);
        }
        [self.sensors.left_counts, self.sensors.right_counts] = self.reckoned.counts();
    }

    /// Seconds by which the robot's clock advanced with a new reading; `None` without one since the last call.
    pub fn take_reading(&mut self) -> Option<f64> {
        self.fresh.take()
    }

    /// Advances the time.
    pub fn tick(&mut self, now: f64) {
        if now - self.last_byte_at > QUIET_S {
            let Self { parser, happenings, firmware, .. } = self;
            parser.idle(&mut |event| {
                let happening = match event {
                    // Frames held back by a false header are outdated.
                    StreamEvent::Frame(frame) => Happening::Refused(whole(frame.content()), FrameRefusal::TooLate),
                    StreamEvent::Refused { bytes, error } => Happening::Refused(bytes.to_vec(), error.into()),
                    StreamEvent::Text(text) => said(firmware, text.line),
                };
                happened(happenings, now, happening);
            });
        }
        match self.phase {
            ConnectionPhase::Closed => {}
            ConnectionPhase::Diagnosing | ConnectionPhase::Waiting => self.find_out(now),
            ConnectionPhase::Connected | ConnectionPhase::Lost => {
                self.pursue_question(now);
                self.watch_line(now);
            }
        }
        self.turn_wheels(now);
        self.mind_telling(now, false);
    }

    fn pursue_question(&mut self, now: f64) {
        match self.question.as_mut().map(|question| question.advance(now)) {
            None | Some(Next::Wait) => {}
            Some(Next::Send(bytes)) => self.push_raw(now, &bytes),
            Some(Next::Done(bytes, words)) => {
                self.question = None;
                self.happened(now, Happening::Answer(bytes, words));
                let _ = self.send(now, Command::PauseResume { state: 1 });
            }
        }
    }

    fn watch_line(&mut self, now: f64) {
        let Some(last) = self.link_stats.last() else { return };
        let silent = now - last;
        if silent > STALL_S && !self.is_stalled {
            self.is_stalled = true;
            self.wheels.stop();
        }
        if silent > LOST_S && self.phase == ConnectionPhase::Connected {
            self.phase = ConnectionPhase::Lost;
            self.filter.forget();
            self.happened(now, Happening::Line("No more data from the robot.".to_owned()));
        }
        if self.phase == ConnectionPhase::Lost && self.diagnosis.step == Step::Done && now - self.revived_at > REVIVE_S
        {
            self.revived_at = now;
            if self.was_in_control {
                self.push(now, &STOP);
                self.stop_brushes(now);
                self.tell_mode(now);
            }
            self.subscribe(now);
        }
    }
}

/// The robot as a port for controllers, except that wheel speeds need the time: [`Driver::drive`].
impl Driver {
    /// This robot as a port at time `now`.
    pub fn port(&mut self, now: f64) -> Port<'_> {
        Port { driver: self, now }
    }
}

/// A robot on a line, at a moment.
pub struct Port<'a> {
    driver: &'a mut Driver,
    now: f64,
}

impl RobotPort for Port<'_> {
    fn sensors(&self) -> &SensorReadings {
        &self.driver.sensors
    }

    fn drive(&mut self, wanted: Drive) {
        self.driver.drive(self.now, wanted);
    }
}

/// An accepted frame, with its distance and angle.
struct Believed {
    moved: Option<DistanceAngle>,
    contained: PacketSet,
}

/// Both wheels at rest.
const STOP: [u8; 5] = [145, 0, 0, 0, 0];
/// Data bytes of the longest command that isn't a song or a list of packets: Schedule.
const LONGEST: usize = 15;

fn happened(happenings: &mut VecDeque<(f64, Happening)>, now: f64, happening: Happening) {
    if happenings.len() == MOST_HAPPENINGS {
        happenings.pop_front();
    }
    happenings.push_back((now, happening));
}

/// Processes a line of text, which can contain the name of the firmware.
fn said(firmware: &mut Option<String>, line: &str) -> Happening {
    if let Said::Firmware(_) = Said::of(line) {
        *firmware = Some(line.to_owned());
    }
    Happening::Text(line.to_owned())
}

/// A frame as it was on the line.
fn whole(content: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(content.len() + FRAMING);
    bytes.extend([HEADER, content.len() as u8]);
    bytes.extend_from_slice(content);
    let sum = bytes.iter().fold(0_u8, |sum, &byte| sum.wrapping_add(byte));
    bytes.push(sum.wrapping_neg());
    bytes
}

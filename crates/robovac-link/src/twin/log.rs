//! What a recording says about a robot's motion: commands, counts, light, and distances that a person measured.

use crate::{
    connection::{Calibration, LineRecording, RecordedEvent, Request},
    driver::Happening,
    recording::{LineEvent, RecordedReading, Watch},
};
use roomba_oi::{Command, CommandDecoder, Mode, Packet, motion::WheelSpeeds, motion::encoder_delta};
use std::{collections::VecDeque, sync::Arc};

/// Time without a reading after which motion is unknown, s.
const GAP_S: f64 = 0.1;
/// Time in which one reading at least is as young as any, s: the others waited somewhere on their way.
const JITTER_S: f64 = 1.0;
/// Least counts of a calibration's move that was carried out: a sixth of a turn, or 20 cm.
const LEAST_COUNTS: f64 = 450.0;
/// Plausible ratios of measured and reported moves.
const FACTORS: std::ops::RangeInclusive<f64> = 0.8..=1.25;

/// A reading.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// Time, s since the start of the recording, as if no reading had waited on its way.
    pub at: f64,
    /// Counts of left and right wheel since the first reading.
    pub counts: [f64; 2],
    /// Signals of the light bumper, from left to right; `None` if the frame had none.
    pub light: Option<[u16; 6]>,
    /// Pressed sides of the bumper: left, right.
    pub bumps: [bool; 2],
    /// Whether the wheels obey commands: Safe or Full, and on the floor.
    pub obeys: bool,
    /// Whether the way since the reading before is unknown.
    pub is_after_gap: bool,
}

/// Wheel speeds of a command, left and right, mm/s; `None` for one whose speeds aren't known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CommandedSpeeds {
    pub at: f64,
    pub speeds: Option<[f64; 2]>,
}

/// A move that a person measured in a calibration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Measured {
    /// Counts of a turn, right less left, and its degrees.
    Turn(f64, f64),
    /// Counts of a straight way, mean of both wheels, and its metres.
    Way(f64, f64),
}

/// Sums of the packets distance and angle, with the counts of the same time.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Claims {
    /// Millimetres, reports, and counts (mean of both wheels), forward and backward alike.
    pub distance: [f64; 3],
}

/// What a recording says.
#[derive(Debug, Default)]
pub(super) struct MotionLog {
    pub samples: Vec<Sample>,
    pub told: Vec<CommandedSpeeds>,
    pub measured: Vec<Measured>,
    pub claims: Claims,
    pub lost_frames: u64,
    pub readings: u64,
    /// Whether the recording has bytes from the robot.
    pub has_bytes: bool,
    /// Whether packets 43 and 44 are swapped.
    pub is_swapped: bool,
    reading: Unfinished,
}

/// State between two readings.
#[derive(Debug, Default)]
struct Unfinished {
    decoder: CommandDecoder,
    last: Option<[u16; 2]>,
    counts: [f64; 2],
    /// Time by the robot's clock, s.
    clock: f64,
    /// Counts at the start of a calibration's move.
    asked: Option<(Calibration, [f64; 2])>,
    /// Counts at the last report of the distance.
    claimed_at: Option<[f64; 2]>,
    /// Arrival less the robot's clock, for each sample, s.
    lags: Vec<f64>,
}

impl MotionLog {
    /// Reads a recording.
    pub fn of(recording: impl Into<Arc<LineRecording>>) -> Self {
        let recording = recording.into();
        let is_received = |event: &RecordedEvent| matches!(event, RecordedEvent::Received(bytes) if !bytes.is_empty());
        let has_bytes = recording.entries.iter().any(|(_, event)| is_received(event));
        let mut log = Self { has_bytes, ..Self::default() };
        let mut watch = Watch::new(recording);
        while watch.go_on(60.0, |at, event| log.take(at, event)) {}
        log.unswap();
        log.smooth();
        log
    }

    /// Counts of both wheels, forward and backward alike.
    pub fn way_counts(&self) -> f64 {
        let step = |pair: &[Sample]| {
            let [before, now] = pair else { return 0.0 };
            (0..2).map(|wheel| (now.counts[wheel] - before.counts[wheel]).abs()).sum()
        };
        0.5 * self.samples.windows(2).map(step).sum::<f64>()
    }

    /// Time covered by readings, s.
    pub fn covered_s(&self) -> f64 {
        let step = |pair: &[Sample]| match pair {
            [before, now] if !now.is_after_gap => now.at - before.at,
            _ => 0.0,
        };
        self.samples.windows(2).map(step).sum()
    }

    fn take(&mut self, now: f64, event: LineEvent) {
        match event {
            LineEvent::Reading(reading) => self.reading(now, &reading),
            LineEvent::Asked(json) => self.asked(&json),
            LineEvent::Happening(Happening::Sent(bytes)) => {
                for &byte in &bytes {
                    if let Some(Ok(command)) = self.reading.decoder.push(byte).map(|received| received.command) {
                        self.told.extend(told(now, command));
                    }
                }
            }
            LineEvent::Happening(Happening::Refused(_, why)) if why.is_loss() => self.lost_frames += 1,
            LineEvent::Happening(_) | LineEvent::Line(_) => {}
        }
    }

    fn reading(&mut self, now: f64, reading: &RecordedReading) {
        let RecordedReading { readings, contained, mode, dt_s, .. } = reading;
        self.readings += 1;
        if !contained.contains(Packet::LeftEncoder) || !contained.contains(Packet::RightEncoder) {
            return;
        }
        let state = &mut self.reading;
        let raw = [readings.left_counts, readings.right_counts];
        let last = state.last.replace(raw).unwrap_or(raw);
        for wheel in 0..2 {
            state.counts[wheel] += f64::from(encoder_delta(last[wheel], raw[wheel]));
        }
        state.clock += dt_s;
        if contained.contains(Packet::Distance) {
            if let Some(before) = state.claimed_at {
                let counts = 0.5 * (state.counts[0] - before[0] + state.counts[1] - before[1]);
                let sum = &mut self.claims.distance;
                sum[0] += f64::from(readings.distance_mm.unsigned_abs());
                sum[1] += if readings.distance_mm == 0 { 0.0 } else { 1.0 };
                sum[2] += if readings.distance_mm == 0 { 0.0 } else { counts.abs() };
            }
            state.claimed_at = Some(state.counts);
        }
        let lag = now - state.clock;
        let is_after_gap = state.lags.last().is_none_or(|before| (lag - before).abs() > GAP_S) || *dt_s > GAP_S;
        state.lags.push(lag);
        let bumps = readings.bumps;
        self.samples.push(Sample {
            at: state.clock,
            counts: state.counts,
            light: contained.contains(Packet::LightCentreLeft).then_some(readings.light_signal),
            bumps: [bumps.bump_left, bumps.bump_right],
            obeys: mode.is_some_and(|mode| mode >= Mode::Safe) && !bumps.drop_left && !bumps.drop_right,
            is_after_gap,
        });
    }

    /// Takes a request: those of calibrations measure moves.
    fn asked(&mut self, json: &str) {
        let counts = self.reading.counts;
        match serde_json::from_str(json) {
            Ok(Request::Calibrate { what }) => self.reading.asked = Some((what, counts)),
            Ok(Request::Answer { value }) => {
                let Some((what, before)) = self.reading.asked.take() else { return };
                let [left, right] = [0, 1].map(|wheel| counts[wheel] - before[wheel]);
                let measured = match what {
                    Calibration::Spin => Measured::Turn(right - left, value),
                    Calibration::Metre => Measured::Way(0.5 * (left + right), value),
                    Calibration::Nudge | Calibration::Square | Calibration::SquareRight => return,
                };
                self.measured.extend(Some(measured).filter(Measured::is_plausible));
            }
            Ok(Request::Skip | Request::Stop) => self.reading.asked = None,
            _ => {}
        }
    }

    /// Finds out by turns on the spot whether the encoders are swapped, and puts them right.
    fn unswap(&mut self) {
        let mut agrees = 0.0;
        let mut told = self.told.iter().peekable();
        let mut speeds = None;
        for (pair, lag) in self.samples.windows(2).zip(&self.reading.lags) {
            let [before, now] = pair else { continue };
            while let Some(next) = told.next_if(|told| told.at < before.at + lag - JITTER_S / 4.0) {
                speeds = next.speeds;
            }
            if let Some([left, right]) = speeds.filter(|[left, right]| left * right < 0.0) {
                let turned = (now.counts[1] - now.counts[0]) - (before.counts[1] - before.counts[0]);
                agrees += turned * f64::signum(right - left);
            }
        }
        self.is_swapped = agrees < -LEAST_COUNTS / 4.0;
        if self.is_swapped {
            for sample in &mut self.samples {
                sample.counts.swap(0, 1);
            }
        }
        for measured in &mut self.measured {
            // A person's turn is to the left.
            if let Measured::Turn(counts, _) = measured {
                *counts = counts.abs();
            }
        }
    }

    /// Puts the readings on the computer's clock: each at the time at which it would have arrived if it had waited as
    /// little as the quickest around it.
    fn smooth(&mut self) {
        let lags = std::mem::take(&mut self.reading.lags);
        let clocks: Vec<f64> = self.samples.iter().map(|sample| sample.at).collect();
        // The smallest lag within the time around, by a queue of candidates in rising order.
        let mut candidates: VecDeque<usize> = VecDeque::new();
        let mut next = 0;
        let gaps: Vec<bool> = self.samples.iter().map(|sample| sample.is_after_gap).collect();
        for (index, sample) in self.samples.iter_mut().enumerate() {
            if sample.is_after_gap {
                candidates.clear();
                next = index;
            }
            let is_near = |other: usize| (clocks[other] - clocks[index]).abs() <= JITTER_S;
            while next < clocks.len() && is_near(next) && (next == index || !gaps[next]) {
                while candidates.back().is_some_and(|&last| lags[last] >= lags[next]) {
                    candidates.pop_back();
                }
                candidates.push_back(next);
                next += 1;
            }
            while candidates.front().is_some_and(|&oldest| !is_near(oldest)) {
                candidates.pop_front();
            }
            let lag = candidates.front().map_or(lags[index], |&best| lags[best]);
            sample.at += lag;
        }
    }
}

impl Measured {
    /// Whether the move was made, and the answer can be right. The page refuses other answers, too.
    fn is_plausible(&self) -> bool {
        use super::{counts_per_turn, model_mm_per_count};
        let (counts, factor) = match *self {
            Self::Turn(counts, degrees) => (counts, degrees / 360.0 * counts_per_turn() / counts.abs()),
            Self::Way(counts, metres) => (counts, 1000.0 * metres / (counts * model_mm_per_count())),
        };
        counts.abs() > LEAST_COUNTS && FACTORS.contains(&factor)
    }
}

/// What a command says about the wheels.
fn told(at: f64, command: Command<'_>) -> Option<CommandedSpeeds> {
    let speeds = match command {
        Command::Drive { velocity, radius } => {
            let WheelSpeeds { right, left } = WheelSpeeds::of_drive(velocity, radius).limited();
            Some([left, right])
        }
        Command::DriveDirect { right, left } => Some([f64::from(left), f64::from(right)]),
        Command::Start | Command::Reset | Command::Stop | Command::Power => Some([0.0; 2]),
        Command::DrivePwm { .. } | Command::Clean | Command::Spot | Command::Max | Command::SeekDock => None,
        _ => return None,
    };
    Some(CommandedSpeeds { at, speeds })
}

//! A twin of a robot from a recording of its line: the figures in which this robot differs from its model.
//!
//! # What a recording tells
//!
//! - *Commands against counts* tell how fast the wheels change their speed, how late they obey, how well they keep the
//!   commanded speed, and how much the counts scatter.
//! - *Turns on the spot beside a wall* tell the counts of a full turn: the light bumper sees the same again after 360
//!   degrees, without any tape. That fixes the ratio of wheel base to wheel size, on which headings depend. How much one
//!   turn differs from the next tells slip.
//! - *Walls met head-on* tell how the light bumper's signal falls with distance: at the contact, the distance is known.
//! - *Calibrations* (Metre, Spin) tell what a person measured.
//!
//! # What it can't tell
//!
//! - The size of the wheels, without a measured metre: a robot regulates its speed by its own counts, so that commands,
//!   counts and its distance packets agree whatever its wheels are. The wheel base follows the wheels' size.
//! - Slip along a straight line, and on which floor it stood: no sensor sees either.
//! - The light that a wall reflects: the gain found is that of the sensor times the reflectance of the walls met.
//!
//! There the model's figures stay, and the twin says why.

mod check;
mod error;
mod figures;
mod light;
mod log;
mod turns;
mod wheels;

pub use check::Prediction;
pub use error::TwinError;
pub use robovac_sim::experiment::{TwinFigure, TwinFile};

use crate::connection::LineRecording;
use figures::Found;
use log::MotionLog;
use robovac_core::{
    math::PI,
    robot::{MODELS, RobotModel, TWIN_MODEL, model},
};
use roomba_oi::motion::{MM_PER_COUNT, WHEEL_BASE_MM};
use std::sync::Arc;

/// Least time covered by readings, s.
pub(crate) const LEAST_S: f64 = 10.0;
/// Least way of the wheels, m.
const LEAST_M: f64 = 0.2;
/// Share of damaged frames from which the line is to blame.
const DAMAGED: f64 = 0.3;

/// A twin that was fitted to a recording.
#[derive(Debug, Clone)]
pub struct TwinFit {
    file: TwinFile,
    delay_s: f64,
}

impl TwinFit {
    /// Fits a twin to a recording. Takes about as long as reading it.
    pub fn of(recording: impl Into<Arc<LineRecording>>) -> Result<Self, TwinError> {
        let log = usable(recording.into())?;
        let found = Found::of(&log, roomba());
        if found.is_nothing() {
            return Err(TwinError::Untold);
        }
        Ok(Self { delay_s: found.delay_s(), file: found.file() })
    }

    /// The twin with all its figures, for a file.
    pub fn file(&self) -> &TwinFile {
        &self.file
    }

    /// How well the twin predicts another recording of the same robot, and how well its model does.
    pub fn check(&self, recording: impl Into<Arc<LineRecording>>) -> Result<Vec<Prediction>, TwinError> {
        let log = usable(recording.into())?;
        let predictions = check::predict(&log, &self.file, self.delay_s, roomba());
        if predictions.is_empty() { Err(TwinError::Untold) } else { Ok(predictions) }
    }
}

/// What a recording says, if it is worth a fit.
fn usable(recording: Arc<LineRecording>) -> Result<MotionLog, TwinError> {
    let log = MotionLog::of(recording);
    let (seconds, metres) = (log.covered_s(), log.way_counts() * model_mm_per_count() / 1000.0);
    let all = log.readings + log.lost_frames;
    let is_short = seconds < LEAST_S;
    match () {
        () if log.readings == 0 && !log.has_bytes => Err(TwinError::Silent),
        () if log.readings == 0 => Err(TwinError::Garbled),
        () if is_short && log.lost_frames as f64 > DAMAGED * all as f64 => {
            Err(TwinError::Damaged { lost: log.lost_frames, all })
        }
        () if log.samples.is_empty() => Err(TwinError::NoEncoders),
        () if is_short => Err(TwinError::Short { seconds }),
        () if metres < LEAST_M => Err(TwinError::Still { metres }),
        () => Ok(log),
    }
}

/// The model of robots that can be connected.
fn roomba() -> &'static RobotModel {
    model(TWIN_MODEL).unwrap_or(MODELS[0])
}

/// The specification's way for one count, mm.
fn model_mm_per_count() -> f64 {
    MM_PER_COUNT
}

/// Counts of a full turn by the specification, right less left.
fn counts_per_turn() -> f64 {
    2.0 * PI * WHEEL_BASE_MM / MM_PER_COUNT
}

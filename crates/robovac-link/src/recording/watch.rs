//! The events of a recording, in order.

use crate::{
    connection::{LineRecording, Replay},
    driver::{Happening, ModeLoss},
};
use robovac_core::geometry::Pose;
use roomba_oi::{Mode, PacketSet, Readings};
use std::sync::Arc;

/// Longest part of a recording whose events are kept at once, s.
const PART_S: f64 = 1.0;

/// An event of a recording.
#[derive(Debug, Clone, PartialEq)]
pub enum LineEvent {
    /// What happened to the line or was asked of it, in the recording's words.
    Line(String),
    /// What the user asked for, as JSON.
    Asked(String),
    /// Bytes, frames and texts, as the driver took them.
    Happening(Happening),
    /// An accepted frame, decoded.
    Reading(Box<RecordedReading>),
}

/// A reading of the sensors, and what follows from it.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedReading {
    /// The latest value of every packet.
    pub readings: Readings,
    /// Packets that this frame contained; the others are of earlier frames.
    pub contained: PacketSet,
    /// The mode, corrected on robots that report one too much.
    pub mode: Option<Mode>,
    /// Why it left Safe or Full, until the next mode command.
    pub loss: Option<ModeLoss>,
    /// Its pose by odometry: as estimated then, with the calibration in use.
    pub pose: Pose,
    /// Path driven so far, m.
    pub distance_m: f64,
    /// Time since the reading before, by the robot's clock, s.
    pub dt_s: f64,
}

/// Plays a recording and passes on its events.
pub struct Watch {
    replay: Replay,
}

impl Watch {
    /// At the start.
    pub fn new(recording: impl Into<Arc<LineRecording>>) -> Self {
        let mut replay = Replay::new(recording);
        replay.watch();
        Self { replay }
    }

    /// Duration, s.
    pub fn duration_s(&self) -> f64 {
        self.replay.duration_s()
    }

    /// Plays so many seconds of the recording, and passes on what happened in them; whether there is more.
    pub fn go_on(&mut self, seconds: f64, mut each: impl FnMut(f64, LineEvent)) -> bool {
        let (end, mut time) = (self.duration_s(), self.replay.time_s());
        let goal = (time + seconds.max(PART_S)).min(end);
        loop {
            time = (time + PART_S).min(goal);
            self.replay.advance(time);
            for (at, event) in self.replay.take_events() {
                each(at, event);
            }
            if time >= goal {
                return goal < end;
            }
        }
    }

    /// What the driver found on the line, in words.
    pub(super) fn diagnosis(&mut self) -> String {
        self.replay.view().diagnosis.text
    }
}

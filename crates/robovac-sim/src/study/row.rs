//! Result of one run of a study.

use crate::{
    experiment::RoomSetup,
    montecarlo::{GOALS, RunOutcome, SAMPLES},
};
use serde::{Deserialize, Serialize};

/// One run's result, as shards hold it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudyRow {
    /// Number of the run.
    pub run: u64,
    /// Why there is no outcome; `None` if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<String>,
    /// The outcome.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outcome: Option<StudyOutcome>,
}

/// The numbers of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudyOutcome {
    /// Reachable floor, m².
    pub floor_m2: f64,
    /// Side of the planning cells, m.
    pub cell_size_m: f64,
    /// Swept share of the floor at the end (of the boundary, for exploring behaviours: detected), 0 to 1.
    pub coverage: f64,
    /// Times at which 90 % and 99 % were reached, s; `None` if they weren't.
    pub reached_s: [Option<f64>; GOALS.len()],
    /// Simulated time, s.
    pub time_s: f64,
    /// Distance driven, m.
    pub distance_m: f64,
    /// Number of bumps.
    pub bumps: u32,
    /// Number of falls down a drop-off.
    pub falls: u32,
    /// Remaining share of the dirt, 0 to 1; `None` if there was none.
    pub dirt_left: Option<f64>,
    /// By how much distance and time exceed the least possible, as shares.
    pub excess: Option<[f64; 2]>,
    /// Coverage at equal intervals, first at the start.
    pub curve: Vec<f32>,
    /// Digest of the final state, hexadecimal.
    pub digest: String,
}

impl StudyOutcome {
    /// The numbers of `outcome`, with `intervals` of its curve, a divisor of [`SAMPLES`]; 0 for none.
    pub(super) fn of(outcome: &RunOutcome, prepared: &RoomSetup, intervals: usize) -> Self {
        let step = SAMPLES.checked_div(intervals);
        Self {
            floor_m2: prepared.floor.area(),
            cell_size_m: prepared.planning_grid.cells.size,
            coverage: outcome.coverage(),
            reached_s: outcome.reached_s.map(|time| Some(time).filter(|time| time.is_finite())),
            time_s: outcome.time_s,
            distance_m: outcome.distance_m,
            bumps: outcome.bumps,
            falls: outcome.falls,
            dirt_left: outcome.dirt_left,
            excess: outcome.excess,
            curve: step.map_or_else(Vec::new, |step| outcome.curve.iter().step_by(step).map(|&x| x as f32).collect()),
            digest: format!("{:016x}", outcome.digest),
        }
    }
}

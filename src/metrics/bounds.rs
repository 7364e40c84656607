//! What no walk can be better than.

use crate::planner::CoverageJob;
use serde::{Deserialize, Serialize};

/// Steps that a quarter turn counts as where steps and turns are put into one number.
pub const TURN_STEPS: usize = 2;

/// Proven lower bounds for every walk that starts in a job's start, ends anywhere and visits all its cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Bounds {
    /// Fewest steps.
    pub steps: usize,
    /// Fewest quarter turns; a reversal counts two, the turn before the first step isn't counted.
    pub turns: usize,
    /// Least steps + [`TURN_STEPS`] x quarter turns; may be more than what the two bounds above add up to.
    pub cost: usize,
}

impl Bounds {
    /// The bounds of `job`.
    pub fn of(job: &CoverageJob) -> Self {
        let steps = job.cells().saturating_sub(1);
        Self { steps, turns: 0, cost: steps }
    }
}

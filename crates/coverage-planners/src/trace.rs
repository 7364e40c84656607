//! Trace of a planner's decisions, for the animation.

use robovac_core::grid::{Cell, Direction};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// One decision of a planner.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct TraceStep {
    /// Index in the walk of the cell in which it is taken.
    pub step: usize,
    /// The rule that decides, in a few words.
    pub rule: Cow<'static, str>,
    /// The cell in which it is taken.
    pub at: Cell,
    /// Where to go.
    pub towards: Direction,
    /// Values that are looked at, and the cells that have them.
    pub marks: Vec<(Cell, u32)>,
    /// Two sides of the room that are compared: all that lies beyond `at` in a direction, and its value.
    pub sides: Option<[(Direction, u32); 2]>,
    /// The decision in words: a sentence without its stop.
    pub note: String,
}

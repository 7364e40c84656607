//! Trace of a planner's decisions, for the animation.

use robovac_core::grid::{Cell, Direction};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// Rule of the last [`TraceStep`] of a walk that misses cells; its note says why the walk ends.
pub const THE_END: &str = "The end";

/// One decision of a planner.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct TraceStep {
    /// Index in the walk of the cell in which it is taken.
    pub step: usize,
    /// The deciding rule, in a few words.
    pub rule: Cow<'static, str>,
    /// The cell in which it is taken.
    pub at: Cell,
    /// The direction to go in.
    pub towards: Direction,
    /// Values that are considered, with their cells.
    pub marks: Vec<(Cell, u32)>,
    /// Two sides of the room that are compared: everything beyond `at` in a direction, and its value.
    pub sides: Option<[(Direction, u32); 2]>,
    /// The decision in words: a sentence without its stop.
    pub note: String,
}

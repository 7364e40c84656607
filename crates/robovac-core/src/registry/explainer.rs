//! Explanation of an algorithm.

use super::text::{is_same, sentences};
use crate::floor_plan::ROOMS;

/// What the page says of an algorithm to someone who doesn't know it.
#[derive(Debug, Clone, Copy)]
pub struct Explainer {
    /// The idea in three sentences.
    pub idea: &'static str,
    /// Time and memory in the number of cells n, as the code has them.
    pub complexity: &'static str,
    /// When to choose it, and when not to.
    pub use_when: &'static str,
    /// A room that ships and that shows what it is good at.
    pub shines: Example,
    /// A room that ships and that shows what it is bad at.
    pub fails: Example,
}

impl Explainer {
    /// Checks that all is said, and `summary` in one sentence.
    ///
    /// # Panics
    ///
    /// If it isn't. It is for constants, where that is an error of the compiler.
    pub const fn check(&self, summary: &str) {
        assert!(sentences(summary) == 1, "`summary` must be one sentence");
        assert!(sentences(self.idea) == 3, "`idea` must be three sentences; write \"about\" rather than \"approx.\"");
        assert!(!self.complexity.is_empty() && !self.use_when.is_empty(), "`complexity` or `use_when` is empty");
        assert!(
            self.shines.is_there() && self.fails.is_there(),
            "an example has no `why`, or names no room that ships"
        );
    }
}

impl Example {
    const fn is_there(&self) -> bool {
        let mut index = 0;
        while index < ROOMS.len() && !is_same(ROOMS[index].id, self.room) {
            index += 1;
        }
        index < ROOMS.len() && !self.why.is_empty()
    }
}

/// A room and what an algorithm does there.
#[derive(Debug, Clone, Copy)]
pub struct Example {
    /// Id of a room that ships.
    pub room: &'static str,
    /// What is to be seen there, in one sentence.
    pub why: &'static str,
}

//! Explanation of an algorithm.

use super::text::{is_same, sentences};
use crate::floor_plan::ROOMS;

/// Introduction to an algorithm, for its panel on the page.
#[derive(Debug, Clone, Copy)]
pub struct Explainer {
    /// The idea in three sentences.
    pub idea: &'static str,
    /// Time and memory of the implementation, in the number of cells n.
    pub complexity: &'static str,
    /// When to choose it, and when not to.
    pub use_when: &'static str,
    /// A built-in room that shows its strengths.
    pub shines: Example,
    /// A built-in room that shows its weaknesses.
    pub fails: Example,
    /// Where it comes from: authors, year, title, section.
    pub source: &'static str,
    /// Address of the source or of a good description; empty if there is none.
    pub link: &'static str,
}

impl Explainer {
    /// Checks that all texts are complete, and that `summary` is one sentence.
    ///
    /// # Panics
    ///
    /// If one isn't. Meant for constants, where it is a compile error.
    pub const fn check(&self, summary: &str) {
        assert!(sentences(summary) == 1, "`summary` must be one sentence");
        assert!(sentences(self.idea) == 3, "`idea` must be three sentences; write \"about\" rather than \"approx.\"");
        assert!(!self.complexity.is_empty() && !self.use_when.is_empty(), "`complexity` or `use_when` is empty");
        assert!(!self.source.is_empty(), "`source` is empty");
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
    /// Id of a built-in room.
    pub room: &'static str,
    /// What it shows, in one sentence.
    pub why: &'static str,
}

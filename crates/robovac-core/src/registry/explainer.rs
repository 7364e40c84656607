//! Explanation of an algorithm.

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

/// A room and what an algorithm does there.
#[derive(Debug, Clone, Copy)]
pub struct Example {
    /// Id of a room that ships.
    pub room: &'static str,
    /// What is to be seen there, in one sentence.
    pub why: &'static str,
}

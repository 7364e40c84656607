//! What is wrong with a lesson, and where.

/// A fault of a lesson: line, cause, and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("line {line}: {what}; {mend}")]
pub struct LessonFault {
    /// Line of the file, from 1.
    pub line: usize,
    /// The cause.
    pub what: String,
    /// What to do.
    pub mend: String,
}

impl LessonFault {
    /// A fault at `line`.
    pub fn new(line: usize, what: impl Into<String>, mend: impl Into<String>) -> Self {
        Self { line, what: what.into(), mend: mend.into() }
    }
}

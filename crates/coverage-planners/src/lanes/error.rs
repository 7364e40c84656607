//! Errors of the planner.

/// Errors of the planner.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LanesError {
    /// A number is out of range.
    #[error("{what} can't be {value}; use {expected}")]
    Value {
        /// Name of the number.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Accepted values.
        expected: &'static str,
    },
    /// The caller asked to stop before there was a path.
    #[error("planning was cancelled")]
    Cancelled,
}

//! Errors of the sweep.

use robovac_core::cspace::CspaceError;

/// Errors of the sweep.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SweepError {
    /// The obstacle map can't be made.
    #[error(transparent)]
    Cspace(#[from] CspaceError),
    /// A number is out of range.
    #[error("{what} can't be {value}; use {expected}")]
    Value {
        /// Name of the number.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Accepted values.
        expected: String,
    },
    /// The body fits nowhere.
    #[error("the robot, {width:.2} m wide, fits nowhere in this room; choose a smaller robot or another region")]
    FitsNowhere {
        /// Width of the outline, m.
        width: f64,
    },
    /// The caller asked to stop.
    #[error("planning was cancelled")]
    Cancelled,
}

//! The controller that drives a connected robot.

use robovac_sim::controller::Controller;

/// A controller at work.
pub(super) struct DriveSession {
    /// Its name.
    pub title: String,
    pub controller: Box<dyn Controller>,
    /// Whether a person is at the controls.
    pub is_manual: bool,
    /// Time since it began, s.
    pub time_s: f64,
    pub is_done: bool,
    /// Why it was ended before it was done; empty if it wasn't.
    pub ended: String,
}

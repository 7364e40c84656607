//! The controller that drives a connected robot.

use robovac_sim::controller::Controller;

/// A controller that is driving.
pub(super) struct DriveSession {
    /// Its name.
    pub title: String,
    pub controller: Box<dyn Controller>,
    /// Whether a person drives.
    pub is_manual: bool,
    /// Whether brushes and vacuum run for it.
    pub cleans: bool,
    /// Time since it began, s.
    pub time_s: f64,
    pub is_done: bool,
    /// Why it was ended early; empty if it wasn't.
    pub ended: String,
}

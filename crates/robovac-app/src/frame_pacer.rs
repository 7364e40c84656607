//! Time on the screen as steps of a simulation.

use robovac_sim::STEP_S;

/// Longest time between two frames, s; after a pause of the browser the rest is dropped.
pub const LONGEST_FRAME: f64 = 0.1;

/// Steps per frame, and the achieved speed.
#[derive(Debug, Clone, Copy, Default)]
pub struct FramePacer {
    /// Steps that are due.
    due: f64,
    speed_factor: f64,
}

impl FramePacer {
    /// Advances by `elapsed_s` at `speed` times real time, 0 for as fast as possible: `advance` receives the number of
    /// steps, takes as many as it has time for, and returns their number.
    pub fn frame(&mut self, elapsed_s: f64, speed: f64, advance: impl FnOnce(u64) -> u64) {
        let elapsed = elapsed_s.clamp(0.0, LONGEST_FRAME);
        self.due += elapsed * speed / STEP_S;
        let wanted = if speed == 0.0 { u64::MAX } else { self.due as u64 };
        let taken = advance(wanted);
        // Steps that couldn't be done in time are dropped; the achieved speed shows it.
        self.due = if taken == wanted { self.due.fract() } else { 0.0 };
        if elapsed > 0.0 {
            let factor = taken as f64 * STEP_S / elapsed;
            // The first frame counts in full: smoothing from zero would look like a slow start.
            let weight = if self.speed_factor > 0.0 { 0.1 } else { 1.0 };
            self.speed_factor += weight * (factor - self.speed_factor);
        }
    }

    /// Achieved speed, times real time.
    pub const fn speed_factor(&self) -> f64 {
        self.speed_factor
    }

    /// Time is paused.
    pub const fn rest(&mut self) {
        self.speed_factor = 0.0;
    }

    /// Resets the due steps when the simulation or its speed changes.
    pub const fn restart(&mut self) {
        self.due = 0.0;
    }
}

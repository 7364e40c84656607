//! Time between frames, and time for simulation in each.

use crate::wire::clock;

/// Time for simulation in a frame, ms: at least, and at most; the rest of 16.7 ms is for drawing and the browser.
const BUDGET_MS: [f64; 2] = [3.0, 8.0];
/// Frames further apart than the first of these, ms, come late. Those further apart than the second tell nothing: they may not be
/// meant to come oftener.
const LATE_MS: [f64; 2] = [18.0, 40.0];

/// Paces frames: where drawing takes long, less is simulated in each, so that as many come as the screen shows.
#[derive(Debug)]
pub struct FrameClock {
    last_ms: Option<f64>,
    budget_ms: f64,
}

impl Default for FrameClock {
    fn default() -> Self {
        Self { last_ms: None, budget_ms: BUDGET_MS[1] }
    }
}

impl FrameClock {
    /// A frame begins at `now_ms`; returns the time since the last one, s, and until when to simulate, by [`clock`].
    pub fn frame(&mut self, now_ms: f64) -> (f64, f64) {
        let elapsed_ms = self.last_ms.replace(now_ms).map_or(0.0, |last| now_ms - last);
        if elapsed_ms <= LATE_MS[0] {
            self.budget_ms = BUDGET_MS[1].min(self.budget_ms + 0.1);
        } else if elapsed_ms <= LATE_MS[1] {
            self.budget_ms = BUDGET_MS[0].max(0.9 * self.budget_ms);
        }
        (elapsed_ms / 1000.0, clock() + self.budget_ms)
    }

    /// Time stands still until the next frame.
    pub fn rest(&mut self) {
        self.last_ms = None;
    }
}

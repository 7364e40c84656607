//! Time on the screen as steps of a simulation.

use robovac_sim::STEP_S;

/// Longest time between two frames that is made up for, s: after a pause of the browser the robot doesn't leap.
pub const LONGEST_FRAME: f64 = 0.1;

/// How many steps a frame takes, and how fast that is.
#[derive(Debug, Clone, Copy, Default)]
pub struct FramePacer {
    /// Steps that are due but not done.
    due: f64,
    speed_factor: f64,
}

impl FramePacer {
    /// Lets `elapsed_s` pass at `speed` times real time, 0 for as fast as it goes: `advance` takes as many steps as it is
    /// given, if it has the time, and returns how many those were.
    pub fn frame(&mut self, elapsed_s: f64, speed: f64, advance: impl FnOnce(u64) -> u64) {
        let elapsed = elapsed_s.clamp(0.0, LONGEST_FRAME);
        self.due += elapsed * speed / STEP_S;
        let wanted = if speed == 0.0 { u64::MAX } else { self.due as u64 };
        let taken = advance(wanted);
        // What couldn't be done in time isn't made up for: the achieved speed says so instead.
        self.due = if taken == wanted { self.due.fract() } else { 0.0 };
        if elapsed > 0.0 {
            let factor = taken as f64 * STEP_S / elapsed;
            // The first frame counts in full: smoothing from zero would look like a slow start.
            let weight = if self.speed_factor > 0.0 { 0.1 } else { 1.0 };
            self.speed_factor += weight * (factor - self.speed_factor);
        }
    }

    /// Speed reached lately, times real time.
    pub const fn speed_factor(&self) -> f64 {
        self.speed_factor
    }

    /// Time stands still.
    pub const fn rest(&mut self) {
        self.speed_factor = 0.0;
    }

    /// Nothing is due: what is played, or how fast, is another.
    pub const fn restart(&mut self) {
        self.due = 0.0;
    }
}

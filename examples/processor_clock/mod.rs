//! A clock for tables of what is found after so many seconds, while other programs may run.

use std::{fs, time::Instant};

/// A clock of the working time.
pub struct Clock {
    begun: Instant,
    worked: Option<f64>,
}

impl Clock {
    /// Begins now.
    pub fn start() -> Self {
        Self { begun: Instant::now(), worked: Self::worked() }
    }

    /// How long it has run, s.
    pub fn seconds(&self) -> f64 {
        Self::worked().zip(self.worked).map_or_else(|| self.begun.elapsed().as_secs_f64(), |(now, then)| now - then)
    }

    /// Processor time of the only thread, s, on Linux.
    fn worked() -> Option<f64> {
        let nanoseconds: f64 =
            fs::read_to_string("/proc/self/schedstat").ok()?.split_whitespace().next()?.parse().ok()?;
        Some(nanoseconds / 1e9)
    }
}

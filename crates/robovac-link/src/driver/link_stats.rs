//! Statistics of the serial link.

use std::collections::VecDeque;

/// Round trips in the median.
const ROUND_TRIPS: usize = 15;
/// Time window of the rate, s.
const WINDOW_S: f64 = 1.0;

/// Rate, gaps and round trips.
#[derive(Debug, Clone, Default)]
pub struct LinkStats {
    arrivals: VecDeque<f64>,
    longest_gap_s: f64,
    /// Command in transit: wheel speeds right and left, and its time.
    asked: Option<((i16, i16), f64)>,
    round_trips: VecDeque<f64>,
}

impl LinkStats {
    /// A frame arrived that reports the requested wheel speeds, right and left.
    pub fn arrived(&mut self, now: f64, requested: (i16, i16)) {
        if let Some(&last) = self.arrivals.back() {
            self.longest_gap_s = self.longest_gap_s.max(now - last);
        }
        self.arrivals.push_back(now);
        while self.arrivals.front().is_some_and(|&first| now - first > WINDOW_S) {
            self.arrivals.pop_front();
        }
        if let Some((asked, at)) = self.asked
            && asked == requested
        {
            self.asked = None;
            self.round_trips.push_back(now - at);
            if self.round_trips.len() > ROUND_TRIPS {
                self.round_trips.pop_front();
            }
        }
    }

    /// Other wheel speeds than before were commanded.
    pub fn asked(&mut self, now: f64, wheels: (i16, i16)) {
        self.asked = Some((wheels, now));
    }

    /// The stream was interrupted on purpose; the next gap doesn't count.
    pub fn pause(&mut self) {
        self.arrivals.clear();
        self.asked = None;
    }

    /// Time of the last frame, s.
    pub fn last(&self) -> Option<f64> {
        self.arrivals.back().copied()
    }

    /// Current frames per second.
    pub fn rate_hz(&self, now: f64) -> f64 {
        let recent = self.arrivals.iter().filter(|&&at| now - at <= WINDOW_S).count();
        let since = self.arrivals.front().map_or(WINDOW_S, |&first| (now - first).clamp(0.1, WINDOW_S));
        recent as f64 / since
    }

    /// The longest time without a frame, s.
    pub fn longest_gap_s(&self) -> f64 {
        self.longest_gap_s
    }

    /// Median time from a command to the robot's report of it, s.
    pub fn round_trip_s(&self) -> Option<f64> {
        let mut sorted: Vec<f64> = self.round_trips.iter().copied().collect();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied()
    }
}

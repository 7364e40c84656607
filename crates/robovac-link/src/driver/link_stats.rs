//! Statistics of the serial link.

use std::collections::VecDeque;

/// Round trips that the median is taken of.
const ROUND_TRIPS: usize = 15;
/// Time over which the rate is measured, s.
const WINDOW_S: f64 = 1.0;

/// Rate, gaps and round trips.
#[derive(Debug, Clone, Default)]
pub struct LinkStats {
    arrivals: VecDeque<f64>,
    longest_gap_s: f64,
    /// Command on its way: wheel speeds right and left, and when it was sent.
    asked: Option<((i16, i16), f64)>,
    round_trips: VecDeque<f64>,
}

impl LinkStats {
    /// A frame arrived that says which wheel speeds, right and left, the robot was asked for last.
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

    /// Other wheel speeds than before were asked for.
    pub fn asked(&mut self, now: f64, wheels: (i16, i16)) {
        self.asked = Some((wheels, now));
    }

    /// The stream was broken off on purpose: what comes now is no gap.
    pub fn pause(&mut self) {
        self.arrivals.clear();
        self.asked = None;
    }

    /// When the last frame came, s.
    pub fn last(&self) -> Option<f64> {
        self.arrivals.back().copied()
    }

    /// Frames a second, lately.
    pub fn rate_hz(&self, now: f64) -> f64 {
        let recent = self.arrivals.iter().filter(|&&at| now - at <= WINDOW_S).count();
        let since = self.arrivals.front().map_or(WINDOW_S, |&first| (now - first).clamp(0.1, WINDOW_S));
        recent as f64 / since
    }

    /// The longest time without a frame, s.
    pub fn longest_gap_s(&self) -> f64 {
        self.longest_gap_s
    }

    /// Time from a command until the robot reports it, s; median.
    pub fn round_trip_s(&self) -> Option<f64> {
        let mut sorted: Vec<f64> = self.round_trips.iter().copied().collect();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied()
    }
}

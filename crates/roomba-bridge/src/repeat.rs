//! A stop that is said several times.

/// How often a stop is said again, and the time between, ms. The bridge can't see whether the robot obeys, and bytes can get
/// lost on the line.
const TIMES: u8 = 3;
const EVERY_MS: u64 = 100;

/// A stop that was sent, and will be again.
#[derive(Debug, Clone, Copy, Default)]
pub struct Repeat {
    bytes: &'static [u8],
    left: u8,
    next_ms: u64,
}

impl Repeat {
    /// Of a stop that is sent now.
    pub fn of(bytes: &'static [u8], now_ms: u64) -> Self {
        Self { bytes, left: TIMES, next_ms: now_ms.saturating_add(EVERY_MS) }
    }

    /// What is due now.
    pub fn due(&mut self, now_ms: u64) -> Option<&'static [u8]> {
        if self.left == 0 || now_ms < self.next_ms {
            return None;
        }
        (self.left, self.next_ms) = (self.left - 1, now_ms.saturating_add(EVERY_MS));
        Some(self.bytes)
    }

    /// Whether there is more to come.
    pub fn is_over(&self) -> bool {
        self.left == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_times_and_no_more() {
        let mut repeat = Repeat::of(&[128], 50);
        let due: Vec<_> = (0..1000).filter(|&now_ms| repeat.due(now_ms).is_some()).collect();
        assert_eq!(due, [150, 250, 350]);
        assert!(repeat.is_over() && Repeat::default().is_over());
    }
}

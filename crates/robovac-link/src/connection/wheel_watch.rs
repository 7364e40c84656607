//! Detects motion of the wheels that isn't caused by this program.

use roomba_oi::motion::encoder_delta;

/// Least counts of both wheels together that are motion rather than jitter.
const MOVED_COUNTS: u32 = 4;
/// Time for which wheels count as turning after a motion, s.
const TURNING_S: f64 = 0.6;
/// Time in which wheels come to rest after a stop, s.
const REST_S: f64 = 1.2;

/// Distinguishes a robot that moves by its own program, or is pushed, from one driven by this program.
#[derive(Debug, Clone, Copy)]
pub(super) struct WheelWatch {
    /// Encoders when the wheels last turned.
    counts: Option<[u16; 2]>,
    turned_at: f64,
    driven_at: f64,
}

impl Default for WheelWatch {
    fn default() -> Self {
        Self { counts: None, turned_at: f64::NEG_INFINITY, driven_at: f64::NEG_INFINITY }
    }
}

impl WheelWatch {
    /// Takes the encoders of a reading, and whether this program drives the robot.
    pub fn take(&mut self, now: f64, counts: [u16; 2], is_driven: bool) {
        if is_driven {
            self.driven_at = now;
        }
        let before = *self.counts.get_or_insert(counts);
        let turned: u32 =
            before.into_iter().zip(counts).map(|(b, n)| u32::from(encoder_delta(b, n).unsigned_abs())).sum();
        if turned >= MOVED_COUNTS {
            (self.counts, self.turned_at) = (Some(counts), now);
        }
    }

    /// Without readings: counts until the next one are ignored.
    pub fn forget(&mut self) {
        (self.counts, self.turned_at) = (None, f64::NEG_INFINITY);
    }

    /// Whether the robot moves by itself.
    pub fn moves_alone(&self, now: f64) -> bool {
        now - self.turned_at < TURNING_S && now - self.driven_at > REST_S
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wheels_that_roll_out_are_not_taken_for_wheels_that_turn_by_themselves() {
        let mut watch = WheelWatch::default();
        let mut count = 65_500_u16;
        for step in 0..400_u32 {
            let now = f64::from(step) * 0.01;
            count = count.wrapping_add(1);
            watch.take(now, [count, count], step < 100);
            // Driven until 0.99 s, and for 1.2 s they can roll out.
            assert_eq!(watch.moves_alone(now), step > 219, "{now}");
        }
        watch.take(4.5, [count, count + 1], false);
        assert!(!watch.moves_alone(4.6), "one count is trembling");
        watch.take(5.0, [count + 9, count], false);
        watch.forget();
        assert!(!watch.moves_alone(5.0));
    }
}

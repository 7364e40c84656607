//! Whether wheels turn that nobody here drives.

use roomba_oi::motion::encoder_delta;

/// Counts of both wheels together that are no trembling.
const MOVED_COUNTS: u32 = 4;
/// For how long wheels count as turning after they did, s.
const TURNING_S: f64 = 0.6;
/// How long wheels take to come to rest after a stop, s.
const REST_S: f64 = 1.2;

/// Tells a robot that moves by its own program, or is pushed, from one that is driven from here.
#[derive(Debug, Clone, Copy)]
pub(super) struct WheelWatch {
    /// Encoders when the wheels turned last.
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
    /// Takes the encoders of a reading, and whether the robot is driven from here.
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

    /// Nothing is heard of the encoders: what they count until they are heard again is nobody's.
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
            // Driven until 0.99 s, and for 1.2 s they may roll out.
            assert_eq!(watch.moves_alone(now), step > 219, "{now}");
        }
        watch.take(4.5, [count, count + 1], false);
        assert!(!watch.moves_alone(4.6), "one count is trembling");
        watch.take(5.0, [count + 9, count], false);
        watch.forget();
        assert!(!watch.moves_alone(5.0));
    }
}

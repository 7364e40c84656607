//! Conditions that last for a while.

/// Time by which two episodes can be apart and are one, s: contacts bounce.
const APART_S: f64 = 0.5;

/// A condition with parts, such as the wheels that hang down.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LastingCondition {
    /// Parts, as bits, that were set in it; when it began, and when it was last seen.
    present: Option<(u8, f64, f64)>,
}

/// An episode that is over: its parts, when it began, and how long it lasted, s.
pub(super) type Over = (u8, f64, f64);

impl LastingCondition {
    /// Takes the parts that are set now; the episode before, if it is over.
    pub fn see(&mut self, now: f64, bits: u8) -> Option<Over> {
        let over = match self.present {
            Some((_, _, last)) if now - last > APART_S => self.end(),
            _ => None,
        };
        if bits != 0 {
            let (sum, from, _) = self.present.unwrap_or((0, now, now));
            self.present = Some((sum | bits, from, now));
        }
        over
    }

    /// The present episode, which ends here.
    pub fn end(&mut self) -> Option<Over> {
        self.present.take().map(|(bits, from, last)| (bits, from, last - from))
    }
}

/// Events of one kind that follow each other closely.
#[derive(Debug, Clone)]
pub(super) struct Cluster<T> {
    /// What they have in common, their number, and the times of the first and the last.
    present: Option<(T, u64, f64, f64)>,
}

impl<T> Default for Cluster<T> {
    fn default() -> Self {
        Self { present: None }
    }
}

impl<T: PartialEq> Cluster<T> {
    /// Takes an event; the cluster before, if this one isn't in it.
    pub fn take(&mut self, now: f64, what: T, apart_s: f64) -> Option<(T, u64, f64, f64)> {
        match &mut self.present {
            Some((same, count, _, last)) if *same == what && now - *last <= apart_s => {
                *count += 1;
                *last = now;
                None
            }
            _ => {
                self.present.replace((what, 1, now, now)).map(|(what, count, from, to)| (what, count, from, to - from))
            }
        }
    }

    /// The present cluster, which ends here: what, how many, when, how long.
    pub fn end(&mut self) -> Option<(T, u64, f64, f64)> {
        self.present.take().map(|(what, count, from, to)| (what, count, from, to - from))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contacts_that_bounce_are_one_episode() {
        let mut wheels = LastingCondition::default();
        assert_eq!(
            [(1.0, 1), (1.1, 0), (1.3, 2), (1.6, 2), (1.7, 0)].map(|(at, bits)| wheels.see(at, bits)),
            [None; 5]
        );
        let (bits, from, duration) = wheels.see(2.2, 0).unwrap();
        assert!(bits == 3 && from == 1.0 && (duration - 0.6).abs() < 1e-9);
        assert_eq!((wheels.see(3.0, 0), wheels.end()), (None, None));
    }

    #[test]
    fn others_begin_another_cluster() {
        let mut commands = Cluster::default();
        assert_eq!([0.0, 0.5, 1.0].map(|at| commands.take(at, "LEDs", 1.0)), [None; 3]);
        assert_eq!(commands.take(1.5, "Clean", 1.0), Some(("LEDs", 3, 0.0, 1.0)));
        assert_eq!(commands.take(9.0, "Clean", 1.0), Some(("Clean", 1, 1.5, 0.0)));
        assert_eq!(commands.end(), Some(("Clean", 1, 9.0, 0.0)));
    }
}

//! The clock and the weekly schedule (opcodes 168 and 167): they make a robot clean by itself, in Off and Passive.
//!
//! Nothing happens before the clock is set; a power loss clears both.

use super::clock::{Nanos, SECOND};
use roomba_oi::{Time, Weekdays};

const DAY_MINUTES: u64 = 24 * 60;
const WEEK_MINUTES: u64 = 7 * DAY_MINUTES;

/// Clock and schedule.
#[derive(Debug, Clone, Default)]
pub(super) struct Calendar {
    /// When the clock was set, and its minute of the week.
    set: Option<(Nanos, u64)>,
    days: Weekdays,
    times: [Time; 7],
    /// Minutes since the clock was set that have been checked.
    looked_at: u64,
}

impl Calendar {
    /// Sets the clock: day, 0 for Sunday, hour and minute.
    pub fn set_clock(&mut self, now: Nanos, day: u8, [hour, minute]: Time) {
        let minute = u64::from(day) * DAY_MINUTES + u64::from(hour) * 60 + u64::from(minute);
        (self.set, self.looked_at) = (Some((now, minute)), 0);
    }

    /// Sets the schedule, from Sunday to Saturday.
    pub fn set_schedule(&mut self, days: Weekdays, times: [Time; 7]) {
        (self.days, self.times) = (days, times);
    }

    /// Whether a time to clean has passed since the last call.
    pub fn is_due(&mut self, now: Nanos) -> bool {
        let Some((set, first)) = self.set else { return false };
        let passed = (now - set) / (60 * SECOND);
        if passed == self.looked_at {
            return false;
        }
        self.looked_at = passed;
        let minute = (first + passed) % WEEK_MINUTES;
        let (day, minute) = (minute / DAY_MINUTES, minute % DAY_MINUTES);
        let is_set = self.days.byte() >> day & 1 == 1;
        let time = self.times.get(day as usize);
        is_set && time.is_some_and(|&[hour, at]| u64::from(hour) * 60 + u64::from(at) == minute)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cleans_on_the_days_and_at_the_times_that_were_set() {
        let mut calendar = Calendar::default();
        let wednesday = Weekdays { wednesday: true, ..Weekdays::default() };
        calendar.set_schedule(wednesday, [[15, 0]; 7]);
        assert!(!calendar.is_due(100 * SECOND));
        // Tuesday, 14:58, for a week.
        calendar.set_clock(0, 2, [14, 58]);
        let due: Vec<u64> = (0..7 * 24 * 60).filter(|minute| calendar.is_due(minute * 60 * SECOND)).collect();
        assert_eq!(due, [24 * 60 + 2]);
    }
}

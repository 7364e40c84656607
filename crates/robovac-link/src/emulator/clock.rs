//! Emulator time in whole nanoseconds: sums don't depend on step sizes.

/// Nanoseconds since the emulator began.
pub(super) type Nanos = u64;

/// One simulation step, which is also how often the robot refreshes its readings: 15 ms.
pub(super) const STEP: Nanos = 15_000_000;

/// A second.
pub(super) const SECOND: Nanos = 1_000_000_000;

/// Milliseconds in nanoseconds.
pub(super) const fn ms(milliseconds: u64) -> Nanos {
    milliseconds * 1_000_000
}

//! Power states (awake, asleep, booting) and the BRC wire.
//!
//! - In Passive it falls asleep after five minutes without a command, a button, a pulse on BRC or a built-in program;
//!   in Safe and Full never. In Off the interface isn't running, and no source mentions sleep: it stays awake.
//! - Power (133) puts it to sleep at once and leaves it in Passive. The specification names the mode and the sleep, but no
//!   time; that it happens at once, and that unsent bytes are lost, is ours.
//! - Asleep it is silent, and no byte wakes it. Its Clean button and the end of a low pulse on BRC do. Mode, rate and
//!   stream are kept: sleep isn't among the documented ways into Off.
//! - Three low pulses on BRC of 50 to 500 ms each, two seconds or more after power-on, set 19200 baud. That they follow each
//!   other within two seconds is ours.
//! - Reset (7) takes five seconds, as if the battery had been taken out: rate and mode are those of power-on. The times
//!   of the banner (15 ms, 1 s, 3 s, 4 s) and its text are from yarc's source; the older one is of a 700, from owners'
//!   logs. When it listens again, 4.5 s, is ours.

use super::{
    calendar::Calendar,
    clock::{Nanos, SECOND, ms},
    machine::Machine,
    personality::Banner,
    sound,
};
use robovac_core::robot::RobotPort;
use roomba_oi::Mode;

/// Time without activity after which a robot in Passive falls asleep.
pub(super) const SLEEPS_AFTER: Nanos = 300 * SECOND;
/// Time from reset to listening.
const BOOT: Nanos = ms(4500);
/// Time between two bytes of a boot loader that is stuck (ours).
const REPEATS: Nanos = ms(100);
/// Length of a BRC pulse that counts for the change to 19200 baud.
const PULSE: [Nanos; 2] = [ms(50), ms(500)];
/// Time after power-on before which pulses don't count.
const SETTLES: Nanos = 2 * SECOND;
/// The rate that they select.
const SLOW_BAUD: u32 = 19_200;
/// Longest time between two pulses.
const BETWEEN: Nanos = 2 * SECOND;

/// State of the robot's processor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PowerState {
    /// Listens.
    Awake,
    /// Asleep, since this time.
    Asleep(Nanos),
    /// Booting, since this time, with the number of banner parts written.
    Booting(Nanos, usize),
    /// Stuck in its boot loader, with the time of its next byte.
    BootLoader(Nanos),
    /// The battery is empty.
    Flat,
}

/// Effect of a pulse on BRC.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pulse {
    /// A pulse has begun: the robot stays awake.
    Began,
    /// A pulse has ended: a sleeping robot wakes.
    Ended,
    /// It was the third short one.
    Third,
}

/// The BRC wire.
#[derive(Debug, Clone, Default)]
pub(super) struct Brc {
    low_since: Option<Nanos>,
    short_pulses: u8,
    last_end: Nanos,
}

impl Brc {
    /// Sets the wire low or high; returns the effect. `powered_on` is the time of power-on.
    fn set(&mut self, now: Nanos, is_low: bool, powered_on: Nanos) -> Option<Pulse> {
        match (self.low_since, is_low) {
            (None, true) => {
                self.low_since = Some(now);
                Some(Pulse::Began)
            }
            (Some(since), false) => {
                self.low_since = None;
                let is_short = (PULSE[0]..=PULSE[1]).contains(&(now - since)) && since >= powered_on + SETTLES;
                let follows = self.short_pulses == 0 || since <= self.last_end + BETWEEN;
                self.short_pulses = match (is_short, follows) {
                    (false, _) => 0,
                    (true, false) => 1,
                    (true, true) => self.short_pulses + 1,
                };
                self.last_end = now;
                if self.short_pulses < 3 {
                    return Some(Pulse::Ended);
                }
                self.short_pulses = 0;
                Some(Pulse::Third)
            }
            _ => None,
        }
    }
}

/// The robot is awake again.
struct Booted;

/// The next part of a banner, after `written` parts of it and at most `passed` after the reset.
fn boot(banner: Banner, written: usize, passed: Nanos) -> Result<Option<&'static [u8]>, Booted> {
    let parts: &[(Nanos, &'static [u8])] = match banner {
        Banner::Stm32 => &[
            (ms(15), b"Soft reset!\n"),
            (ms(1000), &[0xFE]),
            (ms(3000), b"Roomba by iRobot!\r\nstm32\r\n2015-12-18-1607-L   \r\nbattery-current-zero 254\r\n"),
            (ms(4000), b"\r\n2015-12-18-1607-L   \r\nr3-robot/tags/release-stm32-3.7.1:6174 CLEAN\r\n\r\n"),
        ],
        Banner::Str730 => &[
            (ms(15), b"bl-start\r\nSTR730\r\n"),
            (
                ms(1000),
                b"bootloader id: #x47145443 85E4CFFF\r\nbootloader info rev: #xF000\r\nbootloader rev: #x0001\r\n",
            ),
            (ms(3000), b"Roomba by iRobot!\r\nstr730\r\nbattery-current-zero 258\r\n\r\n"),
            (ms(4000), b"r3_robot/tags/release-3.4.0:0 CLEAN\r\n\r\n"),
        ],
        Banner::None => &[],
    };
    match parts.get(written) {
        Some((at, text)) if passed >= *at => Ok(Some(text)),
        None if passed >= BOOT => Err(Booted),
        _ => Ok(None),
    }
}

/// Text written by a robot that wakes up.
pub(super) fn woken(slept: Nanos, by_button: bool) -> String {
    let seconds = slept / SECOND;
    let why = if by_button { "key-wakeup \r\n" } else { "" };
    format!("{why}slept for {} minutes {} seconds\r\n", seconds / 60, seconds % 60)
}

/// Text written by a robot that falls asleep.
const FALLS_ASLEEP: &[u8] = b"processor-sleep\r\n";

impl Machine {
    /// The BRC wire goes low or high.
    pub fn set_brc(&mut self, is_low: bool) {
        if !self.who.has_brc {
            return;
        }
        let pulse = self.brc.set(self.now, is_low, self.powered_on);
        match (pulse, self.power) {
            (Some(Pulse::Third), PowerState::Awake) => {
                self.active = self.now;
                self.sound.sound(sound::SLOW);
                self.line.set_baud(self.now, SLOW_BAUD);
            }
            (Some(_), PowerState::Awake) => self.active = self.now,
            (Some(Pulse::Ended | Pulse::Third), PowerState::Asleep(since)) if self.who.silent_on_dock_s.is_none() => {
                self.wake(self.now - since, false);
            }
            _ => {}
        }
    }

    /// Falls asleep; pending output is lost.
    pub fn fall_asleep(&mut self) {
        if self.who.tells_of_sleep {
            self.line.send(self.now, FALLS_ASLEEP);
        } else {
            self.line.power_down(self.now);
        }
        self.asked.clear();
        self.builtin_program = None;
        self.power = PowerState::Asleep(self.now);
    }

    /// Loses its memory and stops.
    pub fn go_down(&mut self) {
        self.enter(Mode::Off);
        self.builtin_program = None;
        self.line.power_down(self.now);
        self.sound.power_down();
        self.calendar = Calendar::default();
    }

    /// Restarts, as if its battery had been taken out and put in again.
    pub fn boot(&mut self) {
        self.go_down();
        self.line.set_baud(self.now, self.who.default_baud);
        self.powered_on = self.now;
        self.power = if self.who.stays_in_boot_loader {
            PowerState::BootLoader(self.now + REPEATS)
        } else {
            PowerState::Booting(self.now, 0)
        };
    }

    /// Activity while it isn't awake.
    pub fn go_up(&mut self) {
        match self.power {
            PowerState::Booting(since, written) => match boot(self.who.banner, written, self.now - since) {
                Ok(Some(text)) => {
                    self.line.send(self.now, text);
                    self.power = PowerState::Booting(since, written + 1);
                }
                Ok(None) => {}
                Err(Booted) => {
                    let (sensed, [left, right]) = (self.robot.sensors(), self.who.first_counts);
                    self.counts_offset =
                        [left.wrapping_sub(sensed.left_counts), right.wrapping_sub(sensed.right_counts)];
                    self.travel.forget_distance();
                    self.travel.forget_angle();
                    self.power = PowerState::Awake;
                    self.active = self.now;
                }
            },
            PowerState::BootLoader(at) if self.now >= at => {
                self.line.send(self.now, &[0xFE]);
                self.power = PowerState::BootLoader(at + REPEATS);
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pulses(lengths_and_gaps: &[(u64, u64)], from: Nanos) -> Vec<Pulse> {
        let (mut brc, mut now) = (Brc::default(), from);
        let mut seen = Vec::new();
        for &(length, gap) in lengths_and_gaps {
            seen.extend(brc.set(now, true, 0));
            now += ms(length);
            seen.extend(brc.set(now, false, 0));
            now += ms(gap);
        }
        seen
    }

    #[test]
    fn only_three_short_pulses_in_a_row_change_the_rate() {
        let has_third = |p: &[(u64, u64)], from| pulses(p, from).contains(&Pulse::Third);
        assert!(has_third(&[(50, 100), (500, 100), (200, 0)], 2 * SECOND));
        assert!(!has_third(&[(100, 100), (100, 0)], 2 * SECOND));
        assert!(!has_third(&[(100, 100), (1000, 100), (100, 100), (100, 0)], 2 * SECOND));
        assert!(!has_third(&[(100, 100), (49, 100), (100, 0)], 2 * SECOND));
        assert!(!has_third(&[(100, 100), (100, 2100), (100, 0)], 2 * SECOND));
        // Too soon after power-on.
        assert!(!has_third(&[(100, 100), (100, 100), (100, 0)], SECOND));
    }
}

//! LEDs and digit display.
//!
//! In Off and Passive the robot controls its display; Safe switches everything off and obeys commands, and so does
//! Full, which leaves on what was (the specification speaks of Safe alone). What a robot shows by itself is ours, after its
//! manual: the Clean button is green, or red with a low battery, orange while it charges, and dark while it sleeps; Spot and
//! Dock light up while it does that, and Check Robot when it has given up.

use super::{Display, builtin_program::Chore};
use roomba_oi::{Command, Lamps, ScheduleLamps, Weekdays};

/// What is lit by command.
#[derive(Debug, Clone, Default)]
pub(super) struct Lights {
    lamps: Lamps,
    clean: [u8; 2],
    digits: Digits,
    weekdays: Weekdays,
    schedule: ScheduleLamps,
}

/// Blank by default.
#[derive(Debug, Clone)]
struct Digits([u8; 4]);

impl Default for Digits {
    fn default() -> Self {
        Self([b' '; 4])
    }
}

/// What a robot's own lights tell of.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy)]
pub(super) struct Condition {
    pub is_awake: bool,
    pub is_charging: bool,
    pub is_low: bool,
    pub is_in_trouble: bool,
    pub chore: Option<Chore>,
}

impl Lights {
    /// Takes a command; whether it was one for lights. Opcode 163 doesn't work on this firmware, and shows nothing.
    pub fn take(&mut self, command: Command<'_>) -> bool {
        match command {
            Command::Leds { lamps, colour, intensity } => (self.lamps, self.clean) = (lamps, [colour, intensity]),
            Command::SchedulingLeds { weekdays, lamps } => (self.weekdays, self.schedule) = (weekdays, lamps),
            Command::DigitsAscii { text } => self.digits = Digits(text),
            Command::DigitsRaw { .. } => {}
            _ => return false,
        }
        true
    }

    /// What the robot shows by itself.
    pub fn of(condition: Condition) -> Self {
        let Condition { is_awake, is_charging, is_low, is_in_trouble, chore } = condition;
        if !is_awake {
            return Self::default();
        }
        let lamps = Lamps {
            spot: chore == Some(Chore::Spot),
            dock: chore == Some(Chore::Dock),
            check_robot: is_in_trouble,
            ..Lamps::default()
        };
        let colour = match (is_charging, is_low) {
            (true, _) => 128,
            (false, true) => 255,
            (false, false) => 0,
        };
        Self { lamps, clean: [colour, 255], ..Self::default() }
    }

    /// Shows it.
    pub fn show(&self, display: &mut Display) {
        display.lamps = self.lamps;
        display.clean_light = self.clean;
        display.digits = self.digits.0;
        display.weekdays = self.weekdays;
        display.schedule = self.schedule;
    }
}

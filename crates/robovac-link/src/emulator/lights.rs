//! LEDs and digit display.
//!
//! In Off and Passive the robot controls its display; Safe switches everything off and obeys commands; Full obeys them
//! too but keeps the display (the specification mentions Safe only). The robot's own display is ours, after its manual:
//! the Clean button is green, or red with a low battery, orange while it charges, and dark while it sleeps; Spot and
//! Dock light up during these programs, and Check Robot after trouble.

use super::{Display, builtin_program::Chore};
use roomba_oi::{Command, Lamps, ScheduleLamps, Weekdays};

/// Lights set by command.
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

/// State shown by a robot's own lights.
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
    /// Takes a command; returns whether it was one for lights. Opcode 163 has no effect on this firmware.
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

    /// The robot's own display.
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

    /// Copies the lights to the display.
    pub fn show(&self, display: &mut Display) {
        display.lamps = self.lamps;
        display.clean_light = self.clean;
        display.digits = self.digits.0;
        display.weekdays = self.weekdays;
        display.schedule = self.schedule;
    }
}

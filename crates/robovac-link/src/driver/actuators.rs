//! Brushes, vacuum and lights, as they were commanded last.
//!
//! Robots don't report them, but these facts are certain: Passive and Off switch brushes off and give the lights back to
//! the robot, and Safe switches the lights off (Create 2 Open Interface specification, opcodes 131, 138 and 139).

use roomba_oi::{Command, Lamps, Mode, ModeAfter, Motors, ScheduleLamps, Weekdays};

/// Full duty cycle, 1/128 (opcode 144).
const FULL: i8 = 127;

/// Brushes and vacuum of a robot that cleans.
pub const CLEANING_MOTORS: Motors =
    Motors { side_brush: true, vacuum: true, main_brush: true, side_brush_clockwise: false, main_brush_outward: false };

/// What a host has switched on, and the robot hasn't switched off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Actuators {
    /// Running brushes and vacuum, and the chosen directions.
    pub motors: Motors,
    /// Duty cycles in 1/128, -127 to 127: main brush, inward positive; side brush, counter-clockwise positive; vacuum.
    pub duty: [i8; 3],
    /// Lights around the Clean button.
    pub lamps: Lamps,
    /// Colour of the Clean button, 0 green to 255 red, and its brightness, 0 to 255.
    pub clean_light: [u8; 2],
    /// Characters on the four digits.
    pub digits: [u8; 4],
    /// Lights of the weekdays.
    pub weekdays: Weekdays,
    /// Lights of the schedule.
    pub schedule: ScheduleLamps,
}

impl Default for Actuators {
    fn default() -> Self {
        Self {
            motors: Motors::default(),
            duty: [0; 3],
            lamps: Lamps::default(),
            clean_light: [0; 2],
            digits: [b' '; 4],
            weekdays: Weekdays::default(),
            schedule: ScheduleLamps::default(),
        }
    }
}

impl Actuators {
    /// Takes a command that was sent. Robots ignore invalid values.
    pub fn take(&mut self, command: Command<'_>) {
        let command = command.clamped();
        if command.check().is_err() {
            return;
        }
        match command {
            Command::Motors(motors) => (self.motors, self.duty) = (motors, full(motors)),
            Command::PwmMotors { main_brush, side_brush, vacuum } => {
                // Up to 127 after clamping.
                self.duty = [main_brush, side_brush, vacuum.cast_signed()];
                self.motors = Motors {
                    side_brush: side_brush != 0,
                    vacuum: vacuum != 0,
                    main_brush: main_brush != 0,
                    side_brush_clockwise: side_brush < 0,
                    main_brush_outward: main_brush < 0,
                };
            }
            Command::Leds { lamps, colour, intensity } => (self.lamps, self.clean_light) = (lamps, [colour, intensity]),
            Command::DigitsAscii { text } => self.digits = text,
            Command::SchedulingLeds { weekdays, lamps } => (self.weekdays, self.schedule) = (weekdays, lamps),
            _ => match command.opcode().mode_after() {
                ModeAfter::Is(Mode::Safe) => *self = Self { motors: self.motors, duty: self.duty, ..Self::default() },
                ModeAfter::Is(Mode::Off | Mode::Passive) => *self = Self::default(),
                ModeAfter::Is(Mode::Full) | ModeAfter::Same => {}
            },
        }
    }

    /// Whether a brush or the vacuum runs.
    pub fn is_running(&self) -> bool {
        self.motors.side_brush || self.motors.vacuum || self.motors.main_brush
    }
}

/// Duty cycles of motors that are on or off.
fn full(motors: Motors) -> [i8; 3] {
    let duty = |is_on: bool, is_reversed: bool| match (is_on, is_reversed) {
        (false, _) => 0,
        (true, false) => FULL,
        (true, true) => -FULL,
    };
    [
        duty(motors.main_brush, motors.main_brush_outward),
        duty(motors.side_brush, motors.side_brush_clockwise),
        duty(motors.vacuum, false),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(commands: &[Command<'_>]) -> Actuators {
        let mut actuators = Actuators::default();
        for command in commands {
            actuators.take(*command);
        }
        actuators
    }

    #[test]
    fn safe_darkens_the_lights_and_passive_ends_everything() {
        let leds = Command::Leds { lamps: Lamps::from_byte(3), colour: 255, intensity: 9 };
        let on = [Command::Safe, Command::Motors(Motors::from_byte(7)), leds];
        assert_eq!((after(&on).motors.byte(), after(&on).lamps.byte(), after(&on).clean_light), (7, 3, [255, 9]));
        let safe = after(&[&on[..], &[Command::Safe]].concat());
        assert_eq!((safe.is_running(), safe.lamps.byte(), safe.clean_light), (true, 0, [0, 0]));
        assert_eq!(after(&[&on[..], &[Command::Full]].concat()), after(&on));
        for ends in [Command::Start, Command::Clean, Command::Power, Command::Stop, Command::Reset] {
            assert_eq!(after(&[&on[..], &[ends]].concat()), Actuators::default(), "{ends:?}");
        }
    }

    #[test]
    fn duty_cycles_are_shown_as_running_motors() {
        let outward = after(&[Command::PwmMotors { main_brush: -128, side_brush: 0, vacuum: 200 }]);
        assert_eq!((outward.duty, outward.motors.byte()), ([-127, 0, 127], 0b1_0110));
        let bits = after(&[Command::Motors(Motors::from_byte(0b0_1101))]);
        assert_eq!(bits.duty, [127, -127, 0]);
    }

    #[test]
    fn what_robots_ignore_changes_nothing() {
        let text = Command::DigitsAscii { text: [1; 4] };
        assert_eq!(after(&[text]), Actuators::default());
    }
}

//! Wheel and brush commands, and packets 19, 20 and 39 to 42.
//!
//! The last motion command stays in force until another comes or the mode ends: there is no timeout. Drive PWM is taken as
//! a speed: none up to a duty cycle of 21 of 255 on hard floor or 40 on carpet (measured by K. Tibow: what it takes to
//! move), and from there evenly up to 500 mm/s (ours).

use robovac_core::robot::{Drive, SensorReadings};
use roomba_oi::{
    Command, Motors,
    motion::{MAX_SPEED_MM_S, MM_PER_COUNT, WHEEL_BASE_MM, WheelSpeeds, encoder_delta},
};

/// Largest duty cycles at which the wheels don't move, on hard floor and on carpet.
const DEAD: [f64; 2] = [20.0, 39.0];

/// The last wheel command.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Told {
    how: How,
    /// Of the latest Drive: velocity, radius.
    pub drive: [i16; 2],
    /// Of the latest Drive Direct: right, left.
    pub direct: [i16; 2],
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum How {
    Speeds(WheelSpeeds),
    /// Duty cycles: right, left.
    Pwm([i16; 2]),
}

impl Default for How {
    fn default() -> Self {
        Self::Speeds(WheelSpeeds::default())
    }
}

impl Told {
    /// Takes a motion command; returns whether it was one.
    pub fn take(&mut self, command: Command<'_>) -> bool {
        match command {
            Command::Drive { velocity, radius } => {
                self.how = How::Speeds(WheelSpeeds::of_drive(velocity, radius).limited());
                self.drive = [velocity, radius];
            }
            Command::DriveDirect { right, left } => {
                self.how = How::Speeds(WheelSpeeds { right: right.into(), left: left.into() });
                self.direct = [right, left];
            }
            Command::DrivePwm { right, left } => self.how = How::Pwm([right, left]),
            _ => return false,
        }
        true
    }

    /// The commanded wheel speeds, mm/s.
    pub fn speeds(&self, is_on_carpet: bool) -> WheelSpeeds {
        match self.how {
            How::Speeds(speeds) => speeds,
            How::Pwm([right, left]) => {
                let dead = DEAD[usize::from(is_on_carpet)];
                let speed = |duty: i16| {
                    let duty = f64::from(duty);
                    let share = ((duty.abs() - dead) / (255.0 - dead)).max(0.0);
                    f64::from(MAX_SPEED_MM_S) * share.copysign(duty)
                };
                WheelSpeeds { right: speed(right), left: speed(left) }
            }
        }
    }
}

/// Speeds in mm/s as a drive command of the simulated robot.
pub(super) fn to_drive(speeds: WheelSpeeds) -> Drive {
    Drive::wheels(speeds.left / 1000.0, speeds.right / 1000.0)
}

/// Packets 19 and 20: motion of the wheels since each was last read.
///
/// Both are whole numbers, truncated towards 0, and reading one resets it: the remainder is lost. So with reads every
/// 15 ms slow motions are never reported; turns are from 67 degrees a second on (fact sheet, section 7).
#[derive(Debug, Clone, Default)]
pub(super) struct DistanceAngleSum {
    last: [u16; 2],
    /// Counts of left and right wheel since packet 19, and since packet 20, was read.
    distance: [i64; 2],
    angle: [i64; 2],
}

impl DistanceAngleSum {
    /// Takes the counters after a step.
    pub fn count(&mut self, sensed: &SensorReadings) {
        for (wheel, now) in [sensed.left_counts, sensed.right_counts].into_iter().enumerate() {
            let delta = i64::from(encoder_delta(self.last[wheel], now));
            self.last[wheel] = now;
            self.distance[wheel] += delta;
            self.angle[wheel] += delta;
        }
    }

    /// Packet 19, mm; saturates.
    pub fn distance(&self) -> i16 {
        let [left, right] = self.distance;
        (0.5 * (left + right) as f64 * MM_PER_COUNT) as i16
    }

    /// Packet 20, degrees times `factor`; saturates.
    pub fn angle(&self, factor: f64) -> i16 {
        let [left, right] = self.angle;
        (((right - left) as f64 * MM_PER_COUNT / WHEEL_BASE_MM).to_degrees() * factor) as i16
    }

    pub fn forget_distance(&mut self) {
        self.distance = [0; 2];
    }

    pub fn forget_angle(&mut self) {
        self.angle = [0; 2];
    }
}

/// Brushes and vacuum: duty cycles from -1 to 1. The main brush's is positive inward, the side brush's counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Brushes {
    pub main: f64,
    pub side: f64,
    pub vacuum: f64,
}

impl Brushes {
    /// The values while the robot cleans by itself.
    pub const CLEANING: Self = Self { main: 1.0, side: 1.0, vacuum: 1.0 };

    /// The values of Motors (138).
    pub fn of_motors(motors: Motors) -> Self {
        let duty = |is_on: bool, is_reversed: bool| match (is_on, is_reversed) {
            (false, _) => 0.0,
            (true, false) => 1.0,
            (true, true) => -1.0,
        };
        Self {
            main: duty(motors.main_brush, motors.main_brush_outward),
            side: duty(motors.side_brush, motors.side_brush_clockwise),
            vacuum: duty(motors.vacuum, false),
        }
    }

    /// The values of PWM Motors (144).
    pub fn of_pwm(main: i8, side: i8, vacuum: u8) -> Self {
        Self { main: f64::from(main) / 128.0, side: f64::from(side) / 128.0, vacuum: f64::from(vacuum) / 128.0 }
    }

    /// As bits: running motors and their directions.
    pub fn motors(&self) -> Motors {
        Motors {
            side_brush: self.side != 0.0,
            vacuum: self.vacuum != 0.0,
            main_brush: self.main != 0.0,
            side_brush_clockwise: self.side < 0.0,
            main_brush_outward: self.main < 0.0,
        }
    }

    /// Shares of their power: main brush, side brush, vacuum.
    pub fn loads(&self) -> [f64; 3] {
        [self.main.abs(), self.side.abs(), self.vacuum]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(counts: &[(u16, u16)]) -> DistanceAngleSum {
        let mut travel = DistanceAngleSum::default();
        for &(left_counts, right_counts) in counts {
            travel.count(&SensorReadings { left_counts, right_counts, ..SensorReadings::default() });
        }
        travel
    }

    #[test]
    fn distance_and_angle_are_cut_towards_zero_and_saturate() {
        assert_eq!((after(&[(2, 2)]).distance(), after(&[(3, 3)]).distance()), (0, 1));
        assert_eq!(after(&[(65_533, 65_533)]).distance(), -1);
        // 1660.7 counts a wheel are a full turn.
        assert_eq!((after(&[(64_706, 831)]).angle(1.0), after(&[(831, 64_706)]).angle(1.0)), (180, -180));
        let long: Vec<(u16, u16)> = (1..=4).map(|i: u16| (i.wrapping_mul(30_000), i.wrapping_mul(30_000))).collect();
        assert_eq!(after(&long).distance(), i16::MAX);
    }

    #[test]
    fn small_duty_cycles_move_nothing_and_less_on_carpet() {
        let speed = |duty, is_on_carpet| {
            let mut told = Told::default();
            told.take(Command::DrivePwm { right: duty, left: -duty });
            let speeds = told.speeds(is_on_carpet);
            assert_eq!(speeds.left, -speeds.right);
            speeds.right
        };
        assert_eq!(
            (speed(20, false), speed(39, true), speed(255, false), speed(-255, true)),
            (0.0, 0.0, 500.0, -500.0)
        );
        assert!(speed(21, false) > 0.0 && speed(39, false) > 0.0 && speed(40, true) > 0.0);
    }
}

//! The readings of the Open Interface as numbers for a policy.

use robovac_core::robot::{Drive, RobotModel, SensorReadings};

/// Number of values.
pub const READINGS: usize = READING_NAMES.len();

/// Names of the values. Switches are 0 or 1; signals, dirt, infrared characters and charge are shares of their range, 0 to 1; way
/// and turn since the last observation, and the wheel speeds commanded last, are shares of the largest, -1 to 1.
pub const READING_NAMES: [&str; 33] = [
    "bump_left",
    "bump_right",
    "wheel_drop_left",
    "wheel_drop_right",
    "cliff_left",
    "cliff_front_left",
    "cliff_front_right",
    "cliff_right",
    "cliff_left_signal",
    "cliff_front_left_signal",
    "cliff_front_right_signal",
    "cliff_right_signal",
    "wall_signal",
    "light_left_signal",
    "light_front_left_signal",
    "light_centre_left_signal",
    "light_centre_right_signal",
    "light_front_right_signal",
    "light_right_signal",
    "virtual_wall",
    "dirt",
    "infrared_omni",
    "infrared_left",
    "infrared_right",
    "stasis",
    "overcurrent_left",
    "overcurrent_right",
    "charge",
    "on_dock",
    "way",
    "turn",
    "left_command",
    "right_command",
];

/// Turns readings into values, and keeps the wheel counts of the last observation.
#[derive(Debug, Clone, Default)]
pub struct ReadingsEncoder {
    counts: Option<[u16; 2]>,
}

impl ReadingsEncoder {
    /// Writes [`READINGS`] values into `out`; `step_s` is the time between observations, s.
    pub fn write(
        &mut self,
        robot: &RobotModel,
        sensed: &SensorReadings,
        commanded: Drive,
        step_s: f64,
        out: &mut [f32],
    ) {
        let counts = [sensed.left_counts, sensed.right_counts];
        let last = self.counts.replace(counts).unwrap_or(counts);
        let [left, right] = [0, 1].map(|i| f64::from(counts[i].wrapping_sub(last[i]) as i16) / robot.counts_per_metre);
        let farthest = robot.max_wheel_speed * step_s;
        let flag = |on: bool| f64::from(u8::from(on));
        let cliff = sensed.cliff.map(flag);
        let cliff_signal = sensed.cliff_signal.map(|signal| f64::from(signal) / 4095.0);
        let light = sensed.light_signal.map(|signal| f64::from(signal) / 4095.0);
        let infrared = [sensed.infrared.omni, sensed.infrared.left, sensed.infrared.right];
        let values = [
            flag(sensed.bump_left),
            flag(sensed.bump_right),
            flag(sensed.wheel_drop_left),
            flag(sensed.wheel_drop_right),
        ]
        .into_iter()
        .chain(cliff)
        .chain(cliff_signal)
        .chain([f64::from(sensed.wall_signal) / 1023.0])
        .chain(light)
        .chain([flag(sensed.virtual_wall), f64::from(sensed.dirt) / 255.0])
        .chain(infrared.map(|character| f64::from(character) / 255.0))
        .chain([
            flag(sensed.stasis),
            flag(sensed.overcurrent.left_wheel),
            flag(sensed.overcurrent.right_wheel),
            sensed.battery.share(),
            flag(sensed.battery.on_dock),
            0.5 * (left + right) / farthest,
            0.5 * (right - left) / farthest,
            commanded.left / robot.max_wheel_speed,
            commanded.right / robot.max_wheel_speed,
        ]);
        for (value, out) in values.zip(out) {
            *out = value.clamp(-1.0, 1.0) as f32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    #[test]
    fn each_value_has_its_name() {
        let robot = model("roomba600").unwrap();
        let mut readings = ReadingsEncoder::default();
        let mut out = [f32::NAN; READINGS];
        let mut sensed = SensorReadings::default();
        readings.write(robot, &sensed, Drive::STOP, 0.1, &mut out);
        let at = |out: &[f32], name: &str| out[READING_NAMES.iter().position(|n| *n == name).unwrap()];
        assert!(out.iter().all(|value| value.is_finite()));
        assert_eq!((at(&out, "charge"), at(&out, "way")), (1.0, 0.0));
        sensed.bump_right = true;
        sensed.light_signal[5] = 4095;
        sensed.right_counts = 65_535;
        sensed.battery.on_dock = true;
        readings.write(robot, &sensed, Drive::wheels(0.5, -0.25), 0.1, &mut out);
        let names = ["bump_right", "light_right_signal", "on_dock", "left_command", "right_command", "bump_left"];
        assert_eq!(names.map(|name| at(&out, name)), [1.0, 1.0, 1.0, 1.0, -0.5, 0.0]);
        // One count back, although the counter wrapped.
        assert!((-0.05..0.0).contains(&at(&out, "way")) && at(&out, "turn") < 0.0);
    }
}

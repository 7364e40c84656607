//! Sensor readings as a row of numbers, passed to the page every frame.

use robovac_core::robot::SensorReadings;

/// What the numbers of [`readings`] are, in their order; `cliff` stands for the left one of four, and so on.
pub const READINGS: &[&str] = &[
    "bump_left",
    "bump_right",
    "drop_left",
    "drop_right",
    "cliff_0",
    "cliff_1",
    "cliff_2",
    "cliff_3",
    "cliff_signal_0",
    "cliff_signal_1",
    "cliff_signal_2",
    "cliff_signal_3",
    "wall",
    "wall_signal",
    "virtual_wall",
    "light_0",
    "light_1",
    "light_2",
    "light_3",
    "light_4",
    "light_5",
    "light_signal_0",
    "light_signal_1",
    "light_signal_2",
    "light_signal_3",
    "light_signal_4",
    "light_signal_5",
    "dirt",
    "infrared_omni",
    "infrared_left",
    "infrared_right",
    "left_counts",
    "right_counts",
    "lateral_counts",
    "stasis",
    "over_left_wheel",
    "over_right_wheel",
    "over_main_brush",
    "over_side_brush",
    "battery_share",
    "charge_mah",
    "capacity_mah",
    "voltage_mv",
    "current_ma",
    "on_dock",
];

/// The reading in the order of [`READINGS`], in the units of [`SensorReadings`]; 1 and 0 for yes and no. The laser's scan isn't
/// part of it.
pub fn readings(sensed: &SensorReadings) -> [f64; READINGS.len()] {
    let is = |yes: bool| f64::from(u8::from(yes));
    let SensorReadings {
        cliff, cliff_signal: floor, light_bumper: near, light_signal: light, infrared, battery, ..
    } = sensed;
    let over = sensed.overcurrent;
    [
        is(sensed.bump_left),
        is(sensed.bump_right),
        is(sensed.wheel_drop_left),
        is(sensed.wheel_drop_right),
        is(cliff[0]),
        is(cliff[1]),
        is(cliff[2]),
        is(cliff[3]),
        floor[0].into(),
        floor[1].into(),
        floor[2].into(),
        floor[3].into(),
        is(sensed.wall),
        sensed.wall_signal.into(),
        is(sensed.virtual_wall),
        is(near[0]),
        is(near[1]),
        is(near[2]),
        is(near[3]),
        is(near[4]),
        is(near[5]),
        light[0].into(),
        light[1].into(),
        light[2].into(),
        light[3].into(),
        light[4].into(),
        light[5].into(),
        sensed.dirt.into(),
        infrared.omni.into(),
        infrared.left.into(),
        infrared.right.into(),
        sensed.left_counts.into(),
        sensed.right_counts.into(),
        sensed.lateral_counts.into(),
        is(sensed.stasis),
        is(over.left_wheel),
        is(over.right_wheel),
        is(over.main_brush),
        is(over.side_brush),
        battery.share(),
        battery.charge_mah.into(),
        battery.capacity_mah.into(),
        battery.voltage_mv.into(),
        battery.current_ma.into(),
        is(battery.on_dock),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::{BatteryReading, Infrared, Overcurrent};

    /// Every field has a value of its own, so that one that landed in another's place shows.
    #[test]
    fn every_number_is_in_the_place_of_its_name() {
        let sensed = SensorReadings {
            bump_right: true,
            wheel_drop_left: true,
            cliff: [false, true, false, false],
            cliff_signal: [11, 12, 13, 14],
            wall_signal: 20,
            virtual_wall: true,
            light_bumper: [false, false, false, true, false, false],
            light_signal: [31, 32, 33, 34, 35, 36],
            dirt: 40,
            infrared: Infrared { omni: 161, left: 164, right: 168 },
            left_counts: 50,
            right_counts: 51,
            lateral_counts: 52,
            overcurrent: Overcurrent { main_brush: true, ..Overcurrent::default() },
            battery: BatteryReading {
                charge_mah: 60,
                capacity_mah: 120,
                voltage_mv: 14_400,
                current_ma: -61,
                on_dock: true,
                ..BatteryReading::default()
            },
            ..SensorReadings::default()
        };
        let row = readings(&sensed);
        let of = |name: &str| row[READINGS.iter().position(|n| *n == name).unwrap()];
        let expected = [
            ("bump_left", 0.0),
            ("bump_right", 1.0),
            ("drop_left", 1.0),
            ("drop_right", 0.0),
            ("cliff_1", 1.0),
            ("cliff_signal_2", 13.0),
            ("wall", 0.0),
            ("wall_signal", 20.0),
            ("virtual_wall", 1.0),
            ("light_3", 1.0),
            ("light_signal_5", 36.0),
            ("dirt", 40.0),
            ("infrared_omni", 161.0),
            ("infrared_left", 164.0),
            ("infrared_right", 168.0),
            ("left_counts", 50.0),
            ("right_counts", 51.0),
            ("lateral_counts", 52.0),
            ("over_main_brush", 1.0),
            ("over_side_brush", 0.0),
            ("battery_share", 0.5),
            ("charge_mah", 60.0),
            ("capacity_mah", 120.0),
            ("voltage_mv", 14_400.0),
            ("current_ma", -61.0),
            ("on_dock", 1.0),
        ];
        for (name, value) in expected {
            assert_eq!(of(name), value, "{name}");
        }
    }
}

//! Conversion between a Roomba's [`Readings`] and the [`SensorReadings`] of controllers.

use robovac_core::robot::{BatteryReading, Drive, Infrared, Overcurrent, SensorReadings};
use roomba_oi::{BumpsAndDrops, ChargingSources, Command, InfraredSeen, LightBumper, Overcurrents, Readings, Stasis};

/// The packets of a robot with these readings. Values that only the interface has - mode, songs, requests, buttons,
/// motor currents, distance and angle - stay at their defaults, and so does the charger apart from the dock.
pub fn to_readings(sensed: &SensorReadings) -> Readings {
    let [left, front_left, centre_left, centre_right, front_right, right] = sensed.light_bumper;
    Readings {
        bumps: BumpsAndDrops {
            bump_right: sensed.bump_right,
            bump_left: sensed.bump_left,
            drop_right: sensed.wheel_drop_right,
            drop_left: sensed.wheel_drop_left,
        },
        wall: sensed.wall,
        cliff: sensed.cliff,
        virtual_wall: sensed.virtual_wall,
        overcurrents: Overcurrents {
            side_brush: sensed.overcurrent.side_brush,
            main_brush: sensed.overcurrent.main_brush,
            right_wheel: sensed.overcurrent.right_wheel,
            left_wheel: sensed.overcurrent.left_wheel,
        },
        dirt: sensed.dirt,
        infrared: InfraredSeen { omni: sensed.infrared.omni, left: sensed.infrared.left, right: sensed.infrared.right },
        voltage_mv: sensed.battery.voltage_mv,
        current_ma: sensed.battery.current_ma,
        temperature_c: sensed.battery.temperature_c,
        charge_mah: sensed.battery.charge_mah,
        capacity_mah: sensed.battery.capacity_mah,
        wall_signal: sensed.wall_signal,
        cliff_signal: sensed.cliff_signal,
        chargers: ChargingSources { internal_charger: false, home_base: sensed.battery.on_dock },
        left_counts: sensed.left_counts,
        right_counts: sensed.right_counts,
        light_bumper: LightBumper { left, front_left, centre_left, centre_right, front_right, right },
        light_signal: sensed.light_signal,
        stasis: Stasis { toggling: sensed.stasis, disabled: false },
        ..Readings::default()
    }
}

/// The readings that a controller gets.
pub fn to_sensors(readings: &Readings) -> SensorReadings {
    let light = readings.light_bumper;
    SensorReadings {
        bump_left: readings.bumps.bump_left,
        bump_right: readings.bumps.bump_right,
        wheel_drop_left: readings.bumps.drop_left,
        wheel_drop_right: readings.bumps.drop_right,
        cliff: readings.cliff,
        cliff_signal: readings.cliff_signal,
        wall: readings.wall,
        wall_signal: readings.wall_signal,
        virtual_wall: readings.virtual_wall,
        light_bumper: [
            light.left,
            light.front_left,
            light.centre_left,
            light.centre_right,
            light.front_right,
            light.right,
        ],
        light_signal: readings.light_signal,
        dirt: readings.dirt,
        infrared: Infrared {
            omni: readings.infrared.omni,
            left: readings.infrared.left,
            right: readings.infrared.right,
        },
        left_counts: readings.left_counts,
        right_counts: readings.right_counts,
        stasis: readings.stasis.toggling,
        overcurrent: Overcurrent {
            left_wheel: readings.overcurrents.left_wheel,
            right_wheel: readings.overcurrents.right_wheel,
            main_brush: readings.overcurrents.main_brush,
            side_brush: readings.overcurrents.side_brush,
        },
        battery: BatteryReading {
            charge_mah: readings.charge_left_mah(),
            capacity_mah: readings.capacity_mah,
            voltage_mv: readings.voltage_mv,
            current_ma: readings.current_ma,
            temperature_c: readings.temperature_c,
            on_dock: readings.chargers.home_base,
        },
        // The interface has neither a sideways encoder nor a laser; the driver adds distance and angle.
        ..SensorReadings::default()
    }
}

/// The Drive Direct nearest to a controller's command; each wheel is limited to 0.5 m/s, as in the interface.
pub fn drive_command(wanted: Drive) -> Command<'static> {
    Command::wheels(wanted.left, wanted.right)
}

#[cfg(test)]
mod tests {
    use robovac_core::robot::model;
    use roomba_oi::motion::{MAX_SPEED_MM_S, MM_PER_COUNT, ROBOT_RADIUS_MM, WHEEL_BASE_MM};

    #[test]
    fn the_robot_model_has_the_same_figures() {
        let roomba = model("roomba600").unwrap();
        assert!((roomba.counts_per_metre * MM_PER_COUNT - 1000.0).abs() < 1e-9);
        assert_eq!((roomba.wheel_base * 1000.0, roomba.radius * 1000.0), (WHEEL_BASE_MM, ROBOT_RADIUS_MM));
        assert_eq!(roomba.max_wheel_speed * 1000.0, f64::from(MAX_SPEED_MM_S));
    }
}

//! Sensor packets: values, groups, and what controllers see.

use proptest::prelude::*;
use robovac_core::robot::{BatteryReading, Infrared, Overcurrent, SensorReadings};
use robovac_link::sensors::{to_readings, to_sensors};
use roomba_oi::{ChargingState, GROUPS, Packet, PacketId, Readings};

fn id(byte: u8) -> PacketId {
    PacketId::from_byte(byte).unwrap()
}

#[test]
fn snapshot_of_a_standing_robot() {
    // Groups 2, 3 and 106 with values measured on a Roomba 690.
    let mut readings = Readings::default();
    readings.read(id(2), &[161, 1, 0, 10, 255, 166]).unwrap();
    readings.read(id(3), &[2, 61, 184, 255, 36, 24, 10, 60, 10, 136]).unwrap();
    readings.read(id(106), &[0, 20, 0, 16, 0, 32, 0, 31, 0, 21, 0, 3]).unwrap();
    assert_eq!((readings.infrared.omni, readings.buttons.clean), (161, true));
    assert_eq!((readings.distance_mm, readings.angle_deg), (10, -90));
    assert_eq!(readings.charging, ChargingState::Full);
    assert_eq!((readings.voltage_mv, readings.current_ma, readings.temperature_c), (15_800, -220, 24));
    assert_eq!((readings.charge_mah, readings.capacity_mah), (2620, 2696));
    assert_eq!(readings.light_signal, [20, 16, 32, 31, 21, 3]);
}

#[test]
fn bump_bits_are_not_swapped() {
    let mut readings = Readings::default();
    readings.set_raw(Packet::BumpsAndDrops, 9);
    let sensed = to_sensors(&readings);
    assert!(sensed.bump_right && !sensed.bump_left && sensed.wheel_drop_left && !sensed.wheel_drop_right);
}

#[test]
fn flat_battery_is_empty_and_not_at_2430_percent() {
    for (raw, left) in [(65_521, 0), (65_529, 0), (0, 0), (2620, 2620)] {
        let readings = Readings { charge_mah: raw, capacity_mah: 2696, ..Readings::default() };
        assert_eq!(to_sensors(&readings).battery.charge_mah, left);
    }
}

#[test]
fn too_few_bytes_leave_everything_as_it_was() {
    let mut readings = Readings { voltage_mv: 15_000, ..Readings::default() };
    let before = readings.clone();
    for (byte, ..) in GROUPS {
        let short = vec![0xA5; id(byte).size() - 1];
        assert_eq!(readings.read(id(byte), &short), None);
        assert_eq!(readings.write(id(byte), &mut vec![0; short.len()]), None);
    }
    assert_eq!(readings, before);
}

#[test]
fn groups_hold_their_packets_in_ascending_order() {
    let mut readings = Readings::default();
    for packet in Packet::ALL {
        // Distinguishable where there is room.
        readings.set_raw(packet, 0x0100 * packet as u16 + packet as u16);
    }
    for (byte, first, last) in GROUPS {
        let mut group = [0; 80];
        let size = readings.write(id(byte), &mut group).unwrap();
        let mut singles = Vec::new();
        for packet in Packet::ALL.into_iter().filter(|&packet| packet >= first && packet <= last) {
            let mut single = [0; 2];
            let size = readings.write(packet.into(), &mut single).unwrap();
            singles.extend_from_slice(&single[..size]);
        }
        assert_eq!(group[..size], singles);
        let mut again = Readings::default();
        let read = again.read(id(byte), &group).unwrap();
        assert!(read.iter().eq(id(byte).packets()) && read.iter().all(|p| again.raw(p) == readings.raw(p)));
    }
}

fn sensors() -> impl Strategy<Value = SensorReadings> {
    let flags = any::<[bool; 16]>();
    let signals = (any::<[u16; 4]>(), any::<[u16; 6]>(), any::<[u16; 3]>());
    let battery = (any::<[u16; 2]>(), 0_u16..32_768, any::<i16>(), any::<i8>());
    (flags, any::<[bool; 6]>(), signals, any::<[u8; 4]>(), battery).prop_map(
        |(f, light_bumper, signals, bytes, battery)| SensorReadings {
            bump_left: f[0],
            bump_right: f[1],
            wheel_drop_left: f[2],
            wheel_drop_right: f[3],
            cliff: [f[4], f[5], f[6], f[7]],
            cliff_signal: signals.0,
            wall: f[8],
            wall_signal: signals.2[0],
            virtual_wall: f[9],
            light_bumper,
            light_signal: signals.1,
            dirt: bytes[0],
            infrared: Infrared { omni: bytes[1], left: bytes[2], right: bytes[3] },
            left_counts: signals.2[1],
            right_counts: signals.2[2],
            stasis: f[10],
            overcurrent: Overcurrent { left_wheel: f[11], right_wheel: f[12], main_brush: f[13], side_brush: f[14] },
            battery: BatteryReading {
                charge_mah: battery.1,
                capacity_mah: battery.0[0],
                voltage_mv: battery.0[1],
                current_ma: battery.2,
                temperature_c: battery.3,
                on_dock: f[15],
            },
            ..SensorReadings::default()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn controllers_see_the_same_on_either_end_of_the_line(sensed in sensors()) {
        let mut line = [0; 80];
        to_readings(&sensed).write(id(100), &mut line).unwrap();
        let mut readings = Readings::default();
        readings.read(id(100), &line).unwrap();
        prop_assert_eq!(to_sensors(&readings), sensed);
    }

    #[test]
    fn bits_come_back_as_they_were(at in 0..Packet::ALL.len(), raw in any::<u16>()) {
        let packet = Packet::ALL[at];
        let raw = if packet.format().size() == 1 { raw & 0xFF } else { raw };
        let mut readings = Readings::default();
        readings.set_raw(packet, raw);
        let kept = readings.raw(packet);
        let reserved = match packet {
            Packet::Unused1 | Packet::Unused2 | Packet::Unused3 => 0xFFFF,
            Packet::Overcurrents => 0b10,
            _ => 0,
        };
        if packet.is_plausible(raw) {
            prop_assert_eq!(kept, raw & !reserved, "{}", packet);
        }
        // Whatever was dropped, is dropped once.
        let mut line = [0; 2];
        let size = packet.write(kept, &mut line).unwrap();
        let mut again = Readings::default();
        again.read(packet.into(), &line[..size]).unwrap();
        prop_assert_eq!(again, readings);
    }
}

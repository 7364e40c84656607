//! The robot's output: answers, sensor stream and log.
//!
//! Readings are refreshed every 15 ms, and answers are sent at the next refresh, in the order of the queries; then
//! comes the stream's frame. All of it goes through one buffer, at the line's rate.
//!
//! Packets that don't exist are left out of answers and of streams (not described). A stream without packets sends
//! nothing, which is how one driver ends it. A frame of more than 255 bytes is sent with the low byte of its length,
//! and so is invalid (undocumented as well).

use super::machine::Machine;
use robovac_core::robot::RobotPort;
use roomba_oi::{ChargingLog, HEADER, Packet, PacketId, Readings};

/// Packet 25 of an empty battery, -7 mAh, as logged by owners.
const EMPTY_MAH: u16 = 65_529;
/// Currents, mA: of a wheel's motor at rest on the move, and more for each m/s; of a stalled one; of brushes. Robots'
/// values aren't known: these are ours, and match the model's power consumption.
const WHEEL_MA: (f64, f64) = (60.0, 250.0);
const STALLED_MA: f64 = 1200.0;
const MAIN_BRUSH_MA: f64 = 550.0;
const SIDE_BRUSH_MA: f64 = 130.0;

/// The stream (opcodes 148 and 150).
#[derive(Debug, Clone, Default)]
pub(super) struct Stream {
    pub packets: Vec<PacketId>,
    pub is_paused: bool,
}

impl Stream {
    /// Whether frames are sent.
    pub fn is_on(&self) -> bool {
        !self.is_paused && !self.packets.is_empty()
    }
}

impl Machine {
    /// The packet or group with that number, if this robot supports it.
    pub fn packet(&self, id: u8) -> Option<PacketId> {
        PacketId::from_byte(id).filter(|id| id.packets().all(|packet| packet as u8 <= self.who.last_packet))
    }

    /// Sends pending answers and the stream's frame.
    pub fn report(&mut self) {
        let has_stream = self.stream.is_on();
        if self.asked.is_empty() && !has_stream {
            return;
        }
        let mut readings = self.readings();
        let mut bytes = Vec::new();
        for id in core::mem::take(&mut self.asked) {
            if let Some(id) = self.packet(id) {
                self.write(&mut readings, id, &mut bytes);
            }
        }
        if has_stream {
            let begin = bytes.len();
            bytes.extend([HEADER, 0]);
            let packets = core::mem::take(&mut self.stream.packets);
            for &id in &packets {
                bytes.push(id.byte());
                self.write(&mut readings, id, &mut bytes);
            }
            self.stream.packets = packets;
            let length = bytes.len() - begin - 2;
            if let Some(at) = bytes.get_mut(begin + 1) {
                *at = length as u8;
            }
            let sum = bytes.iter().skip(begin).fold(0_u8, |sum, &byte| sum.wrapping_add(byte));
            bytes.push(sum.wrapping_neg());
        }
        self.line.send(self.now, &bytes);
    }

    /// Appends a packet or group. Distance and angle are reset when written.
    fn write(&mut self, readings: &mut Readings, id: PacketId, bytes: &mut Vec<u8>) {
        let begin = bytes.len();
        bytes.resize(begin + id.size(), 0);
        if let Some(out) = bytes.get_mut(begin..) {
            readings.write(id, out);
        }
        for packet in id.packets() {
            match packet {
                Packet::Distance => {
                    self.travel.forget_distance();
                    readings.distance_mm = 0;
                }
                Packet::Angle => {
                    self.travel.forget_angle();
                    readings.angle_deg = 0;
                }
                _ => {}
            }
        }
    }

    /// All current packet values.
    pub fn readings(&self) -> Readings {
        let sensed = self.robot.sensors();
        let speed = self.robot.speed();
        let wheel = |speed: f64, is_stalled: bool| match (is_stalled, speed == 0.0) {
            (true, _) => STALLED_MA as i16,
            (false, true) => 0,
            (false, false) => (WHEEL_MA.0 + WHEEL_MA.1 * speed.abs()).copysign(speed) as i16,
        };
        let brushes = self.running();
        let [left_offset, right_offset] = self.counts_offset;
        let mut readings = crate::sensors::to_readings(sensed);
        readings.buttons = self.buttons();
        readings.distance_mm = self.travel.distance();
        readings.angle_deg = self.travel.angle(self.who.angle_factor);
        readings.charging = self.charger.state;
        readings.chargers.internal_charger = self.charger.is_plugged;
        readings.mode = self.mode.report(self.who.mode_offset);
        readings.song_number = self.sound.number;
        readings.song_playing = self.sound.is_playing(self.now);
        readings.stream_packets = self.stream.packets.len() as u8;
        [readings.requested_velocity, readings.requested_radius] = self.told.drive;
        [readings.requested_right, readings.requested_left] = self.told.direct;
        readings.left_counts = sensed.left_counts.wrapping_add(left_offset);
        readings.right_counts = sensed.right_counts.wrapping_add(right_offset);
        readings.left_motor_ma = wheel(speed.left, sensed.overcurrent.left_wheel);
        readings.right_motor_ma = wheel(speed.right, sensed.overcurrent.right_wheel);
        readings.main_brush_ma = (MAIN_BRUSH_MA * brushes.main) as i16;
        readings.side_brush_ma = (SIDE_BRUSH_MA * brushes.side) as i16;
        if self.who.swaps_encoders {
            core::mem::swap(&mut readings.left_counts, &mut readings.right_counts);
        }
        let battery = sensed.battery;
        if battery.capacity_mah > 0 && battery.charge_mah == 0 && battery.current_ma <= 0 {
            readings.charge_mah = EMPTY_MAH;
        }
        readings
    }

    /// A line of the charging log. The meaning of its state and mode isn't known: they are those of a recorded line.
    pub fn log_line(&self, since: super::clock::Nanos) -> String {
        let battery = self.robot.sensors().battery;
        let seconds = (since / super::clock::SECOND) as i32;
        let log = ChargingLog {
            minutes: seconds / 60,
            seconds: seconds % 60,
            voltage_mv: battery.voltage_mv.into(),
            current_ma: battery.current_ma.into(),
            temperature_tenths_c: 10 * i32::from(battery.temperature_c),
            charge_mah: battery.charge_mah.into(),
            state: 6,
            mode: 8,
        };
        format!("{log}\r\n")
    }
}

//! Sensor readings decoded for a dashboard, of simulated and connected robots.

use crate::sensors::to_sensors;
use robovac_core::robot::{BatteryReading, SensorReadings};
use roomba_oi::{DockBeams, InfraredCharacter, Readings};
use serde::Serialize;

/// Share of the charge below which a battery is low.
const LOW_CHARGE: f64 = 0.15;

/// Sensor readings that all robots have in common. Sensors that a robot doesn't have stay at their defaults.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[expect(clippy::struct_excessive_bools)]
pub struct SensorsView {
    /// Bumper pressed: left and right half.
    pub bumper: [bool; 2],
    /// Wheel dropped: left and right.
    pub wheel_drops: [bool; 2],
    /// Both wheels dropped: the robot is lifted.
    pub is_lifted: bool,
    /// No floor: left, front left, front right, right.
    pub cliffs: [bool; 4],
    /// Signals of the cliff sensors, 0 to 4095.
    pub cliff_signals: [u16; 4],
    /// The wall sensor on the right detects something.
    pub wall: bool,
    /// The beam of a virtual wall is detected.
    pub virtual_wall: bool,
    /// The castor turns.
    pub is_moving: bool,
    /// Motors that draw too much current.
    pub overloads: Vec<&'static str>,
    /// Detections of the light bumper, from left to right.
    pub light: [bool; 6],
    /// Strengths of its signals, 0 to 4095.
    pub light_signals: [u16; 6],
    /// Receivers on the left, on top and on the right.
    pub infrared: [BeamsView; 3],
    /// Battery and charger.
    pub battery: BatteryView,
    /// Encoders: left, right, sideways.
    pub counts: [u16; 3],
    /// Amount of dirt being picked up, 0 to 255.
    pub dirt: u8,
}

/// Beams detected by an infrared receiver.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct BeamsView {
    /// Beams: `green`, `field` and `red` of a dock, `wall` of a virtual wall.
    pub lit: Vec<&'static str>,
    /// The same in words.
    pub text: String,
}

/// Readings of the battery gauge.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct BatteryView {
    /// Remaining share of the capacity, 0 to 1.
    pub share: f64,
    /// Current, mA, negative while discharging.
    pub current_ma: i16,
    /// Whether the robot charges on its dock.
    pub on_dock: bool,
    /// Whether the gauge was read.
    pub is_known: bool,
    /// Whether it is low.
    pub is_low: bool,
}

/// Readings of a Roomba's Open Interface.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct RoombaView {
    /// The readings that all robots have in common.
    pub sensors: SensorsView,
    /// Strength of the wall sensor's signal, 0 to 1023.
    pub wall_signal: u16,
    /// Voltage of the battery, V.
    pub voltage_v: f64,
    /// Its charge, mAh.
    pub charge_mah: u16,
    /// Its capacity, mAh.
    pub capacity_mah: u16,
    /// Its temperature, degrees Celsius.
    pub temperature_c: i8,
    /// Charging state and source of power, in words.
    pub charging: String,
    /// Motor currents, mA: left wheel, right wheel, main brush, side brush.
    pub motors_ma: [i16; 4],
    /// Requested speeds, mm/s: left wheel, right wheel.
    pub requested_mm_s: [i16; 2],
    /// Names of the buttons that are pressed.
    pub buttons: Vec<&'static str>,
    /// Number of the last selected song, from 1.
    pub song: u16,
    /// Whether it plays.
    pub song_plays: bool,
}

impl SensorsView {
    /// The decoded reading.
    pub fn new(sensed: &SensorReadings) -> Self {
        let over = sensed.overcurrent;
        let motors = [
            (over.left_wheel, "left wheel"),
            (over.right_wheel, "right wheel"),
            (over.main_brush, "main brush"),
            (over.side_brush, "side brush"),
        ];
        Self {
            bumper: [sensed.bump_left, sensed.bump_right],
            wheel_drops: [sensed.wheel_drop_left, sensed.wheel_drop_right],
            is_lifted: sensed.wheel_drop_left && sensed.wheel_drop_right,
            cliffs: sensed.cliff,
            cliff_signals: sensed.cliff_signal,
            wall: sensed.wall,
            virtual_wall: sensed.virtual_wall,
            is_moving: sensed.stasis,
            overloads: named(motors),
            light: sensed.light_bumper,
            light_signals: sensed.light_signal,
            infrared: [sensed.infrared.left, sensed.infrared.omni, sensed.infrared.right].map(BeamsView::new),
            battery: BatteryView::new(&sensed.battery),
            counts: [sensed.left_counts, sensed.right_counts, sensed.lateral_counts],
            dirt: sensed.dirt,
        }
    }
}

impl BeamsView {
    fn new(character: u8) -> Self {
        let (lit, text) = match InfraredCharacter::of(character) {
            InfraredCharacter::None => (Vec::new(), "–".to_owned()),
            InfraredCharacter::VirtualWall => (vec!["wall"], "virtual wall".to_owned()),
            InfraredCharacter::Dock(beams) if beams != DockBeams::default() => {
                let lit = named([(beams.green, "green"), (beams.red, "red"), (beams.force_field, "field")]);
                let text = lit.join(" + ");
                (lit, text)
            }
            InfraredCharacter::Remote(_) => (Vec::new(), "remote".to_owned()),
            _ => (Vec::new(), character.to_string()),
        };
        Self { lit, text }
    }
}

impl BatteryView {
    fn new(battery: &BatteryReading) -> Self {
        let is_known = battery.capacity_mah > 0;
        let share = if is_known { battery.share().min(1.0) } else { 0.0 };
        let is_low = share < LOW_CHARGE;
        Self { share, current_ma: battery.current_ma, on_dock: battery.on_dock, is_known, is_low }
    }
}

impl RoombaView {
    /// The decoded packets.
    pub fn new(readings: &Readings) -> Self {
        let source = match (readings.chargers.internal_charger, readings.chargers.home_base) {
            (false, false) => "",
            (true, false) => ", charger plugged in",
            (false, true) => ", home base",
            (true, true) => ", both chargers",
        };
        let pressed = readings.buttons;
        Self {
            sensors: SensorsView::new(&to_sensors(readings)),
            wall_signal: readings.wall_signal,
            voltage_v: f64::from(readings.voltage_mv) / 1000.0,
            charge_mah: readings.charge_left_mah(),
            capacity_mah: readings.capacity_mah,
            temperature_c: readings.temperature_c,
            charging: format!("{}{source}", readings.charging),
            motors_ma: [
                readings.left_motor_ma,
                readings.right_motor_ma,
                readings.main_brush_ma,
                readings.side_brush_ma,
            ],
            requested_mm_s: [readings.requested_left, readings.requested_right],
            buttons: named([
                (pressed.clean, "Clean"),
                (pressed.spot, "Spot"),
                (pressed.dock, "Dock"),
                (pressed.minute, "Minute"),
                (pressed.hour, "Hour"),
                (pressed.day, "Day"),
                (pressed.schedule, "Schedule"),
                (pressed.clock, "Clock"),
            ]),
            song: u16::from(readings.song_number) + 1,
            song_plays: readings.song_playing,
        }
    }
}

/// Names of the flags that are set.
fn named<const N: usize>(all: [(bool, &'static str); N]) -> Vec<&'static str> {
    all.into_iter().filter(|&(is_on, _)| is_on).map(|(_, name)| name).collect()
}

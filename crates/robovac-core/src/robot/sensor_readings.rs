//! Sensor readings for a controller: exactly what the Open Interface reports, in the same units.

use super::DistanceAngle;
use std::sync::Arc;

/// One reading of all sensors, a controller's only input. Sensors that a robot doesn't have stay at their defaults.
///
/// Packet numbers are those of the Open Interface of the Roomba 600 and Create 2.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SensorReadings {
    /// The bumper is pressed on its left half (packet 7, bit 1).
    pub bump_left: bool,
    /// The bumper is pressed on its right half (packet 7, bit 0).
    pub bump_right: bool,
    /// The left wheel hangs down (packet 7, bit 3).
    pub wheel_drop_left: bool,
    /// The right wheel hangs down (packet 7, bit 2).
    pub wheel_drop_right: bool,
    /// No floor under the sensors at left, front left, front right and right (packets 9 to 12). A robot with three sensors
    /// reports its front one as both front left and front right.
    pub cliff: [bool; 4],
    /// Signals of the cliff sensors, 0 to 4095 (packets 28 to 31).
    pub cliff_signal: [u16; 4],
    /// The wall sensor on the right detects something (packet 8).
    pub wall: bool,
    /// Strength of its signal, 0 to 1023 (packet 27).
    pub wall_signal: u16,
    /// The beam of a virtual wall is detected (packet 13).
    pub virtual_wall: bool,
    /// Detections of the light bumper, from left to right (packet 45, bits 0 to 5).
    pub light_bumper: [bool; 6],
    /// Strengths of its signals, 0 to 4095: left, front left, centre left, centre right, front right, right (packets 46 to 51).
    pub light_signal: [u16; 6],
    /// Amount of dirt being picked up, 0 to 255 (packet 15).
    pub dirt: u8,
    /// Infrared characters received all around, on the left and on the right; 0 for none (packets 17, 52 and 53).
    pub infrared: Infrared,
    /// Left wheel encoder, wraps at 65536 (packet 43).
    pub left_counts: u16,
    /// Right wheel encoder, wraps at 65536 (packet 44).
    pub right_counts: u16,
    /// Encoder of the sideways motion, left positive, wraps at 65536; only robots that move in all directions have one.
    pub lateral_counts: u16,
    /// Distance and angle since the last report, if they were requested with this reading (packets 19 and 20).
    pub moved: Option<DistanceAngle>,
    /// The castor's wheel turns: the robot makes forward progress (packet 58, bit 0 toggles; here, whether it does).
    pub stasis: bool,
    /// Motors that draw too much current (packet 14).
    pub overcurrent: Overcurrent,
    /// Battery and charger.
    pub battery: BatteryReading,
    /// The latest scan, if the robot has a laser scanner: ranges in metres, counter-clockwise from the scan's first
    /// angle; infinite where nothing is in range.
    pub laser: Option<Arc<[f32]>>,
}

/// Infrared characters; 0 for none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Infrared {
    /// By the receiver on top that looks all around (packet 17).
    pub omni: u8,
    /// By the front receiver on the left (packet 52).
    pub left: u8,
    /// By the front receiver on the right (packet 53).
    pub right: u8,
}

/// Motors that draw too much current.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Overcurrent {
    /// Left wheel (bit 4).
    pub left_wheel: bool,
    /// Right wheel (bit 3).
    pub right_wheel: bool,
    /// Main brush (bit 2).
    pub main_brush: bool,
    /// Side brush (bit 0).
    pub side_brush: bool,
}

/// Values of the battery's electronics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BatteryReading {
    /// Charge, mAh (packet 25).
    pub charge_mah: u16,
    /// Capacity, mAh (packet 26); 0 for a robot without a battery gauge.
    pub capacity_mah: u16,
    /// Voltage, mV (packet 22).
    pub voltage_mv: u16,
    /// Current, mA, negative while it discharges (packet 23).
    pub current_ma: i16,
    /// Temperature, degrees Celsius (packet 24).
    pub temperature_c: i8,
    /// The robot stands on its dock and is charged from there (packet 34, bit 1).
    pub on_dock: bool,
}

impl SensorReadings {
    /// Whether the bumper is pressed anywhere.
    #[inline]
    pub fn bumped(&self) -> bool {
        self.bump_left || self.bump_right
    }

    /// Whether any cliff sensor sees no floor.
    #[inline]
    pub fn sees_cliff(&self) -> bool {
        self.cliff.contains(&true)
    }

    /// Whether a wheel hangs down: the robot was picked up, or is falling.
    #[inline]
    pub fn wheel_dropped(&self) -> bool {
        self.wheel_drop_left || self.wheel_drop_right
    }
}

impl BatteryReading {
    /// Share of the capacity that is left, 0 to 1; 1 for a robot without a gauge.
    pub fn share(&self) -> f64 {
        if self.capacity_mah == 0 { 1.0 } else { f64::from(self.charge_mah) / f64::from(self.capacity_mah) }
    }
}

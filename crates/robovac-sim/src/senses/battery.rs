//! Battery and charger.
//!
//! The battery is discharged by the model's [`PowerDraw`](robovac_core::robot::PowerDraw): standing power all the time,
//! wheel power in proportion to wheel speed, which gives the model's straight and turning power at the speeds of path
//! following. On the dock it is charged by the model's charging current until it is full.
//!
//! Voltage over charge is a Roomba's with 14.4 V: 13.9 V at 14 % and 16.0 V at 91 % (Open Interface facts, section 6),
//! straight between and beyond, and down to 12 V, 1 V a cell, when empty (ours); other batteries have the same curve
//! in proportion to their nominal voltage (ours). Stalled wheels draw another 10 W, brushes and wheels on carpet 5 W (ours).
//!
//! A [`Supply`] from outside - an interface that switches brushes and charger - replaces standing power and dock.
//!
//! Noise: at "typical" a standard deviation of 20 mV and 10 mA, so that a standing robot has the reported readings
//! (-111 to -151 mA); at "harsh" 100 mV and 50 mA, and a worn battery whose gauge is off by up to 15 %, the same all
//! the time.

use super::Carrier;
use crate::{Conditions, NoiseLevel, RandomStream, STEP_S, SensorKind, World};
use rand::RngExt;
use robovac_core::{
    math,
    robot::{BatteryReading, RobotModel, SensorReadings},
};

/// Points of the voltage curve: share of the charge, and voltage as a share of the nominal one.
const CURVE: [(f64, f64); 4] = [(0.0, 12.0 / 14.4), (0.14, 13.9 / 14.4), (0.91, 16.0 / 14.4), (1.0, 16.2454 / 14.4)];
/// Additional power of stalled wheels, W.
const STALLED_W: f64 = 10.0;
/// Additional power on carpet, W.
const CARPET_W: f64 = 5.0;
/// Temperature of the room, degrees Celsius, rise of the battery's temperature per watt, and its time constant, s.
const WARMTH: (f64, f64, f64) = (22.0, 0.4, 900.0);

/// Power and charging current set from outside the simulation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Supply {
    /// Electronics and cleaning motors, W.
    pub standing_w: f64,
    /// Current from a charger, mA. While there is any, none flows out of the battery.
    pub charge_ma: f64,
}

/// The battery of one robot.
#[derive(Debug, Clone)]
pub(super) struct BatteryCells {
    /// Capacity when new, J.
    capacity: f64,
    /// Charge, J.
    charge: f64,
    /// Power out of it in the last step, W; negative while charging.
    power: f64,
    temperature: f64,
    on_dock: bool,
    supply: Option<Supply>,
    /// Whether it is replaced when it is empty.
    has_spares: bool,
    /// Reading of the gauge, as a share of the charge.
    gauge: f64,
    /// Standard deviations of voltage and current, mV and mA.
    noise: (f64, f64),
    nominal: f64,
    capacity_mah: f64,
    has_gauge: bool,
}

impl BatteryCells {
    /// The battery of `model`, charged to `share`, 0 to 1.
    pub fn new(model: &RobotModel, conditions: Conditions, seed: u64) -> Self {
        let Conditions { noise, start_charge_percent, spare_batteries, .. } = conditions;
        let battery = model.battery;
        let capacity = 3.6 * battery.capacity_mah * battery.voltage;
        let level = noise.of(SensorKind::Battery);
        let is_worn = level == NoiseLevel::Harsh;
        Self {
            capacity,
            charge: capacity * (f64::from(start_charge_percent) / 100.0).min(1.0),
            power: 0.0,
            temperature: WARMTH.0,
            on_dock: false,
            supply: None,
            has_spares: spare_batteries,
            gauge: if is_worn { RandomStream::Sensors.seeded(!seed).random_range(0.85..1.15) } else { 1.0 },
            noise: [(0.0, 0.0), (20.0, 10.0), (100.0, 50.0)][level as usize],
            nominal: battery.voltage,
            capacity_mah: battery.capacity_mah,
            has_gauge: battery.has_gauge,
        }
    }

    /// Whether nothing is left.
    pub fn is_empty(&self) -> bool {
        self.charge <= 0.0
    }

    /// Sets power and charging current from outside.
    pub fn supply(&mut self, supply: Supply) {
        self.supply = Some(supply);
    }

    fn volts(&self) -> f64 {
        self.nominal * curve(self.charge / self.capacity)
    }

    /// One step of discharging or charging.
    pub fn step(&mut self, model: &RobotModel, world: &World, carrier: &Carrier, on_dock: bool, is_stalled: bool) {
        self.on_dock = on_dock;
        let wheels = 0.5 * (carrier.speed.left.abs() + carrier.speed.right.abs()) + carrier.speed.lateral.abs();
        let charger = self.supply.map_or(0.0, |supply| supply.charge_ma);
        self.power = if charger > 0.0 {
            -1e-3 * charger * self.volts()
        } else if on_dock && self.supply.is_none() {
            if self.charge < self.capacity { -1e-3 * model.battery.charge_ma * self.nominal } else { 0.0 }
        } else if self.is_empty() {
            0.0
        } else {
            let stalled = if is_stalled { STALLED_W } else { 0.0 };
            let carpet = if world.is_on_carpet(carrier.pose.position()) { CARPET_W } else { 0.0 };
            let standing = self.supply.map_or(model.power.standing, |supply| supply.standing_w);
            standing + model.power.straight * (wheels / model.cruise_speed) + stalled + carpet
        };
        self.charge = (self.charge - self.power * STEP_S).clamp(0.0, self.capacity);
        if self.has_spares && self.is_empty() {
            self.charge = self.capacity;
        }
        self.temperature += STEP_S / WARMTH.2 * (WARMTH.0 + WARMTH.1 * self.power.abs() - self.temperature);
    }

    /// Readings of its electronics; `deviate` is a normal deviate.
    pub fn report(&self, deviate: f64, sensors: &mut SensorReadings) {
        sensors.battery.on_dock = self.on_dock;
        if !self.has_gauge {
            return;
        }
        let share = self.charge / self.capacity;
        let volts = self.volts();
        let milliamps = -1000.0 * self.power / volts;
        sensors.battery = BatteryReading {
            charge_mah: math::floor((self.gauge * share * self.capacity_mah).min(self.capacity_mah) + 0.5) as u16,
            capacity_mah: self.capacity_mah as u16,
            voltage_mv: (1000.0 * volts + self.noise.0 * deviate).max(0.0) as u16,
            current_ma: (milliamps + self.noise.1 * deviate) as i16,
            temperature_c: self.temperature as i8,
            on_dock: self.on_dock,
        };
    }
}

/// Voltage as a share of the nominal one.
fn curve(share: f64) -> f64 {
    let [empty, low, high, full] = CURVE;
    let on = |from: (f64, f64), to: (f64, f64)| from.1 + (share - from.0) * ((to.1 - from.1) / (to.0 - from.0));
    if share <= low.0 {
        on(empty, low)
    } else if share <= high.0 {
        on(low, high)
    } else {
        on(high, full)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn voltages_are_those_measured() {
        for (share, volts) in [(0.14, 13.9), (0.91, 16.0), (0.0, 12.0)] {
            assert!((14.4 * curve(share) - volts).abs() < 1e-9, "{share}");
        }
        assert!(curve(1.0) > curve(0.95) && curve(0.95) > curve(0.91));
    }
}

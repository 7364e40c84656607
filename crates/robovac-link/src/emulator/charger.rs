//! Charging: states and currents (packets 21, 23 and 34), and the robot's consumption.
//!
//! A charger works in Off and Passive, also while the robot sleeps; in Safe and Full it doesn't (measured: state 2 becomes
//! 0). 1232 mA from the dock and 302 mA into a battery that was run down were measured (fact sheet, section 6); two seconds
//! of waiting, the trickle of 60 mA and that the jack gives as much as the dock are ours.
//!
//! Standing, a robot draws 2 W: -111 to -151 mA. Brushes and vacuum draw the 19 W that cleaning takes beyond driving (see
//! the Roomba's model), split by us; asleep it draws a fortieth of what it does awake (ours).

use super::clock::{Nanos, SECOND};
use robovac_core::robot::BatteryReading;
use robovac_sim::Supply;
use roomba_oi::ChargingState;

/// Time before charging starts.
const WAITS: Nanos = 2 * SECOND;
/// Charging current, mA.
const FULL: f64 = 1232.0;
const RECOVERY: f64 = 302.0;
const TRICKLE: f64 = 60.0;
/// Share of the charge below which a battery counts as deeply discharged.
const RUN_DOWN: f64 = 0.03;
/// Power consumption while awake, W.
const AWAKE: f64 = 2.0;
const ASLEEP: f64 = 0.05;
/// Full power of main brush, side brush and vacuum, W.
pub(super) const CLEANING: [f64; 3] = [8.0, 2.0, 9.0];

/// Sources of current.
#[derive(Debug, Clone, Default)]
pub(super) struct Charger {
    /// Whether a charger is plugged into the jack.
    pub is_plugged: bool,
    /// Whether the robot stands on its dock.
    pub on_dock: bool,
    /// Time of the present connection.
    since: Option<Nanos>,
    pub state: ChargingState,
}

impl Charger {
    /// Whether a powered charger is connected.
    pub fn is_connected(&self) -> bool {
        self.is_plugged || self.on_dock
    }

    /// Time since it was connected.
    pub fn connected_for(&self, now: Nanos) -> Option<Nanos> {
        self.since.map(|since| now - since)
    }

    /// Updates the state and returns the current until the next step. `motors` are main brush, side brush and vacuum,
    /// as shares of their power.
    pub fn step(
        &mut self,
        now: Nanos,
        battery: BatteryReading,
        may_charge: bool,
        is_awake: bool,
        motors: [f64; 3],
    ) -> Supply {
        self.on_dock = battery.on_dock;
        self.since = self.is_connected().then(|| self.since.unwrap_or(now));
        let share = battery.share();
        self.state = match self.since {
            Some(since) if may_charge => match self.state {
                _ if now < since + WAITS => ChargingState::Waiting,
                _ if share < RUN_DOWN => ChargingState::Reconditioning,
                // A full battery isn't charged again for a small loss.
                ChargingState::Trickle if share > 0.99 => ChargingState::Trickle,
                _ if share < 1.0 => ChargingState::Full,
                _ => ChargingState::Trickle,
            },
            _ => ChargingState::None,
        };
        let charge_ma = match self.state {
            ChargingState::Full => FULL,
            ChargingState::Reconditioning => RECOVERY,
            ChargingState::Trickle => TRICKLE,
            _ => 0.0,
        };
        let cleaning: f64 = motors.iter().zip(CLEANING).map(|(share, watts)| share * watts).sum();
        Supply { standing_w: if is_awake { AWAKE } else { ASLEEP } + cleaning, charge_ma }
    }
}

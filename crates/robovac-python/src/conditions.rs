//! Errors of wheels and sensors, and the battery.

use crate::failure::Failure;
use pyo3::prelude::*;
use robovac_core::robot::OdometryModel;
use robovac_sim::{Conditions, Noise, NoiseLevel, SensorKind, SlipLevel};

/// Conditions as arguments; `noise` has a level for one kind of sensor, or for all.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct ConditionsArguments {
    slip: String,
    noise: Vec<(Option<String>, String)>,
    quantised: bool,
    charge_percent: f64,
    odometry: String,
}

impl ConditionsArguments {
    /// Checks all of them.
    pub fn conditions(&self) -> Result<Conditions, Failure> {
        let mut noise = Noise::default();
        for (kind, level) in &self.noise {
            let level = noise_level(level)?;
            match kind {
                None => noise = Noise::all(level),
                Some(kind) => {
                    let known = SensorKind::ALL.map(|(_, name)| name);
                    let found = SensorKind::parse(kind).ok_or_else(|| none("kind of sensor", kind, &known))?;
                    noise.set(found, level);
                }
            }
        }
        Ok(Conditions {
            slip: slip_level(&self.slip)?,
            noise,
            quantised: self.quantised,
            start_charge_percent: charge(self.charge_percent)?,
            spare_batteries: false,
        })
    }

    /// How odometry computes the pose.
    pub fn odometry(&self) -> Result<OdometryModel, Failure> {
        let known = OdometryModel::ALL.map(|(_, name)| name);
        OdometryModel::parse(&self.odometry).ok_or_else(|| none("odometry model", &self.odometry, &known))
    }
}

/// The level of that name.
pub fn slip_level(name: &str) -> Result<SlipLevel, Failure> {
    SlipLevel::parse(name).ok_or_else(|| none("level of slip", name, &SlipLevel::ALL.map(|(_, name)| name)))
}

/// The level of that name.
pub fn noise_level(name: &str) -> Result<NoiseLevel, Failure> {
    NoiseLevel::parse(name).ok_or_else(|| none("level of noise", name, &NoiseLevel::ALL.map(|(_, name)| name)))
}

/// A whole percentage from 1 to 100.
pub fn charge(percent: f64) -> Result<u8, Failure> {
    let is_whole = (1.0..=100.0).contains(&percent) && percent.fract() == 0.0;
    is_whole
        .then_some(percent as u8)
        .ok_or_else(|| Failure::usage(format!("charge_percent can't be {percent}; use a whole number from 1 to 100")))
}

fn none(kind: &str, name: &str, known: &[&str]) -> Failure {
    Failure::usage(format!("there is no {kind} \"{name}\"; there are: {}", known.join(", ")))
}

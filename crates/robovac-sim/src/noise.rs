//! Sensor noise.
//!
//! What each level means for a kind of sensor is said in that sensor's file.

use rand::Rng as _;
use robovac_core::{
    math,
    rng::{Rng, seeded},
};
use serde::{Deserialize, Serialize};

/// Stream of the sensors' random numbers.
const STREAM: u64 = 4;
/// Steps in which the normal distribution is summed up, per unit.
const FINE: i32 = 128;
/// Where that begins and ends.
const WIDE: i32 = 4;
use std::{fmt, sync::Arc};

/// How much a sensor errs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum NoiseLevel {
    /// Not at all.
    #[default]
    Off,
    /// As good sensors in a clean room do.
    Typical,
    /// Worn, dirty or dazzled.
    Harsh,
}

/// Sensors whose noise can be chosen one by one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SensorKind {
    /// Bumper switches.
    Bumper,
    /// Cliff sensors.
    Cliff,
    /// Light bumper and wall sensor.
    Light,
    /// Infrared receivers for docks and virtual walls.
    Infrared,
    /// Dirt sensor.
    Dirt,
    /// Laser scanner.
    Laser,
    /// Battery gauge.
    Battery,
}

/// Noise of every kind of sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Noise([NoiseLevel; SensorKind::ALL.len()]);

impl NoiseLevel {
    /// All levels, with their names in links and on the command line.
    pub const ALL: [(Self, &'static str); 3] = [(Self::Off, "off"), (Self::Typical, "typical"), (Self::Harsh, "harsh")];

    /// The level of that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(level, _)| level)
    }

    /// Name in links and on the command line.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

impl SensorKind {
    /// All kinds, with their names in links and on the command line.
    pub const ALL: [(Self, &'static str); 7] = [
        (Self::Bumper, "bumper"),
        (Self::Cliff, "cliff"),
        (Self::Light, "light"),
        (Self::Infrared, "infrared"),
        (Self::Dirt, "dirt"),
        (Self::Laser, "laser"),
        (Self::Battery, "battery"),
    ];

    /// The kind of that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(kind, _)| kind)
    }
}

/// The level that all have, or those that aren't off, kind by kind: `typical`, `cliff=harsh light=typical`.
impl fmt::Display for Noise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.iter().all(|level| *level == self.0[0]) {
            return f.write_str(self.0[0].id());
        }
        let noisy = SensorKind::ALL.iter().filter(|(kind, _)| self.of(*kind) != NoiseLevel::Off);
        for (index, (kind, name)) in noisy.enumerate() {
            write!(f, "{}{name}={}", if index > 0 { " " } else { "" }, self.of(*kind).id())?;
        }
        Ok(())
    }
}

impl Noise {
    /// The same level for all sensors.
    pub const fn all(level: NoiseLevel) -> Self {
        Self([level; SensorKind::ALL.len()])
    }

    /// The level of one kind of sensor.
    #[inline]
    pub fn of(&self, kind: SensorKind) -> NoiseLevel {
        self.0[kind as usize]
    }

    /// Sets the level of one kind of sensor.
    pub fn set(&mut self, kind: SensorKind, level: NoiseLevel) {
        self.0[kind as usize] = level;
    }

    /// Whether no sensor errs.
    pub fn is_off(&self) -> bool {
        self.0.iter().all(|&level| level == NoiseLevel::Off)
    }
}

/// The random numbers of one robot's sensors.
#[derive(Debug, Clone)]
pub(super) struct NoiseSource {
    rng: Rng,
    normals: Normals,
}

impl NoiseSource {
    /// The source of the robot with number `seed`.
    pub fn new(seed: u64) -> Self {
        Self { rng: seeded(seed, STREAM), normals: Normals::new() }
    }

    /// The random bytes of one step, for all sensors but the laser: each takes its own ones, so that the level of one
    /// kind changes nothing for the others.
    #[inline]
    pub fn draw(&mut self) -> NoiseDraw<'_> {
        NoiseDraw {
            bytes: [self.rng.next_u64().to_le_bytes(), self.rng.next_u64().to_le_bytes()],
            normals: &self.normals,
        }
    }
}

/// Sixteen random bytes.
#[derive(Debug, Clone, Copy)]
pub(super) struct NoiseDraw<'a> {
    bytes: [[u8; 8]; 2],
    normals: &'a Normals,
}

impl NoiseDraw<'_> {
    /// Byte `index`, 0 to 15.
    #[inline]
    pub fn byte(&self, index: usize) -> u8 {
        self.bytes[index / 8 % 2][index % 8]
    }

    /// Byte `index` as a normal deviate.
    #[inline]
    pub fn normal(&self, index: usize) -> f64 {
        self.normals.of(self.byte(index))
    }
}

/// Standard normal deviates from -2.9 to 2.9, one for each byte.
#[derive(Debug, Clone)]
pub(super) struct Normals(Arc<[f64; 256]>);

impl Normals {
    /// The quantiles of the normal distribution at 1/512, 3/512, 5/512 and so on.
    pub fn new() -> Self {
        let mut table = [0.0; 256];
        let density = |z: f64| math::exp(-0.5 * z * z);
        let at = |step: i32| f64::from(step) / f64::from(FINE);
        let total: f64 = (-WIDE * FINE..WIDE * FINE).map(|step| density(at(step))).sum();
        let (mut index, mut below) = (0, 0.0);
        for step in -WIDE * FINE..WIDE * FINE {
            let share = density(at(step)) / total;
            while let Some(slot) = table.get_mut(index) {
                let wanted = (index as f64 + 0.5) / 256.0;
                if below + share < wanted {
                    break;
                }
                *slot = at(step) + ((wanted - below) / share - 0.5) / f64::from(FINE);
                index += 1;
            }
            below += share;
        }
        Self(Arc::new(table))
    }

    /// The deviate of a random byte.
    #[inline]
    pub fn of(&self, byte: u8) -> f64 {
        self.0[usize::from(byte)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deviates_are_standard_normal() {
        let normals = Normals::new();
        let all: Vec<f64> = (0..=255).map(|byte| normals.of(byte)).collect();
        assert!(all.is_sorted());
        let mean = all.iter().sum::<f64>() / 256.0;
        let variance = all.iter().map(|z| z * z).sum::<f64>() / 256.0;
        assert!(mean.abs() < 1e-3, "{mean}");
        assert!((variance - 1.0).abs() < 0.02, "{variance}");
        // Quartiles of the normal distribution.
        assert!((all[63] + 0.674).abs() < 0.01 && (all[192] - 0.674).abs() < 0.01, "{} {}", all[63], all[192]);
        // 1/512 and 511/512.
        assert!((all[0] + 2.886).abs() < 0.02 && (all[255] - 2.886).abs() < 0.02, "{} {}", all[0], all[255]);
    }
}

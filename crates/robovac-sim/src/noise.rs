//! Sensor noise.
//!
//! The effect of each level on a kind of sensor is documented in that sensor's file.

use crate::RandomStream;
use rand::Rng as _;
use robovac_core::{math, rng::Rng};
use serde::{Deserialize, Serialize};
use std::{fmt, ops::Range, sync::Arc};

/// Random bytes that are drawn in each step.
const BYTES: usize = 16;
/// Steps of the normal distribution's numerical integration, per unit.
const FINE: i32 = 128;
/// Limit of the integration.
const WIDE: i32 = 4;

/// An enum whose list of all values can't miss one.
macro_rules! named {
    ($(#[$about:meta])* pub enum $name:ident { $($(#[$meta:meta])* $value:ident = $id:literal,)* }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
        #[serde(rename_all = "lowercase")]
        pub enum $name { $($(#[$meta])* $value,)* }

        impl $name {
            /// All of them, with their names in links and on the command line.
            pub const ALL: [(Self, &'static str); [$($id),*].len()] = [$((Self::$value, $id)),*];

            /// The one of that name.
            pub fn parse(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(value, _)| value)
            }
        }
    };
}

named! {
    /// Level of a sensor's errors.
    #[derive(Default)]
    pub enum NoiseLevel {
        /// No errors.
        #[default]
        Off = "off",
        /// Errors of good sensors in a clean room.
        Typical = "typical",
        /// Errors of worn, dirty or dazzled sensors.
        Harsh = "harsh",
    }
}

named! {
    /// Kinds of sensors whose noise can be set separately.
    pub enum SensorKind {
        /// Bumper switches.
        Bumper = "bumper",
        /// Cliff sensors.
        Cliff = "cliff",
        /// Light bumper and wall sensor.
        Light = "light",
        /// Infrared receivers for docks and virtual walls.
        Infrared = "infrared",
        /// Dirt sensor.
        Dirt = "dirt",
        /// Laser scanner.
        Laser = "laser",
        /// Battery gauge.
        Battery = "battery",
    }
}

/// Noise of every kind of sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Noise([NoiseLevel; SensorKind::ALL.len()]);

impl NoiseLevel {
    /// Name in links and on the command line.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

impl SensorKind {
    /// Name in forms.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Bumper => "Bumper",
            Self::Cliff => "Cliff sensors",
            Self::Light => "Light bumper",
            Self::Infrared => "Infrared",
            Self::Dirt => "Dirt",
            Self::Laser => "Laser",
            Self::Battery => "Battery gauge",
        }
    }

    /// Its random bytes of a step, among the [`BYTES`] that are drawn. All are in use: a new kind has none (`0..0`) and
    /// a random stream of its own, like the laser scanner.
    pub(super) const fn bytes(self) -> Range<usize> {
        match self {
            Self::Cliff => 0..4,
            Self::Light => 4..10,
            Self::Bumper => 10..12,
            Self::Infrared => 12..14,
            Self::Dirt => 14..15,
            Self::Battery => 15..BYTES,
            Self::Laser => 0..0,
        }
    }
}

/// No two kinds share a random byte, and all are within range.
const _: () = {
    let (mut taken, mut kind) = ([false; BYTES], 0);
    while kind < SensorKind::ALL.len() {
        let Range { start, end } = SensorKind::ALL[kind].0.bytes();
        assert!(end <= BYTES, "a kind of sensor takes more random bytes than are drawn: see SensorKind::bytes");
        let mut byte = start;
        while byte < end {
            assert!(!taken[byte], "two kinds of sensors share a random byte: see SensorKind::bytes");
            taken[byte] = true;
            byte += 1;
        }
        kind += 1;
    }
};

/// The common level, or those that aren't off, kind by kind: `typical`, `cliff=harsh light=typical`.
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
        Self { rng: RandomStream::Sensors.seeded(seed), normals: Normals::new() }
    }

    /// The random bytes of one step, for all sensors except the laser: each uses its own, so that the level of one kind
    /// doesn't affect the others.
    #[inline]
    pub fn draw(&mut self) -> NoiseDraw<'_> {
        NoiseDraw {
            bytes: [self.rng.next_u64().to_le_bytes(), self.rng.next_u64().to_le_bytes()],
            normals: &self.normals,
        }
    }
}

/// The random bytes of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct NoiseDraw<'a> {
    bytes: [[u8; 8]; BYTES / 8],
    normals: &'a Normals,
}

impl NoiseDraw<'_> {
    /// Byte `index` of those that belong to `kind`.
    #[inline]
    pub fn byte(&self, kind: SensorKind, index: usize) -> u8 {
        let Range { start, end } = kind.bytes();
        debug_assert!(index < end - start, "{kind:?} has no random byte {index}");
        let byte = start + index;
        self.bytes[byte / 8][byte % 8]
    }

    /// That byte as a normal deviate.
    #[inline]
    pub fn normal(&self, kind: SensorKind, index: usize) -> f64 {
        self.normals.of(self.byte(kind, index))
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

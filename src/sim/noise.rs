//! How much sensors err.

use serde::{Deserialize, Serialize};
use std::fmt;

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
}

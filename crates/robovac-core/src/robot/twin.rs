//! A twin: figures of one particular robot in place of its model's.

use super::{LightBumper, LightLaw, RobotModel, SensorSuite};
use serde::{Deserialize, Serialize};
use std::{fmt, ops::RangeInclusive};

/// Id of the model whose robots can have twins: those that can be connected.
pub const TWIN_MODEL: &str = "roomba600";

/// Shares of the model's lengths that a twin's can be.
const LENGTHS: RangeInclusive<f64> = 0.7..=1.4;
/// Accelerations that a twin can have, m/s².
const ACCELERATIONS: RangeInclusive<f64> = 0.1..=10.0;
/// Gains, m², and offsets, m, of a light bumper's law that a twin can have.
const GAINS: RangeInclusive<f64> = 0.05..=200.0;
const OFFSETS: RangeInclusive<f64> = 0.0..=0.1;

/// Measured figures of one robot; the missing ones are its model's.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Twin {
    /// Way of a wheel for one count of its encoder, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mm_per_count: Option<f64>,
    /// Distance between the wheels' contact points, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel_base_mm: Option<f64>,
    /// Speed over the floor divided by the commanded one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed_factor: Option<f64>,
    /// Acceleration of the wheels, m/s².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration_m_s2: Option<f64>,
    /// How the light bumper's signal falls with distance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<LightLaw>,
}

/// A figure that no robot has.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the twin's {name} can't be {value}; use {from} to {to}")]
pub struct TwinFault {
    name: &'static str,
    value: f64,
    from: f64,
    to: f64,
}

impl Twin {
    /// Checks that a robot can have these figures.
    pub fn check(&self, model: &RobotModel) -> Result<(), TwinFault> {
        let check = |name, value: Option<f64>, unit: f64, range: RangeInclusive<f64>| match value {
            Some(value) if !range.contains(&(value / unit)) => {
                let round = |bound: f64| (1e4 * bound * unit).round() / 1e4;
                Err(TwinFault { name, value, from: round(*range.start()), to: round(*range.end()) })
            }
            _ => Ok(()),
        };
        check("mm_per_count", self.mm_per_count, 1000.0 / model.counts_per_metre, LENGTHS)?;
        check("wheel_base_mm", self.wheel_base_mm, 1000.0 * model.wheel_base, LENGTHS)?;
        check("speed_factor", self.speed_factor, 1.0, LENGTHS)?;
        check("acceleration_m_s2", self.acceleration_m_s2, 1.0, ACCELERATIONS)?;
        check("light.gain_m2", self.light.map(|law| law.gain_m2), 1.0, GAINS)?;
        check("light.offset_m", self.light.map(|law| law.offset_m), 1.0, OFFSETS)
    }

    /// The robot model with these figures. Its speeds are those of the floor, so that a command of the model's cruise
    /// speed is one of the twin's.
    #[must_use]
    pub fn of(&self, model: &RobotModel) -> RobotModel {
        let counts_per_metre = self.mm_per_count.map_or(model.counts_per_metre, |mm| 1000.0 / mm);
        let speed = self.speed_factor.unwrap_or(1.0);
        let lit = |light: LightBumper| LightBumper { law: self.light.unwrap_or(light.law), ..light };
        RobotModel {
            title: "Twin of your Roomba",
            summary: "Wheels, acceleration and light bumper as fitted to a recording",
            counts_per_metre,
            wheel_radius: model.wheel_radius * (model.counts_per_metre / counts_per_metre),
            wheel_base: self.wheel_base_mm.map_or(model.wheel_base, |mm| mm / 1000.0),
            acceleration: self.acceleration_m_s2.unwrap_or(model.acceleration),
            max_wheel_speed: speed * model.max_wheel_speed,
            cruise_speed: speed * model.cruise_speed,
            turn_wheel_speed: speed * model.turn_wheel_speed,
            sensors: SensorSuite { light_bumper: model.sensors.light_bumper.map(lit), ..model.sensors },
            ..model.clone()
        }
    }

    /// The twin of a link: the inverse of its [`Display`](fmt::Display).
    pub fn parse(text: &str) -> Option<Self> {
        let mut twin = Self::default();
        for part in text.split(',').filter(|part| !part.is_empty()) {
            let (key, value) = part.split_once(':')?;
            let number = || value.parse::<f64>().ok();
            match key {
                "count" => twin.mm_per_count = Some(number()?),
                "base" => twin.wheel_base_mm = Some(number()?),
                "speed" => twin.speed_factor = Some(number()?),
                "acceleration" => twin.acceleration_m_s2 = Some(number()?),
                "light" => {
                    let (gain, offset) = value.split_once('_')?;
                    twin.light = Some(LightLaw { gain_m2: gain.parse().ok()?, offset_m: offset.parse().ok()? });
                }
                _ => return None,
            }
        }
        Some(twin)
    }
}

/// As in links: `count:0.4535,base:242.1`.
impl fmt::Display for Twin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = [
            ("count", self.mm_per_count),
            ("base", self.wheel_base_mm),
            ("speed", self.speed_factor),
            ("acceleration", self.acceleration_m_s2),
        ];
        let mut parts: Vec<String> =
            parts.into_iter().filter_map(|(key, value)| value.map(|value| format!("{key}:{value}"))).collect();
        parts.extend(self.light.map(|law| format!("light:{}_{}", law.gain_m2, law.offset_m)));
        f.write_str(&parts.join(","))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::model;

    fn odd() -> Twin {
        Twin {
            mm_per_count: Some(0.4535),
            wheel_base_mm: Some(242.1),
            speed_factor: Some(1.02),
            acceleration_m_s2: Some(1.35),
            light: Some(LightLaw { gain_m2: 4.6, offset_m: 0.025 }),
        }
    }

    #[test]
    fn a_link_holds_all_of_it() {
        assert_eq!(odd().to_string(), "count:0.4535,base:242.1,speed:1.02,acceleration:1.35,light:4.6_0.025");
        for twin in [odd(), Twin::default(), Twin { light: None, ..odd() }] {
            assert_eq!(Twin::parse(&twin.to_string()), Some(twin));
        }
        assert_eq!([Twin::parse("base"), Twin::parse("base:x"), Twin::parse("size:1")], [None; 3]);
    }

    #[test]
    fn a_twin_without_figures_is_the_model_but_for_its_name() {
        let roomba = model(TWIN_MODEL).unwrap();
        let twin = Twin::default().of(roomba);
        assert_eq!(RobotModel { title: roomba.title, summary: roomba.summary, ..twin }, *roomba);
        let twin = odd().of(roomba);
        assert!((twin.counts_per_metre - 1000.0 / 0.4535).abs() < 1e-9 && (twin.wheel_base - 0.2421).abs() < 1e-12);
        assert!((twin.cruise_speed - 0.306).abs() < 1e-12);
    }

    #[test]
    fn figures_that_no_robot_has_are_refused() {
        let roomba = model(TWIN_MODEL).unwrap();
        assert_eq!(odd().check(roomba), Ok(()));
        for (twin, message) in [
            (Twin { wheel_base_mm: Some(0.235), ..odd() }, "wheel_base_mm can't be 0.235; use 164.5 to 329"),
            (Twin { mm_per_count: Some(f64::NAN), ..odd() }, "mm_per_count can't be NaN"),
            (Twin { acceleration_m_s2: Some(0.0), ..odd() }, "acceleration_m_s2 can't be 0; use 0.1 to 10"),
        ] {
            assert!(twin.check(roomba).unwrap_err().to_string().contains(message), "{twin}");
        }
    }
}

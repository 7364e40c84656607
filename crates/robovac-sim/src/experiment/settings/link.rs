//! Settings in a link.

use super::{DEFAULT_SPEED, MANUAL_SPEED, Settings, SettingsError};
use crate::{Conditions, NoiseLevel, SensorKind, experiment::Shows};
use robovac_core::{
    geometry::{MetricPath, Pose},
    registry::Params,
    robot::{OwnRobot, Twin},
};

/// Longest path in a link, letters: about 1,500 corners. Some programs cut longer links off.
const MOST_PATH: usize = 12_000;
/// Stands in a link for a longer path: it is kept with the room.
pub const KEPT_PATH: &str = "kept";

impl Settings {
    /// The path as in a link; [`KEPT_PATH`] for one that is too long.
    pub fn path_link(&self) -> Option<String> {
        let text = self.path.as_ref()?.to_string();
        Some(if text.len() > MOST_PATH { KEPT_PATH.to_owned() } else { text })
    }

    /// The settings as `key=value` pairs for a link, without defaults.
    pub fn to_link(&self) -> Vec<(String, String)> {
        let default = self.defaults();
        let mut pairs = Vec::new();
        let mut push = |key: &str, value: String| pairs.push((key.to_owned(), value));
        push(self.algorithm.kind(), self.algorithm.id().to_owned());
        let defaults = Params::defaults(self.algorithm.params());
        for (id, value) in self.params.iter().filter(|&(id, value)| defaults.get(id) != Some(value)) {
            push(&format!("p.{id}"), value.to_string());
        }
        push("robot", self.robot.to_owned());
        if let Some(custom) = &self.custom {
            push(custom.key(), custom.to_string());
        }
        if let Some(path) = self.path_link() {
            push("path", path);
        }
        push("cell", self.cell_size.to_string());
        if self.cell_offset != default.cell_offset {
            let [x, y] = self.cell_offset;
            push("offset", format!("{x},{y}"));
        }
        if self.seed != default.seed {
            push("seed", self.seed.to_string());
        }
        let Conditions { slip, noise, quantised, start_charge_percent, .. } = self.conditions;
        if slip != default.conditions.slip {
            push("slip", slip.id().to_owned());
        }
        for (kind, name) in SensorKind::ALL.into_iter().filter(|&(kind, _)| noise.of(kind) != NoiseLevel::Off) {
            push(&format!("noise.{name}"), noise.of(kind).id().to_owned());
        }
        if quantised {
            push("quantised", quantised.to_string());
        }
        if start_charge_percent != default.conditions.start_charge_percent {
            push("charge", start_charge_percent.to_string());
        }
        if self.odometry != default.odometry {
            push("odometry", self.odometry.id().to_owned());
        }
        if self.smooth {
            push("smooth", self.smooth.to_string());
        }
        if let Some(start) = self.start {
            push("start", format!("{:.3},{:.3},{:.1}", start.x, start.y, start.heading.to_degrees()));
        }
        if self.speed != if self.is_manual() { MANUAL_SPEED } else { DEFAULT_SPEED } {
            push("speed", self.speed.to_string());
        }
        if self.shows != default.shows {
            push("show", self.shows.to_link());
        }
        pairs
    }

    /// Whether pairs are all that [`Settings::to_link`] tells, and not a part of it.
    pub fn is_whole<'a>(pairs: impl Iterator<Item = (&'a str, &'a str)>) -> bool {
        let always = ["robot", "cell"];
        pairs.filter(|(key, _)| always.contains(key)).count() == always.len()
    }

    /// Sets to its default what a whole link leaves out if it is the default.
    pub fn reset_unlinked(&mut self) {
        let default = self.defaults();
        let Conditions { slip, noise, quantised, start_charge_percent, .. } = default.conditions;
        self.conditions = Conditions { slip, noise, quantised, start_charge_percent, ..self.conditions };
        (self.seed, self.odometry, self.smooth, self.shows) = (default.seed, default.odometry, false, default.shows);
        self.speed = if self.is_manual() { MANUAL_SPEED } else { DEFAULT_SPEED };
    }

    /// Reads one `key=value` pair of a link. Unknown keys are ignored, as links of other versions can have more.
    pub fn take_link(&mut self, key: &str, value: &str) -> Result<(), SettingsError> {
        let number = |kind, expected| {
            let wrong = || SettingsError::Invalid { kind, value: value.to_owned(), expected };
            value.parse::<f64>().ok().filter(|n| n.is_finite()).ok_or_else(wrong)
        };
        match key {
            "planner" | "behaviour" => self.select_fresh_algorithm(value)?,
            "robot" => self.select_robot(value)?,
            "twin" => self.set_twin(Twin::parse(value).ok_or_else(|| SettingsError::Invalid {
                kind: "the twin",
                value: value.to_owned(),
                expected: "figures, e.g. base:242.1,speed:1.02",
            })?)?,
            "own" => self.set_own_robot(OwnRobot::parse(value).ok_or_else(|| SettingsError::Invalid {
                kind: "the own robot",
                value: value.to_owned(),
                expected: "figures, e.g. radius:0.2,tool:0.25,speed:0.3",
            })?)?,
            "path" => {
                self.path = Some(MetricPath::parse(value).ok_or_else(|| SettingsError::Invalid {
                    kind: "the path",
                    value: value.chars().take(40).collect(),
                    expected: "a whole link, or the scenario file of the run",
                })?);
            }
            "cell" => self.set_cell_size(number("the cell size", "a length from 0.02 to 2 (metres)")?)?,
            "offset" => {
                let numbers: Vec<f64> = value.split(',').filter_map(|n| n.trim().parse().ok()).collect();
                self.set_cell_offset(numbers.try_into().map_err(|_| SettingsError::Invalid {
                    kind: "the cells' offset",
                    value: value.to_owned(),
                    expected: "two lengths in metres, e.g. 0.04,0.08",
                })?)?;
            }
            "seed" => self.set_seed(value.parse().ok(), value)?,
            "slip" => self.set_slip(value)?,
            "noise" => self.set_noise(None, value)?,
            "quantised" => self.conditions.quantised = value == "true",
            "charge" => self.set_start_charge(value.parse().ok(), value)?,
            "odometry" => self.set_odometry(value)?,
            "smooth" => self.smooth = value == "true",
            "show" => self.shows = Shows::from_link(value)?,
            "speed" => self.speed = number("the speed", "a number, 0 for as fast as possible")?.max(0.0),
            "start" => {
                let expected = "x,y,heading in metres and degrees, e.g. 1.2,0.8,90";
                let wrong = || SettingsError::Invalid { kind: "the start", value: value.to_owned(), expected };
                let numbers: Vec<f64> = value.split(',').filter_map(|n| n.trim().parse().ok()).collect();
                let [x, y, heading] = numbers[..] else { return Err(wrong()) };
                if !(x.is_finite() && y.is_finite() && heading.is_finite()) {
                    return Err(wrong());
                }
                self.start = Some(Pose::new(x, y, heading.to_radians()));
            }
            _ => {
                if let Some(id) = key.strip_prefix("p.") {
                    self.set_param(id, value)?;
                } else if let Some(sensor) = key.strip_prefix("noise.") {
                    self.set_noise(Some(sensor), value)?;
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_of_cells_are_in_links_and_go_with_another_size() {
        let mut settings = Settings::new();
        assert!(settings.to_link().iter().all(|(key, _)| key != "offset"), "links stay as they were");
        settings.set_cell_size(0.15).unwrap();
        settings.set_cell_offset([0.05, 0.1]).unwrap();
        let mut other = Settings::new();
        for (key, value) in settings.to_link() {
            other.take_link(&key, &value).unwrap();
        }
        assert_eq!(other.cells(), settings.cells());
        assert!(settings.plans_like(&other) && !settings.plans_like(&Settings::new()));
        for wrong in ["0.1", "0.15,0", "-0.01,0", "0,nan", "a,b", "0,0,0"] {
            assert!(other.take_link("offset", wrong).is_err(), "{wrong}");
        }
        other.set_cell_size(0.15).unwrap();
        assert_eq!(other.cells(), 0.15.into());
        settings.select_robot("cell").unwrap();
        assert_eq!(settings.cells().offset, [0.0, 0.0]);
    }
}

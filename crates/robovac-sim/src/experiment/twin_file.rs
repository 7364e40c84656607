//! Files of twins: the figures of one robot, what its floor and sensors are like, and how all this was found.

use super::Settings;
use crate::{Conditions, NoiseLevel, SensorKind, SlipLevel};
use robovac_core::robot::{TWIN_MODEL, Twin, TwinFault, model};
use serde::{Deserialize, Serialize};

/// Value of the key `format`.
const FORMAT: &str = "robovac-twin";
/// Value of the key `version`.
const VERSION: u64 = 1;

/// Content of a twin's file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TwinFile {
    format: String,
    version: u64,
    /// The figures that differ from the model's.
    pub twin: Twin,
    /// The level of slip that its turns suggest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slip: Option<SlipLevel>,
    /// The level of noise that its light bumper suggests.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub light_noise: Option<NoiseLevel>,
    /// Whether its wheels turn only at some speeds; `None` if that couldn't be told.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quantised: Option<bool>,
    /// All figures in words, with those that stayed the model's. Not needed to read the twin.
    #[serde(default)]
    pub figures: Vec<TwinFigure>,
}

/// A figure of a twin, for people.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct TwinFigure {
    /// What it is.
    pub name: String,
    /// Its value; `None` if there is neither a measurement nor a default.
    pub value: Option<f64>,
    /// Its standard deviation; `None` for a value that wasn't fitted.
    pub uncertainty: Option<f64>,
    /// The model's value; `None` if the model has none.
    pub model: Option<f64>,
    /// Unit, empty for none.
    pub unit: String,
    /// Digits after the point.
    pub digits: u8,
    /// A sentence: what it was found from, or why it is the model's.
    pub how: String,
}

/// Reasons why a file isn't a twin.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TwinFileError {
    /// It is another file, or a damaged one.
    #[error("this is not a twin: {0}; \"robovac twin RECORDING --json FILE\" writes one")]
    NotATwin(String),
    /// It is of a later version.
    #[error("this twin has version {0}, but this program reads version {VERSION}; update it")]
    Version(u64),
    /// It has a figure that no robot has.
    #[error(transparent)]
    Fault(#[from] TwinFault),
}

impl TwinFile {
    /// The file of `twin`.
    pub fn new(twin: Twin) -> Self {
        Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            twin,
            slip: None,
            light_noise: None,
            quantised: None,
            figures: Vec::new(),
        }
    }

    /// Reads and checks a file.
    pub fn read(bytes: &[u8]) -> Result<Self, TwinFileError> {
        #[derive(Deserialize)]
        struct TwinHeader {
            format: String,
            version: u64,
        }
        let not = |error: serde_json::Error| TwinFileError::NotATwin(error.to_string());
        let header: TwinHeader = serde_json::from_slice(bytes).map_err(not)?;
        if header.format != FORMAT {
            let found = header.format.chars().take(40).collect::<String>();
            return Err(TwinFileError::NotATwin(format!("its format is \"{found}\", not \"{FORMAT}\"")));
        }
        if header.version != VERSION {
            return Err(TwinFileError::Version(header.version));
        }
        let file: Self = serde_json::from_slice(bytes).map_err(not)?;
        if let Some(model) = model(TWIN_MODEL) {
            file.twin.check(model)?;
        }
        Ok(file)
    }

    /// The file's text.
    pub fn to_json(&self) -> String {
        // Numbers, strings and lists can always be serialised.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// `conditions` with what is known of the floor, the wheels and the light bumper.
    #[must_use]
    pub fn conditions(&self, conditions: Conditions) -> Conditions {
        let mut with = Conditions {
            slip: self.slip.unwrap_or(conditions.slip),
            quantised: self.quantised.unwrap_or(conditions.quantised),
            ..conditions
        };
        if let Some(level) = self.light_noise {
            with.noise.set(SensorKind::Light, level);
        }
        with
    }

    /// The choices of [`Self::choose`] as a part of a link to Explore.
    pub fn to_link(&self) -> String {
        let mut link = format!("robot={TWIN_MODEL}&twin={}", self.twin);
        let choices = [
            ("slip", self.slip.map(|level| level.id().to_owned())),
            ("noise.light", self.light_noise.map(|level| level.id().to_owned())),
            ("quantised", self.quantised.map(|on| on.to_string())),
        ];
        for (key, value) in choices {
            link.extend(value.map(|value| format!("&{key}={value}")));
        }
        link
    }

    /// Makes the twin the robot of `settings`.
    pub fn choose(&self, settings: &mut Settings) {
        settings.select_twin(self.twin);
        settings.conditions = self.conditions(settings.conditions);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::CustomRobot;

    #[test]
    fn what_is_written_is_read() {
        let twin = Twin { wheel_base_mm: Some(242.0), ..Twin::default() };
        let mut file = TwinFile { slip: Some(SlipLevel::Harsh), quantised: Some(true), ..TwinFile::new(twin) };
        file.figures.push(TwinFigure {
            name: "Wheel base".to_owned(),
            value: Some(242.0),
            uncertainty: Some(0.5),
            model: Some(235.0),
            unit: "mm".to_owned(),
            digits: 1,
            how: "From turns.".to_owned(),
        });
        let read = TwinFile::read(file.to_json().as_bytes()).unwrap();
        assert_eq!(read, file);
        let mut settings = Settings::new();
        read.choose(&mut settings);
        assert_eq!(
            (settings.custom.clone(), settings.conditions.slip),
            (Some(CustomRobot::Twin(twin)), SlipLevel::Harsh)
        );
        let mut linked = Settings::new();
        assert_eq!(file.to_link(), "robot=roomba600&twin=base:242&slip=harsh&quantised=true");
        for (key, value) in file.to_link().split('&').filter_map(|pair| pair.split_once('=')) {
            linked.take_link(key, value).unwrap();
        }
        assert_eq!((&linked.custom, linked.conditions), (&settings.custom, settings.conditions));
        assert!(linked.to_link().contains(&("twin".to_owned(), "base:242".to_owned())));
        assert!(settings.conditions.quantised && (settings.robot_model().wheel_base - 0.242).abs() < 1e-12);
    }

    #[test]
    fn other_files_are_refused_with_the_reason() {
        let refused = |text: &str| TwinFile::read(text.as_bytes()).unwrap_err().to_string();
        assert!(refused("robovac-oi-recording 1\n").contains("--json FILE\" writes one"));
        assert!(refused(r#"{"format":"robovac-scenario","version":2}"#).contains("its format is \"robovac-scenario\""));
        assert!(refused(r#"{"format":"robovac-twin","version":9}"#).contains("version 9"));
        let odd = r#"{"format":"robovac-twin","version":1,"twin":{"wheel_base_mm":2350}}"#;
        assert!(refused(odd).contains("wheel_base_mm can't be 2350; use 164.5 to 329"));
    }
}

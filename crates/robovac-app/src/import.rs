//! Import of files: parsed in a worker, applied to the session.

use floor_drawing::{DrawingError, drawing_kind};
use robovac_core::{
    floor_plan::{self, FloorPlan, MapError, Scenario, SourceFile, TAKEN},
    program::Program,
    registry::Params,
    robot::CustomRobot,
};
use robovac_sim::{
    Noise, NoiseLevel, SensorKind,
    experiment::{Settings, SettingsError},
};
use serde::{Deserialize, Serialize};

/// The content of files.
#[derive(Debug, Clone)]
pub struct Import {
    /// The room.
    pub plan: FloorPlan,
    /// Other choices of a scenario; `None` for maps.
    pub choices: Option<ScenarioChoices>,
}

/// The choices of a scenario besides its room, as text that settings check. Missing ones stay unchanged.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(default)]
pub struct ScenarioChoices {
    /// Id of the robot.
    pub robot: Option<String>,
    /// Figures of a twin, as in links; without them the robot is the model.
    pub twin: Option<String>,
    /// Choices of an own robot, as in links.
    pub own_robot: Option<String>,
    /// Side of the planning cells, m.
    pub cell_size: Option<f64>,
    /// How far they begin to the left of the room's lower-left corner and below it, m.
    pub cell_offset: Option<[f64; 2]>,
    /// Id of the planner.
    pub planner: Option<String>,
    /// Id of the behaviour.
    pub behaviour: Option<String>,
    /// The user's program, if that is the planner or behaviour.
    pub program: Option<Program>,
    /// Parameters of the planner or behaviour, by name.
    pub params: Vec<(String, String)>,
    /// A path that is driven in place of the planner's, as in links.
    pub path: Option<String>,
    /// Seed of all random numbers.
    pub seed: Option<String>,
    /// Level of wheel slip.
    pub slip: Option<String>,
    /// Level of noise for each kind of sensor; missing ones are *off*.
    pub noise: Option<Vec<(String, String)>>,
    /// Whether wheel speeds are quantised.
    pub quantised: Option<bool>,
    /// Charge of the battery at the start, percent.
    pub start_charge_percent: Option<u64>,
    /// How the robot computes its pose.
    pub odometry: Option<String>,
    /// Whether the corners of plans are rounded.
    pub smooth: Option<bool>,
}

/// Reasons why files can't be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ImportError {
    /// They aren't a map.
    #[error(transparent)]
    Map(#[from] MapError),
    /// They are a drawing with a flaw.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// A file is a drawing, from which a room must be traced first.
    #[error(
        "\"{name}\" is {kind}, from which a room must be traced first; open it in the Floor plan tab of the page or \
         use \"robovac convert\""
    )]
    IsADrawing {
        /// The file.
        name: String,
        /// Its type, e.g. "a DXF drawing".
        kind: &'static str,
    },
}

impl ImportError {
    /// The reason, and what can be read, if the reason doesn't say so itself.
    pub fn with_formats(&self) -> String {
        let why = self.to_string();
        if why.contains(TAKEN) { why } else { format!("{}. {TAKEN}.", why.trim_end_matches('.')) }
    }
}

/// An unknown value in a scenario.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the scenario can't be run: {path}: {reason}")]
pub struct ScenarioError {
    /// The value in its JSON, e.g. `params.rate`.
    pub path: String,
    /// Description of the error.
    pub reason: String,
}

impl Import {
    /// Reads files that belong together. May take seconds for a large map.
    pub fn read(files: &[SourceFile]) -> Result<Self, ImportError> {
        let plan = floor_plan::load(files).map_err(|error| {
            let drawing = files.iter().find_map(|file| Some((file, drawing_kind(file)?)));
            drawing.map_or(ImportError::Map(error), |(file, kind)| ImportError::IsADrawing {
                name: floor_plan::base_name(&file.name).to_owned(),
                kind,
            })
        })?;
        let choices = match files {
            [file] => Scenario::read(&file.name, &file.bytes).ok().map(|scenario| ScenarioChoices::of(&scenario)),
            _ => None,
        };
        Ok(Self { plan, choices })
    }

    /// Reads a scenario file only.
    pub fn scenario(name: &str, bytes: &[u8]) -> Result<Self, MapError> {
        let scenario = Scenario::read(name, bytes)?;
        Ok(Self { plan: scenario.plan(name)?, choices: Some(ScenarioChoices::of(&scenario)) })
    }
}

impl ScenarioChoices {
    /// The choices of `scenario`.
    pub fn of(scenario: &Scenario) -> Self {
        let text = |value: &serde_json::Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        let Scenario {
            robot,
            twin,
            own_robot,
            path,
            cell_size,
            cell_offset,
            planner,
            behaviour,
            slip,
            noise,
            odometry,
            smooth,
            ..
        } = scenario.clone();
        Self {
            robot,
            twin: twin.map(|twin| twin.to_string()),
            own_robot: own_robot.map(|own| own.to_string()),
            path: path.map(|path| path.to_string()),
            cell_size,
            cell_offset,
            planner,
            behaviour,
            program: scenario.program.clone(),
            params: scenario.params.iter().map(|(id, value)| (id.clone(), text(value))).collect(),
            seed: scenario.seed.map(|seed| seed.to_string()),
            slip,
            noise: noise.map(|levels| levels.into_iter().collect()),
            quantised: scenario.quantised,
            start_charge_percent: scenario.start_charge_percent,
            odometry,
            smooth,
        }
    }

    /// The choices that a scenario can contain, from `settings`.
    pub fn of_settings(settings: &Settings) -> Self {
        let Settings { algorithm, ref params, conditions, .. } = *settings;
        let custom = settings.custom.as_ref();
        let defaults = Params::defaults(algorithm.params());
        let changed = params.iter().filter(|&(id, value)| defaults.get(id) != Some(value));
        let noisy = SensorKind::ALL.into_iter().map(|(kind, name)| (name, conditions.noise.of(kind)));
        let noisy = noisy.filter(|&(_, level)| level != NoiseLevel::Off);
        Self {
            robot: Some(settings.robot.to_owned()),
            twin: custom.and_then(CustomRobot::twin).map(|twin| twin.to_string()),
            own_robot: custom.and_then(CustomRobot::own).map(ToString::to_string),
            path: settings.path.as_ref().map(ToString::to_string),
            cell_size: Some(settings.cell_size),
            cell_offset: Some(settings.cells().offset).filter(|offset| *offset != [0.0, 0.0]),
            planner: algorithm.planner().map(|info| info.id.to_owned()),
            behaviour: algorithm.behaviour().map(|info| info.id.to_owned()),
            program: settings.chosen_program().map(|program| Program::clone(program)),
            params: changed.map(|(id, value)| (id.to_owned(), value.to_string())).collect(),
            seed: Some(settings.seed.to_string()),
            slip: Some(conditions.slip.id().to_owned()),
            noise: Some(noisy.map(|(name, level)| (name.to_owned(), level.id().to_owned())).collect()),
            quantised: Some(conditions.quantised),
            start_charge_percent: Some(conditions.start_charge_percent.into()),
            odometry: Some(settings.odometry.id().to_owned()),
            smooth: Some(settings.smooth),
        }
    }

    /// Id of the planner or behaviour.
    pub fn algorithm(&self) -> Option<&str> {
        self.planner.as_deref().or(self.behaviour.as_deref())
    }

    /// `now`, with the choices of the scenario.
    pub fn settings(&self, now: &Settings) -> Result<Settings, ScenarioError> {
        let mut settings = now.clone();
        if let Some(id) = &self.robot {
            at("robot", settings.select_robot(id))?;
        }
        if let Some(text) = &self.twin {
            at("twin", settings.take_link("twin", text))?;
        }
        if let Some(text) = &self.own_robot {
            at("own_robot", settings.take_link("own", text))?;
        }
        if let Some(metres) = self.cell_size {
            at("cell_size", settings.set_cell_size(metres))?;
        }
        if let Some(offset) = self.cell_offset {
            at("cell_offset", settings.set_cell_offset(offset))?;
        }
        if let Some(program) = &self.program {
            at("program", settings.keep_program(program.clone()))?;
        }
        for (kind, id) in [("planner", &self.planner), ("behaviour", &self.behaviour)] {
            if let Some(id) = id {
                at(kind, settings.select_fresh_of_kind(kind, id))?;
            }
        }
        if let Some(text) = &self.path {
            at("path", settings.take_link("path", text))?;
        }
        for (id, text) in &self.params {
            at(&format!("params.{id}"), settings.set_param(id, text))?;
        }
        if let Some(seed) = &self.seed {
            at("seed", settings.set_seed(seed.parse().ok(), seed))?;
        }
        if let Some(id) = &self.slip {
            at("slip", settings.set_slip(id))?;
        }
        if let Some(levels) = &self.noise {
            settings.conditions.noise = Noise::default();
            for (sensor, level) in levels {
                at(&format!("noise.{sensor}"), settings.set_noise(Some(sensor), level))?;
            }
        }
        if let Some(on) = self.quantised {
            settings.conditions.quantised = on;
        }
        if let Some(percent) = self.start_charge_percent {
            at("start_charge_percent", settings.set_start_charge(Some(percent), &percent.to_string()))?;
        }
        if let Some(id) = &self.odometry {
            at("odometry", settings.set_odometry(id))?;
        }
        if let Some(on) = self.smooth {
            settings.smooth = on;
        }
        Ok(settings)
    }
}

fn at<T>(path: &str, result: Result<T, SettingsError>) -> Result<T, ScenarioError> {
    result.map_err(|error| ScenarioError { path: path.to_owned(), reason: error.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawings_are_called_what_they_are() {
        for (content, kind) in [
            ("  0\nSECTION\n  2\nENTITIES\n", "a DXF"),
            ("\u{feff}<svg xmlns='http://www.w3.org/2000/svg'/>", "an SVG"),
            ("{\"type\": \"FeatureCollection\", \"features\": []}", "a GeoJSON"),
        ] {
            let file = SourceFile { name: "plans/house".to_owned(), bytes: content.into() };
            let message = Import::read(&[file]).unwrap_err().to_string();
            assert!(message.starts_with(&format!("\"house\" is {kind} drawing, from which a room")), "{message}");
        }
        // Opened where drawings are: the message doesn't send one there.
        let dwg = SourceFile { name: "house.dwg".to_owned(), bytes: b"AC1032\0".to_vec() };
        let message = Import::read(&[dwg]).unwrap_err().to_string();
        assert!(message.contains("save it as DXF") && !message.contains("tab"), "{message}");
    }
}

//! Files on their way into a session: read where there is time, taken where the session is.

use crate::floorplan::{self, FloorPlan, MapError, Scenario, SourceFile};
use serde::{Deserialize, Serialize};

/// What files turned out to be.
#[derive(Debug, Clone)]
pub struct Import {
    /// The room.
    pub plan: FloorPlan,
    /// What else a scenario says; `None` for other maps.
    pub choices: Option<Choices>,
}

/// What a scenario says beside its room, as text that settings check. What it doesn't mention stays as it is.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Choices {
    /// Id of the robot.
    pub robot: Option<String>,
    /// Side of the planning cells, m.
    pub cell_size: Option<f64>,
    /// Id of the planner or behaviour.
    pub algorithm: Option<String>,
    /// Its parameters by name.
    pub params: Vec<(String, String)>,
    /// Seed of all random numbers.
    pub seed: Option<String>,
}

impl Import {
    /// Reads files that belong together. May take seconds for a large map.
    pub fn read(files: &[SourceFile]) -> Result<Self, MapError> {
        let plan = floorplan::load(files)?;
        let choices = match files {
            [file] => Scenario::read(&file.name, &file.bytes).ok().map(|scenario| Choices::of(&scenario)),
            _ => None,
        };
        Ok(Self { plan, choices })
    }
}

impl Choices {
    /// What `scenario` says.
    pub fn of(scenario: &Scenario) -> Self {
        let text = |value: &serde_json::Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        Self {
            robot: scenario.robot.clone(),
            cell_size: scenario.cell_size,
            algorithm: scenario.planner.clone(),
            params: scenario.params.iter().map(|(id, value)| (id.clone(), text(value))).collect(),
            seed: scenario.seed.map(|seed| seed.to_string()),
        }
    }
}

//! Scenario files: a room, where the robot starts in it, and what is to be run there.
//!
//! JSON with the map as `#.?` rows, the top row first, so that a scenario can be read and changed by hand.

use super::{
    FloorPlan, MAX_SIDE, MapError,
    ascii::{cell_of, glyph},
    error::checked_resolution,
};
use crate::{
    geometry::Pose,
    grid::{Grid, Occupancy, picture},
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What the key `format` says.
pub const SCENARIO_FORMAT: &str = "robovac-scenario";
/// The version that is written and read. To be raised when older programs would misread a file.
pub const SCENARIO_VERSION: u64 = 1;

/// Content of a scenario file. Keys that are unknown are ignored when reading.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Scenario {
    format: String,
    version: u64,
    /// Short name of the room.
    #[serde(default)]
    pub name: String,
    /// One sentence on what it is good for.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub note: String,
    /// Metres per cell.
    pub resolution: f64,
    /// Columns of the map.
    pub width: usize,
    /// Rows of the map.
    pub height: usize,
    /// Cells as `#.?`, the top row first.
    pub rows: Vec<String>,
    /// Pose of the lower-left corner in the map frame that the room came from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin: Option<ScenarioPose>,
    /// Where the robot starts, from the lower-left corner.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<ScenarioPose>,
    /// Id of the robot.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub robot: Option<String>,
    /// Id of the planner or controller.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub planner: Option<String>,
    /// Values of its parameters that differ from the defaults: numbers, words, or true and false.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub params: BTreeMap<String, serde_json::Value>,
    /// Side of the planning cells, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_size: Option<f64>,
    /// Seed of all random numbers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
}

/// A pose with its heading in degrees, for people who edit files.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ScenarioPose {
    /// Metres to the right.
    pub x: f64,
    /// Metres up.
    pub y: f64,
    /// Degrees counter-clockwise from the right.
    #[serde(default)]
    pub heading_deg: f64,
}

impl From<Pose> for ScenarioPose {
    fn from(pose: Pose) -> Self {
        Self { x: pose.x, y: pose.y, heading_deg: pose.heading.to_degrees() }
    }
}

impl From<ScenarioPose> for Pose {
    fn from(pose: ScenarioPose) -> Self {
        Self::new(pose.x, pose.y, pose.heading_deg.to_radians())
    }
}

impl Scenario {
    /// A scenario that consists of a room only.
    pub fn of(plan: &FloorPlan) -> Self {
        let is_moved = plan.origin != Pose::new(0.0, 0.0, 0.0);
        Self {
            format: SCENARIO_FORMAT.to_owned(),
            version: SCENARIO_VERSION,
            name: plan.name.clone(),
            note: plan.note.clone(),
            resolution: plan.resolution,
            width: plan.occupancy.width(),
            height: plan.occupancy.height(),
            rows: picture(&plan.occupancy, |&o| glyph(o)).lines().map(str::to_owned).collect(),
            origin: is_moved.then(|| plan.origin.into()),
            start: plan.start.map(Into::into),
            robot: None,
            planner: None,
            params: BTreeMap::new(),
            cell_size: None,
            seed: None,
        }
    }

    /// Reads and checks the file `name`; [`Scenario::plan`] then finds nothing to complain about.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, MapError> {
        let syntax = |error: serde_json::Error| explain(name, &error);
        // The head first, so that files of other kinds and versions aren't blamed for details.
        let value: serde_json::Value = serde_json::from_slice(bytes).map_err(syntax)?;
        if value.get("format").and_then(|v| v.as_str()) != Some(SCENARIO_FORMAT) {
            return Err(MapError::NotAScenario { name: name.to_owned() });
        }
        let version = value.get("version").and_then(serde_json::Value::as_u64);
        if let Some(version) = version.filter(|&version| version != SCENARIO_VERSION) {
            return Err(MapError::UnknownVersion { name: name.to_owned(), version, known: SCENARIO_VERSION });
        }
        drop(value);
        // Again, as only this way errors have a line and a column.
        let scenario: Self = serde_json::from_slice(bytes).map_err(syntax)?;
        scenario.plan(name)?;
        Ok(scenario)
    }

    /// The file's text.
    pub fn to_json(&self) -> String {
        // Strings, numbers and maps with string keys: nothing in here can fail to be written.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// The room; `file` is named in errors.
    pub fn plan(&self, file: &str) -> Result<FloorPlan, MapError> {
        let plan = FloorPlan {
            name: self.name.clone(),
            note: self.note.clone(),
            resolution: checked_resolution(file, "key \"resolution\"", &self.resolution.to_string())?,
            occupancy: self.occupancy(file)?,
            objects: Vec::new(),
            start: checked_pose(file, "key \"start\"", self.start)?,
            origin: checked_pose(file, "key \"origin\"", self.origin)?.unwrap_or(Pose::new(0.0, 0.0, 0.0)),
        };
        plan.checked(file)
    }

    fn occupancy(&self, file: &str) -> Result<Grid<Occupancy>, MapError> {
        if self.width.max(self.height) > MAX_SIDE {
            return Err(MapError::TooLarge { name: file.to_owned(), width: self.width, height: self.height });
        }
        if self.rows.len() != self.height {
            return Err(wrong_size(file, "key \"rows\"".to_owned(), "height", self.rows.len(), self.height));
        }
        let mut cells = Vec::with_capacity(self.width * self.height);
        for (index, row) in self.rows.iter().enumerate().rev() {
            let count = row.chars().count();
            if count != self.width {
                return Err(wrong_size(file, format!("rows[{index}]"), "width", count, self.width));
            }
            for found in row.chars() {
                // The start has a key of its own.
                let cell = cell_of(found).filter(|_| found != 'S');
                cells.push(cell.ok_or_else(|| bad_cell(file, index, found))?);
            }
        }
        Grid::from_rows(self.width, cells).ok_or_else(|| MapError::NoFreeCell { name: file.to_owned() })
    }
}

fn checked_pose(file: &str, place: &str, pose: Option<ScenarioPose>) -> Result<Option<Pose>, MapError> {
    match pose {
        Some(ScenarioPose { heading_deg, .. }) if !(-360.0..=360.0).contains(&heading_deg) => Err(MapError::BadValue {
            name: file.to_owned(),
            place: place.to_owned(),
            key: "heading_deg",
            value: heading_deg.to_string(),
            expected: "degrees from -360 to 360".to_owned(),
        }),
        pose => Ok(pose.map(Into::into)),
    }
}

fn wrong_size(file: &str, place: String, key: &'static str, found: usize, expected: usize) -> MapError {
    MapError::WrongSize { name: file.to_owned(), place, key, found, expected }
}

fn bad_cell(file: &str, row: usize, found: char) -> MapError {
    MapError::BadValue {
        name: file.to_owned(),
        place: format!("rows[{row}]"),
        key: "a cell",
        value: found.escape_debug().to_string(),
        expected: "# for wall, . for floor or ? for unknown".to_owned(),
    }
}

/// What is wrong with the JSON, and where.
fn explain(name: &str, error: &serde_json::Error) -> MapError {
    if error.is_eof() {
        return MapError::Truncated { name: name.to_owned(), part: "JSON" };
    }
    // The library's own text ends with the place, which the message already names.
    let cause = error.to_string();
    let cause = cause.split(" at line ").next().unwrap_or_default().to_owned();
    MapError::Syntax { name: name.to_owned(), line: error.line(), column: error.column(), cause }
}

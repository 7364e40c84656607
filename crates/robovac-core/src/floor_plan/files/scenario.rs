//! Scenario files: a room, its objects, the robot's start, and the algorithm to run.
//!
//! JSON with the map as `#.?` rows, the top row first, so that a scenario can be read and changed by hand. Its schema
//! is `docs/scenario.schema.json`. Version 2 added objects, behaviours, noise and slip.

use super::{
    Flaw, FloorPlan, JsonPlace, MAX_RESOLUTION, MAX_SIDE, MIN_RESOLUTION, MapError, Object, PlacementFault,
    PlacementRefusal,
    ascii::{cell_of, glyph},
    layout::JsonLayout,
    scenario_object::ScenarioObject,
};
use crate::{
    geometry::{MetricPath, Pose},
    grid::{Grid, Occupancy, picture},
    program::Program,
    robot::{OwnRobot, Twin},
};
use serde::{Deserialize, Serialize, de::IgnoredAny};
use std::collections::BTreeMap;

/// Value of the key `format`.
pub const SCENARIO_FORMAT: &str = "robovac-scenario";
/// The version that is written; older ones can be read as well. To be increased when older programs would misread a
/// file.
pub const SCENARIO_VERSION: u64 = 2;
/// Value of the key `$schema`: the schema's name, relative to the file. The page serves it beside itself.
pub const SCENARIO_SCHEMA: &str = "scenario.schema.json";

/// Content of a scenario file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// Where editors find the schema; ignored when reading.
    #[serde(rename = "$schema", default)]
    schema: String,
    format: String,
    version: u64,
    /// Short name of the room.
    #[serde(default)]
    pub name: String,
    /// One sentence on its purpose.
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
    /// Objects of the room, in coordinates from the lower-left corner.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    objects: Vec<ScenarioObject>,
    /// Start of the robot, in coordinates from the lower-left corner.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<ScenarioPose>,
    /// Id of the robot.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub robot: Option<String>,
    /// Figures of one particular robot in place of the model's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub twin: Option<Twin>,
    /// What an own robot has in place of the model's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub own_robot: Option<OwnRobot>,
    /// Id of the planner, unless there is a behaviour.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub planner: Option<String>,
    /// Id of the behaviour, unless there is a planner.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub behaviour: Option<String>,
    /// The user's program, if that is the planner or behaviour.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<Program>,
    /// Values of its parameters that differ from the defaults: numbers, words, or true and false.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub params: BTreeMap<String, serde_json::Value>,
    /// A path that is driven in place of the planner's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path: Option<MetricPath>,
    /// Side of the planning cells, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_size: Option<f64>,
    /// How far the planning cells begin to the left of the room's lower-left corner and below it, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_offset: Option<[f64; 2]>,
    /// Seed of all random numbers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// Level of wheel slip.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slip: Option<String>,
    /// Level of noise of each kind of sensor; missing ones are *off*.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noise: Option<BTreeMap<String, String>>,
    /// Whether wheel speeds are limited to the steps of the robot's interface.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quantised: Option<bool>,
    /// Charge of the battery at the start, percent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start_charge_percent: Option<u64>,
    /// How the robot computes its pose.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub odometry: Option<String>,
    /// Whether the corners of plans are rounded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub smooth: Option<bool>,
}

/// The fields that determine how to read the rest, and the keys that version 1 doesn't have.
#[derive(Deserialize)]
struct ScenarioHeader {
    format: Option<serde_json::Value>,
    version: Option<serde_json::Value>,
    objects: Option<IgnoredAny>,
    behaviour: Option<IgnoredAny>,
    slip: Option<IgnoredAny>,
    noise: Option<IgnoredAny>,
    quantised: Option<IgnoredAny>,
    start_charge_percent: Option<IgnoredAny>,
    odometry: Option<IgnoredAny>,
    smooth: Option<IgnoredAny>,
    twin: Option<IgnoredAny>,
    own_robot: Option<IgnoredAny>,
    path: Option<IgnoredAny>,
    cell_offset: Option<IgnoredAny>,
    program: Option<IgnoredAny>,
}

/// A pose with its heading in degrees, for hand-edited files.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "an object with x and y")]
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
        let exact = pose.heading.to_degrees();
        let round = (exact * 1e6).round() / 1e6;
        // Of all numbers that give the same heading, the roundest: a file that is read must run the same way.
        let candidates = [round, exact, exact.next_up(), exact.next_down()];
        let heading_deg = candidates.into_iter().find(|deg| deg.to_radians() == pose.heading).unwrap_or(exact);
        Self { x: pose.x, y: pose.y, heading_deg }
    }
}

impl From<ScenarioPose> for Pose {
    fn from(pose: ScenarioPose) -> Self {
        Self::new(pose.x, pose.y, pose.heading_deg.to_radians())
    }
}

impl ScenarioHeader {
    /// An invalid value of the header, by its path.
    fn flaw(&self) -> Option<(&'static str, Flaw)> {
        let version = self.version.as_ref()?;
        let Self { objects, behaviour, slip, noise, quantised, start_charge_percent, .. } = self;
        let Self { odometry, smooth, twin, own_robot, path, cell_offset, program, .. } = self;
        match version.as_u64() {
            Some(1) => [
                ("objects", objects),
                ("behaviour", behaviour),
                ("slip", slip),
                ("noise", noise),
                ("quantised", quantised),
                ("start_charge_percent", start_charge_percent),
                ("odometry", odometry),
                ("smooth", smooth),
                ("twin", twin),
                ("own_robot", own_robot),
                ("path", path),
                ("cell_offset", cell_offset),
                ("program", program),
            ]
            .into_iter()
            .find(|(_, value)| value.is_some())
            .map(|(key, _)| (key, Flaw::KeyOfLaterVersion)),
            Some(SCENARIO_VERSION) => None,
            _ => Some(("version", Flaw::Version { found: version.to_string(), known: SCENARIO_VERSION })),
        }
    }
}

impl Scenario {
    /// A scenario that consists of a room only.
    pub fn of(plan: &FloorPlan) -> Self {
        let is_moved = plan.origin != Pose::new(0.0, 0.0, 0.0);
        Self {
            schema: SCENARIO_SCHEMA.to_owned(),
            format: SCENARIO_FORMAT.to_owned(),
            version: SCENARIO_VERSION,
            name: plan.name.clone(),
            note: plan.note.clone(),
            resolution: plan.resolution,
            width: plan.occupancy.width(),
            height: plan.occupancy.height(),
            rows: picture(&plan.occupancy, |&o| glyph(o)).lines().map(str::to_owned).collect(),
            origin: is_moved.then(|| plan.origin.into()),
            objects: plan.objects.iter().map(Into::into).collect(),
            start: plan.start.map(Into::into),
            robot: None,
            twin: None,
            own_robot: None,
            planner: None,
            behaviour: None,
            program: None,
            params: BTreeMap::new(),
            path: None,
            cell_size: None,
            cell_offset: None,
            seed: None,
            slip: None,
            noise: None,
            quantised: None,
            start_charge_percent: None,
            odometry: None,
            smooth: None,
        }
    }

    /// Reads and checks the file `name`; [`Scenario::plan`] of the result doesn't fail.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, MapError> {
        let refused = |path: &str, flaw| MapError::BadScenario {
            name: name.to_owned(),
            place: JsonPlace::of(path, bytes),
            flaw: Box::new(flaw),
        };
        // The header first, so that files of other kinds and versions give the right error.
        let head: ScenarioHeader =
            serde_json::from_slice(bytes).map_err(|error| explain(name, String::new(), &error))?;
        if head.format.as_ref().and_then(|v| v.as_str()) != Some(SCENARIO_FORMAT) {
            return Err(MapError::NotAScenario { name: name.to_owned() });
        }
        if let Some((path, flaw)) = head.flaw() {
            return Err(refused(path, flaw));
        }
        let mut json = serde_json::Deserializer::from_slice(bytes);
        let mut scenario: Self = serde_path_to_error::deserialize(&mut json)
            .map_err(|error| explain(name, error.path().to_string(), error.inner()))?;
        scenario.built().map_err(|(path, flaw)| refused(&path, flaw))?;
        // An older version is written as the present one.
        scenario.version = SCENARIO_VERSION;
        SCENARIO_SCHEMA.clone_into(&mut scenario.schema);
        Ok(scenario)
    }

    /// The file's text.
    pub fn to_json(&self) -> String {
        let mut text = Vec::new();
        // Strings, numbers and maps with string keys can always be serialised.
        let _ = self.serialize(&mut serde_json::Serializer::with_formatter(&mut text, JsonLayout::default()));
        text.push(b'\n');
        String::from_utf8(text).unwrap_or_default()
    }

    /// The room; `file` is named in errors.
    pub fn plan(&self, file: &str) -> Result<FloorPlan, MapError> {
        self.built().map_err(|(path, flaw)| MapError::BadScenario {
            name: file.to_owned(),
            place: JsonPlace { path, at: None },
            flaw: Box::new(flaw),
        })
    }

    /// The room, or the path of its flaw.
    fn built(&self) -> Result<FloorPlan, (String, Flaw)> {
        if self.planner.is_some() && self.behaviour.is_some() {
            return Err(("behaviour".to_owned(), Flaw::TwoAlgorithms));
        }
        in_range("resolution", self.resolution, [MIN_RESOLUTION, MAX_RESOLUTION], "metres per cell")?;
        if let Some(percent) = self.start_charge_percent {
            in_range("start_charge_percent", percent as f64, [1.0, 100.0], "a percentage")?;
        }
        let poses = self.objects.iter().enumerate().filter_map(|(index, object)| match object {
            ScenarioObject::Dock(pose) => Some((format!("objects[{index}].dock.heading_deg"), pose.heading_deg)),
            ScenarioObject::VirtualWall(beam) => {
                Some((format!("objects[{index}].virtual_wall.heading_deg"), beam.heading_deg))
            }
            _ => None,
        });
        for (path, heading) in poses {
            in_range(&path, heading, [-360.0, 360.0], "degrees")?;
        }
        let plan = FloorPlan {
            name: self.name.clone(),
            note: self.note.clone(),
            resolution: self.resolution,
            occupancy: self.occupancy()?,
            objects: self.objects.iter().map(Object::from).collect(),
            start: checked_pose("start", self.start)?,
            origin: checked_pose("origin", self.origin)?.unwrap_or(Pose::new(0.0, 0.0, 0.0)),
        };
        plan.check_objects(plan.start).map_err(|PlacementRefusal { path, fault }| (path, fault.into()))?;
        Ok(plan)
    }

    fn occupancy(&self) -> Result<Grid<Occupancy>, (String, Flaw)> {
        for (key, found) in [("width", self.width), ("height", self.height)] {
            if found > MAX_SIDE {
                return Err((key.to_owned(), Flaw::TooLarge { found }));
            }
        }
        let wrong_size = |key, found, expected| Flaw::WrongSize { key, found, expected };
        if self.rows.len() != self.height {
            return Err(("rows".to_owned(), wrong_size("height", self.rows.len(), self.height)));
        }
        let mut cells = Vec::with_capacity(self.width * self.height);
        for (index, row) in self.rows.iter().enumerate().rev() {
            let path = || format!("rows[{index}]");
            let count = row.chars().count();
            if count != self.width {
                return Err((path(), wrong_size("width", count, self.width)));
            }
            for found in row.chars() {
                // The start has a key of its own.
                let cell = cell_of(found).filter(|_| found != 'S');
                cells.push(cell.ok_or_else(|| (path(), Flaw::Cell { found: found.escape_debug().to_string() }))?);
            }
        }
        let has_floor = cells.contains(&Occupancy::Free);
        let grid = Grid::from_rows(self.width, cells).filter(|_| has_floor);
        grid.ok_or_else(|| ("rows".to_owned(), Flaw::NoFreeCell))
    }
}

fn in_range(path: &str, value: f64, [low, high]: [f64; 2], unit: &'static str) -> Result<(), (String, Flaw)> {
    let is_in = (low..=high).contains(&value);
    if is_in { Ok(()) } else { Err((path.to_owned(), PlacementFault::Range { value, low, high, unit }.into())) }
}

fn checked_pose(path: &str, pose: Option<ScenarioPose>) -> Result<Option<Pose>, (String, Flaw)> {
    if let Some(pose) = pose {
        in_range(&format!("{path}.heading_deg"), pose.heading_deg, [-360.0, 360.0], "degrees")?;
    }
    Ok(pose.map(Into::into))
}

/// The message for invalid JSON, with its place.
fn explain(name: &str, path: String, error: &serde_json::Error) -> MapError {
    if error.is_eof() {
        return MapError::Truncated { name: name.to_owned(), part: "JSON" };
    }
    // The library's message ends with the place, which ours already names.
    let cause = error.to_string();
    let cause = cause.split(" at line ").next().unwrap_or_default();
    let cause = [("usize", "a whole number"), ("u64", "a whole number"), ("f64", "a number")]
        .into_iter()
        .fold(cause.to_owned(), |cause, (rust, plain)| {
            cause.replace(&format!("expected {rust}"), &format!("expected {plain}"))
        });
    let path = if path == "." { String::new() } else { path };
    MapError::BadJson {
        name: name.to_owned(),
        place: JsonPlace { path, at: Some((error.line(), error.column())) },
        cause,
    }
}

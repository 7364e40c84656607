//! The file of a study.

use super::{Study, StudyConditions, StudyRoom, is_robot};
use crate::{
    experiment::{BEHAVIOUR, Entrant, PLANNER, Settings},
    montecarlo::SAMPLES,
};
use robovac_core::{
    floor_plan::{
        JsonPlace,
        generate::{FlatId, FlatSpec},
        room,
    },
    robot::OdometryModel,
};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::{collections::BTreeMap, fmt::Display};

/// Value of the key `format`.
pub const STUDY_FORMAT: &str = "robovac-study";
/// Value of the key `version`.
pub const STUDY_VERSION: u64 = 1;
/// Most runs of a study.
pub const MOST_RUNS: u64 = 100_000_000;
/// Shortest and longest run, min.
const MINUTES: [f64; 2] = [0.1, 6000.0];

/// A study as its file has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StudySpec {
    /// Where editors find the schema; ignored when reading.
    #[serde(rename = "$schema", default, skip_serializing)]
    schema: String,
    format: String,
    version: u64,
    /// What it is about; for people.
    #[serde(default)]
    pub name: String,
    /// The rooms.
    pub rooms: Vec<RoomSpec>,
    /// The robots.
    pub robots: Vec<RobotSpec>,
    /// The algorithms.
    pub algorithms: Vec<AlgorithmEntry>,
    /// Slip, noise and battery; none of them if there is no entry.
    #[serde(default)]
    pub conditions: Vec<ConditionsEntry>,
    /// The seeds of the runs.
    pub seeds: SeedRange,
    /// Simulated time of each run, min.
    pub minutes: f64,
    /// Seed of the planners, which plan once in each room.
    #[serde(default = "one")]
    pub plan_seed: u64,
    /// Number of intervals of the coverage curve in the results; 0 for no curve.
    #[serde(default = "usual_curve")]
    pub curve: usize,
}

/// Seeds `first`, `first` + 1 and so on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SeedRange {
    /// The first seed.
    pub first: u64,
    /// Number of seeds.
    pub count: u64,
}

/// Rooms of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", expecting = "an object of one key: room, file or flats")]
pub enum RoomSpec {
    /// One that is built in, by its id.
    Room(String),
    /// A map file, relative to the study.
    File(String),
    /// Generated flats.
    Flats(FlatsEntry),
}

/// Generated flats: their seeds, and what they are like.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FlatsEntry {
    /// The first seed.
    pub first: u64,
    /// Number of seeds.
    pub count: u64,
    /// Least and greatest area, m².
    #[serde(default = "usual_area")]
    pub area_m2: [f64; 2],
    /// How much furniture there is, 0 to 1.
    #[serde(default = "usual_furniture")]
    pub furniture: f64,
    /// Whether there are rugs.
    #[serde(default = "yes")]
    pub rugs: bool,
}

/// A robot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RobotSpec {
    /// Its id.
    pub robot: String,
    /// Side of the planning cells, m; the robot's own if it isn't given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_size_m: Option<f64>,
}

/// An algorithm: either a planner or a behaviour, by its id.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AlgorithmEntry {
    /// Id of a planner.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub planner: Option<String>,
    /// Id of a behaviour.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub behaviour: Option<String>,
    /// Parameters that differ from their defaults.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub params: BTreeMap<String, Value>,
}

/// Conditions of runs; what isn't given is perfect.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ConditionsEntry {
    /// Name in the results.
    #[serde(default)]
    pub name: String,
    /// Level of wheel slip.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slip: Option<String>,
    /// Level of noise of all sensors, or an object of levels of each kind.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noise: Option<Value>,
    /// Whether wheel speeds are limited to the steps of the robot's interface.
    #[serde(default)]
    pub quantised: bool,
    /// Charge at the start, percent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start_charge_percent: Option<u64>,
    /// How followers of paths compute their poses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub odometry: Option<String>,
}

/// What is wrong with a study, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {place}: {cause}")]
pub struct StudyError {
    /// Name of the file.
    pub file: String,
    /// The place in it.
    pub place: JsonPlace,
    /// What is wrong there, and what to do.
    pub cause: String,
}

fn one() -> u64 {
    1
}

fn yes() -> bool {
    true
}

fn usual_curve() -> usize {
    20
}

fn usual_area() -> [f64; 2] {
    FlatSpec::default().area_m2
}

fn usual_furniture() -> f64 {
    FlatSpec::default().furniture
}

/// A path in the file, and what is wrong there.
type SpecFault = (String, String);

fn at(path: impl Into<String>) -> impl FnOnce(&dyn Display) -> SpecFault {
    let path = path.into();
    move |error| (path, error.to_string())
}

impl StudySpec {
    /// Reads and checks a study.
    pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Study, StudyError> {
        let mut json = serde_json::Deserializer::from_slice(bytes);
        let spec: Self = serde_path_to_error::deserialize(&mut json).map_err(|error| {
            let inner = error.inner();
            let path = error.path().to_string();
            let path = if path == "." { String::new() } else { path };
            // The library's message ends with the place, which ours already names.
            let cause = inner.to_string().split(" at line ").next().unwrap_or_default().to_owned();
            StudyError {
                file: file.to_owned(),
                place: JsonPlace { path, at: Some((inner.line(), inner.column())) },
                cause,
            }
        })?;
        spec.checked().map_err(|(path, cause)| StudyError {
            file: file.to_owned(),
            place: JsonPlace::of(&path, bytes),
            cause,
        })
    }

    fn checked(self) -> Result<Study, SpecFault> {
        let fail = |path: &str, cause: &str| Err((path.to_owned(), cause.to_owned()));
        if self.format != STUDY_FORMAT {
            return fail("format", &format!("this is not a study; its format must be \"{STUDY_FORMAT}\""));
        }
        if self.version != STUDY_VERSION {
            return fail("version", &format!("this program reads version {STUDY_VERSION}; update it or the file"));
        }
        let lists = [("rooms", self.rooms.len()), ("robots", self.robots.len()), ("algorithms", self.algorithms.len())];
        if let Some((path, _)) = lists.into_iter().find(|(_, length)| *length == 0) {
            return fail(path, "there is none; add one");
        }
        if self.seeds.count == 0 {
            return fail("seeds.count", "there is no run; give a number from 1 on");
        }
        if !(MINUTES[0]..=MINUTES[1]).contains(&self.minutes) {
            return fail("minutes", "give a number from 0.1 to 6000");
        }
        if self.curve != 0 && !SAMPLES.is_multiple_of(self.curve) {
            return fail("curve", &format!("give 0 or a number that divides {SAMPLES}, e.g. 20"));
        }
        let mut rooms = Vec::new();
        for (index, entry) in self.rooms.iter().enumerate() {
            entry.check(&format!("rooms[{index}]"), &mut rooms)?;
        }
        for (index, entry) in self.robots.iter().enumerate() {
            let path = format!("robots[{index}]");
            if !is_robot(&entry.robot) {
                let cause = format!("there is no robot \"{}\"; \"robovac robots\" lists them", entry.robot);
                return Err((format!("{path}.robot"), cause));
            }
            if let Some(size) = entry.cell_size_m {
                Settings::new().set_cell_size(size).map_err(|e| at(format!("{path}.cell_size_m"))(&e))?;
            }
        }
        let entrants = self.algorithms.iter().enumerate();
        let entrants =
            entrants.map(|(i, entry)| entry.entrant(&format!("algorithms[{i}]"))).collect::<Result<_, _>>()?;
        let perfect = [ConditionsEntry::default()];
        let conditions = if self.conditions.is_empty() { &perfect[..] } else { self.conditions.as_slice() };
        let conditions = conditions.iter().enumerate();
        let conditions =
            conditions.map(|(i, entry)| entry.check(&format!("conditions[{i}]"))).collect::<Result<_, _>>()?;
        let study = Study { robots: self.robots.clone(), rooms, entrants, conditions, spec: self };
        if study.runs() > MOST_RUNS {
            return fail(
                "",
                &format!("these are {} runs, but at most {MOST_RUNS} are allowed; split it", study.runs()),
            );
        }
        Ok(study)
    }
}

impl RoomSpec {
    fn check(&self, path: &str, rooms: &mut Vec<StudyRoom>) -> Result<(), SpecFault> {
        match self {
            Self::Room(id) => {
                if room(id).is_none() {
                    let cause = format!("there is no room \"{id}\"; \"robovac rooms\" lists them");
                    return Err((format!("{path}.room"), cause));
                }
                rooms.push(StudyRoom::BuiltIn(id.clone()));
            }
            Self::File(name) => rooms.push(StudyRoom::File(name.clone())),
            Self::Flats(flats) => {
                let FlatsEntry { first, count, area_m2, furniture, rugs } = *flats;
                let spec = FlatSpec { area_m2, furniture, rugs };
                spec.check().map_err(|e| at(format!("{path}.flats"))(&e))?;
                if !(1..=MOST_RUNS).contains(&count) {
                    let cause = format!("give a number from 1 to {MOST_RUNS}");
                    return Err((format!("{path}.flats.count"), cause));
                }
                let seeds = (0..count).map(|number| first.saturating_add(number));
                rooms.extend(seeds.map(|seed| StudyRoom::Flat(FlatId { seed, spec })));
            }
        }
        Ok(())
    }
}

impl AlgorithmEntry {
    fn entrant(&self, path: &str) -> Result<Entrant, SpecFault> {
        let (kind, id) = match (&self.planner, &self.behaviour) {
            (Some(id), None) => (PLANNER, id),
            (None, Some(id)) => (BEHAVIOUR, id),
            _ => return Err((path.to_owned(), "give either a planner or a behaviour, by its id".to_owned())),
        };
        let mut entrant = Entrant::parse(kind, id).map_err(|e| at(format!("{path}.{kind}"))(&e))?;
        if entrant.algorithm.behaviour().is_some_and(|info| info.claims.manual) {
            return Err((format!("{path}.{kind}"), format!("\"{id}\" is driven by hand; choose another one")));
        }
        for (key, value) in &self.params {
            let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
            entrant.set(key, &text).map_err(|e| at(format!("{path}.params.{key}"))(&e))?;
        }
        Ok(entrant)
    }
}

impl ConditionsEntry {
    fn check(&self, path: &str) -> Result<StudyConditions, SpecFault> {
        let mut settings = Settings::new();
        settings.odometry = OdometryModel::Arc;
        if let Some(slip) = &self.slip {
            settings.set_slip(slip).map_err(|e| at(format!("{path}.slip"))(&e))?;
        }
        match &self.noise {
            None => {}
            Some(Value::String(level)) => {
                settings.set_noise(None, level).map_err(|e| at(format!("{path}.noise"))(&e))?;
            }
            Some(Value::Object(levels)) => {
                for (sensor, level) in levels {
                    let level = level.as_str().unwrap_or_default();
                    let place = format!("{path}.noise.{sensor}");
                    settings.set_noise(Some(sensor), level).map_err(|e| at(place)(&e))?;
                }
            }
            Some(_) => {
                let cause = "give a level, or an object of levels as in {\"cliff\": \"harsh\"}";
                return Err((format!("{path}.noise"), cause.to_owned()));
            }
        }
        if let Some(percent) = self.start_charge_percent {
            let place = format!("{path}.start_charge_percent");
            settings.set_start_charge(Some(percent), &percent.to_string()).map_err(|e| at(place)(&e))?;
        }
        if let Some(model) = &self.odometry {
            settings.set_odometry(model).map_err(|e| at(format!("{path}.odometry"))(&e))?;
        }
        settings.conditions.quantised = self.quantised;
        Ok(StudyConditions { name: self.name.clone(), conditions: settings.conditions, odometry: settings.odometry })
    }
}

//! Studies: every algorithm with every robot in every room under all conditions, over many seeds.
//!
//! A [`Study`] is read from one JSON file, whose schema is `docs/study.schema.json`, and numbers its runs. A run depends
//! on nothing but the study and its number, so any machine can make any of them, in any order. This module makes runs;
//! `robovac study` stores them.

mod identity;
mod row;
mod spec;

pub use identity::fingerprint;
pub use row::{StudyOutcome, StudyRow};
pub use spec::{
    AlgorithmEntry, ConditionsEntry, FlatsEntry, MOST_RUNS, RobotSpec, RoomSpec, STUDY_FORMAT, STUDY_VERSION,
    SeedRange, StudyError, StudySpec,
};

use crate::{
    Conditions,
    experiment::{
        BEHAVIOUR, Entrant, PLANNER, RoomSetup, Settings,
        planning::{CELL_ROBOT, choose_robot},
    },
    montecarlo::{Lab, Terms},
};
use robovac_core::{
    floor_plan::{FloorPlan, generate::FlatId, room},
    robot::OdometryModel,
};
use std::fmt;

/// A study whose every name and value was checked.
#[derive(Debug, Clone)]
pub struct Study {
    /// What was read.
    pub spec: StudySpec,
    rooms: Vec<StudyRoom>,
    robots: Vec<RobotSpec>,
    entrants: Vec<Entrant>,
    conditions: Vec<StudyConditions>,
}

/// A room of a study.
#[derive(Debug, Clone, PartialEq)]
pub enum StudyRoom {
    /// One that is built in, by its id.
    BuiltIn(String),
    /// A map file, named relative to the study.
    File(String),
    /// A generated flat.
    Flat(FlatId),
}

/// Conditions with their name.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyConditions {
    /// Name in the results.
    pub name: String,
    /// Slip, noise and battery.
    pub conditions: Conditions,
    /// How followers of planned paths compute their poses.
    pub odometry: OdometryModel,
}

/// What one run is made of.
#[derive(Debug, Clone, Copy)]
pub struct StudyRun<'a> {
    /// Its number, from 0.
    pub number: u64,
    /// Number of its lab: runs with the same room and robot share one.
    pub lab: u64,
    /// The room.
    pub room: &'a StudyRoom,
    /// The robot.
    pub robot: &'a RobotSpec,
    /// The algorithm with its parameters.
    pub entrant: &'a Entrant,
    /// The conditions.
    pub conditions: &'a StudyConditions,
    /// The run's seed.
    pub seed: u64,
}

/// As its command-line option has it.
impl fmt::Display for StudyRoom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BuiltIn(id) => f.write_str(id),
            Self::File(name) => f.write_str(name),
            Self::Flat(id) => write!(f, "flat:{id}"),
        }
    }
}

impl Study {
    /// Reads and checks a study; `name` is that of its file in errors.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, StudyError> {
        StudySpec::read(name, bytes)
    }

    /// Number of runs.
    pub fn runs(&self) -> u64 {
        let Self { spec, rooms, robots, entrants, conditions } = self;
        let lengths = [rooms.len(), robots.len(), entrants.len(), conditions.len()];
        lengths.into_iter().fold(spec.seeds.count, |runs, length| runs.saturating_mul(length as u64))
    }

    /// The rooms in order.
    pub fn rooms(&self) -> &[StudyRoom] {
        &self.rooms
    }

    /// The run with that number; `None` if there are fewer. Rooms change slowest, then robots, algorithms, conditions and
    /// seeds.
    pub fn run(&self, number: u64) -> Option<StudyRun<'_>> {
        let mut rest = number;
        let mut digit = |length: u64| {
            let digit = rest % length.max(1);
            rest /= length.max(1);
            digit
        };
        let seed = self.spec.seeds.first.saturating_add(digit(self.spec.seeds.count));
        let conditions = self.conditions.get(digit(self.conditions.len() as u64) as usize)?;
        let entrant = self.entrants.get(digit(self.entrants.len() as u64) as usize)?;
        let lab = rest;
        let mut digit = |length: usize| {
            let digit = rest % (length as u64).max(1);
            rest /= (length as u64).max(1);
            digit as usize
        };
        let robot = self.robots.get(digit(self.robots.len()))?;
        let room = self.rooms.get(usize::try_from(rest).ok()?)?;
        Some(StudyRun { number, lab, room, robot, entrant, conditions, seed })
    }

    /// The lab for a run, and for all others with the same number of a lab; `load` reads map files. Errors are for users.
    pub fn lab(&self, run: &StudyRun<'_>, load: &dyn Fn(&str) -> Result<FloorPlan, String>) -> Result<Lab, String> {
        let plan = match run.room {
            StudyRoom::BuiltIn(id) => {
                room(id).map(|info| (info.build)()).ok_or_else(|| format!("there is no room {id}"))?
            }
            StudyRoom::File(name) => load(name)?,
            StudyRoom::Flat(flat) => flat.build(),
        };
        let id = run.robot.robot.as_str();
        let (robot, cell) =
            choose_robot(id, &plan, run.robot.cell_size_m).ok_or_else(|| format!("there is no robot {id}"))?;
        let prepared = RoomSetup::new(&plan, &robot, cell, None).map_err(|error| error.to_string())?;
        let StudyConditions { conditions, odometry, .. } = *run.conditions;
        let duration_s = 60.0 * self.spec.minutes;
        Ok(Lab::on(prepared, Terms { conditions, odometry, smooth: false, duration_s, plan_seed: self.spec.plan_seed }))
    }

    /// Makes a run in its lab.
    pub fn make(&self, run: &StudyRun<'_>, lab: &Result<Lab, String>) -> StudyRow {
        let made = lab.as_ref().map_err(Clone::clone).and_then(|lab| {
            lab.plan(run.entrant, None).map_err(|error| error.to_string())?;
            let StudyConditions { conditions, odometry, .. } = *run.conditions;
            let outcome = lab.run_under(run.entrant, conditions, odometry, run.seed);
            let outcome = outcome.ok_or_else(|| "this algorithm can't be run".to_owned())?;
            Ok(StudyOutcome::of(&outcome, lab.prepared(), self.spec.curve))
        });
        match made {
            Ok(outcome) => StudyRow { run: run.number, error: None, outcome: Some(outcome) },
            Err(error) => StudyRow { run: run.number, error: Some(error), outcome: None },
        }
    }

    /// The command that makes the same run by itself.
    pub fn command(&self, run: &StudyRun<'_>) -> String {
        let source = match run.room {
            StudyRoom::BuiltIn(id) => format!("--room {id}"),
            StudyRoom::File(name) => format!("--map '{}'", name.replace('\'', "'\\''")),
            StudyRoom::Flat(id) => format!("--flat {id}"),
        };
        let RobotSpec { robot, cell_size_m } = run.robot;
        let cell = cell_size_m.map_or_else(String::new, |cell| format!(" --cell {cell}"));
        let kind = if run.entrant.algorithm.planner().is_some() { PLANNER } else { BEHAVIOUR };
        let StudyConditions {
            conditions: Conditions { slip, noise, quantised, start_charge_percent, .. },
            odometry,
            ..
        } = run.conditions;
        let quantised = if *quantised { " --quantised" } else { "" };
        let noise = noise.to_string().replace(' ', " --noise ");
        format!(
            "robovac montecarlo {source} --robot {robot}{cell} --{kind} {} --seeds 1 --seed {} --plan-seed {} --minutes {} \
             --slip {} --noise {noise}{quantised} --charge {start_charge_percent} --odometry {} --json",
            run.entrant,
            run.seed,
            self.spec.plan_seed,
            self.spec.minutes,
            slip.id(),
            odometry.id(),
        )
    }
}

/// Whether a robot of that id exists.
fn is_robot(id: &str) -> bool {
    id == CELL_ROBOT || Settings::new().select_robot(id).is_ok()
}

#[cfg(test)]
mod tests;

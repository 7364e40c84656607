//! Executes the runs.

use crate::{
    Conditions, STEP_S,
    experiment::{
        Algorithm, Entrant, TrialError,
        planning::{Driven, PlanRequest, Planned, RoomSetup},
    },
};
use coverage_planners::Observer;
use robovac_core::{
    coverage::{Boundary, BoundaryTracker, FloorError},
    floor_plan::FloorPlan,
    geometry::Pose,
    robot::{OdometryModel, RobotModel},
};
use std::{
    collections::BTreeMap,
    sync::{Arc, OnceLock},
};

use super::RunOutcome;

/// Settings of all runs of a study besides room and robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Terms {
    /// Slip and noise.
    pub conditions: Conditions,
    /// How followers of planned paths compute their poses.
    pub odometry: OdometryModel,
    /// Whether corners of planned paths are rounded.
    pub smooth: bool,
    /// Simulated time of each run, s.
    pub duration_s: f64,
    /// Seed of the planners, which plan once; the runs have seeds of their own.
    pub plan_seed: u64,
}

/// A room laid out for a robot, in which any number of runs are made.
///
/// A planner plans once; its path is then driven with the slip of every seed. The seed of its plan is that of the
/// [`Terms`], so that a run doesn't depend on which others are made.
pub struct Lab {
    prepared: RoomSetup,
    terms: Terms,
    /// Planned lines, by the names of the entrants.
    lines: BTreeMap<String, Result<Driven, TrialError>>,
    /// The boundary for exploring behaviours, once needed.
    boundary: OnceLock<Arc<Boundary>>,
}

impl Lab {
    /// Lays `plan` out for `robot`, with planning cells of `cell_size` metres.
    pub fn new(
        plan: &FloorPlan,
        robot: &RobotModel,
        cell_size: f64,
        start: Option<Pose>,
        terms: Terms,
    ) -> Result<Self, FloorError> {
        Ok(Self::on(RoomSetup::new(plan, robot, cell_size, start)?, terms))
    }

    /// A lab in a room that is laid out already.
    pub fn on(prepared: RoomSetup, terms: Terms) -> Self {
        Self { prepared, terms, lines: BTreeMap::new(), boundary: OnceLock::new() }
    }

    /// Plans for an entrant, if it is a planner and hasn't planned yet. To be called before its runs.
    pub fn plan(&mut self, entrant: &Entrant, observer: Option<Observer<'_>>) -> Result<(), TrialError> {
        let Algorithm::Planner(planner) = entrant.algorithm else { return Ok(()) };
        let name = entrant.to_string();
        if !self.lines.contains_key(&name) {
            let params = entrant.params.clone();
            let job = self.prepared.job.clone();
            let request = PlanRequest { id: 0, planner, params, seed: self.terms.plan_seed, job };
            let planned = request.serve(|| 0.0, observer).map_err(TrialError::from);
            let planned = planned.and_then(|answer| {
                let planned = Planned::new(&self.prepared, &answer)?;
                Ok(if self.terms.smooth { planned.rounded(&self.prepared)? } else { planned })
            });
            self.lines.insert(name.clone(), planned.map(|planned| planned.driven()));
        }
        self.lines[&name].clone().map(|_| ())
    }

    /// Makes a run; `None` for an entrant that has no plan or isn't in the registry.
    pub fn run(&self, entrant: &Entrant, seed: u64) -> Option<RunOutcome> {
        let RoomSetup { floor, robot, .. } = &self.prepared;
        let Self { prepared, terms: Terms { conditions, odometry, duration_s, .. }, .. } = self;
        let run = match entrant.algorithm {
            Algorithm::Behaviour(info) => prepared.run_behaviour(info, &entrant.params, *conditions, seed)?,
            Algorithm::Planner(_) => {
                let line = self.lines.get(&entrant.to_string())?.as_ref().ok()?;
                prepared.run_driven(line, *conditions, *odometry, seed)
            }
        };
        if entrant.explores() {
            let boundary = self.boundary.get_or_init(|| Arc::new(Boundary::new(floor, robot)));
            return Some(RunOutcome::of_exploring(run, robot, seed, *duration_s, BoundaryTracker::new(boundary)));
        }
        Some(RunOutcome::of(run, robot, seed, *duration_s))
    }
}

impl Terms {
    /// Steps of a whole run.
    pub fn steps(&self) -> u64 {
        (self.duration_s / STEP_S).round() as u64
    }
}

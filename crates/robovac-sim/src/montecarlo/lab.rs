//! Executes the runs.

use crate::{
    Conditions, Run, STEP_S,
    experiment::{
        Algorithm, Entrant, TrialError,
        planning::{PathToDrive, PlanAnswer, PlanRequest, Planned, RoomSetup},
    },
    program::{CommandLog, Logged, SharedLog, check_walk},
};
use coverage_planners::{CoveragePath, Observer, smooth::SmoothSetup};
use robovac_core::{
    coverage::{Boundary, BoundaryTracker, FloorError, PlanningCells},
    floor_plan::FloorPlan,
    geometry::Pose,
    grid::Cell,
    robot::{OdometryModel, RobotModel},
};
use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex, OnceLock, PoisonError},
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

/// A line once it is planned, or the reason why there is none.
type PlannedLine = Arc<OnceLock<Result<PathToDrive, TrialError>>>;

/// A room laid out for a robot, in which any number of runs are made.
///
/// A planner plans once; its path is then driven with the slip of every seed. The seed of its plan is that of the
/// [`Terms`], so that a run doesn't depend on which others are made.
pub struct Lab {
    prepared: RoomSetup,
    terms: Terms,
    /// Planned lines, by the names of the entrants; each planner plans once, whichever thread asks first.
    lines: Mutex<BTreeMap<String, PlannedLine>>,
    /// The boundary for exploring behaviours, once needed.
    boundary: OnceLock<Arc<Boundary>>,
}

impl Lab {
    /// Lays `plan` out for `robot`, with those planning cells; a number is their side, m.
    pub fn new(
        plan: &FloorPlan,
        robot: &RobotModel,
        cells: impl Into<PlanningCells>,
        start: Option<Pose>,
        terms: Terms,
    ) -> Result<Self, FloorError> {
        Ok(Self::on(RoomSetup::new(plan, robot, cells, start)?, terms))
    }

    /// A lab in a room that is laid out already.
    pub fn on(prepared: RoomSetup, terms: Terms) -> Self {
        Self { prepared, terms, lines: Mutex::default(), boundary: OnceLock::new() }
    }

    /// The room laid out for the robot.
    pub fn prepared(&self) -> &RoomSetup {
        &self.prepared
    }

    /// The settings besides room and robot.
    pub fn terms(&self) -> Terms {
        self.terms
    }

    /// Plans for an entrant, if it is a planner and hasn't planned yet. To be called before its runs.
    pub fn plan(&self, entrant: &Entrant, observer: Option<Observer<'_>>) -> Result<(), TrialError> {
        let Algorithm::Planner(planner) = entrant.algorithm else { return Ok(()) };
        let plan = || {
            let params = entrant.params.clone();
            let job = self.prepared.job.clone().rounded(self.terms.smooth);
            let request = PlanRequest { id: 0, planner, params, seed: self.terms.plan_seed, job };
            let planned = request.serve(|| 0.0, observer).map_err(TrialError::from);
            let planned = planned.and_then(|answer| {
                let planned = Planned::new(&self.prepared, &answer)?;
                Ok(if self.terms.smooth { planned.rounded(&self.prepared, &request.smooth_setup())? } else { planned })
            });
            planned.map(|planned| planned.driven())
        };
        self.line(entrant).get_or_init(plan).clone().map(|_| ())
    }

    fn line(&self, entrant: &Entrant) -> PlannedLine {
        // A thread that panicked while it held the lock has at most left a line that isn't planned yet.
        let mut lines = self.lines.lock().unwrap_or_else(PoisonError::into_inner);
        Arc::clone(lines.entry(entrant.to_string()).or_default())
    }

    /// Makes a run; `None` for an entrant that has no plan or isn't in the registry.
    pub fn run(&self, entrant: &Entrant, seed: u64) -> Option<RunOutcome> {
        let Terms { conditions, odometry, .. } = self.terms;
        self.run_under(entrant, conditions, odometry, seed)
    }

    /// The same under other conditions than those of the terms.
    pub fn run_under(
        &self,
        entrant: &Entrant,
        conditions: Conditions,
        odometry: OdometryModel,
        seed: u64,
    ) -> Option<RunOutcome> {
        let RoomSetup { floor, robot, .. } = &self.prepared;
        let Self { prepared, terms: Terms { duration_s, .. }, .. } = self;
        let run = match entrant.algorithm {
            Algorithm::Behaviour(info) => prepared.run_behaviour(info, &entrant.params, conditions, seed)?,
            Algorithm::Planner(_) => {
                let line = self.line(entrant);
                prepared.run_driven(line.get()?.as_ref().ok()?, conditions, odometry, seed)
            }
        };
        if entrant.explores() {
            let boundary = self.boundary.get_or_init(|| Arc::new(Boundary::new(floor, robot)));
            return Some(RunOutcome::of_exploring(run, robot, seed, *duration_s, BoundaryTracker::new(boundary)));
        }
        Some(self.outcome(run, seed))
    }

    /// Repeats the run of a user's program that made `log` with that seed. One whose log ends too early ends there.
    pub fn repeat(&self, log: CommandLog, seed: u64) -> RunOutcome {
        let setup = self.prepared.setup(self.terms.conditions, seed);
        let run = Run::new(&setup, Box::new(Logged::new(SharedLog::new(log))));
        self.outcome(run.without_sight(), seed)
    }

    /// Runs along a walk that a user's program has planned. Errors are for users.
    pub fn follow(&self, seeds: &[u64], cells: Vec<Cell>) -> Result<Vec<RunOutcome>, String> {
        let room = &self.prepared;
        check_walk(&room.job, &cells).map_err(|fault| format!("the plan can't be driven: {fault}"))?;
        let answer = PlanAnswer { path: CoveragePath::walk(cells), seconds: 0.0, proof: None, trace: Vec::new() };
        let planned = Planned::new(room, &answer).map_err(|error| error.to_string())?;
        let setup = SmoothSetup::default();
        let planned =
            if self.terms.smooth { planned.rounded(room, &setup).map_err(|e| e.to_string())? } else { planned };
        let Terms { conditions, odometry, .. } = self.terms;
        Ok(seeds.iter().map(|&seed| self.outcome(planned.run(room, conditions, odometry, seed), seed)).collect())
    }

    fn outcome(&self, run: Run, seed: u64) -> RunOutcome {
        RunOutcome::of(run, &self.prepared.robot, seed, self.terms.duration_s)
    }
}

impl Terms {
    /// Steps of a whole run.
    pub fn steps(&self) -> u64 {
        (self.duration_s / STEP_S).round() as u64
    }
}

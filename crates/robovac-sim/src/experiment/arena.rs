//! One planner in one room: the unit of every comparison.

use crate::{
    experiment::planning::{PlanAnswer, PlanRequest, Planned, RoomSetup},
    program::{WalkFault, check_walk},
};
use coverage_planners::{
    Bounds, CoveragePath, Observer, PathError, PlanError, PlannerInfo,
    metrics::PlanNumbers,
    smooth::{SmoothError, SmoothSetup},
};
use robovac_core::{
    coverage::{FloorError, PlanningCells},
    floor_plan::FloorPlan,
    geometry::Pose,
    grid::Cell,
    registry::Params,
    robot::RobotModel,
    trajectory::Trajectory,
};
use std::sync::Arc;

/// A room laid out for a robot, with its lower bounds: the same for all entrants.
pub struct Arena {
    prepared: RoomSetup,
    bounds: Bounds,
    /// Whether corners are rounded.
    is_smooth: bool,
}

/// Result of a planner.
#[derive(Debug, Clone)]
pub struct PlanOutcome {
    /// Its numbers.
    pub numbers: PlanNumbers,
    /// Its path.
    pub path: CoveragePath,
    /// How it is driven smoothly, if it is.
    pub smooth: Option<Arc<Trajectory>>,
}

/// Reasons for a trial without a result.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TrialError {
    /// The robot can't be placed in the room.
    #[error(transparent)]
    Floor(#[from] FloorError),
    /// The planner failed.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The planner returned an invalid walk.
    #[error("the planner returned an invalid walk: {0}")]
    Path(#[from] PathError),
    /// A user's program planned a walk that can't be driven.
    #[error("the plan can't be driven: {0}")]
    Walk(#[from] WalkFault),
    /// The robot can't drive smoothly.
    #[error(transparent)]
    Smooth(#[from] SmoothError),
}

impl Arena {
    /// Lays `plan` out for `robot` with those planning cells; a number is their side, m.
    pub fn new(
        plan: &FloorPlan,
        robot: &RobotModel,
        cells: impl Into<PlanningCells>,
        start: Option<Pose>,
    ) -> Result<Self, FloorError> {
        let prepared = RoomSetup::new(plan, robot, cells, start)?;
        let bounds = Bounds::of(&prepared.job);
        Ok(Self { prepared, bounds, is_smooth: false })
    }

    /// The same with corners rounded, or not.
    pub fn smooth(self, is_smooth: bool) -> Self {
        Self { is_smooth, ..self }
    }

    /// Lower bounds in this room.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Runs a planner. `clock` returns seconds since any moment.
    pub fn run(
        &self,
        planner: &'static PlannerInfo,
        params: &Params,
        seed: u64,
        clock: impl Fn() -> f64,
        observer: Option<Observer<'_>>,
    ) -> Result<PlanOutcome, TrialError> {
        let request = PlanRequest {
            id: 0,
            planner,
            params: params.clone(),
            seed,
            job: self.prepared.job.clone().rounded(self.is_smooth),
        };
        self.outcome(request.serve(clock, observer)?, &request.smooth_setup())
    }

    /// The result of a walk that a user's program planned in `seconds`. That it misses cells is a result, too.
    pub fn judge(&self, cells: Vec<Cell>, seconds: f64) -> Result<PlanOutcome, TrialError> {
        check_walk(&self.prepared.job, &cells)?;
        let answer = PlanAnswer { path: CoveragePath::walk(cells), seconds, proof: None, trace: Vec::new() };
        self.outcome(answer, &SmoothSetup::default())
    }

    fn outcome(&self, answer: PlanAnswer, setup: &SmoothSetup) -> Result<PlanOutcome, TrialError> {
        let planned = Planned::new(&self.prepared, &answer)?;
        let planned = if self.is_smooth { planned.rounded(&self.prepared, setup)? } else { planned };
        let numbers = planned.numbers(&self.prepared, self.bounds);
        Ok(PlanOutcome { numbers, path: answer.path, smooth: planned.smooth })
    }
}

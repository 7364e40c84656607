//! One planner in one room: the unit of every comparison.

use crate::experiment::planning::{PlanRequest, Planned, RoomSetup};
use coverage_planners::{Bounds, CoveragePath, Observer, PathError, PlanError, PlannerInfo, metrics::PlanNumbers};
use robovac_core::{
    coverage::FloorError, floor_plan::FloorPlan, geometry::Pose, registry::Params, robot::RobotModel,
};

/// A room laid out for a robot, with its lower bounds: the same for all entrants.
pub struct Arena {
    prepared: RoomSetup,
    bounds: Bounds,
}

/// Result of a planner.
#[derive(Debug, Clone)]
pub struct PlanOutcome {
    /// Its numbers.
    pub numbers: PlanNumbers,
    /// Its path.
    pub path: CoveragePath,
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
}

impl Arena {
    /// Lays `plan` out for `robot` with planning cells of `cell_size` metres.
    pub fn new(plan: &FloorPlan, robot: &RobotModel, cell_size: f64, start: Option<Pose>) -> Result<Self, FloorError> {
        let prepared = RoomSetup::new(plan, robot, cell_size, start)?;
        let bounds = Bounds::of(&prepared.job);
        Ok(Self { prepared, bounds })
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
        let request = PlanRequest { id: 0, planner, params: params.clone(), seed, job: self.prepared.job.clone() };
        let answer = request.serve(clock, observer)?;
        let numbers = Planned::new(&self.prepared, &answer)?.numbers(&self.prepared, self.bounds);
        Ok(PlanOutcome { numbers, path: answer.path })
    }
}

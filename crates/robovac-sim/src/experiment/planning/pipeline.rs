//! The pipeline: grid for the robot, planner, walk with metrics, driven path.

use crate::{
    Conditions, Run, RunSetup, World,
    controller::{self, BehaviourInfo, Behaviours, FollowPath, Recharge, Setup},
};
use coverage_planners::{
    Bounds, CoverageJob, CoveragePath, Film, MOST_FILMED_CELLS, Observer, PathError, PlanContext, PlanError,
    PlannerInfo, Proof, TraceStep,
    metrics::{DriveMetrics, PlanNumbers, WalkMetrics},
};
use robovac_core::{
    coverage::{FloorError, PlanningGrid, ReachableFloor, fine_resolution},
    floor_plan::FloorPlan,
    geometry::{Point, Pose},
    registry::Params,
    robot::{OdometryModel, RobotModel},
};
use std::sync::Arc;

/// A room laid out for one robot, one start and one cell size.
#[derive(Debug, Clone)]
pub struct RoomSetup {
    /// The reachable floor.
    pub floor: Arc<ReachableFloor>,
    /// The planning grid.
    pub planning_grid: Arc<PlanningGrid>,
    /// The planner's job on it.
    pub job: CoverageJob,
    /// Objects of the room other than walls.
    pub world: Arc<World>,
    /// The robot.
    pub robot: RobotModel,
}

/// A job for a planner, which can run in a worker.
#[derive(Debug, Clone)]
pub struct PlanRequest {
    /// Number of the request; answers carry it, and answers to older requests are dropped.
    pub id: u32,
    /// The planner.
    pub planner: &'static PlannerInfo,
    /// Its parameters.
    pub params: Params,
    /// Seed of its random numbers.
    pub seed: u64,
    /// The job.
    pub job: CoverageJob,
}

/// Result of a planner.
#[derive(Debug, Clone)]
pub struct PlanAnswer {
    /// The walk.
    pub path: CoveragePath,
    /// Planning time, s.
    pub seconds: f64,
    /// The proof of the walk, for planners that have one.
    pub proof: Option<Proof>,
    /// The planner's decisions, if it traces them and the room isn't larger than [`MOST_SEARCH_CELLS`].
    pub trace: Vec<TraceStep>,
}

/// Most free cells for which decisions are recorded: a record of a step is far larger than the step.
pub const MOST_SEARCH_CELLS: usize = 20_000;

/// A plan with its numbers, ready to be driven.
#[derive(Debug, Clone)]
pub struct Planned {
    /// Corners of the line to be driven, m.
    pub line: Arc<[Point]>,
    /// Numbers of the walk on the planning grid.
    pub walk: WalkMetrics,
    /// Numbers of the line driven without noise.
    pub drive: DriveMetrics,
    /// Planning time, s.
    pub planning_s: f64,
    /// Its planner's proof of the walk, in the planner's weights.
    pub proof: Option<Proof>,
    /// Its proof in steps + 2 x quarter turns, the weights of comparisons, once available.
    pub compared: Option<Proof>,
    /// Share of the search after which the user ended it, if so.
    pub kept_at: Option<f64>,
}

impl RoomSetup {
    /// Lays out `plan` for `robot` with planning cells of `cell_size` metres.
    pub fn new(plan: &FloorPlan, robot: &RobotModel, cell_size: f64, start: Option<Pose>) -> Result<Self, FloorError> {
        // Finer cells would contain no fine cell's centre, and for a robot that fills a cell there could be billions.
        let least = fine_resolution(plan);
        if cell_size < least * (1.0 - 1e-9) {
            return Err(FloorError::CellTooSmall { cell_size, least });
        }
        Ok(Self::on(plan, ReachableFloor::new(plan, robot, start)?, robot, cell_size))
    }

    /// Lays planning cells of `cell_size` metres over the floor that `robot` can reach in `plan`.
    pub fn on(plan: &FloorPlan, floor: ReachableFloor, robot: &RobotModel, cell_size: f64) -> Self {
        let planning_grid = PlanningGrid::new(&floor, cell_size);
        let job = CoverageJob::on_planning_grid(&planning_grid, &floor, robot);
        let world = Arc::new(World::new(plan));
        Self { floor: Arc::new(floor), planning_grid: Arc::new(planning_grid), job, world, robot: robot.clone() }
    }
}

impl RoomSetup {
    /// The setup of a run on this floor.
    pub fn setup(&self, conditions: Conditions, seed: u64) -> RunSetup {
        let Self { floor, world, robot, .. } = self;
        RunSetup { floor: Arc::clone(floor), world: Arc::clone(world), robot: robot.clone(), conditions, seed }
    }

    /// A run along `line` (corners, m) by dead reckoning. A robot that can dock goes to its dock when the battery is low,
    /// and goes on where it stopped. Without a dock empty batteries are replaced, as plans are compared by the floor that
    /// they clean, with energy as a separate number.
    pub fn run_along(&self, line: &Arc<[Point]>, conditions: Conditions, odometry: OdometryModel, seed: u64) -> Run {
        let follower = self.follower(&self.robot, line, odometry);
        let follower = if self.world.drop_offs.is_empty() { follower } else { follower.carefully() };
        match Recharge::new(&follower, &self.floor, &self.world.docks, seed) {
            Some(recharge) => Run::new(&self.setup(conditions, seed), Box::new(recharge)),
            None => {
                let conditions = Conditions { spare_batteries: true, ..conditions };
                Run::new(&self.setup(conditions, seed), Box::new(follower))
            }
        }
    }

    /// The follower of `line` (corners, m) from the start, for `robot`, which is this one or its calibrated model.
    pub fn follower(&self, robot: &RobotModel, line: &Arc<[Point]>, odometry: OdometryModel) -> FollowPath {
        FollowPath::new(robot, odometry, self.floor.start, Arc::clone(line))
    }

    /// A run of `behaviour`; `None` for one that isn't in the registry.
    pub fn run_behaviour(
        &self,
        behaviour: &BehaviourInfo,
        params: &Params,
        conditions: Conditions,
        seed: u64,
    ) -> Option<Run> {
        self.run_one_of(controller::ALL, behaviour, params, conditions, seed)
    }

    /// The same, restricted to `behaviours`.
    pub fn run_one_of(
        &self,
        behaviours: Behaviours,
        behaviour: &BehaviourInfo,
        params: &Params,
        conditions: Conditions,
        seed: u64,
    ) -> Option<Run> {
        let controller = behaviours.build(behaviour.id, &Setup { robot: &self.robot, params, seed })?;
        Some(Run::new(&self.setup(conditions, seed), controller))
    }
}

impl PlanRequest {
    /// A film of the search, which takes the planner's reports; `None` for planners that don't improve a walk, and for
    /// rooms of more than [`MOST_FILMED_CELLS`].
    pub fn film(&self) -> Option<Film> {
        let is_filmed = self.planner.is_anytime() && self.job.cells() <= MOST_FILMED_CELLS;
        is_filmed.then(|| Film::of(self.planner, &self.params, &self.job))
    }

    /// Plans synchronously. `clock` returns seconds since any moment, as the core has no clock of its own.
    pub fn serve(&self, clock: impl Fn() -> f64, observer: Option<Observer<'_>>) -> Result<PlanAnswer, PlanError> {
        let planner = self.planner.build(&self.params);
        let mut ctx = match observer {
            Some(observer) => PlanContext::observed(self.seed, observer),
            None => PlanContext::new(self.seed),
        };
        let mut trace = Vec::new();
        let mut tell = |step| trace.push(step);
        if self.planner.claims.traces && self.job.cells() <= MOST_SEARCH_CELLS {
            ctx = ctx.traced(&mut tell);
        }
        let began = clock();
        let path = planner.plan(&self.job, &mut ctx)?;
        let proof = ctx.proof;
        Ok(PlanAnswer { path, seconds: (clock() - began).max(0.0), proof, trace })
    }
}

impl Planned {
    /// Checks a walk and computes its line and metrics.
    pub fn new(prepared: &RoomSetup, answer: &PlanAnswer) -> Result<Self, PathError> {
        let PlanAnswer { path, seconds, proof, .. } = answer;
        path.check(&prepared.job)?;
        let line: Arc<[Point]> = prepared.planning_grid.polyline(&prepared.floor, &path.cells).into();
        Ok(Self {
            walk: WalkMetrics::of(&prepared.job, path),
            drive: DriveMetrics::of(&prepared.floor, &prepared.robot, &line),
            line,
            planning_s: *seconds,
            proof: *proof,
            compared: None,
            kept_at: None,
        })
    }

    /// All metrics for a table, with the bounds of the job if they have been computed.
    pub fn numbers(&self, bounds: Option<Bounds>) -> PlanNumbers {
        let Self { walk, drive, planning_s, .. } = *self;
        PlanNumbers { walk, drive, planning_s, bounds }
    }

    /// A run along the line by dead reckoning.
    pub fn run(&self, prepared: &RoomSetup, conditions: Conditions, odometry: OdometryModel, seed: u64) -> Run {
        prepared.run_along(&self.line, conditions, odometry, seed)
    }
}

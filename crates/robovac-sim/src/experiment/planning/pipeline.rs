//! The pipeline: grid for the robot, planner, walk with metrics, driven path.

use crate::{
    Conditions, Run, RunSetup, World,
    controller::{self, BehaviourInfo, Behaviours, FollowPath, FollowSmoothly, Follower, Recharge, Setup, safe_speed},
};
use coverage_planners::{
    Bounds, CoverageJob, CoveragePath, Film, FilmFrame, Observer, PathError, PlanContext, PlanError, PlannerInfo,
    Proof, ShownSearch, TraceStep,
    metrics::{DriveMetrics, MetricExcess, PlanNumbers, SweepBound, WalkMetrics},
    smooth::{SmoothError, SmoothPath, SmoothSetup, limits_of, smooth},
};
use robovac_core::{
    coverage::{FloorError, PlanningCells, PlanningGrid, ReachableFloor, fine_resolution},
    floor_plan::FloorPlan,
    geometry::{MetricPath, Point, Pose},
    registry::Params,
    robot::{OdometryModel, RobotModel, WheelLayout},
    trajectory::Trajectory,
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
    /// Width and height of the floor within its walls, m.
    pub size: [f64; 2],
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
    /// The walk, or the path in metres.
    pub path: CoveragePath,
    /// Planning time, s.
    pub seconds: f64,
    /// The proof of the walk, for planners that have one.
    pub proof: Option<Proof>,
    /// The planner's decisions, if it traces them and the room isn't larger than [`MOST_SEARCH_CELLS`].
    pub trace: Vec<TraceStep>,
}

/// Share of the floor whose bounds stand beside plans: walks over all cells sweep about as much.
pub const WHOLE: f64 = 0.99;

/// Most free cells for which decisions are recorded: a record of a step is far larger than the step.
pub const MOST_SEARCH_CELLS: usize = 20_000;

/// A plan with its numbers, ready to be driven.
#[derive(Debug, Clone)]
pub struct Planned {
    /// Corners of the line to be driven, m.
    pub line: Arc<[Point]>,
    /// Numbers of the walk on the planning grid; `None` for a path in metres.
    pub walk: Option<WalkMetrics>,
    /// Numbers of the line driven without noise.
    pub drive: DriveMetrics,
    /// How it is driven smoothly; `None` with stops at all corners.
    pub smooth: Option<Arc<Trajectory>>,
    /// Planning time, s.
    pub planning_s: f64,
    /// Its planner's proof of the walk, in the planner's weights.
    pub proof: Option<Proof>,
    /// Its proof in steps + 2 x quarter turns, the weights of comparisons, once available.
    pub compared: Option<Proof>,
    /// Its exact coverage, and what any path needs that sweeps as much, once available.
    pub least: Option<SweepBound>,
    /// Share of the search after which the user ended it, if so.
    pub kept_at: Option<f64>,
}

impl RoomSetup {
    /// Lays out `plan` for `robot` with those planning cells; a number is their side, m.
    pub fn new(
        plan: &FloorPlan,
        robot: &RobotModel,
        cells: impl Into<PlanningCells>,
        start: Option<Pose>,
    ) -> Result<Self, FloorError> {
        let cells = cells.into();
        // Finer cells would contain no fine cell's centre, and for a robot that fills a cell there could be billions.
        let least = fine_resolution(plan);
        if cells.size < least * (1.0 - 1e-9) {
            return Err(FloorError::CellTooSmall { cell_size: cells.size, least });
        }
        Ok(Self::on(plan, ReachableFloor::new(plan, robot, start)?, robot, cells))
    }

    /// Lays those planning cells over the floor that `robot` can reach in `plan`.
    pub fn on(plan: &FloorPlan, floor: ReachableFloor, robot: &RobotModel, cells: impl Into<PlanningCells>) -> Self {
        let planning_grid = PlanningGrid::new(&floor, cells);
        let floor = Arc::new(floor);
        let job = CoverageJob::on_planning_grid(&planning_grid, &floor, robot).in_place(&floor, robot);
        let world = Arc::new(World::new(plan));
        Self {
            floor,
            planning_grid: Arc::new(planning_grid),
            job,
            world,
            robot: robot.clone(),
            size: plan.floor_size(),
        }
    }

    /// Lays out `plan` for `robot` that drives `path` and stands at its start, with `heading` rad if it turns to where it
    /// drives. Otherwise it keeps heading 0, for which such paths are planned.
    pub fn along(
        plan: &FloorPlan,
        robot: &RobotModel,
        cells: impl Into<PlanningCells>,
        path: &MetricPath,
        heading: f64,
    ) -> Result<Self, FloorError> {
        let turns = robot.wheels == WheelLayout::Differential;
        let (start, heading) = (path.start(), if turns { heading } else { 0.0 });
        let floor = ReachableFloor::of_path(plan, robot, Pose::new(start.x, start.y, heading))?;
        let cells = cells.into();
        let cells = PlanningCells { size: cells.size.max(fine_resolution(plan)), ..cells };
        Ok(Self::on(plan, floor, robot, cells))
    }
}

impl RoomSetup {
    /// The line that a robot drives to follow `path`, corners in m, after checking the path.
    pub fn line(&self, path: &CoveragePath) -> Result<Arc<[Point]>, PathError> {
        path.check(&self.job)?;
        let line =
            if path.is_in_metres() { path.line.clone() } else { self.planning_grid.polyline(&self.floor, &path.cells) };
        Ok(line.into())
    }

    /// The setup of a run on this floor.
    pub fn setup(&self, conditions: Conditions, seed: u64) -> RunSetup {
        let Self { floor, world, robot, .. } = self;
        RunSetup { floor: Arc::clone(floor), world: Arc::clone(world), robot: robot.clone(), conditions, seed }
    }

    /// A run along `line` (corners, m), with a stop at each; see [`RoomSetup::run_driven`].
    pub fn run_along(&self, line: &Arc<[Point]>, conditions: Conditions, odometry: OdometryModel, seed: u64) -> Run {
        self.run_driven(&PathToDrive { line: Arc::clone(line), smooth: None }, conditions, odometry, seed)
    }

    /// A run by dead reckoning. A robot that can dock goes to its dock when the battery is low, and goes on where it stopped.
    /// Without a dock empty batteries are replaced, as plans are compared by the floor that they clean, with energy as a
    /// separate number.
    pub fn run_driven(&self, driven: &PathToDrive, conditions: Conditions, odometry: OdometryModel, seed: u64) -> Run {
        let follower = driven.follower(&self.robot, self.follower_in_room(&driven.line, odometry));
        if let Some(recharge) = Recharge::new(&follower, &self.floor, &self.world.docks, seed) {
            return Run::new(&self.setup(conditions, seed), Box::new(recharge));
        }
        let conditions = Conditions { spare_batteries: true, ..conditions };
        Run::new(&self.setup(conditions, seed), Box::new(follower))
    }

    /// The follower of `line`, with what it has to know of the room.
    fn follower_in_room(&self, line: &Arc<[Point]>, odometry: OdometryModel) -> FollowPath {
        let follower = self.follower(&self.robot, line, odometry);
        // A robot that doesn't turn to where it drives keeps its path's distance from edges at every heading.
        let is_careful = !self.is_flat() && (self.floor.turns || !self.floor.is_for_path);
        let follower = if is_careful { follower.carefully() } else { follower };
        if self.floor.is_for_path { follower.knowing(&self.floor) } else { follower }
    }

    fn is_flat(&self) -> bool {
        self.world.drop_offs.is_empty()
    }

    /// `line` (corners, m) with its corners rounded, as fast as the robot's wheels allow, or as it can stop before stairs if there
    /// are any or `is_careful`.
    pub fn smooth(&self, line: &[Point], setup: &SmoothSetup, is_careful: bool) -> Result<SmoothPath, SmoothError> {
        let limits = limits_of(&self.robot)?;
        let is_slow = is_careful || !self.is_flat();
        let limits = if is_slow { limits.no_faster_than(safe_speed(&self.robot)) } else { limits };
        Ok(smooth(&self.floor, line, &limits, setup))
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

/// A line, and how it is driven.
#[derive(Debug, Clone, Default)]
pub struct PathToDrive {
    /// Corners, m.
    pub line: Arc<[Point]>,
    /// Its trajectory with rounded corners; `None` with stops at all corners.
    pub smooth: Option<Arc<Trajectory>>,
}

impl PathToDrive {
    /// What drives it: `path`, which follows the line, or its trajectory if there is one and `robot` can.
    pub fn follower(&self, robot: &RobotModel, path: FollowPath) -> Follower {
        let smooth = self.smooth.as_ref();
        let smooth = smooth.and_then(|trajectory| FollowSmoothly::new(robot, path.clone(), Arc::clone(trajectory)));
        smooth.map_or(Follower::Stopping(path), Follower::Smooth)
    }
}

impl PlanRequest {
    /// What rounding the corners of its plan may do.
    pub fn smooth_setup(&self) -> SmoothSetup {
        let asked = self.planner.asked_coverage(&self.params);
        SmoothSetup { least: asked.unwrap_or(1.0), ..SmoothSetup::default() }
    }

    /// A film of the search, which takes the planner's reports; `None` for planners that aren't filmed, and in rooms of more than
    /// [`PlannerInfo::most_filmed_cells`].
    pub fn film(&self) -> Option<Film> {
        self.is_filmed().then(|| Film::of(self.planner, &self.params, &self.job))
    }

    /// The same film once it has recorded `frames`; at its beginning without any.
    pub fn film_with(&self, frames: Vec<FilmFrame>) -> Option<Film> {
        if frames.is_empty() {
            return self.film();
        }
        self.is_filmed().then(|| Film::with(self.planner, &self.job, frames))
    }

    fn is_filmed(&self) -> bool {
        self.planner.shown_search() == ShownSearch::Film && self.job.cells() <= self.planner.most_filmed_cells()
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
        if self.planner.shown_search() == ShownSearch::Decisions && self.job.cells() <= MOST_SEARCH_CELLS {
            ctx = ctx.traced(&mut tell);
        }
        let began = clock();
        let path = planner.plan(&self.job, &mut ctx)?;
        let proof = ctx.proof;
        Ok(PlanAnswer { path, seconds: (clock() - began).max(0.0), proof, trace })
    }
}

impl Planned {
    /// Checks a walk or a path in metres, and computes its line and metrics.
    pub fn new(prepared: &RoomSetup, answer: &PlanAnswer) -> Result<Self, PathError> {
        let PlanAnswer { path, seconds, proof, .. } = answer;
        let line = prepared.line(path)?;
        Ok(Self {
            walk: (!path.is_in_metres()).then(|| WalkMetrics::of(&prepared.job, path)),
            drive: DriveMetrics::of(&prepared.floor, &prepared.robot, &line),
            line,
            smooth: None,
            planning_s: *seconds,
            proof: *proof,
            compared: None,
            least: None,
            kept_at: None,
        })
    }

    /// The plan to drive along `path`, which took `seconds` to find.
    pub fn along(prepared: &RoomSetup, path: &MetricPath, seconds: f64) -> Self {
        Self {
            walk: None,
            drive: DriveMetrics::of(&prepared.floor, &prepared.robot, path.corners()),
            line: Arc::clone(path.corners()),
            smooth: None,
            planning_s: seconds,
            proof: None,
            compared: None,
            least: None,
            kept_at: None,
        }
    }

    /// All metrics for a table, with the bounds of the job.
    pub fn numbers(&self, prepared: &RoomSetup, bounds: Bounds) -> PlanNumbers {
        let Self { walk, ref line, drive, planning_s, .. } = *self;
        let RoomSetup { floor, robot, .. } = prepared;
        let excess = match &self.smooth {
            Some(trajectory) => MetricExcess::of_trajectory(floor, robot, trajectory, &drive),
            None => MetricExcess::of(floor, robot, line, &drive),
        };
        let least = SweepBound::new(&prepared.floor, &prepared.robot, WHOLE);
        PlanNumbers { walk, drive, planning_s, bounds: Some(bounds), excess, least }
    }

    /// The same plan with rounded corners, as far as the robot can; see [`RoomSetup::smooth`].
    pub fn rounded(self, prepared: &RoomSetup, setup: &SmoothSetup) -> Result<Self, SmoothError> {
        let path = prepared.smooth(&self.line, setup, false)?;
        Ok(self.driven_along(prepared, Arc::new(path.trajectory)))
    }

    /// The same plan, driven along a trajectory with rounded corners.
    pub fn driven_along(self, prepared: &RoomSetup, trajectory: Arc<Trajectory>) -> Self {
        let drive = DriveMetrics::of_trajectory(&prepared.floor, &prepared.robot, &trajectory);
        Self { drive, smooth: Some(trajectory), ..self }
    }

    /// The line, and how it is driven.
    pub fn driven(&self) -> PathToDrive {
        PathToDrive { line: Arc::clone(&self.line), smooth: self.smooth.clone() }
    }

    /// A run along the line by dead reckoning.
    pub fn run(&self, prepared: &RoomSetup, conditions: Conditions, odometry: OdometryModel, seed: u64) -> Run {
        prepared.run_driven(&self.driven(), conditions, odometry, seed)
    }
}

//! From a room and a robot to a planner's job, and from its walk back to something that can be driven.

use crate::{
    coverage::{FloorError, Lattice, ReachableFloor},
    floorplan::FloorPlan,
    geometry::{Point, Pose},
    grid::Cell,
    metrics::{DriveMetrics, WalkMetrics},
    planner::{CoverageJob, CoveragePath, Params},
    robot::RobotModel,
};
use std::sync::Arc;

/// A room laid out for one robot, one start and one cell size.
#[derive(Debug, Clone)]
pub struct Prepared {
    /// What the robot can reach.
    pub floor: Arc<ReachableFloor>,
    /// The planning grid.
    pub lattice: Arc<Lattice>,
    /// The planner's job on it.
    pub job: CoverageJob,
    /// The robot.
    pub robot: RobotModel,
}

impl Prepared {
    /// Lays out `plan` for `robot` with planning cells of `cell_size` metres.
    pub fn new(plan: &FloorPlan, robot: &RobotModel, cell_size: f64, start: Option<Pose>) -> Result<Self, FloorError> {
        let floor = ReachableFloor::new(plan, robot, start)?;
        let lattice = Lattice::new(&floor, cell_size);
        let job = CoverageJob::on_lattice(&lattice, &floor, robot);
        Ok(Self { floor: Arc::new(floor), lattice: Arc::new(lattice), job, robot: robot.clone() })
    }
}

/// A job for a planner that runs elsewhere.
#[derive(Debug, Clone)]
pub struct PlanRequest {
    /// Number of the request; answers carry it, and answers to older requests are dropped.
    pub id: u32,
    /// The planner.
    pub planner: &'static str,
    /// Its parameters.
    pub params: Params,
    /// Seed of its random numbers.
    pub seed: u64,
    /// What is to be planned.
    pub job: CoverageJob,
}

/// A plan with its numbers, ready to be driven.
#[derive(Debug, Clone)]
pub struct Planned {
    /// Corners of the line to be driven, m.
    pub line: Arc<[Point]>,
    /// Numbers of the walk on the planning grid.
    pub walk: WalkMetrics,
    /// Numbers of the line driven without noise.
    pub drive: DriveMetrics,
    /// Time that planning took, s.
    pub planning_s: f64,
}

impl Planned {
    /// Works out line and numbers of a walk.
    pub fn new(prepared: &Prepared, cells: Vec<Cell>, planning_s: f64) -> Self {
        let path = CoveragePath { cells };
        Self {
            line: prepared.lattice.polyline(&prepared.floor, &path.cells).into(),
            walk: WalkMetrics::of(&prepared.job, &path),
            drive: DriveMetrics::of(&prepared.floor, &prepared.lattice, &prepared.robot, &path),
            planning_s,
        }
    }
}

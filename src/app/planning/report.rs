//! What the command line writes about a plan.

use super::{PlanningTask, Prepared, Solution};
use crate::{
    grid::Cell,
    metrics::{Bounds, DriveMetrics, PlanNumbers, WalkMetrics},
    planner::Params,
};
use serde::Serialize;

/// What was asked for; the head of every answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TaskReport {
    /// Id of the planner.
    pub planner: &'static str,
    /// All its parameters.
    pub params: Params,
    /// Seed of all random numbers.
    pub seed: u64,
    /// The room in planning cells.
    pub room: RoomReport,
    /// Id of the robot.
    pub robot: &'static str,
    /// The planning cell that the walk starts in.
    pub start: Cell,
    /// Heading at the start, degrees counter-clockwise from the right.
    pub heading_deg: f64,
}

/// The planning grid of a room.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoomReport {
    /// Name of the room.
    pub name: String,
    /// Columns of planning cells.
    pub width: usize,
    /// Rows of planning cells.
    pub height: usize,
    /// Side of a planning cell, m.
    pub resolution_m: f64,
}

/// A walk with its numbers.
#[derive(Debug, Clone, Serialize)]
pub struct PlanReport {
    /// What was asked for.
    #[serde(flatten)]
    pub task: TaskReport,
    /// The walk over planning cells, `[x, y]` with x right and y up from the lower-left one, the start included.
    pub cells: Vec<Cell>,
    /// Numbers of the walk.
    #[serde(flatten)]
    pub walk: WalkMetrics,
    /// Numbers of the line that the robot drives.
    #[serde(flatten)]
    pub drive: DriveMetrics,
    /// Time that the planner took, s.
    pub planning_s: f64,
    /// What no walk can be better than.
    pub bounds: Bounds,
    /// How much more the walk's steps + 2 x quarter turns are than that, %; `None` if the walk misses cells.
    pub above_bound_percent: Option<f64>,
}

impl TaskReport {
    /// What `task` asks for, with the start as it turned out.
    pub fn new(task: &PlanningTask, prepared: &Prepared) -> Self {
        Self {
            planner: task.planner.id,
            params: task.params.clone(),
            seed: task.seed,
            room: RoomReport {
                name: task.plan.name.clone(),
                width: prepared.lattice.free.width(),
                height: prepared.lattice.free.height(),
                resolution_m: task.cell_size,
            },
            robot: task.robot.id,
            start: prepared.job.start,
            heading_deg: prepared.floor.start.heading.to_degrees(),
        }
    }
}

impl PlanReport {
    /// The numbers of `solution`.
    pub fn new(task: &PlanningTask, solution: Solution) -> Self {
        let bounds = Bounds::of(&solution.prepared.job);
        let numbers = solution.planned.numbers(Some(bounds));
        let PlanNumbers { walk, drive, planning_s, .. } = numbers;
        Self {
            task: TaskReport::new(task, &solution.prepared),
            cells: solution.path.cells,
            walk,
            drive,
            planning_s,
            bounds,
            above_bound_percent: numbers.above_bound_percent(),
        }
    }
}

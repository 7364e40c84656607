//! Report of a plan for the command line.

use super::{Placement, PlanSolution, PlanningTask, RoomSetup};
use crate::experiment::Algorithm;
use coverage_planners::{
    Bounds,
    metrics::{DriveMetrics, PlanNumbers, WalkMetrics},
};
use robovac_core::{grid::Cell, registry::Params};
use serde::Serialize;

/// What was asked for; the head of every answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TaskReport {
    /// Id of the planner, if a planner is at work.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planner: Option<&'static str>,
    /// Id of the behaviour, if there is no planner.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub behaviour: Option<&'static str>,
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
    /// What is asked of `algorithm`, with the start as it turned out.
    pub fn new(algorithm: Algorithm, params: &Params, seed: u64, placement: &Placement, prepared: &RoomSetup) -> Self {
        Self {
            planner: algorithm.planner().map(|info| info.id),
            behaviour: algorithm.behaviour().map(|info| info.id),
            params: params.clone(),
            seed,
            room: RoomReport {
                name: placement.plan.name.clone(),
                width: prepared.planning_grid.free.width(),
                height: prepared.planning_grid.free.height(),
                resolution_m: placement.cell_size,
            },
            robot: placement.robot.id,
            start: prepared.job.start,
            heading_deg: prepared.floor.start.heading.to_degrees(),
        }
    }
}

impl PlanReport {
    /// The numbers of `solution`.
    pub fn new(task: &PlanningTask, solution: PlanSolution) -> Self {
        let bounds = Bounds::of(&solution.prepared.job);
        let numbers = solution.planned.numbers(Some(bounds));
        let PlanNumbers { walk, drive, planning_s, .. } = numbers;
        Self {
            task: TaskReport::new(
                Algorithm::Planner(task.planner),
                &task.params,
                task.seed,
                &task.placement,
                &solution.prepared,
            ),
            cells: solution.path.cells,
            walk,
            drive,
            planning_s,
            bounds,
            above_bound_percent: numbers.above_bound_percent(),
        }
    }
}

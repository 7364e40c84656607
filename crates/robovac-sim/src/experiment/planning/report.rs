//! Report of a plan for the command line.

use super::{Placement, PlanSolution, PlanningTask, RoomSetup};
use crate::experiment::Algorithm;
use coverage_planners::{
    Bounds,
    metrics::{DriveMetrics, MetricExcess, PlanNumbers, WalkMetrics},
};
use robovac_core::{grid::Cell, registry::Params};
use serde::Serialize;

/// The task; the header of every report.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TaskReport {
    /// Id of the planner, if it is a planner.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planner: Option<&'static str>,
    /// Id of the behaviour, if it isn't a planner.
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
    /// How far the cells begin to the left of the room's lower-left corner and below it, m; left out at the corner.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub offset_m: Option<[f64; 2]>,
}

/// A walk with its numbers.
#[derive(Debug, Clone, Serialize)]
pub struct PlanReport {
    /// The task.
    #[serde(flatten)]
    pub task: TaskReport,
    /// The walk over planning cells, `[x, y]` with x right and y up from the lower-left one, the start included; empty for a
    /// path in metres.
    pub cells: Vec<Cell>,
    /// Corners of a path in metres, `[x, y]`; left out for a walk.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub corners_m: Vec<[f64; 2]>,
    /// Numbers of the walk; left out for a path in metres.
    #[serde(flatten)]
    pub walk: Option<WalkMetrics>,
    /// Numbers of the line that the robot drives.
    #[serde(flatten)]
    pub drive: DriveMetrics,
    /// Planning time, s.
    pub planning_s: f64,
    /// Lower bounds of any walk.
    pub bounds: Bounds,
    /// Cost of the walk above the bound, steps + 2 x quarter turns, %; `None` if the walk misses cells.
    pub above_bound_percent: Option<f64>,
    /// Swept floor, bounds for it, and how far length and time exceed them; `None` for a robot that fills a cell.
    pub excess: Option<MetricExcess>,
}

impl TaskReport {
    /// The header for `algorithm`, with the actual start.
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
                resolution_m: placement.cells.size,
                offset_m: Some(placement.cells.offset).filter(|offset| *offset != [0.0, 0.0]),
            },
            robot: placement.robot.id,
            start: prepared.job.start,
            heading_deg: prepared.floor.start.heading.to_degrees(),
        }
    }
}

impl PlanReport {
    /// The report of `solution`.
    pub fn new(task: &PlanningTask, solution: PlanSolution) -> Self {
        let bounds = Bounds::of(&solution.prepared.job);
        let numbers = solution.planned.numbers(&solution.prepared, bounds);
        let PlanNumbers { walk, drive, planning_s, .. } = numbers;
        Self {
            task: TaskReport::new(
                Algorithm::Planner(task.planner),
                &task.params,
                task.seed,
                &task.placement,
                &solution.prepared,
            ),
            corners_m: solution.path.line.iter().map(|at| [at.x, at.y]).collect(),
            cells: solution.path.cells,
            walk,
            drive,
            planning_s,
            bounds,
            above_bound_percent: numbers.above_bound_percent(),
            excess: numbers.excess,
        }
    }
}

//! Planning errors.

use coverage_planners::{PathError, PlanError};
use robovac_core::{coverage::FloorError, floor_plan::MAX_RESOLUTION, grid::Cell};

/// Planning errors.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanningError {
    /// No planning cells of that size can be laid over this map.
    #[error("planning cells of {cell_size} m don't suit this map; choose {least} m to {MAX_RESOLUTION} m")]
    CellSize {
        /// The given side, m.
        cell_size: f64,
        /// The smallest allowed side, m.
        least: f64,
    },
    /// The heading isn't a number.
    #[error("the heading can't be {0}; give degrees, counter-clockwise from 0 = right")]
    Heading(f64),
    /// No planning cells can be chosen for a planner in metres.
    #[error(
        "the planner \"{planner}\" needs no planning cells; its own parameter says how much of the floor it sweeps"
    )]
    NeedsNoCells {
        /// Id of the planner.
        planner: &'static str,
    },
    /// No planning cells can be chosen for a robot that fills one.
    #[error("the robot \"cell\" fills its planning cells, so there is no choice; take another robot")]
    FillsItsCells,
    /// The coverage isn't a share.
    #[error("the coverage can't be {} %; give a number from 0 to 100", 100.0 * .0)]
    Coverage(f64),
    /// The start lies outside.
    #[error(
        "the start cell {start} lies outside the planning grid of {width} x {height} cells; \
         choose x from 0 to {}, y from 0 to {} (counted from the lower left)", width - 1, height - 1
    )]
    StartOutside {
        /// The given cell.
        start: Cell,
        /// Columns of planning cells.
        width: usize,
        /// Rows of planning cells.
        height: usize,
    },
    /// The start lies in a wall.
    #[error("the start cell {start} is inside a wall; the nearest cell where the robot fits is {nearest}")]
    StartInWall {
        /// The given cell.
        start: Cell,
        /// The nearest allowed one.
        nearest: Cell,
    },
    /// The robot doesn't fit between the walls around the start.
    #[error(
        "the robot, {diameter:.2} m wide, doesn't fit into the start cell {start}; the nearest cell where it fits is \
         {nearest}"
    )]
    StartTooTight {
        /// The given cell.
        start: Cell,
        /// The nearest allowed one.
        nearest: Cell,
        /// Diameter of the robot, m.
        diameter: f64,
    },
    /// The robot can't be placed in the room.
    #[error(transparent)]
    Floor(#[from] FloorError),
    /// The planner failed.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The planner returned an invalid walk.
    #[error("planner \"{planner}\" returned an invalid walk: {error}; please report this with the map")]
    BadPath {
        /// Id of the planner.
        planner: &'static str,
        /// The violation.
        error: PathError,
    },
}

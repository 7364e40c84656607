//! Input and results of the stages.

use crate::stage::Subgoal;
use robovac_core::{
    cspace::Outline,
    geometry::{Point, Pose},
    grid::Grid,
};

/// A step from one subgoal to the next.
#[derive(Debug, Clone, PartialEq)]
pub struct SubgoalLink {
    /// Index of the subgoal that it leads from.
    pub from: usize,
    /// Index of the subgoal that it leads to.
    pub to: usize,
    /// Whether the straight way goes through an obstacle (Fig. 4).
    pub collides: bool,
    /// The way that is driven, ends included: straight, or the detour (Figs 5 and 6). Empty if no detour was found.
    pub way: Vec<Point>,
}

/// Input of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepSetup {
    /// The robot's outline.
    pub outline: Outline,
    /// Distance between scan lines, m; half the outline's width if `None` (001, section 3).
    pub scan_width: Option<f64>,
    /// Side of the obstacle map's cells, m.
    pub cell: f64,
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
    /// Distance between scan lines, m; lines lie in the rows of cells nearest below, so it holds on average.
    pub scan_width: f64,
    /// Stage 1: subgoal points in the order of the scan (Fig. 3), each at the exact place where the body touches, m.
    pub subgoals: Vec<Subgoal<Point>>,
    /// Stages 2 and 3: links in the order in which they are driven (Figs 4 and 5).
    pub links: Vec<SubgoalLink>,
    /// Links whose straight way collides.
    pub collisions: usize,
    /// Of these, those with a detour.
    pub resolved: usize,
    /// Share of the reachable floor that is swept when all points are linked: the result of the paper's method.
    pub linked_share: f64,
    /// Stage 4, ours: strokes along edges of obstacles that lie between two scan lines, each with the way there; m.
    pub finish: Vec<Vec<Point>>,
    /// Corners of the whole path, m.
    pub path: Vec<Point>,
    /// Length of the path, m.
    pub length: f64,
    /// Share of the reachable floor that the outline sweeps, 0 to 1.
    ///
    /// Reachable is the floor under the outline at heading 0 in any FREE cell that the robot can reach by steps to
    /// neighbouring FREE cells, and on the path; swept is the floor under the outline on the path. Floor is counted in
    /// cells of the obstacle map by their centres, so the share is known to about half a cell along every edge.
    pub coverage: f64,
}

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

/// The least distance that a planned path keeps from everything, m. Files round places to less.
pub const CLEARANCE: f64 = 1e-4;

/// The order in which subgoals are linked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum LinkOrder {
    /// At the end of a line to the nearest point: 001, section 4 without steps 3 to 5.
    #[default]
    Nearest,
    /// Across to the lines beside first: with steps 3 to 5, as they are meant.
    Printed,
    /// Without crossings where the room allows it; runs are cut in two where a channel is passed twice (ours).
    Uncrossed,
}

impl LinkOrder {
    /// All orders.
    pub const ALL: [Self; 3] = [Self::Nearest, Self::Printed, Self::Uncrossed];

    /// Its name in files and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            Self::Nearest => "nearest",
            Self::Printed => "printed",
            Self::Uncrossed => "uncrossed",
        }
    }
}

/// What an order costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrderCost {
    /// Crossings of the links.
    pub crossings: usize,
    /// Length of the whole path, m.
    pub length: f64,
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
    /// The order of the links.
    pub order: LinkOrder,
    /// Whether the robot turns to where it drives, as one with two driven wheels. Then the circle in which it turns is
    /// kept free. Otherwise it keeps heading 0.
    pub turns: bool,
    /// The distance to keep from everything, m; at least [`CLEARANCE`] is kept.
    pub clearance: f64,
}

impl SweepSetup {
    /// A sweep from the first subgoal by a robot that keeps its heading, with lines half its width apart.
    pub fn new(outline: Outline, cell: f64) -> Self {
        Self { outline, scan_width: None, cell, start: None, order: LinkOrder::Nearest, turns: false, clearance: 0.0 }
    }
}

/// The sweep with all its stages.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// What is kept free: the outline at heading 0, or the circle in which it turns.
    pub outline: Outline,
    /// Obstacle map of that: FREE cells.
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
    /// How often the ways of links cross each other: where one passes to the other side of another.
    pub crossings: usize,
    /// The same sweep in the order [`LinkOrder::Nearest`], for comparison with another one.
    pub nearest: Option<OrderCost>,
    /// Share of the reachable floor that is swept when all points are linked: the result of the paper's method.
    pub linked_share: f64,
    /// Stage 4, ours: strokes along edges of obstacles that lie between two scan lines, each with the way there; m.
    pub finish: Vec<Vec<Point>>,
    /// Corners of the whole path, m.
    pub path: Vec<Point>,
    /// Length of the path, m.
    pub length: f64,
    /// Length of the last stage, m, with the ways to its strokes.
    pub finish_length: f64,
    /// Share of the reachable floor that the robot sweeps, 0 to 1.
    ///
    /// Reachable is the floor under [`Sweep::outline`] in any FREE cell that the robot can reach by steps to
    /// neighbouring FREE cells, and on the path; swept is the floor under the robot on the path. Floor is counted in
    /// cells of the obstacle map by their centres, so the share is known to about half a cell along every edge.
    pub coverage: f64,
}

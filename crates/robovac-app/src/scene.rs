//! The scene to draw, independent of the renderer.

use crate::explore::FilmPicture;
use coverage_planners::TraceStep;
use robovac_core::{
    coverage::{CoverageTracker, PlanningCells, ReachableFloor},
    floor_plan::{FloorPlan, Object},
    geometry::{Point, Pose},
    grid::Cell,
    robot::{Body, Castor, RobotModel, SensorReadings, SensorSuite},
};
use robovac_sim::experiment::Shows;
use robovac_sim::{Life, Run};

/// The content of the floor's picture at one moment. Renderers cache costly parts (outlines, pictures of cells) until
/// the corresponding version changes.
#[derive(Debug, Clone, Copy)]
pub struct Scene<'a> {
    /// Walls.
    pub plan: &'a FloorPlan,
    /// Changes whenever `plan` or `floor` does.
    pub plan_version: u64,
    /// The reachable floor; `None` while it isn't known, as with a robot that doesn't fit.
    pub floor: Option<&'a ReachableFloor>,
    /// The swept floor.
    pub tracker: Option<&'a CoverageTracker>,
    /// Changes when the tracker is replaced rather than updated.
    pub run_version: u64,
    /// Lowest and highest row of the tracker that changed since the last scene.
    pub dirty_rows: Option<(usize, usize)>,
    /// The line that the planner found; corners only.
    pub planned: &'a [Point],
    /// The best line so far while planning; drawn instead of `planned`.
    pub preview: &'a [Point],
    /// A picture of the planner's film; drawn instead of `planned`.
    pub film: Option<FilmScene<'a>>,
    /// Changes whenever `planned`, `preview` or `film` does.
    pub planned_version: u64,
    /// The robot's recent positions, oldest first.
    pub trail: &'a [Point],
    /// Moving and consumable objects in the room; `None` without a run.
    pub life: Option<&'a Life>,
    /// Changes whenever `life` or `sensed` can have changed.
    pub steps: u64,
    /// Its estimated trail; empty if it isn't shown.
    pub estimated_trail: &'a [Point],
    /// The robot; `None` before there is a run.
    pub robot: Option<RobotView>,
    /// The planner's current decision, if it is shown.
    pub search: Option<SearchScene<'a>>,
    /// Where the robot starts.
    pub start: Option<Pose>,
    /// Radius of the robot that starts there, m.
    pub start_radius: f64,
    /// Its outline.
    pub start_body: Body,
    /// The map cell under a tool.
    pub cursor: Option<Cell>,
    /// Object of the plan that is selected.
    pub selected: Option<usize>,
    /// Object of the plan that isn't drawn, as it is being dragged.
    pub lifted: Option<usize>,
    /// Objects being dragged.
    pub in_hand: &'a [Object],
    /// Whether colours are for a dark background.
    pub dark: bool,
    /// Which layers are drawn.
    pub shows: Shows,
    /// The robot's sensing, if it is shown.
    pub sensed: Option<SensedFloor<'a>>,
}

/// A sensor reading and the floor under the robot.
#[derive(Debug, Clone, Copy)]
pub struct SensedFloor<'a> {
    /// The reading.
    pub reading: &'a SensorReadings,
    /// The floor that it stands on.
    pub floor: &'a ReachableFloor,
}

/// A decision on the planning grid.
#[derive(Debug, Clone, Copy)]
pub struct SearchScene<'a> {
    /// The decision.
    pub step: &'a TraceStep,
    /// The planning cells.
    pub cells: PlanningCells,
}

/// A picture of a film on the planning grid.
#[derive(Debug, Clone, Copy)]
pub struct FilmScene<'a> {
    /// The picture.
    pub picture: &'a FilmPicture,
    /// The planning cells.
    pub cells: PlanningCells,
}

/// A robot seen from above.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobotView {
    /// Its pose.
    pub pose: Pose,
    /// Its estimated pose, if that is shown.
    pub estimate: Option<Pose>,
    /// Outline of its body.
    pub body: Body,
    /// Radius of the circle around its body, m.
    pub radius: f64,
    /// Distance between its wheels, and their radius, m.
    pub wheels: [f64; 2],
    /// Its castors.
    pub castors: &'static [Castor],
    /// Its sensors.
    pub suite: SensorSuite,
    /// Whether it is held.
    pub is_lifted: bool,
    /// Width of the strip that it cleans, m.
    pub tool_width: f64,
    /// Whether the left half of its bumper is pressed.
    pub bump_left: bool,
    /// Whether the right half of its bumper is pressed.
    pub bump_right: bool,
}

impl<'a> Scene<'a> {
    /// A room without a robot.
    pub fn empty(plan: &'a FloorPlan) -> Self {
        Self {
            plan,
            plan_version: 0,
            floor: None,
            tracker: None,
            run_version: 0,
            dirty_rows: None,
            planned: &[],
            preview: &[],
            film: None,
            planned_version: 0,
            trail: &[],
            life: None,
            steps: 0,
            estimated_trail: &[],
            robot: None,
            start: None,
            search: None,
            start_radius: 0.0,
            start_body: Body::Round,
            shows: Shows::DEFAULT,
            sensed: None,
            cursor: None,
            selected: None,
            lifted: None,
            in_hand: &[],
            dark: false,
        }
    }
}

impl RobotView {
    /// The robot of `run`, which is a `model`, and its estimated pose if that is to be shown.
    pub fn of(run: &Run, model: &RobotModel, with_estimate: bool) -> Self {
        Self {
            pose: run.pose(),
            estimate: run.estimate().filter(|_| with_estimate),
            body: model.body,
            radius: model.radius,
            wheels: [model.wheel_base, model.wheel_radius],
            castors: model.castors,
            suite: model.sensors,
            is_lifted: run.is_lifted(),
            tool_width: 2.0 * run.floor().tool_radius,
            bump_left: run.sensors().bump_left,
            bump_right: run.sensors().bump_right,
        }
    }
}

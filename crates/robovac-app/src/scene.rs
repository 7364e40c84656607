//! The scene to draw, independent of the renderer.

use crate::explore::Picture;
use coverage_planners::TraceStep;
use robovac_core::{
    coverage::{CoverageTracker, ReachableFloor},
    floor_plan::{FloorPlan, Object},
    geometry::{Point, Pose},
    grid::Cell,
    robot::{Body, RobotModel, SensorReadings, SensorSuite},
};
use robovac_sim::experiment::Shows;
use robovac_sim::{Life, Run};

/// Everything that is seen on the floor at one moment. Whoever draws it keeps what is costly (outlines, pictures of
/// cells) until the version beside it changes.
#[derive(Debug, Clone, Copy)]
pub struct Scene<'a> {
    /// Walls.
    pub plan: &'a FloorPlan,
    /// Changes whenever `plan` or `floor` does.
    pub plan_version: u64,
    /// What the robot can reach; `None` while that isn't known, as with a robot that doesn't fit.
    pub floor: Option<&'a ReachableFloor>,
    /// What has been swept.
    pub tracker: Option<&'a CoverageTracker>,
    /// Changes whenever the tracker was replaced rather than swept on.
    pub run_version: u64,
    /// Lowest and highest row of the tracker that changed since the last scene.
    pub dirty_rows: Option<(usize, usize)>,
    /// The line that the planner found; corners only.
    pub planned: &'a [Point],
    /// The best line so far while planning; drawn instead of `planned`.
    pub preview: &'a [Point],
    /// A picture of how the plan came to be; drawn instead of `planned`.
    pub film: Option<FilmScene<'a>>,
    /// Changes whenever `planned`, `preview` or `film` does.
    pub planned_version: u64,
    /// Where the robot has just been, oldest first.
    pub trail: &'a [Point],
    /// What moves and is used up in the room; `None` without a run.
    pub life: Option<&'a Life>,
    /// Changes whenever `life` or `sensed` may have.
    pub steps: u64,
    /// Its estimated trail; empty if that isn't to be shown.
    pub believed: &'a [Point],
    /// The robot; `None` before there is a run.
    pub robot: Option<RobotView>,
    /// The planner's decision at this moment, if it is to be shown.
    pub search: Option<SearchScene<'a>>,
    /// Where the robot starts.
    pub start: Option<Pose>,
    /// Radius of the robot that starts there, m.
    pub start_radius: f64,
    /// Its outline.
    pub start_body: Body,
    /// The map cell at which a tool would act.
    pub cursor: Option<Cell>,
    /// Object of the plan that is selected.
    pub selected: Option<usize>,
    /// Object of the plan that isn't to be drawn, as it is in the hand.
    pub lifted: Option<usize>,
    /// Objects in the hand, where they are held.
    pub in_hand: &'a [Object],
    /// Colours for dark ground.
    pub dark: bool,
    /// Which layers are drawn.
    pub shows: Shows,
    /// What the robot senses, if that is to be shown.
    pub sensed: Option<Sensed<'a>>,
}

/// What a robot senses, and where.
#[derive(Debug, Clone, Copy)]
pub struct Sensed<'a> {
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
    /// Side of a planning cell, m.
    pub cell_size: f64,
}

/// A picture of a film on the planning grid.
#[derive(Debug, Clone, Copy)]
pub struct FilmScene<'a> {
    /// The picture.
    pub picture: &'a Picture,
    /// Side of a planning cell, m.
    pub cell_size: f64,
}

/// A robot as it is seen from above.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobotView {
    /// Where it is.
    pub pose: Pose,
    /// Its estimated pose, if that is to be shown.
    pub estimate: Option<Pose>,
    /// Outline of its body.
    pub body: Body,
    /// Radius of the circle around its body, m.
    pub radius: f64,
    /// Distance between its wheels, and their radius, m.
    pub wheels: [f64; 2],
    /// What it senses with.
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
            believed: &[],
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
            suite: model.sensors,
            is_lifted: run.is_lifted(),
            tool_width: 2.0 * run.floor().tool_radius,
            bump_left: run.sensors().bump_left,
            bump_right: run.sensors().bump_right,
        }
    }
}

//! View model of the page's numbers and texts: one snapshot a frame.

use crate::explore::SessionState;
use coverage_planners::metrics::{DriveMetrics, WalkMetrics};
use robovac_core::registry::Params;
use robovac_sim::SensorKind;
use robovac_sim::experiment::Shows;
use serde::Serialize;

/// Snapshot of a session. SI units; shares from 0 to 1.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct SessionView {
    /// What the page is doing.
    pub state: SessionState,
    /// What the user may do.
    pub can: SessionActions,
    /// Something to tell the user; empty for nothing.
    pub message: String,
    /// `error` or `notice`; empty for nothing.
    #[cfg_attr(feature = "types", ts(type = "\"\" | \"error\" | \"notice\""))]
    pub message_kind: &'static str,
    /// The room.
    pub room: RoomView,
    /// Id of the robot.
    pub robot: &'static str,
    /// Id of the planner or behaviour.
    pub algorithm: &'static str,
    /// `planner` or `behaviour`.
    #[cfg_attr(feature = "types", ts(type = "\"planner\" | \"behaviour\""))]
    pub kind: &'static str,
    /// What the robot is doing, in a few words; empty if there is nothing to tell.
    pub activity: &'static str,
    /// Changes whenever the list of events does.
    pub diary: f64,
    /// Whether the robot is held.
    pub is_lifted: bool,
    /// Why a person's commands aren't obeyed: forward, left, right, backward; `None` unless a person drives.
    pub blocked: Option<[Option<&'static str>; 4]>,
    /// Share of the dirt that is left; `None` where there was none.
    pub dirt_left: Option<f64>,
    /// Its parameters.
    pub params: Params,
    /// Side of the planning cells, m.
    pub cell_size_m: f64,
    /// Seed of everything random.
    pub seed: u64,
    /// How well the wheels hold.
    pub slip: &'static str,
    /// How much the sensors err, in the order of the catalogue's sensors.
    pub noise: [&'static str; SensorKind::ALL.len()],
    /// Whether wheels only turn at the speeds that the motor controller can keep.
    pub quantised: bool,
    /// What is drawn on the floor.
    pub shows: Shows,
    /// How the follower computes its pose.
    pub odometry: &'static str,
    /// Speed asked for, times real time; 0 for as fast as it goes.
    pub speed: f64,
    /// Speed reached lately, times real time.
    pub speed_factor: f64,
    /// Time shown, s.
    pub time_s: f64,
    /// Furthest simulated time, s.
    pub run_end_s: f64,
    /// Swept share of the reachable floor.
    pub coverage: f64,
    /// Area swept again, as a share of the area swept.
    pub overlap: f64,
    /// Distance driven, m.
    pub distance_m: f64,
    /// Sum of all turning, degrees.
    pub turning_deg: f64,
    /// How often the bumper was pressed.
    pub bumps: u32,
    /// Distance between the robot's true and estimated position, m.
    pub pose_error_m: f64,
    /// The planner's search.
    pub search: SearchView,
    /// The plan, or what is known of it while the planner is at work.
    pub plan: Option<PlanView>,
}

/// Snapshot of a session, and of what the hand on the picture of the floor is doing.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct PageView {
    /// The session.
    #[serde(flatten)]
    pub session: SessionView,
    /// What the pointer does on the floor.
    pub tool: FloorTool,
    /// What stands, lies and moves in the room, by name.
    pub objects: Vec<&'static str>,
    /// Index of the selected one; -1 for none.
    pub selected: i32,
    /// What the tool "place" places.
    pub placing: &'static str,
    /// Whether the robot is held on the picture, to be put down somewhere.
    pub is_carried: bool,
    /// Whether it is held in the upper half of the picture.
    pub is_held_high: bool,
}

/// What the pointer does on the floor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum FloorTool {
    /// Shifts the picture.
    View,
    /// Draws walls.
    Wall,
    /// Erases walls.
    Erase,
    /// Moves the start.
    Start,
    /// Places objects.
    Place,
}

/// What the user may do now: a flag for each button, which JavaScript only copies.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct SessionActions {
    /// Let time go on.
    pub play: bool,
    /// Stop time.
    pub pause: bool,
    /// Go on by one move.
    pub step: bool,
    /// Back to the start.
    pub reset: bool,
    /// Stop the planner.
    pub cancel: bool,
    /// Stop it, and drive the best walk that it has found.
    pub keep: bool,
    /// Go to another point of time.
    pub seek: bool,
    /// Change something.
    pub edit: bool,
    /// Pick the robot up.
    pub lift: bool,
    /// Take the last change of the room back.
    pub undo: bool,
    /// Make it again.
    pub redo: bool,
}

/// The planner's search in words.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct SearchView {
    /// Whether the planner can show it.
    pub offered: bool,
    /// Whether it is to be shown.
    pub on: bool,
    /// The decision at this moment, or what the film shows; empty if there is nothing to tell.
    pub text: String,
    /// Why it can't be shown in this room; empty if it can.
    pub refusal: String,
    /// The film, if there is one and it is to be shown.
    pub film: Option<FilmView>,
}

/// How far a film is.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct FilmView {
    /// Number of the picture that is seen, from 0; that of all pictures once it's over.
    pub at: usize,
    /// How many pictures there are.
    pub pictures: usize,
    /// Whether it goes on by itself.
    pub runs: bool,
}

/// The room in numbers.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct RoomView {
    /// Id if it ships and hasn't been changed, else empty.
    pub id: &'static str,
    /// Name.
    pub title: String,
    /// What it is good for.
    pub note: String,
    /// Width, m.
    pub width_m: f64,
    /// Height, m.
    pub height_m: f64,
    /// Side of a map cell, m.
    pub resolution_m: f64,
    /// Number of map cells.
    pub cells: usize,
    /// Floor that the robot's tool can reach from the start, m².
    pub reachable_m2: f64,
    /// Free floor that it can't reach, m².
    pub left_out_m2: f64,
}

/// The plan in numbers; those of walk and drive are 0 until it is there.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct PlanView {
    /// Whether the planner is at work.
    pub running: bool,
    /// How far it is.
    pub progress: f64,
    /// Numbers of the walk.
    #[serde(flatten)]
    pub walk: WalkMetrics,
    /// Numbers of the line.
    #[serde(flatten)]
    pub drive: DriveMetrics,
    /// Time that planning took, s; `None` while it goes on, and for a plan that was made in advance.
    pub planning_s: Option<f64>,
    /// By how much the plan, or the best walk so far, costs more than any walk must in what its planner keeps low, as a share
    /// of that; 0 if it is proven to be the best, `None` for planners that prove nothing.
    pub gap: Option<f64>,
    /// The same in steps + 2 x quarter turns, as plans are compared; `None` as long as nothing is proven, or if it misses cells.
    pub above_bound: Option<f64>,
    /// Steps that a quarter turn counts as in `gap`.
    pub turn_weight: Option<f64>,
    /// Whether that is as long as the robot takes for one.
    pub times_turns: bool,
    /// Share of the search after which the user was content with the plan; `None` if the planner ended by itself.
    pub kept_at: Option<f64>,
}

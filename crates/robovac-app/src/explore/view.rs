//! View model of the page's numbers and texts: one snapshot per frame.

use crate::explore::SessionState;
use coverage_planners::metrics::{DriveMetrics, SweepBound, WalkMetrics};
use robovac_core::{
    program::{ProgramKind, ProgramLanguage},
    registry::Params,
};
use robovac_sim::SensorKind;
use robovac_sim::experiment::Shows;
use serde::Serialize;

/// Snapshot of a session. SI units; shares from 0 to 1.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[expect(clippy::struct_excessive_bools)]
pub struct SessionView {
    /// State of the session.
    pub state: SessionState,
    /// Actions that are allowed now.
    pub can: SessionActions,
    /// Message for the user; empty for none.
    pub message: String,
    /// `error` or `notice`; empty for none.
    #[cfg_attr(feature = "types", ts(type = "\"\" | \"error\" | \"notice\""))]
    pub message_kind: &'static str,
    /// The room.
    pub room: RoomView,
    /// Id of the robot.
    pub robot: &'static str,
    /// Figures of a twin, as in links; empty for the model and for an own robot.
    pub twin: String,
    /// Choices of an own robot, as in links; empty for a model; `model` for one that is built on a model without changes.
    pub own_robot: String,
    /// Corners of a path from elsewhere that is driven in place of the planner's; 0 for none.
    pub path_corners: usize,
    /// Id of the planner or behaviour.
    pub algorithm: &'static str,
    /// `planner` or `behaviour`.
    #[cfg_attr(feature = "types", ts(type = "\"planner\" | \"behaviour\""))]
    pub kind: &'static str,
    /// The user's program, if it is chosen.
    pub program: Option<ProgramView>,
    /// The robot's activity, in a few words; empty for none.
    pub activity: &'static str,
    /// Changes whenever the list of events does.
    pub diary: f64,
    /// Whether the robot is held.
    pub is_lifted: bool,
    /// Why a person's commands are blocked: forward, left, right, backward; `None` unless a person drives.
    pub blocked: Option<[Option<&'static str>; 4]>,
    /// Share of the dirt that is left; `None` in rooms without dirt.
    pub dirt_left: Option<f64>,
    /// Its parameters.
    pub params: Params,
    /// Side of the planning cells, m.
    pub cell_size_m: f64,
    /// How far the planning cells begin to the left of the room's lower-left corner and below it, m.
    pub cell_offset_m: [f64; 2],
    /// Seed of everything random.
    pub seed: u64,
    /// Level of wheel slip.
    pub slip: &'static str,
    /// Levels of noise, in the order of the catalogue's sensors.
    pub noise: [&'static str; SensorKind::ALL.len()],
    /// Whether wheels turn only at the speeds that the motor controller can keep.
    pub quantised: bool,
    /// Charge of the battery at the start, percent.
    pub start_charge_percent: u8,
    /// Layers drawn on the floor.
    pub shows: Shows,
    /// How the follower computes its pose.
    pub odometry: &'static str,
    /// Whether the corners of plans are rounded, and whether this robot can do that.
    pub smooth: bool,
    /// See above.
    pub can_smooth: bool,
    /// Set speed, times real time; 0 for as fast as possible.
    pub speed: f64,
    /// Achieved speed, times real time.
    pub speed_factor: f64,
    /// Displayed time, s.
    pub time_s: f64,
    /// Share of the reachable floor that was swept before the room was changed, which began the run again; 0 if it
    /// wasn't.
    pub swept_before: f64,
    /// Furthest simulated time, s.
    pub run_end_s: f64,
    /// Swept share of the reachable floor.
    pub coverage: f64,
    /// Area swept again, as a share of the area swept.
    pub overlap: f64,
    /// Distance driven, m.
    pub distance_m: f64,
    /// The least distance in which any robot with this tool sweeps as much floor, m; `None` until the run is over, of those that plan
    /// it, and where it isn't known.
    pub least_m: Option<f64>,
    /// Time for that distance at the robot's top speed, s: no run that sweeps as much takes less.
    pub least_s: Option<f64>,
    /// Sum of all turning, degrees.
    pub turning_deg: f64,
    /// Number of bumps.
    pub bumps: u32,
    /// Distance between the robot's true and estimated position, m.
    pub pose_error_m: f64,
    /// The planner's search.
    pub search: SearchView,
    /// The plan, or the best so far while the planner is running.
    pub plan: Option<PlanView>,
}

/// A user's program that is chosen.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct ProgramView {
    /// Its name.
    pub name: String,
    /// Its language.
    pub language: ProgramLanguage,
    /// What it does.
    pub kind: ProgramKind,
    /// Changes when it has to be run again: from the start, or from a person's last input on.
    pub version: u32,
    /// Steps for which it has commanded; `None` for a planner.
    pub reach_steps: Option<u32>,
    /// How it ended, if it has.
    #[cfg_attr(feature = "types", ts(type = "\"done\" | \"failed\" | null"))]
    pub end: Option<&'static str>,
    /// Whether the run stands still because the program hasn't got farther.
    pub waits: bool,
    /// Steps before a person's last input; `None` without one.
    pub input: Option<u64>,
}

/// Snapshot of a session and of the pointer's tool.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct PageView {
    /// The session.
    #[serde(flatten)]
    pub session: SessionView,
    /// The pointer's tool.
    pub tool: FloorTool,
    /// Names of the objects in the room.
    pub objects: Vec<&'static str>,
    /// Index of the selected one; -1 for none.
    pub selected: i32,
    /// Kind of object that the tool *place* places.
    pub placing: &'static str,
    /// Whether the robot is held on the picture.
    pub is_carried: bool,
    /// Whether the whole room is shown: it then gives way to what is said above it.
    pub is_all_shown: bool,
    /// Where on the picture the robot is, as shares of its width from the left and of its height from the top: nothing must
    /// hide it. 1 and 1 without one.
    pub robot_spot: [f64; 2],
}

/// Tools of the pointer on the floor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum FloorTool {
    /// Pans the picture.
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

/// Allowed actions: one flag per button, which JavaScript only copies.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct SessionActions {
    /// Start or continue.
    pub play: bool,
    /// Pause.
    pub pause: bool,
    /// Advance by one move.
    pub step: bool,
    /// Return to the start.
    pub reset: bool,
    /// Cancel planning.
    pub cancel: bool,
    /// Stop planning, and drive the best walk so far.
    pub keep: bool,
    /// Seek another time.
    pub seek: bool,
    /// Change choices or the room.
    pub edit: bool,
    /// Pick the robot up.
    pub lift: bool,
    /// Undo the last change of the room.
    pub undo: bool,
    /// Redo it.
    pub redo: bool,
}

/// The planner's search in words.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct SearchView {
    /// Whether the planner can show it.
    pub offered: bool,
    /// Whether it is shown.
    pub on: bool,
    /// The current decision, or the film's caption; empty for none.
    pub text: String,
    /// Why it can't be shown; empty if it can.
    pub refusal: String,
    /// Whether it could in a smaller room.
    pub fits_small: bool,
    /// The film, if there is one and it is shown.
    pub film: Option<FilmView>,
}

/// Progress of a film.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct FilmView {
    /// Index of the current picture; the number of pictures once it's over.
    pub at: usize,
    /// Number of pictures.
    pub pictures: usize,
    /// Whether it plays by itself.
    pub runs: bool,
}

/// The room in numbers.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct RoomView {
    /// Id if it is built in and unchanged, else empty.
    pub id: &'static str,
    /// Name.
    pub title: String,
    /// Its purpose; without the name of a generated flat.
    pub note: String,
    /// What it was generated from, also after changes.
    pub flat: Option<FlatView>,
    /// Width of the floor within its walls, m.
    pub width_m: f64,
    /// Its height, m.
    pub height_m: f64,
    /// Side of a map cell, m.
    pub resolution_m: f64,
    /// Number of map cells.
    pub cells: usize,
    /// Floor that the robot's tool can reach from the start, m².
    pub reachable_m2: f64,
    /// Free floor that the tool can't reach, m².
    pub left_out_m2: f64,
}

/// The parts of a generated flat's name: joined, they are the name.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct FlatView {
    /// Its seed, which can be larger than a JavaScript number.
    pub seed: String,
    /// Its area, as in `~area:40..60`; empty if any.
    pub area: String,
    /// What else it has.
    pub more: String,
}

impl FlatView {
    /// The parts of a name.
    pub fn new(name: &str) -> Self {
        let (seed, rest) = name.split_at(name.find('~').unwrap_or(name.len()));
        let starts_with_area = rest.starts_with("~area:");
        let end = if starts_with_area { rest[1..].find('~').map_or(rest.len(), |at| at + 1) } else { 0 };
        let (area, more) = rest.split_at(end);
        Self { seed: seed.to_owned(), area: area.to_owned(), more: more.to_owned() }
    }
}

/// The plan in numbers; those of walk and drive are 0 while planning, those of the walk also for a path in metres.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct PlanView {
    /// Whether the planner is running.
    pub running: bool,
    /// Its progress, 0 to 1.
    pub progress: f64,
    /// Numbers of the walk.
    #[serde(flatten)]
    pub walk: WalkMetrics,
    /// Numbers of the line.
    #[serde(flatten)]
    pub drive: DriveMetrics,
    /// Planning time, s; `None` while planning, and for a precomputed plan.
    pub planning_s: Option<f64>,
    /// Optimality gap of the plan, or of the best walk so far, in the planner's own objective, as a share of the bound;
    /// 0 if it is proven optimal, `None` for planners that prove nothing.
    pub gap: Option<f64>,
    /// The same in steps + 2 x quarter turns, as in comparisons; `None` until it is proven, or if the walk misses
    /// cells.
    pub above_bound: Option<f64>,
    /// Its exact coverage, and what any path needs that sweeps as much; `None` until it is computed.
    pub least: Option<SweepBound>,
    /// Steps that a quarter turn counts as in `gap`.
    pub turn_weight: Option<f64>,
    /// Whether that is the robot's time for one.
    pub times_turns: bool,
    /// Share of the search after which the user ended it; `None` if the planner finished.
    pub kept_at: Option<f64>,
    /// The share of the floor that it was to sweep, 0 to 1, if the planner has a parameter for it.
    pub asked_coverage: Option<f64>,
}

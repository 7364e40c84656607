//! The sweeping planner of 001, from the room and the robot's outline to its path: obstacle map, subgoals, links,
//! detours, and a finish of our own for what these leave out; and the export of paths to robots and other programs.
//!
//! The registry's planner ([`crate`], `subgoal_sweep`) works on planning cells like every other; this one works as the
//! paper does: with the outline drawn by the user, in metres, with scan lines at any distance. The robot keeps heading
//! 0 and moves in every direction (section 2); one that has to turn gets the room that it needs for that.
//!
//! The path touches nothing: every piece of it is free for the exact outline, with [`CLEARANCE`] to spare.

mod contour;
mod cover;
mod crossings;
mod error;
mod finish;
mod linker;
mod pipeline;
mod program;
mod program_smooth;
mod stages;
mod track;
mod track_smooth;

pub use crate::stage::{LineEndContact, Subgoal};
pub use error::SweepError;
pub use pipeline::{SCAN_WIDTHS, sweep};
pub use program::{planned_for, program};
pub use program_smooth::smooth_program;
pub use stages::{CLEARANCE, LinkOrder, OrderCost, SubgoalLink, Sweep, SweepSetup};
pub use track::{FRAME, Waypoint, in_frame, start_text, to_csv, to_ros_path, waypoints};
pub use track_smooth::waypoints_along;

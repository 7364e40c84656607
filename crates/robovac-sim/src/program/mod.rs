//! Programs of users: what they sense, what they command, and runs that repeat it.
//!
//! A program never drives the run that is shown. It drives a [`Lockstep`] of its own, somewhere else, as fast as it
//! can, and only its [`CommandLog`] comes back: the wheel speeds of each step. A run with the controller [`Logged`]
//! repeats them. As runs are deterministic, both are in the same state at each step, to the last bit.
//!
//! - [`SLOTS`]: the readings of a program, numbers at fixed places
//! - [`ProgramSenses`]: keeps them up to date, of a simulated or a real robot
//! - [`Lockstep`]: sense and drive, step by step
//! - [`CommandLog`], [`Logged`]: the log, and the controller that repeats it
//! - [`Piloted`]: the controller that asks a program elsewhere, for a real robot
//! - [`ProgramRoom`], [`check_walk`]: what a user's planner gets, and what its walk is checked for
//! - [`BEHAVIOUR_PROGRAM`], [`PLANNER_PROGRAM`]: the entries of programs beside those of the registries

mod entries;
mod layout;
mod lockstep;
mod log;
mod logged;
mod piloted;
mod room;
mod senses;
mod walk;

pub use entries::{BEHAVIOUR_PROGRAM, PLANNER_PROGRAM};
pub use layout::{
    LASER, LaserFacts, Reckoned, RobotFacts, SLOTS, Slot, layout_json, readings_json, top_speed_mm_s, wheel_command,
    write_readings,
};
pub use lockstep::{Lockstep, LockstepFrame};
pub use log::{CommandChange, CommandLog, LogEnd, LogError, LogPart};
pub use logged::{Logged, SharedLog};
pub use piloted::{Piloted, RemotePilot};
pub use room::ProgramRoom;
pub use senses::ProgramSenses;
pub use walk::{MissedCells, WalkFault, check_walk};

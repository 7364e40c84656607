//! Comparison of planners: same room, same robot, one definition of every metric.
//!
//! An [`Arena`] is where one planner tries; [`Comparison`] says what has to be tried and keeps what came out,
//! [`Table`] sums it up, [`Race`] lets robots drive the plans under one clock.

mod arena;
mod base;
mod comparison;
mod entrant;
mod export;
mod race;
mod rooms;
mod table;
mod trial;
mod trials;

pub use arena::{Arena, Outcome, TrialError};
pub use comparison::{Comparison, MOST_SEEDS};
pub use entrant::{BEHAVIOUR, Entrant, PLANNER};
pub(super) use export::quoted;
pub use export::{Record, to_csv, to_json};
pub use race::{Lane, MOST_LANES, Race, RaceSetup, Racer};
pub use rooms::{RoomChoice, RoomSet};
pub use table::{Row, Spread, Table};
pub use trial::TrialRequest;
pub(super) use trial::plan_of;
pub use trials::{Progress, Trial};

//! Building blocks shared by several behaviours.

mod attempt_budget;
mod barred;
mod beacon;
mod braking;
mod home;
mod lookout;
mod obstruction;
mod pilot;
mod reactive;
mod route;
mod search;
mod tracking;
mod trail;
mod travel;
mod voids;

/// What a robot does that senses that it's lifted.
pub const LIFTED: &str = "lifted, waiting to be put down";

pub(super) use attempt_budget::{AttemptBudget, THERE};
pub(super) use barred::Barred;
pub(super) use beacon::Beacon;
pub(crate) use braking::safe_speed;
pub(super) use home::{GO_HOME, LEAVE_HOME};
pub(super) use lookout::Lookout;
pub(super) use obstruction::{Obstruction, ObstructionKind, ObstructionSide};
pub(super) use pilot::{By, Move, Pilot};
pub(super) use reactive::{Behaviour, Reactive};
pub(super) use route::Route;
pub(super) use search::{RelocaliseSearch, Searched};
pub(super) use tracking::{TRACKING, chosen_tracking};

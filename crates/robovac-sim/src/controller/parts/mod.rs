//! Building blocks shared by several behaviours.

mod barred;
mod beacon;
mod braking;
mod driven;
mod hit;
mod home;
mod pilot;
mod route;
mod search;
mod trail;
mod travel;
mod voids;

pub(super) use barred::Barred;
pub(super) use beacon::Beacon;
pub(super) use braking::safe_speed;
pub(super) use driven::{Driven, Habit};
pub(super) use hit::{Hit, Kind, Side};
pub(super) use home::{GO_HOME, LEAVE_HOME};
pub(super) use pilot::{By, Move, Pilot};
pub(super) use route::Route;
pub(super) use search::{Search, Searched};

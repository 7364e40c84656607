//! Building blocks shared by several behaviours.

#[cfg(feature = "mapping")]
mod barred;
mod beacon;
mod braking;
mod driven;
mod hit;
mod home;
mod pilot;
#[cfg(feature = "mapping")]
mod route;
#[cfg(feature = "mapping")]
mod search;
mod trail;
mod travel;
mod voids;

#[cfg(feature = "mapping")]
pub(super) use barred::Barred;
pub(super) use beacon::Beacon;
pub(super) use braking::safe_speed;
pub(super) use driven::{Driven, Habit};
pub(super) use hit::{Hit, Kind, Side};
pub(super) use home::{GO_HOME, LEAVE_HOME};
pub(super) use pilot::{By, Move, Pilot};
#[cfg(feature = "mapping")]
pub(super) use route::Route;
#[cfg(feature = "mapping")]
pub(super) use search::{Search, Searched};

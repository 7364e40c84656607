//! What behaviours have in common: each part is one thing that several of them do.

mod braking;
mod driven;
mod feel;
mod hit;
mod pilot;
mod trail;
mod travel;

pub(super) use driven::{Driven, Habit};
pub(super) use hit::{Hit, Kind, Side};
pub(super) use pilot::{By, Move, Pilot};

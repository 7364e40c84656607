//! Every planner in every room.

mod bounds;
mod contract;
mod golden;
mod papers;
mod properties;
mod support;

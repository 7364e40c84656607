//! Every planner in every room.

mod bounds;
mod contract;
mod golden;
mod properties;
mod support;

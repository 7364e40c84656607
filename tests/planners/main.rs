//! Every planner in every room.

mod contract;
mod golden;
mod properties;
mod support;

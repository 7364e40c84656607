//! Every planner in every room.

mod contract;
mod golden;
mod papers;
mod properties;
mod support;

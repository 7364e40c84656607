//! Every planner in every room.

mod bounds;
mod contract;
mod explainer;
mod golden;
mod near_optimal;
mod papers;
mod peers;
mod properties;
mod support;

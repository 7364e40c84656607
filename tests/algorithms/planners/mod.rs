//! Every planner in every room.

mod bounds;
mod contract;
mod explainer;
mod golden;
mod in_metres;
mod near_optimal;
mod papers;
mod peers;
mod printed_snake;
mod properties;
mod shown_search;
mod support;

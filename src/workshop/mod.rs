//! The module `workshop`: planners, trials and map readers for workers, and the tabs Compare, Map and Robot.

mod bench;
mod comparison;
mod comparison_view;
mod guest;
mod link;
mod live_map;
mod montecarlo;
mod plan_job;
mod read_map;
mod replay;
mod runner;
mod survey;
mod trial;
mod virtual_robot;

#[allow(unused_imports, reason = "the boundary's tests are Rust; the page uses them by their exports")]
pub use {guest::Guest, link::Link, plan_job::plan, read_map::read_map, replay::Replay, virtual_robot::VirtualRobot};

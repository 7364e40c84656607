//! The module `workshop`: planners, trials and map readers for workers, and the Compare, Map and Robot tabs.

mod bench;
mod comparison;
mod connection;
mod fit_cells;
mod flat;
mod live_map;
mod map_session;
mod montecarlo;
mod own_robot;
mod plan_job;
mod read_map;
mod replay;
mod run_bag;
mod runner;
mod session_mirror;
mod trade_off;
mod trial;
mod twin;
mod virtual_robot;

#[allow(unused_imports, reason = "the boundary's tests are Rust; the page uses them by their exports")]
pub use {
    connection::Connection, live_map::LiveMap, plan_job::plan, read_map::read_map, replay::Replay,
    session_mirror::SessionMirror, virtual_robot::VirtualRobot,
};

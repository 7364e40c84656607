//! Robovac Playground: coverage algorithms for robot vacuum cleaners, simulated and real.
//!
//! The modules from the bottom up; imports only point to modules earlier in this list:
//!
//! - [`math`], [`rng`]: elementary functions and random numbers that agree bit for bit natively and in wasm
//! - [`geometry`]: points, angles, poses
//! - [`grid`]: rectangular grids, occupancy, clearance, reachability, `#.` pictures
//! - [`floorplan`]: built-in rooms, map files
//! - [`drawing`]: CAD drawings and other line drawings, and the rooms that are traced from them
//! - [`robot`]: models, sensors, drive commands, odometry
//! - [`coverage`]: which floor a robot can reach and what it has swept; the planning grid
//! - [`cspace`]: where a body of any outline fits: the configuration space over x, y and heading
//! - [`registry`]: shared by planners and behaviours: parameters, explanations
//! - [`planner`]: one file a planner, and the registry that menus, tests and command line iterate
//! - [`mapping`]: mapping and pose estimation
//! - [`controller`]: reactive and map-based behaviours: one file each, and their registry
//! - [`sim`]: the simulated robot and its world
//! - [`oi`]: the Open Interface, the serial protocol of real Roombas
//! - [`metrics`]: one definition of every metric
//! - [`app`]: view models: sessions, recording, scenes
//! - `web`: the only code that knows the browser (wasm32 only)
//!
//! The core is pure: no clock, no input or output, no global state, no panic on bad input.

pub mod app;
pub mod controller;
pub mod coverage;
pub mod cspace;
#[cfg(feature = "draft")]
pub mod drawing;
pub mod floorplan;
pub mod geometry;
pub mod grid;
#[cfg(feature = "mapping")]
pub mod mapping;
pub mod math;
pub mod metrics;
pub mod oi;
pub mod planner;
pub mod registry;
pub mod rng;
pub mod robot;
pub mod sim;
#[cfg(target_arch = "wasm32")]
pub mod web;

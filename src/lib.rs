//! Robovac Playground: coverage algorithms for robot vacuum cleaners, simulated and real.
//!
//! A tour of the house, from the ground up; imports only ever point downwards in this list:
//!
//! - [`math`], [`rng`]: elementary functions and random numbers that agree bit for bit natively and in wasm
//! - [`geometry`]: points, angles, poses
//! - [`grid`]: rectangular grids, occupancy, clearance, reachability, `#.` pictures
//! - [`floorplan`]: rooms that ship, map files
//! - [`drawing`]: CAD drawings and other line drawings, and the rooms that are traced from them
//! - [`robot`]: models, what they sense and can be told, odometry
//! - [`coverage`]: which floor a robot can reach and what it has swept; the planning grid
//! - [`cspace`]: where a body of any outline fits: the configuration space over x, y and heading
//! - [`registry`]: what planners and behaviours have in common: parameters, explanations
//! - [`planner`]: one file a planner, and the registry that menus, tests and command line iterate
//! - [`mapping`]: maps that a robot makes, and where it believes to be on them
//! - [`controller`]: what drives a robot from what it senses: one file a behaviour, and their registry
//! - [`sim`]: the simulated robot and the world around it
//! - [`oi`]: the Open Interface, the language of real Roombas
//! - [`metrics`]: one definition of every number
//! - [`app`]: sessions, recording, what to draw
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

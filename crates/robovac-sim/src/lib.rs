//! The simulated robot: motion, contact, sensors, and a whole run.
//!
//! Time advances in fixed steps of [`STEP_S`], whatever the speed of the display, so that a run is the same on every
//! machine and a robot never moves farther at once than a few millimetres; contact looks even closer where that is needed, so
//! that nothing tunnels through a wall or a thin leg.

mod contact;
mod dirt;
mod event;
mod input;
mod life;
mod mover;
mod noise;
mod observer;
mod run;
mod senses;
mod sim_robot;
mod slip;
mod touch;
mod world;

pub mod controller;
pub mod experiment;
pub mod mapping;
pub mod montecarlo;
mod recording;

pub use dirt::Spot;
pub use event::{Event, What};
pub use input::Input;
pub use life::Life;
pub use noise::{Noise, NoiseLevel, SensorKind};
pub use observer::RunObserver;
pub use recording::RunRecording;
pub use run::{Conditions, Run, RunSetup};
pub use senses::Supply;
pub use sim_robot::SimRobot;
pub use slip::{Slip, SlipLevel};
pub use touch::Touch;
pub use world::World;

/// Seconds per simulation step: the Open Interface sends its sensor stream every 15 ms.
pub const STEP_S: f64 = 0.015;

//! A simulated robot vacuum: motion, contact, sensors and their errors, behaviours, maps, and experiments with all of them.
//!
//! For predicting how well a plan or a behaviour cleans on a real robot, over many seeded runs.
//!
//! ```
//! use robovac_core::{floor_plan::room, registry::Params, robot::model};
//! use robovac_sim::{Conditions, controller, experiment::RoomSetup};
//!
//! let plan = (room("bedroom").unwrap().build)();
//! let robot = model("roomba600").unwrap();
//! let setup = RoomSetup::new(&plan, robot, robot.default_cell, None).unwrap();
//! let behaviour = controller::find("random_walk").unwrap();
//! let params = Params::defaults(behaviour.params);
//! let mut run = setup.run_behaviour(behaviour, &params, Conditions::default(), 1).unwrap();
//! while run.time_s() < 30.0 {
//!     run.step();
//! }
//! assert!(run.distance_m() > 1.0 && run.coverage() > 0.0);
//! ```
//!
//! - [`Run`]: one robot, one controller, one room; [`World`], [`Conditions`]: objects of the room, and errors of the
//!   robot
//! - [`controller`]: behaviours and followers of plans
//! - [`mapping`]: mapping and localisation from bumps and odometry
//! - [`learning`]: cleaning as a task for reinforcement learning
//! - [`program`]: users' programs
//! - [`experiment`], [`montecarlo`]: from room and robot to a run, and many runs with their statistics
//!
//! Time advances in fixed steps of [`STEP_S`], whatever the speed of the display, so that a run is the same on every
//! machine and a robot never moves farther at once than a few millimetres. Contact uses smaller steps where needed, so
//! that nothing tunnels through a wall or a thin leg.

mod contact;
mod dirt;
mod docking;
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
pub mod learning;
pub mod mapping;
pub mod montecarlo;
pub mod program;
mod random_stream;
mod recording;
pub mod study;

pub use dirt::Spot;
pub use docking::{berth, dock_at};
pub use event::{Event, What};
pub use input::Input;
pub use life::Life;
pub use noise::{Noise, NoiseLevel, SensorKind};
pub use observer::RunObserver;
pub use random_stream::RandomStream;
pub use recording::RunRecording;
pub use run::{Conditions, Run, RunSetup};
pub use senses::Supply;
pub use sim_robot::{SimRobot, kept_speed};
pub use slip::{Slip, SlipLevel};
pub use touch::Touch;
pub use world::World;

/// Seconds per simulation step: the Open Interface sends its sensor stream every 15 ms.
pub const STEP_S: f64 = 0.015;

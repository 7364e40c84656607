//! Both ends of a Roomba's serial line: a driver that keeps a real robot safe, and an emulator of a robot.
//!
//! For programs that drive a Roomba, and for testing them without one. Nothing here opens a port or reads a clock: the caller
//! moves the bytes and passes the time.
//!
//! ```
//! use robovac_core::{floor_plan::room, robot::model};
//! use robovac_link::{driver::Driver, emulator::{Emulator, personality}};
//! use robovac_sim::{Conditions, experiment::RoomSetup};
//!
//! let plan = (room("empty").unwrap().build)();
//! let robot = model("roomba600").unwrap();
//! let setup = RoomSetup::new(&plan, robot, robot.default_cell, None).unwrap().setup(Conditions::default(), 1);
//! let mut roomba = Emulator::new(&setup, personality("model").unwrap());
//! let mut driver = Driver::new();
//! driver.open(0.0);
//! // Both ends exchange bytes every 10 ms until the driver has its first sensor frame.
//! while driver.readings().is_none() {
//!     driver.tick(roomba.time_s());
//!     roomba.receive(&driver.take_tx(), driver.baud());
//!     roomba.advance(0.01);
//!     let mut received = Vec::new();
//!     roomba.transmit(driver.baud(), &mut received);
//!     let mut rest = received.as_slice();
//!     while !rest.is_empty() {
//!         rest = &rest[driver.feed(roomba.time_s(), rest)..];
//!     }
//!     assert!(roomba.time_s() < 10.0, "{:?}", driver.diagnosis());
//! }
//! ```
//!
//! - [`driver`]: the host's end: identifies the robot, reads its sensors, stops it
//! - [`connection`]: a driver with a controller, a view model and a recording
//! - [`recording`]: what a recording of the line contains, in words and as a table
//! - [`twin`]: the figures of one robot, fitted to a recording
//! - [`emulator`]: the robot's end
//! - [`sensors`]: conversion between the sensor readings of the simulator and of the Open Interface

pub mod connection;
pub mod dashboard;
pub mod driver;
pub mod emulator;
mod path_commands;
pub mod recording;
pub mod sensors;
mod smooth_commands;
pub mod twin;

pub use path_commands::{TimedCommand, commands, commands_text};
pub use smooth_commands::{smooth_commands, smooth_commands_text};

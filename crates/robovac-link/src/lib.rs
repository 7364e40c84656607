//! Both ends of a Roomba's serial line: driver, emulator, connection and recordings.

pub mod connection;
pub mod dashboard;
pub mod driver;
pub mod emulator;
mod path_commands;
pub mod sensors;

pub use path_commands::{TimedCommand, commands, commands_text};

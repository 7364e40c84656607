//! Both ends of the serial line of a Roomba: a driver, an emulator, a connection for users, and recordings of it.

pub mod connection;
pub mod driver;
pub mod emulator;
mod path_commands;
pub mod sensors;

pub use path_commands::{TimedCommand, commands, commands_text};

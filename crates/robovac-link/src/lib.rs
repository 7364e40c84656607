//! Both ends of the serial line of a Roomba: a driver, an emulator, a connection for users, and recordings of it.

pub mod driver;
pub mod emulator;
pub mod link;
mod path_commands;
pub mod sensors;

pub use path_commands::{TimedCommand, commands, commands_text};

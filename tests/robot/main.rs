//! The Open Interface: its language, the driver, the virtual Roomba.

mod connection;
mod emulator;
mod oi;
mod vectors;

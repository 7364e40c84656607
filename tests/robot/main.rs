//! The Open Interface: its language, the driver, the virtual Roomba.

mod emulator;
mod link;
mod oi;

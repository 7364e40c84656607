//! The rules of a bridge between a network and the serial port of a Roomba: who may drive, and when the robot is stopped.
//!
//! The Open Interface has no timeout, so a bridge that only copies bytes leaves a robot driving when the other side dies. This
//! one stops it. `no_std`, no allocation, no clock and no I/O: `robovac bridge` runs it on a computer, and firmware for a
//! microcontroller can be built on it.
//!
//! - One client drives, the others watch: they receive all bytes of the robot, and theirs are dropped. When the driver
//!   leaves, the next one in order of arrival drives.
//! - Only whole commands are passed on, so that no stop is swallowed by half a command.
//! - While wheels or brushes are on, the driver has to be heard of: after [`Limits::halt_ms`] of silence the wheels are
//!   stopped, after [`Limits::lost_ms`] everything is, and the driver is disconnected.
//! - When the driver leaves, or the bridge starts or ends, the robot is stopped. A robot that cleans by its own program
//!   goes on, as after a press of its button.
//!
//! Clients send the robot's bytes as binary messages of a WebSocket, and the words of [`ToBridge`] as text; they are
//! answered likewise, with [`FromBridge`].
//!
//! ```
//! use roomba_bridge::{Bridge, ClientId, Ends, FromBridge, Limits, STOP};
//!
//! /// What a program connects to the rules: the serial port, and the clients' connections.
//! #[derive(Default)]
//! struct Wires(Vec<u8>);
//! impl Ends for Wires {
//!     fn robot(&mut self, bytes: &[u8]) {
//!         self.0.extend(bytes);
//!     }
//!     fn baud(&mut self, _baud: u32) {}
//!     fn brc(&mut self, _is_low: bool) {}
//!     fn tell(&mut self, client: ClientId, word: FromBridge) {
//!         println!("to {client}: {word}");
//!     }
//!     fn close(&mut self, client: ClientId, why: &str) {
//!         println!("{client} is disconnected: {why}");
//!     }
//! }
//!
//! let mut wires = Wires::default();
//! let mut bridge = Bridge::new(Limits::default());
//! bridge.opened(&mut wires);
//! bridge.joined(7, 0, &mut wires);
//! bridge.bytes(7, &[131, 145, 0, 100, 0, 100], 10, &mut wires);
//! assert!(wires.0.ends_with(&[131, 145, 0, 100, 0, 100]));
//! // The client dies. Wheels first: it may be back at once. Then all of it.
//! bridge.tick(210, &mut wires);
//! assert!(wires.0.ends_with(&[145, 0, 0, 0, 0]));
//! bridge.tick(1010, &mut wires);
//! assert!(wires.0.ends_with(&STOP));
//! ```

#![cfg_attr(not(test), no_std)]

mod bridge;
mod motion;
mod words;

pub use bridge::{Bridge, ClientId, Ends, Full, Limits, MAX_CLIENTS};
pub use motion::{HALT, STOP};
pub use words::{FromBridge, Halted, ToBridge, UnknownWord, VERSION};

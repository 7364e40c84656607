//! The rules of a bridge between a network and the serial port of a Roomba: who may drive, and when the robot is stopped.
//!
//! The Open Interface has no timeout, so a bridge that only copies bytes leaves a robot driving when the other side dies. This
//! one stops it. `no_std`, no allocation, no clock and no I/O: `robovac bridge` runs it on a computer, and firmware for a
//! microcontroller can be built on it.
//!
//! - One client drives, the others watch: they receive all bytes of the robot, and theirs are dropped. When the driver
//!   leaves, the next one in order of arrival may drive.
//! - Every client can stop the robot with a word, whoever drives.
//! - Whoever may drive has to take its turn, and again after every stop by the bridge. What it sent before it knew of its turn
//!   or of the stop is dropped.
//! - The bridge sends numbered beats, and every client answers them. While wheels or brushes are on, the newest beat that the
//!   driver answered has to be young: at an age of [`Limits::halt_ms`] the wheels are stopped, at [`Limits::lost_ms`]
//!   everything is, and the driver is disconnected. So a network that is steadily late is noticed, too: what sets something in
//!   motion is carried out only if the client sent it less than [`Limits::halt_ms`] ago.
//! - Only whole commands are passed on, so that no stop is swallowed by half a command. Who sends more of them than the serial
//!   line can carry is stopped.
//! - When the driver leaves, or the bridge starts or ends, the robot is stopped, and the line is as it was at first. A robot
//!   that cleans by its own program goes on, as after a press of its button.
//! - Every stop is repeated three times, or until somebody takes control again.
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
//!     fn robot(&mut self, command: &[u8]) -> bool {
//!         self.0.extend(command);
//!         true
//!     }
//!     fn stop(&mut self, bytes: &[u8]) {
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
//! let mut bridge = Bridge::new(Limits::default(), 115_200);
//! bridge.opened(0, &mut wires);
//! // It is told "drive 1".
//! bridge.joined(7, 0, &mut wires);
//! bridge.text(7, "take 1", 5, &mut wires);
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
mod repeat;
mod words;

pub use bridge::{Bridge, ClientId, Ends, Full, Limits, MAX_CLIENTS};
pub use motion::{HALT, STOP, STOP_ALL};
pub use words::{FromBridge, Halted, ToBridge, UnknownWord, VERSION};

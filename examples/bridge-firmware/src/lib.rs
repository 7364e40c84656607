//! A bridge for a microcontroller on the robot, such as an ESP32-C3: everything but its drivers.
//!
//! It needs no operating system, no memory allocation and no clock but a counter of milliseconds. What a chip's own libraries
//! do is behind [`Board`]: a serial port, a pin at the robot's BRC line, and a WebSocket server. With
//! [esp-hal](https://docs.rs/esp-hal) these are `Uart`, `Output`, `Instant::now`, and a server such as `edge-ws`.
//!
//! ```sh
//! rustup target add riscv32imc-unknown-none-elf
//! cargo build --package bridge-firmware --target riscv32imc-unknown-none-elf
//! ```
//!
//! Two things are the board's own duty: a watchdog that restarts the chip if [`Firmware::step`] isn't called for some 100 ms,
//! since the bridge stops the robot first of all when it starts; and a token or a network that nobody else is in.

#![cfg_attr(not(test), no_std)]

use roomba_bridge::{Bridge, ClientId, Ends, FromBridge, Full, Limits};

/// The rate of the robot's serial port.
const BAUD: u32 = 115_200;
/// Events of one round.
const MOST_EVENTS: usize = 32;

/// What has arrived from the network.
#[derive(Debug, Clone, Copy)]
pub enum Arrived<'a> {
    /// A client has connected, and its origin and token are right.
    Client(ClientId),
    /// A binary message.
    Binary(ClientId, &'a [u8]),
    /// A text message.
    Text(ClientId, &'a str),
    /// A connection has ended.
    Gone(ClientId),
}

/// The chip and its libraries. No call may wait for longer than a few milliseconds, but for those while it starts.
pub trait Board: Ends {
    /// Milliseconds since the start.
    fn now_ms(&self) -> u64;
    /// Bytes of the robot that have arrived; how many there are in `buffer`.
    fn receive(&mut self, buffer: &mut [u8]) -> usize;
    /// Sends bytes of the robot to all clients.
    fn broadcast(&mut self, bytes: &[u8]);
    /// The next event of the network, with its message in `buffer`.
    fn next_event<'b>(&mut self, buffer: &'b mut [u8]) -> Option<Arrived<'b>>;
}

/// The bridge with its buffers, 2 KB in all.
pub struct Firmware {
    bridge: Bridge,
    buffer: [u8; 1024],
}

impl Firmware {
    /// Stops the robot, and is ready for clients.
    pub fn start(board: &mut impl Board) -> Self {
        let mut bridge = Bridge::new(Limits::default(), BAUD);
        let now_ms = board.now_ms();
        bridge.opened(now_ms, board);
        Self { bridge, buffer: [0; 1024] }
    }

    /// One round: to be called for ever, at least every 10 ms.
    pub fn step(&mut self, board: &mut impl Board) {
        let count = board.receive(&mut self.buffer);
        if let Some(bytes @ [_, ..]) = self.buffer.get(..count) {
            board.broadcast(bytes);
        }
        let now_ms = board.now_ms();
        for _ in 0..MOST_EVENTS {
            match board.next_event(&mut self.buffer) {
                Some(Arrived::Client(client)) => self.greet(client, now_ms, board),
                Some(Arrived::Binary(client, bytes)) => self.bridge.bytes(client, bytes, now_ms, board),
                Some(Arrived::Text(client, text)) => self.bridge.text(client, text, now_ms, board),
                Some(Arrived::Gone(client)) => self.bridge.left(client, now_ms, board),
                None => break,
            }
        }
        self.bridge.tick(now_ms, board);
    }

    fn greet(&mut self, client: ClientId, now_ms: u64, board: &mut impl Board) {
        if self.bridge.joined(client, now_ms, board) == Err(Full) {
            board.close(client, "there are too many clients");
        }
    }

    /// The client that drives.
    pub fn driver(&self) -> Option<ClientId> {
        self.bridge.driver()
    }
}

/// What a board shows on its screen or prints, for example.
pub fn label(word: FromBridge) -> &'static str {
    match word {
        FromBridge::Hello => "connected",
        FromBridge::Drive(_) => "may drive",
        FromBridge::Watch => "watches",
        FromBridge::Beat(_) => "alive",
        FromBridge::Halted(_) => "robot stopped",
        FromBridge::Unknown => "not understood",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use roomba_bridge::STOP;

    const DRIVE: &[u8] = &[131, 145, 0, 100, 0, 100];

    enum Message {
        Joins,
        Binary(&'static [u8]),
        Text(&'static str),
    }

    /// A board in memory.
    #[derive(Default)]
    struct Bench {
        now_ms: u64,
        robot: Vec<u8>,
        arriving: Vec<(ClientId, Message)>,
        closed: Vec<ClientId>,
    }

    impl Ends for Bench {
        fn robot(&mut self, command: &[u8]) -> bool {
            self.robot.extend(command);
            true
        }
        fn stop(&mut self, bytes: &[u8]) {
            self.robot.extend(bytes);
        }
        fn baud(&mut self, _baud: u32) {}
        fn brc(&mut self, _is_low: bool) {}
        fn tell(&mut self, _client: ClientId, word: FromBridge) {
            assert!(!label(word).is_empty());
        }
        fn close(&mut self, client: ClientId, _why: &str) {
            self.closed.push(client);
        }
    }

    impl Board for Bench {
        fn now_ms(&self) -> u64 {
            self.now_ms
        }
        fn receive(&mut self, _buffer: &mut [u8]) -> usize {
            0
        }
        fn broadcast(&mut self, _bytes: &[u8]) {}
        fn next_event<'b>(&mut self, buffer: &'b mut [u8]) -> Option<Arrived<'b>> {
            let (client, message) = self.arriving.pop()?;
            let mut put = |bytes: &[u8]| buffer[..bytes.len()].copy_from_slice(bytes);
            Some(match message {
                Message::Joins => Arrived::Client(client),
                Message::Binary(bytes) => {
                    put(bytes);
                    Arrived::Binary(client, &buffer[..bytes.len()])
                }
                Message::Text(text) => Arrived::Text(client, text),
            })
        }
    }

    #[test]
    fn a_silent_client_leaves_a_robot_that_stands() {
        let mut bench = Bench::default();
        let mut firmware = Firmware::start(&mut bench);
        assert!(bench.robot.ends_with(&STOP));
        bench.arriving = vec![(1, Message::Binary(DRIVE)), (1, Message::Text("take 1")), (1, Message::Joins)];
        for now_ms in (0..2000).step_by(10) {
            bench.now_ms = now_ms;
            firmware.step(&mut bench);
            assert!(now_ms != 100 || bench.robot.ends_with(DRIVE), "it drove");
        }
        assert!(bench.robot.ends_with(&STOP), "{:?}", bench.robot);
        assert_eq!((firmware.driver(), bench.closed), (None, vec![1]));
    }
}

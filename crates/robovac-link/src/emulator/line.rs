//! The serial line in both directions: pacing, rates, faults, and the robot's buffer.

use super::{
    clock::{Nanos, ms},
    personality::Personality,
    uart::{Uart, byte_time},
};
use rand::RngExt;
use robovac_core::rng::Rng;
use robovac_sim::RandomStream;
use std::collections::VecDeque;

/// Most bytes waiting to be sent. Others are lost, so a stream that overruns its slots is corrupted after a while, as
/// the specification warns. The size is ours.
const BUFFER: usize = 1024;
/// Most bytes sent and not fetched; the oldest are dropped first.
const UNFETCHED: usize = 1 << 16;
/// Time for which a host can hand over bytes in advance: a late computer leaves no gap in them, and a host that changes its
/// rate doesn't wait for bytes of the old one (ours).
const AHEAD: Nanos = ms(20);
/// Time after a change of rate in which nothing is received or sent (opcode 129).
const CHANGE: Nanos = ms(100);

/// Both directions.
#[derive(Debug, Clone)]
pub(super) struct SerialLine {
    baud: u32,
    /// Time before which nothing is received.
    deaf_until: Nanos,
    /// Bytes from the host, with their rate and start.
    arriving: VecDeque<(u8, u32, Nanos)>,
    /// Time at which the host's direction is free again.
    host_free: Nanos,
    ear: Uart,
    heard: VecDeque<u8>,
    /// Bytes to the host, with their rate.
    waiting: VecDeque<(u8, u32)>,
    /// Time at which the robot's direction is free again.
    free: Nanos,
    /// Bytes that were sent, with their rate and start.
    sent: VecDeque<(u8, u32, Nanos)>,
    host_ear: Uart,
    /// Probabilities: lost to the host, flipped to the host, lost to the robot.
    faults: [f64; 3],
    is_cut: bool,
    rng: Rng,
}

impl SerialLine {
    pub fn new(who: &Personality, seed: u64) -> Self {
        Self {
            baud: who.baud,
            deaf_until: 0,
            arriving: VecDeque::new(),
            host_free: 0,
            ear: Uart::default(),
            heard: VecDeque::new(),
            waiting: VecDeque::new(),
            free: 0,
            sent: VecDeque::new(),
            host_ear: Uart::default(),
            faults: [who.lost_to_host, who.flipped_to_host, who.lost_to_robot],
            is_cut: !who.is_heard,
            rng: RandomStream::SerialLine.seeded(seed),
        }
    }

    /// The robot's rate.
    pub fn baud(&self) -> u32 {
        self.baud
    }

    /// Changes the robot's rate; waiting bytes are still sent at the old one.
    pub fn set_baud(&mut self, now: Nanos, baud: u32) {
        self.baud = baud;
        self.deaf_until = now + CHANGE;
        self.ear = Uart::default();
        self.heard.clear();
    }

    /// Whether the robot's rate is changing at the moment.
    pub fn is_changing(&self, now: Nanos) -> bool {
        now < self.deaf_until
    }

    /// The robot loses power: unsent and unread bytes are lost.
    pub fn power_down(&mut self, now: Nanos) {
        self.carry(now);
        self.waiting.clear();
        self.heard.clear();
        self.ear = Uart::default();
    }

    /// Takes bytes that the host starts to send now, or as soon as the line is free.
    pub fn receive(&mut self, now: Nanos, bytes: &[u8], baud: u32) {
        for &byte in bytes {
            let start = now.max(self.host_free);
            self.host_free = start + byte_time(baud);
            if !happens(&mut self.rng, self.faults[2]) {
                self.arriving.push_back((byte, baud, start));
            }
        }
    }

    /// Bytes that a host can hand over now at this rate: what the line carries in [`AHEAD`], or one if it is slower.
    pub fn room(&self, now: Nanos, baud: u32) -> usize {
        let time = byte_time(baud);
        let room = match self.host_free.saturating_sub(now) {
            0 => (AHEAD / time).max(1),
            ahead => AHEAD.saturating_sub(ahead) / time,
        };
        usize::try_from(room).unwrap_or(usize::MAX)
    }

    /// Whether bytes from the host, and whether bytes to it, are in transit.
    pub fn is_busy(&self) -> [bool; 2] {
        [!self.arriving.is_empty(), !self.waiting.is_empty()]
    }

    /// Arrival time of the next byte from the host.
    pub fn next_arrival(&self) -> Option<Nanos> {
        self.arriving.front().map(|&(_, baud, start)| start + byte_time(baud))
    }

    /// The next byte received by the robot so far.
    pub fn hear(&mut self, now: Nanos) -> Option<u8> {
        while self.heard.is_empty() && self.next_arrival().is_some_and(|at| at <= now) {
            let (byte, baud, start) = self.arriving.pop_front()?;
            if start >= self.deaf_until {
                let heard = &mut self.heard;
                self.ear.hear(byte, start, [baud, self.baud], |b| heard.push_back(b));
            }
        }
        if self.heard.is_empty() {
            // A byte in transit isn't rest.
            let quiet = self.arriving.front().map_or(now, |&(_, _, start)| start.min(now));
            let heard = &mut self.heard;
            self.ear.rest(quiet, self.baud, |b| heard.push_back(b));
        }
        self.heard.pop_front()
    }

    /// Sends bytes; those that don't fit into the buffer are lost.
    pub fn send(&mut self, now: Nanos, bytes: &[u8]) {
        self.carry(now);
        if self.waiting.is_empty() {
            self.free = self.free.max(now);
        }
        let room = BUFFER - self.waiting.len().min(BUFFER);
        self.waiting.extend(bytes.iter().take(room).map(|&byte| (byte, self.baud)));
    }

    /// Moves the bytes transmitted so far.
    pub fn carry(&mut self, now: Nanos) {
        while let Some(&(byte, baud)) = self.waiting.front() {
            let end = self.free + byte_time(baud);
            if end > now {
                return;
            }
            self.waiting.pop_front();
            let start = core::mem::replace(&mut self.free, end);
            if self.is_cut || happens(&mut self.rng, self.faults[0]) {
                continue;
            }
            let is_flipped = happens(&mut self.rng, self.faults[1]);
            let flip = if is_flipped { 1 << self.rng.random_range(0..8_u32) } else { 0 };
            if self.sent.len() == UNFETCHED {
                self.sent.pop_front();
            }
            self.sent.push_back((byte ^ flip, baud, start));
        }
    }

    /// Passes on the bytes that a host receives at `baud`.
    pub fn transmit(&mut self, now: Nanos, baud: u32, out: &mut Vec<u8>) {
        self.carry(now);
        let ear = &mut self.host_ear;
        for (byte, sender, start) in self.sent.drain(..) {
            ear.hear(byte, start, [sender, baud], |b| out.push(b));
        }
        // A byte in transit isn't rest.
        let quiet = if self.waiting.is_empty() { now } else { self.free.min(now) };
        ear.rest(quiet, baud, |b| out.push(b));
    }
}

/// True with this probability; draws no number if it is 0.
fn happens(rng: &mut Rng, probability: f64) -> bool {
    probability > 0.0 && rng.random_range(0.0..1.0) < probability
}

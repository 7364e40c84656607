//! A bit-level UART receiver: how bytes sent at another baud rate are garbled.
//!
//! The line is high at rest. A byte is a low start bit, eight data bits, the lowest first, and a high stop bit. A
//! receiver waits for a falling edge, then samples the middle of every bit by its own clock. At a wrong rate it so
//! takes one byte as several or several as one, deterministically. A low stop bit is an error that both ends ignore:
//! the byte is accepted (as terminals do by default).

use super::clock::Nanos;

/// Largest relative difference of rates at which bytes are received correctly: half a bit in ten.
const TOLERANCE: f64 = 0.045;

/// Transmission time of a byte: ten bits.
pub(super) fn byte_time(baud: u32) -> Nanos {
    bits(10, baud)
}

fn bits(count: u64, baud: u32) -> Nanos {
    count * 1_000_000_000 / u64::from(baud.max(1))
}

/// One receiver.
#[derive(Debug, Clone, Default)]
pub(super) struct Uart {
    /// The byte in progress: time of its falling edge, number of sampled bits, and the bits.
    byte: Option<(Nanos, u64, u8)>,
}

impl Uart {
    /// Takes a byte sent from time `from` at the rate `sender`; passes on what a receiver at the rate `own` receives.
    pub fn hear(&mut self, byte: u8, from: Nanos, [sender, own]: [u32; 2], mut out: impl FnMut(u8)) {
        self.rest(from, own, &mut out);
        let difference = f64::from(sender.abs_diff(own));
        if self.byte.is_none() && difference <= TOLERANCE * f64::from(sender.max(own)) {
            out(byte);
            return;
        }
        // Start, data, stop; the bit before is the last stop bit, or rest.
        let levels = (u32::from(byte) << 1) | 1 << 9;
        let level = |bit: u64| bit >= 10 || levels >> bit & 1 == 1;
        let (mut at, end) = (from, from + byte_time(sender));
        loop {
            if let Some((start, seen, _)) = self.byte {
                at = start + bits(2 * seen + 3, own) / 2;
                if at >= end {
                    return;
                }
                let bit = (at - from) * u64::from(sender) / 1_000_000_000;
                self.see(level(bit), &mut out);
            } else {
                let falls =
                    |bit: &u64| !level(*bit) && (*bit == 0 || level(bit - 1)) && from + bits(*bit, sender) >= at;
                let Some(bit) = (0..10).find(falls) else { return };
                self.byte = Some((from + bits(bit, sender), 0, 0));
            }
        }
    }

    /// The line is at rest until `until`.
    pub fn rest(&mut self, until: Nanos, own: u32, mut out: impl FnMut(u8)) {
        while let Some((start, seen, _)) = self.byte
            && start + bits(2 * seen + 3, own) / 2 < until
        {
            self.see(true, &mut out);
        }
    }

    /// Processes a sampled bit.
    fn see(&mut self, is_high: bool, out: &mut impl FnMut(u8)) {
        let Some((start, seen, byte)) = self.byte else { return };
        if seen == 8 {
            self.byte = None;
            out(byte);
        } else {
            self.byte = Some((start, seen + 1, byte | u8::from(is_high) << seen));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heard(bytes: &[u8], sender: u32, own: u32) -> Vec<u8> {
        let (mut uart, mut out) = (Uart::default(), Vec::new());
        let mut at = 1000;
        for &byte in bytes {
            uart.hear(byte, at, [sender, own], |b| out.push(b));
            at += byte_time(sender);
        }
        uart.rest(at + 1_000_000_000, own, |b| out.push(b));
        out
    }

    #[test]
    fn the_same_rate_and_nearly_the_same_are_understood() {
        let all: Vec<u8> = (0..=255).collect();
        assert_eq!(heard(&all, 115_200, 115_200), all);
        assert_eq!(heard(&all, 115_200, 117_000), all);
    }

    /// Sampling bit by bit gives the same result where the rates agree: the short cut above changes nothing.
    #[test]
    fn bits_make_the_byte_again() {
        for byte in 0..=255 {
            let (mut uart, mut out) = (Uart::default(), Vec::new());
            // 5 % off, beyond the short cut, and still in the last bit at the end.
            uart.hear(byte, 500, [100_000, 105_000], |b| out.push(b));
            uart.rest(10_000_000, 105_000, |b| out.push(b));
            assert_eq!(out, [byte]);
        }
    }

    #[test]
    fn slow_bytes_look_like_several_and_fast_ones_like_fewer() {
        // A start bit of 19200 baud is six bits long at 115200: a byte with a low end.
        let slow = heard(&[0x80], 19_200, 115_200);
        assert!(slow.len() > 1 || slow != [0x80], "{slow:?}");
        let fast = heard(&[0x80, 0x8E, 0x23, 0x80, 0x8E, 0x23], 115_200, 19_200);
        assert!(!fast.is_empty() && fast.len() < 6, "{fast:?}");
        assert_eq!(fast, heard(&[0x80, 0x8E, 0x23, 0x80, 0x8E, 0x23], 115_200, 19_200));
    }
}

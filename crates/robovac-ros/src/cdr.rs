//! The Common Data Representation, in which ROS 2 encodes messages: little-endian, every value aligned to its size.

/// Encapsulation: plain CDR, little-endian.
const HEADER: [u8; 4] = [0, 1, 0, 0];

/// A message in the making.
#[derive(Debug)]
pub struct Cdr(Vec<u8>);

impl Default for Cdr {
    fn default() -> Self {
        Self::new()
    }
}

impl Cdr {
    /// An empty message.
    pub fn new() -> Self {
        Self(HEADER.to_vec())
    }

    /// The encoded message, with its encapsulation of four bytes.
    pub fn bytes(self) -> Vec<u8> {
        self.0
    }

    fn value<const N: usize>(&mut self, bytes: [u8; N]) {
        // Counted from the end of the encapsulation.
        let at = self.0.len() - HEADER.len();
        self.0.resize(HEADER.len() + at.next_multiple_of(N), 0);
        self.0.extend(bytes);
    }

    /// `uint8`
    pub fn byte(&mut self, value: u8) {
        self.value([value]);
    }

    /// `bool`, several in turn.
    pub fn flags(&mut self, values: &[bool]) {
        for &value in values {
            self.byte(value.into());
        }
    }

    /// `uint16`
    pub fn short(&mut self, value: u16) {
        self.value(value.to_le_bytes());
    }

    /// `uint32`, and the length of a list.
    pub fn word(&mut self, value: u32) {
        self.value(value.to_le_bytes());
    }

    /// `float32`
    pub fn single(&mut self, value: f32) {
        self.value(value.to_le_bytes());
    }

    /// `float64`, several in turn.
    pub fn doubles(&mut self, values: &[f64]) {
        for value in values {
            self.value(value.to_le_bytes());
        }
    }

    /// A string, with its length and the zero at its end.
    pub fn string(&mut self, text: &str) {
        self.word(text.len() as u32 + 1);
        self.0.extend(text.bytes());
        self.0.push(0);
    }

    /// `std_msgs/Header`
    pub fn header(&mut self, time_s: f64, frame: &str) {
        self.time(time_s);
        self.string(frame);
    }

    /// `builtin_interfaces/Time`
    pub fn time(&mut self, time_s: f64) {
        let nanos = nanos(time_s);
        self.word((nanos / 1_000_000_000) as u32);
        self.word((nanos % 1_000_000_000) as u32);
    }
}

/// Time in ns.
pub fn nanos(time_s: f64) -> u64 {
    (1e9 * time_s).round() as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_aligned_to_their_size() {
        let mut cdr = Cdr::new();
        cdr.byte(1);
        cdr.short(2);
        cdr.string("a");
        cdr.doubles(&[0.5]);
        assert_eq!(
            cdr.bytes(),
            [&[0, 1, 0, 0, 1, 0, 2, 0, 2, 0, 0, 0, b'a', 0, 0, 0, 0, 0, 0, 0][..], &0.5_f64.to_le_bytes()].concat()
        );
    }
}

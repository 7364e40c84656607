//! Classifies unsolicited data on a line.

use super::Finding;
use roomba_oi::{HEADER, Mode, Said, StreamFrame};

/// Most bytes kept.
const MOST: usize = 4096;

/// Bytes received since [`Self::clear`].
#[derive(Debug, Clone, Default)]
pub struct LineClassifier {
    bytes: Vec<u8>,
}

/// Classified bytes.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct LineContent {
    /// Whole frames of a stream.
    pub frames: usize,
    /// Lines of text.
    pub lines: Vec<String>,
    /// The other bytes.
    pub rest: Vec<u8>,
}

impl LineClassifier {
    /// Discards all bytes.
    pub fn clear(&mut self) {
        self.bytes.clear();
    }

    /// Appends bytes.
    pub fn push(&mut self, bytes: &[u8]) {
        let room = MOST - self.bytes.len().min(MOST);
        self.bytes.extend_from_slice(bytes.get(..room).unwrap_or(bytes));
    }

    /// Classifies the bytes.
    pub fn classify(&self) -> LineContent {
        let mut heard = LineContent::default();
        let mut rest = &self.bytes[..];
        while let [first, others @ ..] = rest {
            let length = others.first().map_or(0, |&n| usize::from(n) + 3);
            let frame = (*first == HEADER).then(|| rest.get(..length)).flatten();
            if frame.is_some_and(|bytes| StreamFrame::parse(bytes).is_ok()) {
                heard.frames += 1;
                rest = rest.get(length..).unwrap_or_default();
                continue;
            }
            let printable = rest.iter().take_while(|b| matches!(b, b' '..=b'~' | b'\t')).count();
            let ends = matches!(rest.get(printable), Some(b'\r' | b'\n'));
            // A few printable bytes can be anything; more of them, or some with a line end, are text.
            if printable >= 6 || (ends && printable >= 2) {
                heard.lines.push(rest.iter().take(printable).map(|&b| char::from(b)).collect());
                rest = rest.get(printable..).unwrap_or_default();
                continue;
            }
            if !matches!(first, b'\r' | b'\n') || heard.lines.is_empty() {
                heard.rest.push(*first);
            }
            rest = others;
        }
        heard
    }
}

impl LineContent {
    /// The mode byte that answers a query, after any other bytes.
    pub fn mode_byte(&self) -> Option<u8> {
        let is_mode = |byte: &u8| Mode::from_report(*byte, 0).is_some() || Mode::from_report(*byte, 1).is_some();
        let last = *self.rest.last()?;
        (self.rest.len() <= 4 && self.rest.iter().all(is_mode)).then_some(last)
    }

    /// The finding that follows.
    pub fn finding(&self) -> Finding {
        let said = |what: fn(&Said) -> bool| self.lines.iter().any(|line| what(&Said::of(line)));
        let is_boot_byte = |byte: &u8| matches!(byte, 0xB1 | 0xFE | 0xFF);
        if said(|s| matches!(s, Said::Booting | Said::Firmware(_))) {
            Finding::Booting
        } else if said(|s| matches!(s, Said::Charging(_))) {
            Finding::Charging
        } else if !self.rest.is_empty() && self.rest.iter().all(|&byte| byte == 0xFE) {
            Finding::Bootloader
        } else if !self.rest.is_empty() && self.rest.iter().all(is_boot_byte) {
            Finding::Booting
        } else if self.frames > 0 {
            Finding::Stream
        } else if self.rest.len() > 4 {
            Finding::Garbage
        } else if !self.lines.is_empty() {
            Finding::Text
        } else if self.rest.is_empty() {
            Finding::Silence
        } else {
            Finding::Garbage
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heard(bytes: &[u8]) -> LineContent {
        let mut classifier = LineClassifier::default();
        classifier.push(bytes);
        classifier.classify()
    }

    #[test]
    fn what_real_lines_carry_is_told_apart() {
        let log = b"bat:   min 0  sec 10  mV 5930  mA 302  tenths-deg-C 182  mAH 0  state 6  mode 8\r\n";
        for (bytes, finding) in [
            (&b""[..], Finding::Silence),
            (&[19, 2, 35, 1, 199, 19, 2, 35, 1, 199], Finding::Stream),
            (log, Finding::Charging),
            (b"Soft reset!\n\xFE\nRoomba by iRobot!\n", Finding::Booting),
            (&[0xFE, 0xFE], Finding::Bootloader),
            (&[0xB1, 0xFF], Finding::Booting),
            (&[0x80, 0x1C, 0xE0, 0x9C, 0x03, 0xFC], Finding::Garbage),
            (b"hello there\r\n", Finding::Text),
        ] {
            assert_eq!(heard(bytes).finding(), finding, "{bytes:?}");
        }
    }

    #[test]
    fn the_mode_is_found_between_frames_and_text() {
        assert_eq!(heard(&[1]).mode_byte(), Some(1));
        assert_eq!(heard(&[b"key-wakeup\r\n", &[19, 2, 35, 1, 199, 2][..]].concat()).mode_byte(), Some(2));
        assert_eq!(heard(&[77]).mode_byte(), None);
        assert_eq!(heard(&[0, 0, 0, 0, 1]).mode_byte(), None);
    }
}

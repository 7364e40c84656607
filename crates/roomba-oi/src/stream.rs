//! Extracts frames and text from a robot's byte stream, tolerating line errors.

use super::{
    frame::{FRAMING, FrameError, HEADER, MAX_FRAME, StreamFrame},
    limits::CommandRefusal,
    packet::PacketId,
    text::{LineCollector, Text},
};

/// Something that the bytes turned out to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StreamEvent<'a> {
    /// A frame whose checksum is right.
    Frame(StreamFrame<'a>),
    /// It began like a frame and is none. All bytes but the first are looked at again.
    Refused {
        /// The bytes received so far.
        bytes: &'a [u8],
        /// The error.
        error: FrameError,
    },
    /// The robot wrote something.
    Text(Text<'a>),
}

/// How many of what arrived.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StreamCounts {
    /// Frames whose checksum is right.
    pub frames: u64,
    /// Complete frames whose checksum is wrong.
    pub bad_checksums: u64,
    /// Headers that no frame follows: noise, and frames whose length or packet numbers were garbled.
    pub false_headers: u64,
    /// Lines of text, and pieces of such.
    pub texts: u64,
    /// Bytes that are neither in a frame nor in a text.
    pub noise: u64,
}

/// Finds frames in a stream of bytes, cut up in any way, and text between them.
///
/// Memory is bounded and nothing is allocated. A header is given up as soon as what follows it can't be a frame - a
/// packet that doesn't exist, one that the length cuts, a wrong checksum - and the search goes on with the byte after it. So
/// any bytes give the frames that [`StreamFrame::parse`] finds when it is tried at each byte outside the frame before, however
/// they were cut.
#[derive(Debug, Clone)]
pub struct StreamParser {
    /// Unclassified bytes: none, or a header and the bytes after it.
    buffer: [u8; MAX_FRAME],
    filled: usize,
    /// Bytes of the buffer that have been looked at; all of them, between two calls.
    checked: usize,
    /// Sum of those.
    sum: u8,
    /// Where the next packet's number stands in the buffer.
    next_field: usize,
    /// Packets before it.
    fields: usize,
    /// Subscriptions whose frames are taken; any frame is if there are none. And the one whose length the header has.
    expected: [Option<Expected>; 2],
    promised: usize,
    lines: LineCollector,
    counts: StreamCounts,
}

/// The packets of a subscription: each takes at least two bytes of 255.
#[derive(Debug, Clone, Copy)]
struct Expected {
    ids: [u8; 127],
    /// Length that frames must have.
    length: u8,
}

impl Expected {
    /// Frames with these packets, if there are any.
    fn of(packets: &[u8]) -> Result<Option<Self>, CommandRefusal> {
        if packets.is_empty() {
            return Ok(None);
        }
        let mut length = 0;
        for &id in packets {
            length += 1 + PacketId::size_of(id).ok_or(CommandRefusal::UnknownPacket(id))?;
        }
        let mut ids = [0; 127];
        for (to, &from) in ids.iter_mut().zip(packets) {
            *to = from;
        }
        let room = MAX_FRAME - FRAMING;
        let length = u8::try_from(length).map_err(|_| CommandRefusal::BufferTooSmall { needed: length, got: room })?;
        Ok(Some(Self { ids, length }))
    }
}

impl Default for StreamParser {
    fn default() -> Self {
        Self {
            buffer: [0; MAX_FRAME],
            filled: 0,
            checked: 0,
            sum: 0,
            next_field: 0,
            fields: 0,
            expected: [None; 2],
            promised: 0,
            lines: LineCollector::default(),
            counts: StreamCounts::default(),
        }
    }
}

impl StreamParser {
    /// How many of what arrived so far.
    pub fn counts(&self) -> StreamCounts {
        self.counts
    }

    /// From now on takes frames with exactly these packets in this order only, or any again if there are none. That
    /// leaves hardly any chance to noise, but also refuses the frames of an older subscription.
    pub fn expect(&mut self, packets: &[u8]) -> Result<(), CommandRefusal> {
        self.expect_either([packets, &[]])
    }

    /// The same for two subscriptions that follow each other, of frames of unequal length.
    pub fn expect_either(&mut self, subscriptions: [&[u8]; 2]) -> Result<(), CommandRefusal> {
        let [first, second] = subscriptions;
        self.expected = [Expected::of(first)?, Expected::of(second)?];
        Ok(())
    }

    /// Takes bytes from the line, and returns what they are.
    ///
    /// ```
    /// use roomba_oi::{Readings, StreamEvent, StreamParser};
    /// let mut parser = StreamParser::default();
    /// let mut readings = Readings::default();
    /// // A frame that lost its end, then a whole one.
    /// parser.feed(&[19, 5, 29, 2, 19, 5, 29, 2, 25, 13, 0, 163], &mut |event| {
    ///     if let StreamEvent::Frame(frame) = event {
    ///         frame.apply(&mut readings);
    ///     }
    /// });
    /// assert_eq!(readings.cliff_signal, [0, 537, 0, 0]);
    /// assert_eq!((parser.counts().frames, parser.counts().false_headers), (1, 1));
    /// ```
    pub fn feed(&mut self, bytes: &[u8], sink: &mut impl FnMut(StreamEvent<'_>)) {
        for &byte in bytes {
            if self.filled == 0 && byte != HEADER {
                self.outside(byte, sink);
                continue;
            }
            if let Some(free) = self.buffer.get_mut(self.filled) {
                *free = byte;
                self.filled += 1;
            }
            self.settle(sink);
        }
    }

    /// The line has been quiet for longer than a frame takes, so an incomplete frame won't be completed. Without this a
    /// false header can hold back the bytes after it until its length is reached. Also returns text without a line end.
    pub fn idle(&mut self, sink: &mut impl FnMut(StreamEvent<'_>)) {
        while self.filled > 0 {
            self.refuse(FrameError::Incomplete, sink);
            self.settle(sink);
        }
        self.counts.noise += self.lines.finish(false, &mut |text| {
            self.counts.texts += 1;
            sink(StreamEvent::Text(text));
        });
    }

    /// Discards all bytes, but keeps the counts and the expected packets: for a line that was reopened.
    pub fn clear(&mut self) {
        (self.filled, self.checked, self.sum) = (0, 0, 0);
        self.lines = LineCollector::default();
    }

    /// Processes the remaining bytes.
    fn settle(&mut self, sink: &mut impl FnMut(StreamEvent<'_>)) {
        while self.checked < self.filled {
            match self.check_next() {
                Ok(false) => {}
                Ok(true) => {
                    self.counts.frames += 1;
                    if let Some(fields) = self.buffer.get(2..self.checked - 1) {
                        sink(StreamEvent::Frame(StreamFrame::of_fields(fields)));
                    }
                    self.drop_front(self.checked, sink);
                }
                Err(error) => self.refuse(error, sink),
            }
        }
    }

    /// Looks at one more byte; whether it completes a frame.
    fn check_next(&mut self) -> Result<bool, FrameError> {
        let [_, length, ..] = self.buffer;
        let (at, end) = (self.checked, usize::from(length) + 2);
        let &byte = self.buffer.get(at).ok_or(FrameError::Incomplete)?;
        self.checked += 1;
        self.sum = self.sum.wrapping_add(byte);
        if at < 2 {
            (self.next_field, self.fields) = (2, 0);
            if at == 0 {
                return Ok(false);
            }
            let is_promised = |expected: &Option<Expected>| expected.is_some_and(|expected| expected.length == byte);
            self.promised = self.expected.iter().position(is_promised).unwrap_or_default();
            return match self.expected {
                [None, None] if byte == 0 => Err(FrameError::Empty),
                [None, None] => Ok(false),
                expected if expected.iter().any(is_promised) => Ok(false),
                _ => Err(FrameError::NotExpected),
            };
        }
        if at == end {
            return if self.sum == 0 { Ok(true) } else { Err(FrameError::Checksum(self.sum)) };
        }
        if at == self.next_field {
            self.next_field += 1 + PacketId::size_of(byte).ok_or(FrameError::UnknownPacket(byte))?;
            if self.next_field > end {
                return Err(FrameError::CutPacket(byte));
            }
            let expected = self.expected.get(self.promised).copied().flatten();
            if expected.is_some_and(|expected| expected.ids.get(self.fields) != Some(&byte)) {
                return Err(FrameError::NotExpected);
            }
            self.fields += 1;
        }
        Ok(false)
    }

    /// The header at the front is none.
    fn refuse(&mut self, error: FrameError, sink: &mut impl FnMut(StreamEvent<'_>)) {
        match error {
            FrameError::Checksum(_) => self.counts.bad_checksums += 1,
            _ => self.counts.false_headers += 1,
        }
        if let Some(bytes) = self.buffer.get(..self.checked) {
            sink(StreamEvent::Refused { bytes, error });
        }
        self.outside(HEADER, sink);
        self.drop_front(1, sink);
    }

    /// Lets go of that many bytes, and of those up to the next header.
    fn drop_front(&mut self, count: usize, sink: &mut impl FnMut(StreamEvent<'_>)) {
        let mut from = count;
        while from < self.filled {
            match self.buffer.get(from) {
                Some(&byte) if byte != HEADER => self.outside(byte, sink),
                _ => break,
            }
            from += 1;
        }
        self.buffer.copy_within(from..self.filled, 0);
        self.filled -= from;
        (self.checked, self.sum) = (0, 0);
    }

    /// A byte that belongs to no frame.
    fn outside(&mut self, byte: u8, sink: &mut impl FnMut(StreamEvent<'_>)) {
        self.counts.noise += self.lines.push(byte, &mut |text| {
            self.counts.texts += 1;
            sink(StreamEvent::Text(text));
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODE: [u8; 5] = [19, 2, 35, 1, 199];
    const VOLTAGE: [u8; 6] = [19, 3, 22, 19, 19, 174];

    fn events(parser: &mut StreamParser, bytes: &[u8]) -> Vec<String> {
        let mut events = Vec::new();
        parser.feed(bytes, &mut |event| {
            events.push(match event {
                StreamEvent::Frame(frame) => format!("{:?}", frame.values().collect::<Vec<_>>()),
                StreamEvent::Refused { bytes, error } => format!("{bytes:?} {error}"),
                StreamEvent::Text(text) => text.line.to_string(),
            });
        });
        events
    }

    #[test]
    fn a_false_header_is_given_up_at_the_first_byte_that_fits_no_frame() {
        let mut parser = StreamParser::default();
        assert_eq!(events(&mut parser, &[19, 200, 99]), ["[19, 200, 99] there is no packet 99"]);
        assert_eq!(events(&mut parser, &MODE), ["[(OiMode, 1)]"]);
        assert_eq!(events(&mut parser, &[19, 2, 22]), ["[19, 2, 22] it ends within packet 22"]);
        assert_eq!(parser.counts(), StreamCounts { frames: 1, false_headers: 2, noise: 6, ..StreamCounts::default() });
    }

    #[test]
    fn text_goes_on_after_a_frame_in_its_midst() {
        let mut parser = StreamParser::default();
        let bytes = [b"bat:   min 0 ", &MODE[..], b" sec 10\r\n"].concat();
        assert_eq!(events(&mut parser, &bytes), ["[(OiMode, 1)]", "bat:   min 0  sec 10"]);
        assert_eq!(parser.counts().noise, 0);
    }

    #[test]
    fn quiet_releases_what_a_false_header_held_back() {
        let mut parser = StreamParser::default();
        // 200 bytes are promised, the first 52 of them group 6.
        assert_eq!(events(&mut parser, &[&[19, 200, 6][..], &MODE, b"hello"].concat()), [""; 0]);
        let mut after = Vec::new();
        parser.idle(&mut |event| after.push(format!("{event:?}")));
        assert_eq!(after.len(), 3, "{after:?}");
        assert!(
            after[0].contains("Incomplete") && after[1].contains("Frame") && after[2].contains("hello"),
            "{after:?}"
        );
        assert_eq!(parser.counts().frames, 1);
    }

    #[test]
    fn only_what_was_asked_for_is_taken() {
        let mut parser = StreamParser::default();
        parser.expect(&[35]).unwrap();
        assert_eq!(events(&mut parser, &VOLTAGE)[0], "[19, 3] its packets aren't those requested");
        assert_eq!(events(&mut parser, &[19, 2, 7, 0, 228])[0], "[19, 2, 7] its packets aren't those requested");
        assert_eq!(events(&mut parser, &MODE), ["[(OiMode, 1)]"]);
        assert_eq!(parser.expect(&[59]), Err(CommandRefusal::UnknownPacket(59)));
        assert!(parser.expect(&[100; 4]).is_err());
        parser.expect(&[]).unwrap();
        assert_eq!(events(&mut parser, &VOLTAGE), ["[(Voltage, 4883)]"]);
    }
}

//! Streams: cut, corrupted, mixed with text.

use roomba_oi::{
    MAX_LINE, Packet, PacketId, Readings, Said, StreamEvent, StreamFrame, StreamParser, slot_bytes, write_frame,
};

/// The classified content of a stream, for comparison.
#[derive(Debug, PartialEq, Default)]
pub struct Heard {
    pub frames: Vec<Vec<(Packet, u16)>>,
    pub texts: Vec<(String, bool)>,
    pub refused: Vec<Vec<u8>>,
}

impl Heard {
    pub fn take(&mut self, event: StreamEvent<'_>) {
        match event {
            StreamEvent::Frame(frame) => self.frames.push(frame.values().collect()),
            StreamEvent::Text(text) => self.texts.push((text.line.to_string(), text.ended)),
            StreamEvent::Refused { bytes, .. } => self.refused.push(bytes.to_vec()),
        }
    }
}

/// All that comes out of these bytes, fed in these pieces, and a quiet line at the end.
pub fn hear<'a>(pieces: impl IntoIterator<Item = &'a [u8]>) -> Heard {
    let (mut parser, mut heard) = (StreamParser::default(), Heard::default());
    for piece in pieces {
        parser.feed(piece, &mut |event| heard.take(event));
    }
    parser.idle(&mut |event| heard.take(event));
    let counts = parser.counts();
    assert_eq!(counts.frames, heard.frames.len() as u64);
    assert_eq!(counts.bad_checksums + counts.false_headers, heard.refused.len() as u64);
    assert_eq!(counts.texts, heard.texts.len() as u64);
    heard
}

/// Frames, with the charging log of a robot between them, and a frame that lost a byte.
fn recording() -> Vec<u8> {
    let readings = Readings { voltage_mv: 4883, mode: 19, left_counts: 0x1302, ..Readings::default() };
    let ids = [7, 22, 35, 43, 106].map(|id| PacketId::from_byte(id).unwrap());
    let mut slot = [0; slot_bytes(115_200)];
    let frame = write_frame(&ids, &readings, &mut slot).unwrap();
    let log = b"bat:   min 0  sec 10  mV 5930  mA 302  tenths-deg-C 182  mAH 0  state 6  mode 8\r\n";
    [frame, &log[..30], frame, &log[30..], &frame[..9], &frame[10..], frame, frame, b"key-wakeup\n"].concat()
}

#[test]
fn every_split_in_two_gives_the_same() {
    let bytes = recording();
    let whole = hear([&bytes[..]]);
    assert_eq!(whole.frames.len(), 4);
    assert_eq!(whole.texts.len(), 2, "{:?}", whole.texts);
    assert!(matches!(Said::of(&whole.texts[0].0), Said::Charging(log) if log.voltage_mv == 5930));
    assert_eq!(whole.texts[1], ("key-wakeup".into(), true));
    for at in 0..=bytes.len() {
        assert_eq!(hear([&bytes[..at], &bytes[at..]]), whole, "split at {at}");
    }
    assert_eq!(hear(bytes.chunks(1)), whole);
}

#[test]
fn every_single_flipped_bit_is_noticed() {
    let frame = [19, 5, 29, 2, 25, 13, 0, 163];
    let good: Vec<(Packet, u16)> = StreamFrame::parse(&frame).unwrap().values().collect();
    for bit in 0..8 * frame.len() {
        let mut flipped = frame;
        flipped[bit / 8] ^= 1 << (bit % 8);
        // The frame itself is lost, and the one after it never.
        let heard = hear([&flipped[..], &frame, &frame]);
        assert_eq!(heard.frames.last(), Some(&good));
        assert_eq!(heard.frames, [good.clone(), good.clone()], "bit {bit}");
    }
}

#[test]
fn one_checksum_of_256_is_right() {
    for checksum in 0..=255 {
        let heard = hear([&[19, 5, 29, 2, 25, 13, 0, checksum][..]]);
        assert_eq!(heard.frames.len(), usize::from(checksum == 163), "{checksum}");
    }
}

#[test]
fn packets_that_the_length_cuts_are_refused() {
    // Voltage with one of its two bytes, and with none; the sums are right.
    for bytes in [&[19, 2, 22, 0, 213][..], &[19, 1, 22, 214]] {
        assert_eq!(bytes.iter().map(|&byte| u32::from(byte)).sum::<u32>() % 256, 0);
        assert!(hear([bytes]).frames.is_empty() && StreamFrame::parse(bytes).is_err());
    }
}

#[test]
fn every_lost_byte_costs_one_frame_only() {
    let bytes = recording();
    let frames = hear([&bytes[..]]).frames.len();
    for at in 0..bytes.len() {
        let rest = [&bytes[..at], &bytes[at + 1..]].concat();
        assert!(hear([&rest[..]]).frames.len() >= frames - 1, "byte {at}");
    }
}

#[test]
fn values_are_committed_after_the_checksum_only() {
    let mut parser = StreamParser::default();
    let mut readings = Readings { virtual_wall: true, ..Readings::default() };
    let before = readings.clone();
    for byte in [19, 5, 29, 2, 25, 13, 0, 164] {
        parser.feed(&[byte], &mut |event| {
            if let StreamEvent::Frame(frame) = event {
                frame.apply(&mut readings);
            }
        });
    }
    assert_eq!((readings, parser.counts().bad_checksums), (before, 1));
}

#[test]
fn boot_banner_comes_line_by_line() {
    let banner = b"\r\nbl-start\r\nSTR730\r\nbootloader id: #x47175347 4C636FFF\r\nRoomba by iRobot!\r\n\
        r3_robot/tags/release-3.5.4:6058 CLEAN\r\n\xFE\xFE\xFE";
    let heard = hear(banner.chunks(3));
    assert_eq!(heard.texts.len(), 5);
    assert!(matches!(Said::of(&heard.texts[4].0), Said::Firmware(firmware) if firmware.version == [3, 5, 4]));
    assert!(heard.frames.is_empty() && heard.refused.is_empty());
}

#[test]
fn an_endless_line_is_bounded() {
    let heard = hear([&[b'x'; 10 * MAX_LINE + 7][..]]);
    assert_eq!(heard.texts.iter().map(|(line, _)| line.len()).sum::<usize>(), 10 * MAX_LINE + 7);
    assert!(heard.texts.iter().all(|(line, ended)| line.len() <= MAX_LINE && !ended));
}

#[test]
fn headers_without_end_are_only_slow() {
    let mut bytes = vec![19; 5000];
    bytes.extend([19, 2, 35, 1, 199]);
    let heard = hear([&bytes[..]]);
    assert_eq!(heard.frames.last().map(Vec::as_slice), Some(&[(Packet::OiMode, 1)][..]));
}

//! Whatever a robot sends: no panic, the frames that a search byte by byte finds, however the bytes are cut.
#![no_main]

use libfuzzer_sys::fuzz_target;
use robovac_link::sensors::{to_readings, to_sensors};
use roomba_oi::{AnswerReader, StreamFrame, Readings, Said, StreamEvent, StreamParser};

/// Digest of a frame's values.
fn values(frame: &StreamFrame<'_>) -> Vec<(u8, u16)> {
    frame.values().map(|(packet, raw)| (packet as u8, raw)).collect()
}

fuzz_target!(|input: (u8, &[u8])| {
    let (cut, bytes) = input;
    let mut expected = Vec::new();
    let mut at = 0;
    while let Some(rest) = bytes.get(at..).filter(|rest| !rest.is_empty()) {
        at += StreamFrame::parse(rest).map_or(1, |frame| {
            expected.push(values(&frame));
            frame.size()
        });
    }

    let (mut parser, mut readings, mut found) = (StreamParser::default(), Readings::default(), Vec::new());
    let mut take = |event: StreamEvent<'_>| match event {
        StreamEvent::Frame(frame) => {
            frame.apply(&mut readings);
            found.push(values(&frame));
        }
        StreamEvent::Text(text) => {
            assert!(!text.line.is_empty());
            let _ = Said::of(text.line);
        }
        StreamEvent::Refused { bytes, .. } => assert_eq!(bytes.first(), Some(&19)),
    };
    for piece in bytes.chunks(usize::from(cut) + 1) {
        parser.feed(piece, &mut take);
    }
    parser.idle(&mut take);
    assert_eq!(found, expected);
    assert_eq!(to_readings(&to_sensors(&readings)).light_signal, readings.light_signal);

    // The first byte says how many packets were asked for.
    if let Some((&count, rest)) = bytes.split_first() {
        let (ids, answered) = rest.split_at(rest.len().min(count.into()));
        if let Ok(mut answer) = AnswerReader::to(ids) {
            answer.feed(answered);
            let _ = answer.apply(&mut readings);
        }
    }
});

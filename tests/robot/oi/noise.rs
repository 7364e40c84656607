//! Any bytes at all: no panic, no frame with a bad checksum, and the next good frame is found.

use super::stream::hear;
use proptest::{collection::vec, prelude::*};
use roomba_oi::{MAX_FRAME, Packet, PacketId, Readings, StreamEvent, StreamFrame, StreamParser, write_frame};
use std::ops::Range;

/// Where a frame is, and what it holds.
type Found = (Range<usize>, Vec<(Packet, u16)>);

/// The reference for the parser: try each byte outside of the frame before.
fn reference(bytes: &[u8]) -> Vec<Found> {
    let (mut at, mut found) = (0, Vec::new());
    while at < bytes.len() {
        let Ok(frame) = StreamFrame::parse(&bytes[at..]) else {
            at += 1;
            continue;
        };
        let (end, values) = (at + frame.size(), frame.values().collect());
        assert_eq!(bytes[at..end].iter().fold(0_u8, |sum, &byte| sum.wrapping_add(byte)), 0);
        found.push((at..end, values));
        at = end;
    }
    found
}

/// Bytes as they come from a bad line: anything, with many headers and packet numbers among them.
fn garbage(length: Range<usize>) -> impl Strategy<Value = Vec<u8>> {
    let byte = |[kind, byte]: [u8; 2]| match kind % 11 {
        0..4 => byte,
        4..6 => 19,
        6..8 => 1 + byte % 29,
        8..10 => 7 + byte % 52,
        _ => b"bat: min 0\r\n"[usize::from(byte) % 12],
    };
    vec(any::<[u8; 2]>(), length).prop_map(move |pairs| pairs.into_iter().map(byte).collect())
}

fn frame() -> impl Strategy<Value = Vec<u8>> {
    let ids: Vec<u8> = (0..=255).filter(|&id| PacketId::from_byte(id).is_some()).collect();
    (vec(proptest::sample::select(ids), 1..8), vec(any::<u8>(), 80)).prop_filter_map("too long", |(ids, bytes)| {
        let ids: Vec<PacketId> = ids.into_iter().filter_map(PacketId::from_byte).collect();
        let mut readings = Readings::default();
        readings.read(PacketId::from_byte(100)?, &bytes)?;
        let mut out = [0; MAX_FRAME];
        write_frame(&ids, &readings, &mut out).map(<[u8]>::to_vec).ok()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_is_heard(frames in vec(frame(), 0..12)) {
        let heard = hear(frames.iter().map(Vec::as_slice));
        let written: Vec<Vec<_>> = frames.iter().map(|f| StreamFrame::parse(f).unwrap().values().collect()).collect();
        prop_assert_eq!(heard.frames, written);
        prop_assert!(heard.refused.is_empty() && heard.texts.is_empty());
    }

    #[test]
    fn any_bytes_give_what_a_search_byte_by_byte_finds(
        bytes in vec(prop_oneof![garbage(0..60), frame()], 0..12),
        cuts in vec(1_usize..40, 1..20),
    ) {
        let bytes = bytes.concat();
        let mut pieces = Vec::new();
        let mut rest = &bytes[..];
        for &cut in cuts.iter().cycle() {
            let (piece, after) = rest.split_at(cut.min(rest.len()));
            pieces.push(piece);
            rest = after;
            if rest.is_empty() {
                break;
            }
        }
        let heard = hear(pieces);
        let found: Vec<_> = reference(&bytes).into_iter().map(|(_, values)| values).collect();
        prop_assert_eq!(heard.frames, found);
    }

    #[test]
    fn the_next_good_frame_is_found(before in garbage(0..300), good in frame()) {
        let values: Vec<_> = StreamFrame::parse(&good).unwrap().values().collect();
        let bytes = [&before[..], &good].concat();
        let heard = hear([&bytes[..]]);
        // One thing only can hide it: garbage that is a frame by chance, right checksum and all, and reaches into it.
        let hidden = reference(&bytes).iter().any(|(range, _)| range.start < before.len() && range.end > before.len());
        prop_assert!(hidden || heard.frames.last() == Some(&values));
    }

    #[test]
    fn without_a_header_in_the_garbage_it_is_found_at_once(before in garbage(0..300), good in frame()) {
        let bytes: Vec<u8> = before.into_iter().filter(|&byte| byte != 19).chain(good.iter().copied()).collect();
        let mut parser = StreamParser::default();
        parser.feed(&bytes, &mut |_| {});
        prop_assert_eq!(parser.counts().frames, 1);
    }

    #[test]
    fn a_subscription_hears_its_own_frames_only(bytes in garbage(0..2000), mode in any::<u8>(), left in any::<u16>()) {
        let ids = [35, 43].map(|id| PacketId::from_byte(id).unwrap());
        let mut out = [0; MAX_FRAME];
        let readings = Readings { mode, left_counts: left, ..Readings::default() };
        let good = write_frame(&ids, &readings, &mut out).unwrap();
        let (mut parser, mut last) = (StreamParser::default(), None);
        parser.expect(&[35, 43]).unwrap();
        for piece in [&bytes[..], good] {
            parser.feed(piece, &mut |event| {
                if let StreamEvent::Frame(frame) = event {
                    last = Some(frame.values().collect::<Vec<_>>());
                }
            });
        }
        parser.idle(&mut |_| {});
        // Its own is among them, as garbage can hide it only by having its header, length, packets and checksum.
        let values = last.expect("the good frame is heard");
        prop_assert_eq!(values, [(Packet::OiMode, mode.into()), (Packet::LeftEncoder, left)]);
    }

    #[test]
    fn every_byte_is_counted_once(bytes in garbage(0..2000)) {
        let mut parser = StreamParser::default();
        let (mut in_frames, mut in_texts) = (0, 0);
        let mut count = |event: StreamEvent<'_>| match event {
            StreamEvent::Frame(frame) => in_frames += frame.size(),
            StreamEvent::Text(text) => in_texts += text.line.len(),
            StreamEvent::Refused { .. } => {}
        };
        parser.feed(&bytes, &mut count);
        parser.idle(&mut count);
        let ends = bytes.iter().filter(|byte| matches!(byte, b'\r' | b'\n')).count();
        let counted = in_frames + in_texts + parser.counts().noise as usize;
        prop_assert!(counted <= bytes.len() && counted + ends >= bytes.len(), "{} of {}", counted, bytes.len());
    }
}

//! Benchmarks of the sensor stream.

use super::Bench;
use robovac_link::{connection::Connection, driver::FRAME_S};
use roomba_oi::{MAX_FRAME, PacketId, Readings, StreamParser, write_frame};

/// Bytes of the parsed stream, bytes of one of its frames, and frames for the whole connection: one minute.
const STREAM_BYTES: usize = 10_000_000;
const FRAME_BYTES: usize = 84;
const HEARD_FRAMES: usize = 4000;
/// Frames after which the robot reports its mode, which has been requested by then.
const ANSWER_AFTER: usize = 40;

/// Frames of all sensors: parsed alone, and processed by a whole connection.
pub fn streaming(bench: &mut Bench<'_>) {
    let stream = stream(STREAM_BYTES);
    let mut parse = || {
        let mut parser = StreamParser::default();
        parser.feed(&stream, &mut |_| {});
    };
    bench.take(&format!("parse {} MB of sensor stream", STREAM_BYTES / 1_000_000), &mut parse, None);
    let mut hear = || {
        let mut link = Connection::new();
        for (index, frame) in stream.chunks_exact(FRAME_BYTES).take(HEARD_FRAMES).enumerate() {
            let now = index as f64 * FRAME_S;
            if index == 0 {
                link.opened(now);
            }
            link.feed(now, frame);
            if index == ANSWER_AFTER {
                link.feed(now, &[1]);
            }
            link.tick(now);
            let _ = (link.take_tx(), link.take_trace());
            // As often as the worker updates its page.
            if index % 3 == 0 {
                let _ = (link.view(now), link.take_traffic());
            }
        }
    };
    bench.take("hear all sensors at full rate", &mut hear, Some(HEARD_FRAMES as f64 * FRAME_S));
}

/// Frames of all packets as a robot streams them, with every value changing; at most `bytes` of them.
pub fn stream(bytes: usize) -> Vec<u8> {
    let mut stream = Vec::with_capacity(bytes);
    let mut buffer = [0; MAX_FRAME];
    let Some(all) = PacketId::from_byte(100) else { return stream };
    let mut readings = Readings { mode: 1, capacity_mah: 2696, voltage_mv: 15_000, ..Readings::default() };
    while stream.len() + FRAME_BYTES <= bytes {
        readings.left_counts = readings.left_counts.wrapping_add(7);
        readings.right_counts = readings.right_counts.wrapping_add(11);
        readings.light_signal = readings.light_signal.map(|signal| (signal + 13) % 4096);
        readings.current_ma = -400 - (readings.left_counts % 300) as i16;
        match write_frame(&[all], &readings, &mut buffer) {
            Ok(frame) => stream.extend_from_slice(frame),
            Err(_) => break,
        }
    }
    stream
}

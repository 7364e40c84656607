//! Any file as a recording: no panic, and what is read can be played.
#![no_main]

use libfuzzer_sys::fuzz_target;
use robovac_link::connection::{LineRecording, Replay};

fuzz_target!(|text: &str| {
    for text in [text.to_owned(), format!("robovac-oi-recording 1\n{text}")] {
        let Ok(recording) = LineRecording::parse(&text) else { continue };
        let mut replay = Replay::new(recording);
        if replay.duration_s() < 60.0 {
            replay.advance(f64::INFINITY);
            let _ = (replay.view(), replay.take_traffic(), replay.take_trace());
        }
    }
});

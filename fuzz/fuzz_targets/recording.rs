//! Any file as a recording: no panic, and what is read can be played, examined, written as a table and made a twin.
#![no_main]

use libfuzzer_sys::fuzz_target;
use robovac_link::{
    connection::{LineRecording, Replay},
    recording::{Examination, csv},
    twin::TwinFit,
};
use std::sync::Arc;

fuzz_target!(|text: &str| {
    for text in [text.to_owned(), format!("robovac-oi-recording 1\n{text}")] {
        let Ok(recording) = LineRecording::parse(&text) else { continue };
        let recording = Arc::new(recording);
        let mut replay = Replay::new(Arc::clone(&recording));
        if replay.duration_s() < 60.0 {
            replay.advance(f64::INFINITY);
            let _ = (replay.view(), replay.take_traffic(), replay.take_trace());
            let mut examination = Examination::new(Arc::clone(&recording));
            while examination.go_on(10.0) {}
            let _ = examination.timeline().summary();
            let _ = csv(Arc::clone(&recording), |_| Ok::<_, ()>(()));
            if let Ok(fit) = TwinFit::of(Arc::clone(&recording)) {
                let _ = fit.check(recording);
            }
        }
    }
});

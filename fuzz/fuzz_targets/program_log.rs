//! Logs of users' programs: none panics, what is accepted is in order, and comes back from its bytes.
#![no_main]

use libfuzzer_sys::fuzz_target;
use robovac_sim::program::{CommandLog, LogPart};

fuzz_target!(|data: &[u8]| {
    let Ok(part) = LogPart::from_bytes(data) else { return };
    let mut log = CommandLog::default();
    (0..100).for_each(|step| log.push([step, -step]));
    for shown in [0, 50] {
        let mut log = log.clone();
        if log.extend_beyond(shown, part.clone()).is_ok() {
            assert!(log.changes().is_sorted_by(|a, b| a.step < b.step));
            assert!(log.changes().iter().all(|change| change.step < log.until()) && log.until() >= shown);
            assert_eq!(CommandLog::from_bytes(&log.to_bytes()), Ok(log));
        }
    }
});

//! Map files of any content: no panic, and what is taken in can be written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use robovac_core::floor_plan::{Scenario, SourceFile, load, to_ascii};

fuzz_target!(|bytes: &[u8]| {
    let file = |name: &str, bytes: &[u8]| SourceFile { name: name.into(), bytes: bytes.into() };
    // Once as a map by itself, once as the description of a small image.
    let image = file("map.pgm", b"P5 2 1 255\n\xfe\x00");
    let _ = load(&[file("map.yaml", bytes), image]);
    if let Ok(plan) = load(&[file("map", bytes)]) {
        let text = load(&[file("map.txt", to_ascii(&plan).as_bytes())]).expect("written as text");
        assert_eq!(text.occupancy, plan.occupancy);
        let scenario = load(&[file("map.json", Scenario::of(&plan).to_json().as_bytes())]).expect("written as scenario");
        assert_eq!(scenario.occupancy, plan.occupancy);
    }
});

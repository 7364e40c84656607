//! Scenario files of any content: no panic, and what is taken in comes back as it was written, objects and all.
#![no_main]

use libfuzzer_sys::fuzz_target;
use robovac_core::floor_plan::Scenario;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(scenario) = Scenario::read("a.json", bytes) {
        let again = Scenario::read("b.json", scenario.to_json().as_bytes()).expect("written as scenario");
        assert_eq!(again, scenario);
        let objects = |scenario: &Scenario| scenario.plan("a.json").expect("checked when it was read").objects;
        assert_eq!(objects(&again), objects(&scenario));
    }
});

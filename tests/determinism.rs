//! The same seed gives the same run, natively and in WebAssembly, to the last bit.

use robovac_playground::app::Session;
use wasm_bindgen_test::wasm_bindgen_test;
#[cfg(target_arch = "wasm32")]
wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);

/// Digest of everything that a run of `seconds` leaves behind.
fn digest(link: &str, seconds: f64) -> u64 {
    let mut session = Session::new();
    session.restore(link).unwrap();
    session.plan_now(|| 0.0);
    session.run_ahead(seconds);
    session.recording().unwrap().run().digest()
}

/// Half an hour in the flat, with slipping wheels. If a change is meant to alter runs, commit the new number.
#[wasm_bindgen_test(unsupported = test)]
fn furnished_flat_with_slip() {
    assert_eq!(
        format!("{:016x}", digest("room=flat&planner=boustrophedon&slip=typical&seed=42", 1800.0)),
        "2b555fcca53877f9"
    );
}

/// The snake, with contact all the time: wheels that slip harshly.
#[wasm_bindgen_test(unsupported = test)]
fn twelve_foot_room_with_harsh_slip() {
    assert_eq!(format!("{:016x}", digest("room=room12ft&planner=snake&slip=harsh&seed=7", 1800.0)), "c30852545b8b610b");
}

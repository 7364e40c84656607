//! Benchmarks in the browser, with a clock and a memory gauge.

use super::{clock, to_js};
use js_sys::Function;
use robovac_app::bench::{Bench, BenchResult};
use wasm_bindgen::JsValue;

/// Size of a page of memory, bytes (WebAssembly's specification).
#[cfg(target_arch = "wasm32")]
const PAGE: usize = 65_536;

/// Runs `cases`, each a single time if `once`, calls `on_result` with each result as it comes, and returns them all.
pub fn run(cases: &[fn(&mut Bench<'_>)], once: bool, on_result: &Function) -> Result<JsValue, JsValue> {
    let clock = || clock() / 1000.0;
    let mut report = |result: &BenchResult| {
        if let Ok(object) = to_js(result) {
            // Errors of the listener don't stop the run.
            let _ = on_result.call1(&JsValue::NULL, &object);
        }
    };
    // An instance's memory never shrinks, so this is the peak.
    #[cfg(target_arch = "wasm32")]
    let memory = || Some(core::arch::wasm32::memory_size(0) * PAGE);
    #[cfg(not(target_arch = "wasm32"))]
    let memory = || None;
    let mut bench = Bench::new(&clock, &memory, &mut report).once_each(once);
    for measure in cases {
        measure(&mut bench);
    }
    to_js(&bench.into_results())
}

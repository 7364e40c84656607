//! The benchmark in the browser: the cases of one module.

use super::{clock, to_js};
use crate::app::bench::{self, Bench};
use js_sys::Function;
use wasm_bindgen::prelude::*;

/// Bytes of a page of memory, by WebAssembly's specification.
const PAGE: usize = 65_536;

/// Runs all cases of the workshop, calls `on_result` with each as it comes, and returns them all. Blocks: call it in a
/// worker.
#[cfg(feature = "workshop")]
#[wasm_bindgen]
pub fn bench(on_result: &Function) -> Result<JsValue, JsValue> {
    run(&[bench::planning, bench::mapping, bench::streaming], on_result)
}

/// The same for the drafting room.
#[cfg(feature = "draft")]
#[wasm_bindgen]
pub fn bench_draft(on_result: &Function) -> Result<JsValue, JsValue> {
    run(&[bench::drafting], on_result)
}

/// The bytes of a DXF with so many entities, for what only the page can measure.
#[cfg(feature = "draft")]
#[wasm_bindgen]
pub fn office_drawing(entities: usize) -> Vec<u8> {
    bench::office_drawing(entities)
}

fn run(cases: &[fn(&mut Bench<'_>)], on_result: &Function) -> Result<JsValue, JsValue> {
    let clock = || clock() / 1000.0;
    let mut report = |result: &bench::BenchResult| {
        if let Ok(object) = to_js(result) {
            // A page that can't show the result shouldn't stop the run.
            let _ = on_result.call1(&JsValue::NULL, &object);
        }
    };
    // An instance's memory never shrinks, so this is the most that it has had.
    let memory = || Some(core::arch::wasm32::memory_size(0) * PAGE);
    let mut bench = Bench::new(&clock, &memory, &mut report);
    for measure in cases {
        measure(&mut bench);
    }
    to_js(&bench.into_results())
}

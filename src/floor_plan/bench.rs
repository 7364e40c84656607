//! The benchmark of drawings in the browser.

use js_sys::Function;
use robovac_app::bench;
use robovac_playground::wire::benchmark::run;
use wasm_bindgen::prelude::*;

/// Runs the cases about drawings, each a single time if `once`, calls `on_result` with each result as it comes, and returns
/// them all. Blocks: call it in a worker.
#[wasm_bindgen(unchecked_return_type = "rust.BenchResult[]")]
pub fn bench_drawings(once: bool, on_result: &Function) -> Result<JsValue, JsValue> {
    run(&[bench::floor_plan], once, on_result)
}

/// The bytes of a DXF with so many entities, for what only the page can measure.
#[wasm_bindgen]
pub fn office_drawing(entities: usize) -> Vec<u8> {
    bench::office_drawing(entities)
}

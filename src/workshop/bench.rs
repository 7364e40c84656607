//! The benchmark in the browser: planning, mapping, streaming.

use js_sys::Function;
use robovac_app::bench;
use robovac_playground::wire::benchmark::run;
use wasm_bindgen::prelude::*;

/// Runs all cases of the workshop, each a single time if `once`, calls `on_result` with each as it comes, and returns them all. Blocks: call it in a
/// worker.
#[wasm_bindgen(unchecked_return_type = "rust.BenchResult[]")]
pub fn bench(once: bool, on_result: &Function) -> Result<JsValue, JsValue> {
    run(&[bench::planning, bench::programs, bench::mapping, bench::streaming], once, on_result)
}

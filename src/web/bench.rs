//! The benchmark in the browser.

use super::{clock, to_js};
use js_sys::Function;
use wasm_bindgen::prelude::*;

/// Runs all cases, calls `on_result` with each as it comes, and returns them all. Blocks: call it in a worker.
#[wasm_bindgen]
pub fn bench(on_result: &Function) -> Result<JsValue, JsValue> {
    let results = crate::app::bench::run(&|| clock() / 1000.0, &mut |result| {
        if let Ok(object) = to_js(result) {
            // A page that can't show the result shouldn't stop the run.
            let _ = on_result.call1(&JsValue::NULL, &object);
        }
    });
    to_js(&results)
}

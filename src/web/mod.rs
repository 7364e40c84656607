//! The only code that knows wasm-bindgen, web-sys and js-sys.
//!
//! The boundary is coarse: one `Playground` and one `Comparison` on the page, `plan` and `Trials` in workers, a handful of calls a frame.

mod bench;
mod canvas;
mod catalogue;
mod comparison;
mod comparison_view;
mod layer;
mod plan_job;
mod playground;
mod robot;
mod search;
mod trial;

pub use bench::bench;
pub use comparison::Comparison;
pub use plan_job::plan;
pub use playground::Playground;
pub use trial::Trials;

use serde::Serialize;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Milliseconds since the page or worker started.
    #[wasm_bindgen(js_namespace = performance, js_name = now)]
    fn clock() -> f64;
}

/// A value as a plain JavaScript object.
fn to_js(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(|e| JsValue::from(e.to_string()))
}

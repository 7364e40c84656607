//! The only code that knows wasm-bindgen, web-sys and js-sys.
//!
//! It is compiled into two modules. The page's has one `Playground`, one `Comparison` and one `MonteCarlo`, a
//! handful of calls a frame; the workshop's, which runs in workers and is loaded when it is first needed, has `plan`,
//! `Trials`, `Runner`, `read_map` and `bench`.
//! Plain objects and arrays go to and fro between them: `request` and `map` say how.

#[cfg(feature = "workshop")]
mod bench;
#[cfg(feature = "page")]
mod canvas;
#[cfg(feature = "page")]
mod catalogue;
#[cfg(feature = "page")]
mod comparison;
#[cfg(feature = "page")]
mod comparison_view;
#[cfg(feature = "page")]
mod furnish;
#[cfg(feature = "page")]
mod layer;
mod map;
#[cfg(feature = "page")]
mod montecarlo;
#[cfg(feature = "page")]
mod objects;
#[cfg(feature = "workshop")]
mod plan_job;
#[cfg(feature = "page")]
mod playground;
mod request;
#[cfg(feature = "page")]
mod robot;
#[cfg(feature = "workshop")]
mod runner;
#[cfg(feature = "page")]
mod search;
#[cfg(feature = "page")]
mod sensed;
#[cfg(feature = "workshop")]
mod trial;

#[cfg(feature = "workshop")]
pub use bench::bench;
#[cfg(feature = "page")]
pub use comparison::Comparison;
#[cfg(feature = "workshop")]
pub use map::read_map;
#[cfg(feature = "page")]
pub use montecarlo::MonteCarlo;
#[cfg(feature = "workshop")]
pub use plan_job::plan;
#[cfg(feature = "page")]
pub use playground::Playground;
#[cfg(feature = "workshop")]
pub use runner::Runner;
#[cfg(feature = "workshop")]
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

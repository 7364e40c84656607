//! Values passed between the page and its workers, and between Rust and JavaScript: plain objects and arrays,
//! or bytes if JavaScript only hands them on.

pub mod benchmark;
pub mod bytes;
pub mod frames;
pub mod map_file;
pub mod pictures;
pub mod proof;
pub mod request;
pub mod trajectory;
pub mod walk;

use serde::Serialize;
use wasm_bindgen::prelude::*;

/// Import of the types that methods name: written by the test `types` of `tests/page`.
#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = "import type * as rust from \"./www/types\";";

#[wasm_bindgen]
extern "C" {
    /// Milliseconds since the page or worker started.
    #[wasm_bindgen(js_namespace = performance, js_name = now)]
    pub fn clock() -> f64;
}

/// A value as a plain JavaScript object.
pub fn to_js(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(|e| JsValue::from(e.to_string()))
}

/// An error as the message that JavaScript catches.
pub fn message(error: impl std::fmt::Display) -> JsValue {
    error.to_string().into()
}

//! Values as bytes, for what passes from one module to another and JavaScript only hands on: takes less code in the page than
//! objects.

use super::message;
use serde::{Deserialize, Serialize};
use wasm_bindgen::JsValue;

/// A value as bytes.
pub fn to_bytes(value: &impl Serialize) -> Result<Vec<u8>, JsValue> {
    postcard::to_allocvec(value).map_err(message)
}

/// The inverse of [`to_bytes`], in a module of the same build.
pub fn from_bytes<'a, T: Deserialize<'a>>(bytes: &'a [u8]) -> Result<T, JsValue> {
    postcard::from_bytes(bytes).map_err(message)
}

//! The only code that knows wasm-bindgen, web-sys and js-sys.

mod canvas;
mod layer;
mod robot;

pub use canvas::Canvas;
use wasm_bindgen::prelude::*;

/// Version of the crate.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

//! Map files, read in a worker, as large ones take time.

use js_sys::Array;
use robovac_app::Import;
use robovac_playground::wire::map_file::{import_to_bytes, source_files};
use wasm_bindgen::prelude::*;

/// Reads an array of `{ name, bytes }` that belong together: a map, or a scenario. To be called in a worker.
///
/// Returns the argument of `Playground.take_map`; throws a message if the files aren't a map.
#[wasm_bindgen]
pub fn read_map(files: &Array) -> Result<Vec<u8>, JsValue> {
    import_to_bytes(Import::read(&source_files(files)?).map_err(|e| e.to_string())?)
}

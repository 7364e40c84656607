//! Generated flats, made in a worker: the generator isn't in the page's module.

use robovac_app::Import;
use robovac_core::floor_plan::generate::{FlatId, FlatIdError};
use robovac_playground::wire::map_file::import_to_bytes;
use wasm_bindgen::prelude::*;

/// The furnished flat with that name, such as `7` or `7~area:40..60`: the argument of `Playground.take_map`. Throws a
/// message if the text names none.
#[wasm_bindgen]
pub fn flat(id: &str) -> Result<Vec<u8>, JsValue> {
    let id: FlatId = id.parse().map_err(|e: FlatIdError| e.to_string())?;
    import_to_bytes(Import { plan: id.build(), choices: None })
}

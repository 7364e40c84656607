//! Film frames from a worker, as plain objects.

use crate::wire::proof::proof_from_js;
use crate::wire::proof::proof_to_js;
use crate::wire::walk;
use coverage_planners::FilmFrame;
use js_sys::Float64Array;
use js_sys::Object;
use js_sys::{Array, Reflect};
use wasm_bindgen::JsValue;

/// An array of `{ path, proof, planner, number }`: see [`walk::path_to_js`], `[cost, bound]` or nothing, a title or "", and the
/// number of improvements so far.
pub fn frames_to_js(frames: &[FilmFrame]) -> Result<Array, JsValue> {
    let film = Array::new();
    for frame in frames {
        let object = Object::new();
        Reflect::set(&object, &"path".into(), &walk::path_to_js(&frame.path.cells, &frame.path.line))?;
        Reflect::set(&object, &"proof".into(), &proof_to_js(frame.proof))?;
        Reflect::set(&object, &"planner".into(), &frame.planner.as_str().into())?;
        Reflect::set(&object, &"number".into(), &frame.number.into())?;
        film.push(&object);
    }
    Ok(film)
}

/// The inverse of [`frames_to_js`].
pub fn frames_from_js(film: &Array) -> Result<Vec<FilmFrame>, JsValue> {
    let frame = |object: JsValue| -> Result<FilmFrame, JsValue> {
        let proof = Reflect::get(&object, &"proof".into())?;
        let proof = (!proof.is_undefined()).then(|| Float64Array::new(&proof).to_vec());
        Ok(FilmFrame {
            path: walk::path_from_js(&Reflect::get(&object, &"path".into())?),
            proof: proof_from_js(proof),
            planner: Reflect::get(&object, &"planner".into())?.as_string().unwrap_or_default(),
            number: Reflect::get(&object, &"number".into())?.as_f64().unwrap_or(0.0) as u32,
        })
    };
    film.iter().map(frame).collect()
}

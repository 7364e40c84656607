//! Paths from a worker: cells of a walk as x, y, x, y, ...; corners of a path in metres in the same way, as an array of
//! another type.

use coverage_planners::CoveragePath;
use js_sys::{Float64Array, Uint32Array};
use robovac_core::{geometry::Point, grid::Cell};
use wasm_bindgen::{JsCast, JsValue};

/// A walk as x, y, x, y, ...
pub fn flat(cells: &[Cell]) -> Uint32Array {
    let flat: Vec<u32> = cells.iter().flat_map(|c| [c.x as u32, c.y as u32]).collect();
    Uint32Array::from(flat.as_slice())
}

/// The inverse of [`flat`].
pub fn cells(flat: &[u32]) -> Vec<Cell> {
    flat.chunks_exact(2).map(|c| Cell::new(c[0] as i32, c[1] as i32)).collect()
}

/// A walk as a `Uint32Array`, or the corners of a path in metres as a `Float64Array`.
pub fn path_to_js(cells: &[Cell], line: &[Point]) -> JsValue {
    if line.is_empty() {
        return flat(cells).into();
    }
    let flat: Vec<f64> = line.iter().flat_map(|p| [p.x, p.y]).collect();
    Float64Array::from(flat.as_slice()).into()
}

/// The inverse of [`path_to_js`].
pub fn path_from_js(flat: &JsValue) -> CoveragePath {
    match flat.dyn_ref::<Float64Array>() {
        Some(line) => {
            let line = line.to_vec();
            CoveragePath::in_metres(line.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect())
        }
        None => CoveragePath::walk(cells(&Uint32Array::new(flat).to_vec())),
    }
}

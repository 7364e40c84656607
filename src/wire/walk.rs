//! Walks from a worker: cells as x, y, x, y, ...

use js_sys::Uint32Array;
use robovac_core::grid::Cell;

/// A walk as x, y, x, y, ...
pub fn flat(cells: &[Cell]) -> Uint32Array {
    let flat: Vec<u32> = cells.iter().flat_map(|c| [c.x as u32, c.y as u32]).collect();
    Uint32Array::from(flat.as_slice())
}

/// The inverse of [`flat`].
pub fn cells(flat: &[u32]) -> Vec<Cell> {
    flat.chunks_exact(2).map(|c| Cell::new(c[0] as i32, c[1] as i32)).collect()
}

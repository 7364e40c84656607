//! Walks from a worker: cells as x, y, x, y, ...

use crate::grid::Cell;
#[cfg(feature = "workshop")]
use js_sys::Uint32Array;

/// A walk as x, y, x, y, ...
#[cfg(feature = "workshop")]
pub(super) fn flat(cells: &[Cell]) -> Uint32Array {
    let flat: Vec<u32> = cells.iter().flat_map(|c| [c.x as u32, c.y as u32]).collect();
    Uint32Array::from(flat.as_slice())
}

/// The inverse of [`flat`].
pub(super) fn cells(flat: &[u32]) -> Vec<Cell> {
    flat.chunks_exact(2).map(|c| Cell::new(c[0] as i32, c[1] as i32)).collect()
}

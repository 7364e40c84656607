//! Rectangles that tests draw.

use robovac_core::grid::{Cell, Grid};

/// Fills the pixels of a rectangle: left, bottom, right, top.
pub(super) fn fill(walls: &mut Grid<bool>, [left, bottom, right, top]: [i32; 4]) {
    for (x, y) in (bottom..top).flat_map(|y| (left..right).map(move |x| (x, y))) {
        walls[Cell::new(x, y)] = true;
    }
}

/// Draws the sides of a rectangle, `pen` pixels wide.
pub(super) fn frame(walls: &mut Grid<bool>, [left, bottom, right, top]: [i32; 4], pen: i32) {
    for side in [
        [left, bottom, right, bottom + pen],
        [left, top - pen, right, top],
        [left, bottom, left + pen, top],
        [right - pen, bottom, right, top],
    ] {
        fill(walls, side);
    }
}

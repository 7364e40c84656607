//! Downsampled grids for display.

use robovac_core::grid::{Cell, Grid};

/// A grid with at most `most` cells a side, and the factor of its cell size. A coarse cell is set if all its cells are;
/// those in the last column and row can reach beyond the grid.
///
/// ```
/// use robovac_app::floor_plan::coarse;
/// use robovac_core::grid::Grid;
/// let free = Grid::filled(5, 2, true);
/// let (grid, times) = coarse(free, 3);
/// assert_eq!((grid.width(), grid.height(), times), (3, 1, 2));
/// ```
pub fn coarse(grid: Grid<bool>, most: usize) -> (Grid<bool>, usize) {
    let times = grid.width().max(grid.height()).div_ceil(most.max(1));
    if times <= 1 {
        return (grid, 1);
    }
    let mut coarse = Grid::filled(grid.width().div_ceil(times), grid.height().div_ceil(times), true);
    for (cell, is_set) in grid.iter() {
        coarse[Cell::new(cell.x / times as i32, cell.y / times as i32)] &= is_set;
    }
    (coarse, times)
}

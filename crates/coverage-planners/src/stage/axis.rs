//! Stage: the transposed room, so that stages for rows also work on columns.

use crate::CoverageJob;
use robovac_core::grid::{Cell, Direction, Grid};

/// Whether lanes along the rows are at most as many as lanes along the columns. Each costs about two turns.
pub fn lanes_lie_down(free: &Grid<bool>) -> bool {
    lanes_along_rows(free) <= lanes_along_columns(free)
}

/// Number of lanes along the rows.
fn lanes_along_rows(free: &Grid<bool>) -> usize {
    let begun_inside = |row: &[bool]| row.windows(2).filter(|w| !w[0] && w[1]).count();
    free.values().chunks(free.width()).map(|row| usize::from(row[0]) + begun_inside(row)).sum()
}

/// Number of lanes along the columns.
fn lanes_along_columns(free: &Grid<bool>) -> usize {
    let rows = || free.values().chunks(free.width());
    let begun_above = |(below, row): (&[bool], &[bool])| below.iter().zip(row).filter(|(b, r)| !**b && **r).count();
    let lowest: usize = rows().take(1).flatten().map(|&is_free| usize::from(is_free)).sum();
    lowest + rows().zip(rows().skip(1)).map(begun_above).sum::<usize>()
}

/// The job with x and y swapped.
pub fn swap_axes(job: &CoverageJob) -> CoverageJob {
    CoverageJob {
        free: swap_grid(&job.free),
        start: swap_cell(job.start),
        heading: swap_direction(job.heading),
        place: None,
        ..*job
    }
}

/// A walk with x and y swapped.
pub fn swap_walk(walk: &mut [Cell]) {
    for cell in walk {
        *cell = swap_cell(*cell);
    }
}

/// A cell with x and y swapped.
pub(super) fn swap_cell(cell: Cell) -> Cell {
    Cell::new(cell.y, cell.x)
}

/// A direction with x and y swapped.
pub(super) fn swap_direction(direction: Direction) -> Direction {
    match direction {
        Direction::Right => Direction::Up,
        Direction::Up => Direction::Right,
        Direction::Left => Direction::Down,
        Direction::Down => Direction::Left,
    }
}

/// A grid with x and y swapped.
pub fn swap_grid(grid: &Grid<bool>) -> Grid<bool> {
    let mut swapped = Grid::filled(grid.height(), grid.width(), false);
    let height = grid.height();
    for (y, row) in grid.values().chunks(grid.width()).enumerate() {
        for (value, &is_free) in swapped.values_mut()[y..].iter_mut().step_by(height).zip(row) {
            *value = is_free;
        }
    }
    swapped
}

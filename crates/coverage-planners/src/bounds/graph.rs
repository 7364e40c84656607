//! Free cells, numbered row by row, with their neighbours' numbers.

use robovac_core::grid::{Cell, Grid};

/// No neighbour on that side.
pub const NONE: u32 = u32::MAX;

/// The free cells of a job.
pub struct Graph {
    /// Per cell its neighbours counter-clockwise from the right, [`NONE`] where there is a wall.
    pub neighbours: Vec<[u32; 4]>,
    /// Number of the start.
    pub start: usize,
    /// Numbers of all cells, [`NONE`] for walls.
    pub numbers: Grid<u32>,
}

impl Graph {
    pub fn new(free: &Grid<bool>, start: Cell) -> Self {
        let mut count = 0;
        let numbers = free.map(|&is_free| {
            let number = if is_free { count } else { NONE };
            count += u32::from(is_free);
            number
        });
        let number = |cell: Cell| numbers.get(cell).copied().unwrap_or(NONE);
        let cells = free.iter().filter(|&(_, &is_free)| is_free);
        Self {
            neighbours: cells.map(|(cell, _)| cell.neighbours().map(number)).collect(),
            start: number(start) as usize,
            numbers,
        }
    }

    pub fn len(&self) -> usize {
        self.neighbours.len()
    }
}

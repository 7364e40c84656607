//! Random rooms from a seed, for tests and benchmarks.

use crate::{
    grid::{Cell, Grid, reachable},
    rng::{Rng, seeded},
};
use rand::RngExt;

/// Share of the floor that is occupied in [`random_hall`].
const HALL_FILL: f64 = 0.1;
/// Sides of the obstacles in [`random_hall`], in cells.
const HALL_SIDES: std::ops::RangeInclusive<usize> = 2..=40;

/// A hall of `width` x `height` cells with rectangles of 2 to 40 cells a side, until a tenth of it is occupied.
///
/// True is free. The lower-left cell is free, and so is every cell connected with it; cells cut off from it are filled.
pub fn random_hall(width: usize, height: usize, seed: u64) -> Grid<bool> {
    let mut rng = seeded(seed, 0);
    let mut free = Grid::filled(width, height, true);
    let to_fill = (HALL_FILL * free.len() as f64) as usize;
    let mut filled = 0;
    while filled < to_fill {
        // Small halls get small furniture.
        let mut side = |length: usize| rng.random_range(HALL_SIDES).min(length.div_ceil(4));
        let (wide, high) = (side(width), side(height));
        filled += fill(&mut free, wide, high, &mut rng);
    }
    free[START] = true;
    reachable(&free, START)
}

/// Each cell blocked with probability `share`, 0 to 1; cells not connected with the lower-left cell are filled.
pub fn random_clutter(width: usize, height: usize, share: f64, seed: u64) -> Grid<bool> {
    let mut rng = seeded(seed, 0);
    let mut free = Grid::filled(width, height, true);
    free.values_mut().iter_mut().for_each(|cell| *cell = !rng.random_bool(share));
    free[START] = true;
    reachable(&free, START)
}

/// The cell that stays free.
const START: Cell = Cell::new(0, 0);

/// Fills a rectangle at a random place; returns the number of cells that were free before.
fn fill(free: &mut Grid<bool>, wide: usize, high: usize, rng: &mut Rng) -> usize {
    let left = rng.random_range(0..=free.width() - wide);
    let bottom = rng.random_range(0..=free.height() - high);
    let mut filled = 0;
    for y in bottom..bottom + high {
        for x in left..left + wide {
            let cell = &mut free[Cell::new(x as i32, y as i32)];
            filled += usize::from(std::mem::take(cell));
        }
    }
    filled
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hall_is_a_tenth_full_connected_and_told_by_its_seed() {
        let hall = random_hall(120, 80, 7);
        let share = 1.0 - hall.count() as f64 / hall.len() as f64;
        assert!((0.08..0.25).contains(&share), "{share}");
        assert_eq!(reachable(&hall, START), hall);
        assert_eq!(random_hall(120, 80, 7), hall);
        assert_ne!(random_hall(120, 80, 8), hall);
    }

    #[test]
    fn tiny_halls_work() {
        for side in 1..5 {
            assert!(random_hall(side, 1, 3).count() > 0);
            assert!(random_clutter(1, side, 1.0, 3).count() == 1);
        }
    }
}

//! Random rooms from a seed, for tests and benchmarks.

mod flat;

pub use flat::{FlatId, FlatIdError, FlatSpec, FlatSpecError, generate_flat};

use super::{FloorPlan, Rect, Sketch};
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

/// A furnished flat of `columns` x `rows` rooms with doors between them, solid furniture along the walls and in the open,
/// tables on legs and round things. Cells of 5 cm; the robot starts in the lower left corner.
pub fn random_flat(columns: u32, rows: u32, seed: u64) -> FloorPlan {
    let mut rng = seeded(seed, 0);
    let mut lines = |count: u32| -> Vec<f64> {
        let mut line = 0.15;
        let mut lines = vec![line];
        for _ in 0..count {
            line += f64::from(rng.random_range(50..100)) * 0.05 + 0.1;
            lines.push(line);
        }
        lines
    };
    let (xs, ys) = (lines(columns), lines(rows));
    let (width, height) = (xs[columns as usize] + 0.05, ys[rows as usize] + 0.05);
    let mut sketch = Sketch::solid(width, height, 0.05);
    let start = (xs[0] + 0.3, ys[0] + 0.3);
    for column in 0..columns as usize {
        for row in 0..rows as usize {
            let room = [xs[column], ys[row], xs[column + 1] - 0.1, ys[row + 1] - 0.1];
            sketch = sketch.carve(&[room]);
            if column > 0 {
                let y = rng.random_range(room[1] + 0.1..room[3] - 1.0);
                sketch = sketch.carve(&[[room[0] - 0.1, y, room[0], y + 0.85]]);
            }
            if row > 0 && (column == 0 || rng.random_bool(0.4)) {
                let x = rng.random_range(room[0] + 0.1..room[2] - 1.0);
                sketch = sketch.carve(&[[x, room[1] - 0.1, x + 0.85, room[1]]]);
            }
        }
    }
    for column in 0..columns as usize {
        for row in 0..rows as usize {
            let room = [xs[column], ys[row], xs[column + 1] - 0.1, ys[row + 1] - 0.1];
            sketch = furnish(sketch, room, &mut rng);
        }
    }
    // The start stays free.
    let place = [start.0 - 0.3, start.1 - 0.3, start.0 + 0.3, start.1 + 0.3];
    sketch.carve(&[place]).start(start.0, start.1, 0.0).finish("Random flat", "")
}

/// Puts some furniture into a room: left, bottom, right and top edge.
fn furnish(mut sketch: Sketch, [left, bottom, right, top]: Rect, rng: &mut Rng) -> Sketch {
    for _ in 0..rng.random_range(2..6) {
        let (wide, deep) = (rng.random_range(0.4..1.6), rng.random_range(0.3..0.8));
        let (wide, deep) = if rng.random_bool(0.5) { (wide, deep) } else { (deep, wide) };
        let x = rng.random_range(left..(right - wide).max(left + 0.05));
        let y = rng.random_range(bottom..(top - deep).max(bottom + 0.05));
        let rect = match rng.random_range(0..6) {
            0 => [left, y, left + wide, y + deep],
            1 => [right - wide, y, right, y + deep],
            2 => [x, bottom, x + wide, bottom + deep],
            3 => [x, top - deep, x + wide, top],
            _ => [x, y, x + wide, y + deep],
        };
        let rect = [rect[0].max(left), rect[1].max(bottom), rect[2].min(right), rect[3].min(top)];
        sketch = if rng.random_bool(0.3) { sketch.legs(&[rect]) } else { sketch.fill(&[rect]) };
    }
    if rng.random_bool(0.6) {
        let (x, y) = (rng.random_range(left..right), rng.random_range(bottom..top));
        sketch = sketch.disc(x, y, rng.random_range(0.05..0.25));
    }
    sketch
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
    fn flats_are_told_by_their_seed_and_have_floor_at_the_start() {
        for seed in 0..20 {
            let flat = random_flat(2, 2, seed);
            let start = flat.start.unwrap();
            assert!(flat.occupancy[flat.cell_at(start.position())].is_free());
            assert_eq!(random_flat(2, 2, seed), flat);
        }
        assert_ne!(random_flat(2, 1, 1), random_flat(2, 1, 2));
    }

    #[test]
    fn tiny_halls_work() {
        for side in 1..5 {
            assert!(random_hall(side, 1, 3).count() > 0);
            assert!(random_clutter(1, side, 1.0, 3).count() == 1);
        }
    }
}

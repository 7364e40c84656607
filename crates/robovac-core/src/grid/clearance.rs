//! Distance to the nearest obstacle.

use super::{Cell, Grid};

/// Distance from the centre of every cell to the nearest blocked square, in cells, 0 in blocked cells.
///
/// Exact up to `limit` cells; farther cells get `limit`. Everything outside the grid counts as blocked, as a robot
/// can't leave its map. A disc of radius `r` around a cell's centre is free of obstacles if the value is at least `r`.
///
/// Two passes (Saito & Toriwaki 1994): nearest blocked cell in the row, then the best row within `limit`. O(n · limit).
pub fn clearance(blocked: &Grid<bool>, limit: f32) -> Grid<f32> {
    let (width, height) = (blocked.width(), blocked.height());
    let reach = limit.ceil() as usize + 1;
    let far = reach as u16 + 1;
    let mut in_row = vec![far; width * height];
    for (row, out) in blocked.values().chunks(width).zip(in_row.chunks_mut(width)) {
        let mut since = 0;
        for (is_blocked, cell) in row.iter().zip(out.iter_mut()) {
            since = if *is_blocked { 0 } else { (since + 1).min(far) };
            *cell = since;
        }
        since = 0;
        for (is_blocked, cell) in row.iter().zip(out.iter_mut()).rev() {
            since = if *is_blocked { 0 } else { (since + 1).min(far) };
            *cell = since.min(*cell);
        }
    }
    // From a centre to the near edge of a square that is `d` cells away: d - 1/2.
    let edge = |d: usize| (d as f32 - 0.5).max(0.0);
    let squared: Vec<f32> = (0..=usize::from(far)).map(|d| edge(d) * edge(d)).collect();
    let mut result = Grid::filled(width, height, limit);
    for y in 0..height {
        for x in 0..width {
            let here = in_row[y * width + x];
            if here == 0 {
                result[Cell::new(x as i32, y as i32)] = 0.0;
                continue;
            }
            let mut best = squared[usize::from(here)];
            for dy in 1..=reach {
                let vertical = squared[dy.min(squared.len() - 1)];
                if vertical >= best {
                    break;
                }
                let above = if y + dy < height { in_row[(y + dy) * width + x] } else { 0 };
                let below = if dy <= y { in_row[(y - dy) * width + x] } else { 0 };
                best = best.min(vertical + squared[usize::from(above.min(below))]);
            }
            result[Cell::new(x as i32, y as i32)] = best.sqrt().min(limit);
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::from_picture;
    use proptest::prelude::*;

    fn brute_force(blocked: &Grid<bool>, cell: Cell) -> f32 {
        let edge = |a: i32, b: i32| ((a - b).abs() as f32 - 0.5).max(0.0);
        if blocked[cell] {
            return 0.0;
        }
        let mut best = f32::MAX;
        for y in -1..=blocked.height() as i32 {
            for x in -1..=blocked.width() as i32 {
                if !blocked.contains(Cell::new(x, y)) || blocked[Cell::new(x, y)] {
                    best = best.min(edge(x, cell.x).hypot(edge(y, cell.y)));
                }
            }
        }
        best
    }

    #[test]
    fn beside_a_wall_it_is_half_a_cell() {
        let grid = from_picture("....\n..#.\n....", |c| c == '#').unwrap();
        let field = clearance(&grid, 5.0);
        assert_eq!(field[Cell::new(1, 1)], 0.5);
        assert_eq!(field[Cell::new(2, 1)], 0.0);
    }

    proptest! {
        #[test]
        fn agrees_with_brute_force(bits in proptest::collection::vec(proptest::bool::weighted(0.1), 13 * 9), limit in 0.5_f32..8.0) {
            let grid = Grid::from_rows(13, bits).unwrap();
            let field = clearance(&grid, limit);
            for (cell, &value) in field.iter() {
                let expected = brute_force(&grid, cell).min(limit);
                prop_assert!((value - expected).abs() < 1e-5, "{} {} {}", cell, value, expected);
            }
        }
    }
}

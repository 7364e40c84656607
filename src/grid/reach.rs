//! Which cells can be reached in 4-neighbour steps.

use super::{Cell, Grid};

/// The free cells that 4-neighbour steps through free cells connect with `start`; none if `start` isn't free.
pub fn reachable(free: &Grid<bool>, start: Cell) -> Grid<bool> {
    let mut seen = Grid::filled(free.width(), free.height(), false);
    flood(free, start, &mut seen);
    seen
}

/// The first cell, from the lower left, of the largest connected part of `free`; `None` if nothing is free.
pub fn largest_part(free: &Grid<bool>) -> Option<Cell> {
    let mut seen = Grid::filled(free.width(), free.height(), false);
    let mut best: Option<(usize, Cell)> = None;
    for (cell, _) in free.iter() {
        let size = flood(free, cell, &mut seen);
        if size > best.map_or(0, |(most, _)| most) {
            best = Some((size, cell));
        }
    }
    best.map(|(_, cell)| cell)
}

/// Marks the free cells connected with `start` that haven't been seen, and counts them.
fn flood(free: &Grid<bool>, start: Cell, seen: &mut Grid<bool>) -> usize {
    if !free.is_set(start) || seen[start] {
        return 0;
    }
    let mut size = 1;
    seen[start] = true;
    let mut stack = vec![start];
    while let Some(cell) = stack.pop() {
        for next in cell.neighbours() {
            if free.is_set(next) && !seen[next] {
                seen[next] = true;
                size += 1;
                stack.push(next);
            }
        }
    }
    size
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{from_picture, picture};

    #[test]
    fn reachable_stops_at_walls_and_diagonals() {
        let free = from_picture("..#.\n..#.\n##..", |c| c == '.').unwrap();
        let seen = reachable(&free, Cell::new(0, 2));
        assert_eq!(picture(&seen, |&s| if s { 'o' } else { '-' }), "oo--\noo--\n----\n");
    }

    #[test]
    fn largest_part_is_named_by_its_first_cell() {
        let free = from_picture("..#.\n..#.\n##..", |c| c == '.').unwrap();
        // Four cells each: the first from the lower left wins.
        assert_eq!(largest_part(&free), Some(Cell::new(2, 0)));
        assert_eq!(largest_part(&Grid::filled(2, 2, false)), None);
    }
}

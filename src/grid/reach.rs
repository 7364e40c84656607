//! Which cells can be reached in 4-neighbour steps.

use super::{Cell, Grid};

/// The free cells that 4-neighbour steps through free cells connect with `start`; none if `start` isn't free.
pub fn reachable(free: &Grid<bool>, start: Cell) -> Grid<bool> {
    let mut seen = Grid::filled(free.width(), free.height(), false);
    if !free.is_set(start) {
        return seen;
    }
    seen[start] = true;
    let mut stack = vec![start];
    while let Some(cell) = stack.pop() {
        for next in cell.neighbours() {
            if free.is_set(next) && !seen[next] {
                seen[next] = true;
                stack.push(next);
            }
        }
    }
    seen
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
}

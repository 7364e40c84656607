//! Which cells can be reached in 4-neighbour steps, and how.

use super::{Cell, Grid};
use std::collections::VecDeque;

/// Marks a cell that no path leads to in [`steps_from`].
pub const UNREACHED: u32 = u32::MAX;

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

/// Number of steps of a shortest path from `start` to every free cell; [`u32::MAX`] where there is none.
pub fn steps_from(free: &Grid<bool>, start: Cell) -> Grid<u32> {
    let mut steps = Grid::filled(free.width(), free.height(), UNREACHED);
    if !free.is_set(start) {
        return steps;
    }
    steps[start] = 0;
    let mut queue = VecDeque::from([start]);
    while let Some(cell) = queue.pop_front() {
        let next_steps = steps[cell] + 1;
        for next in cell.neighbours() {
            if free.is_set(next) && steps[next] == UNREACHED {
                steps[next] = next_steps;
                queue.push_back(next);
            }
        }
    }
    steps
}

/// A shortest path from `from` to `to`, both included; `None` if there is none.
///
/// Among shortest paths it prefers to go straight on, as turning costs time.
pub fn shortest_path(free: &Grid<bool>, from: Cell, to: Cell) -> Option<Vec<Cell>> {
    let steps = steps_from(free, to);
    if !free.is_set(from) || steps[from] == UNREACHED {
        return None;
    }
    let mut path = vec![from];
    let mut cell = from;
    let mut ahead = None;
    while cell != to {
        let closer = |next: Cell| free.is_set(next) && steps[next] + 1 == steps[cell];
        let straight = ahead.filter(|&d| closer(cell.step(d)));
        let direction = straight.or_else(|| super::Direction::ALL.into_iter().find(|&d| closer(cell.step(d))))?;
        cell = cell.step(direction);
        ahead = Some(direction);
        path.push(cell);
    }
    Some(path)
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
    fn shortest_path_goes_round_the_wall() {
        let free = from_picture("...\n##.\n...", |c| c == '.').unwrap();
        let path = shortest_path(&free, Cell::new(0, 2), Cell::new(0, 0)).unwrap();
        assert_eq!(path.len(), 7);
        assert!(path.windows(2).all(|w| w[0].direction_to(w[1]).is_some()));
        let walled = from_picture("...\n###\n...", |c| c == '.').unwrap();
        assert_eq!(shortest_path(&walled, Cell::new(0, 2), Cell::new(0, 0)), None);
    }
}

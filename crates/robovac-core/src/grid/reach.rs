//! Cells that can be reached in 4-neighbour steps.

use super::{Cell, Grid};

/// The free cells that 4-neighbour steps through free cells connect with `start`; none if `start` isn't free.
pub fn reachable(free: &Grid<bool>, start: Cell) -> Grid<bool> {
    let mut seen = Grid::filled(free.width(), free.height(), false);
    flood(free, start, &mut seen);
    seen
}

/// The free cells that steps connect with any of `starts`, a grid of the same size.
pub fn reachable_from_any(free: &Grid<bool>, starts: &Grid<bool>) -> Grid<bool> {
    let mut seen = Grid::filled(free.width(), free.height(), false);
    for (start, _) in starts.iter().filter(|&(_, &is_start)| is_start) {
        flood(free, start, &mut seen);
    }
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

/// The free cells that lie in a free square of `side` cells (a morphological opening).
pub fn opened(free: &Grid<bool>, side: usize) -> Grid<bool> {
    let width = free.width();
    let mut open = Grid::filled(width, free.height(), false);
    // Sides of the largest squares whose upper right cells are those of a row, and of the row below.
    let mut below = vec![0; width];
    for y in 0..free.height() {
        let mut row = vec![0; width];
        for x in 0..width {
            if !free.values()[y * width + x] {
                continue;
            }
            row[x] = if x == 0 { 1 } else { 1 + below[x].min(below[x - 1]).min(row[x - 1]) };
            if row[x] >= side {
                for line in y + 1 - side..=y {
                    open.values_mut()[line * width + x + 1 - side..=line * width + x].fill(true);
                }
            }
        }
        below = row;
    }
    open
}

/// Marks the free cells connected with `start` that haven't been seen, and counts them.
///
/// Run by run, each marked as a whole: a cell is read about three times, in the order of memory.
fn flood(free: &Grid<bool>, start: Cell, seen: &mut Grid<bool>) -> usize {
    if !free.is_set(start) || seen[start] {
        return 0;
    }
    let width = free.width();
    let mut size = 0;
    let mut stack = vec![free.index(start)];
    while let Some(index) = stack.pop() {
        if seen.values()[index] {
            continue;
        }
        let (row, x) = (index - index % width, index % width);
        let cells = &free.values()[row..row + width];
        let first = cells[..x].iter().rposition(|&is_free| !is_free).map_or(0, |wall| wall + 1);
        let end = cells[x..].iter().position(|&is_free| !is_free).map_or(width, |run| x + run);
        seen.values_mut()[row + first..row + end].fill(true);
        size += end - first;
        let above = Some(row + width).filter(|&above| above < free.len());
        for beside in [row.checked_sub(width), above].into_iter().flatten() {
            let cells = beside + first..beside + end;
            let (is_free, is_seen) = (&free.values()[cells.clone()], &seen.values()[cells.clone()]);
            let mut was_new = false;
            for ((index, is_free), is_seen) in cells.zip(is_free).zip(is_seen) {
                let is_new = *is_free && !is_seen;
                if is_new && !was_new {
                    stack.push(index);
                }
                was_new = is_new;
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
    fn parts_without_a_start_are_not_reached() {
        let free = from_picture("..#.\n..#.\n##.#", |c| c == '.').unwrap();
        let starts = from_picture("*-*-\n-*--\n--*-", |c| c == '*').unwrap();
        let seen = reachable_from_any(&free, &starts);
        assert_eq!(picture(&seen, |&s| if s { 'o' } else { '-' }), "oo--\noo--\n--o-\n");
    }

    #[test]
    fn slots_are_not_open() {
        let free = from_picture("...#.\n...#.\n#.##.\n#....", |c| c == '.').unwrap();
        let draw = |side| picture(&opened(&free, side), |&is_open| if is_open { 'o' } else { '-' });
        assert_eq!(draw(1), "ooo-o\nooo-o\n-o--o\n-oooo\n");
        assert_eq!(draw(2), "ooo--\nooo--\n-----\n-----\n");
        assert_eq!(draw(3), "-----\n-----\n-----\n-----\n");
    }

    /// By the definition, cell by cell.
    #[test]
    fn floods_fill_all_that_steps_connect() {
        for (seed, density) in [(1, 0.1), (2, 0.3), (3, 0.45), (4, 0.6)] {
            let free = crate::floor_plan::generate::random_clutter(37, 29, density, seed);
            let (start, _) = free.iter().find(|(_, is_free)| **is_free).unwrap();
            let seen = reachable(&free, start);
            assert!(seen.is_set(start));
            for (cell, &is_free) in free.iter() {
                let beside = cell.neighbours().into_iter().any(|next| seen.is_set(next));
                assert!(!seen[cell] || is_free);
                assert!(!(is_free && beside) || seen[cell], "{cell}");
                assert!(!seen[cell] || cell == start || beside, "{cell}");
            }
        }
    }

    #[test]
    fn largest_part_is_named_by_its_first_cell() {
        let free = from_picture("..#.\n..#.\n##..", |c| c == '.').unwrap();
        // Four cells each: the first from the lower left wins.
        assert_eq!(largest_part(&free), Some(Cell::new(2, 0)));
        assert_eq!(largest_part(&Grid::filled(2, 2, false)), None);
    }
}

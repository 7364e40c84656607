//! Stage: line of sight over a grid of free cells.

use robovac_core::grid::{Cell, Direction, Grid};
use std::{cmp::Ordering, ops::ControlFlow};

/// Calls `visit` with every cell that the straight line between two cells' centres touches, in order, until it breaks;
/// where the line passes exactly through a corner, with the two cells beside it as well. In whole numbers, without
/// rounding (Dedu, Bresenham-based supercover line algorithm, 2001).
pub fn supercover(from: Cell, to: Cell, mut visit: impl FnMut(Cell) -> ControlFlow<()>) -> ControlFlow<()> {
    let (dx, dy) = (i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y));
    let (right, up) = (dx.signum() as i32, dy.signum() as i32);
    let (dx, dy) = (dx.abs(), dy.abs());
    // Above 0 the line crosses a vertical border next, below 0 a horizontal one.
    let mut error = dx - dy;
    let mut cell = from;
    visit(cell)?;
    while cell != to {
        let (beside, ahead) = (Cell::new(cell.x + right, cell.y), Cell::new(cell.x, cell.y + up));
        match error.cmp(&0) {
            Ordering::Greater => {
                cell = beside;
                error -= 2 * dy;
            }
            Ordering::Less => {
                cell = ahead;
                error += 2 * dx;
            }
            Ordering::Equal => {
                visit(beside)?;
                visit(ahead)?;
                cell = Cell::new(beside.x, ahead.y);
                error += 2 * (dx - dy);
            }
        }
        visit(cell)?;
    }
    ControlFlow::Continue(())
}

/// Whether the straight line between two cells' centres stays in free cells.
pub fn is_straight_free(free: &Grid<bool>, from: Cell, to: Cell) -> bool {
    let look = |cell| if free.is_set(cell) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
    supercover(from, to, look).is_continue()
}

/// Single steps along a straight free way, without `from`: round one corner if those cells are free, first on in the
/// direction of `facing` if that helps; else as a staircase along the line.
pub fn steps_along(free: &Grid<bool>, from: Cell, to: Cell, facing: Direction) -> Vec<Cell> {
    let (level, upright) = (Cell::new(to.x, from.y), Cell::new(from.x, to.y));
    let ahead = from.step(facing);
    let is_level_first = if facing.is_horizontal() {
        (ahead.x > from.x) == (to.x > from.x)
    } else {
        (ahead.y > from.y) != (to.y > from.y)
    };
    let corners = if is_level_first { [level, upright] } else { [upright, level] };
    let round = corners.into_iter().find(|&c| is_straight_free(free, from, c) && is_straight_free(free, c, to));
    let mut steps = Vec::with_capacity(from.manhattan(to) as usize);
    for (from, to) in round.map_or(vec![(from, to)], |corner| vec![(from, corner), (corner, to)]) {
        let mut last = from;
        // Of the two cells beside a corner the second is no neighbour of the first.
        let _ = supercover(from, to, |cell| {
            if last.manhattan(cell) == 1 {
                steps.push(cell);
                last = cell;
            }
            ControlFlow::Continue(())
        });
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::{from_picture, picture};

    fn drawn(from: Cell, to: Cell) -> String {
        let mut touched = Grid::filled(6, 4, false);
        let _ = supercover(from, to, |cell| {
            touched[cell] = true;
            ControlFlow::Continue(())
        });
        picture(&touched, |&t| if t { 'o' } else { '-' })
    }

    #[test]
    fn supercover_touches_what_the_line_touches() {
        // By the definition: squares that share a point with the line 5 y = 3 x. A square reaches 4 to both sides of
        // it.
        let mut expected = Grid::filled(6, 4, false);
        for index in 0..24 {
            let cell = expected.cell(index);
            expected[cell] = (5 * cell.y - 3 * cell.x).abs() <= 4;
        }
        assert_eq!(drawn(Cell::new(0, 0), Cell::new(5, 3)), picture(&expected, |&t| if t { 'o' } else { '-' }));
        assert_eq!(drawn(Cell::new(1, 2), Cell::new(3, 0)), "------\n-oo---\n-ooo--\n--oo--\n");
        assert_eq!(drawn(Cell::new(4, 1), Cell::new(1, 1)), "------\n------\n-oooo-\n------\n");
        for (a, b) in [((0, 0), (5, 2)), ((5, 3), (0, 1)), ((2, 2), (2, 2)), ((0, 3), (4, 0))] {
            let (a, b) = (Cell::new(a.0, a.1), Cell::new(b.0, b.1));
            assert_eq!(drawn(a, b), drawn(b, a));
        }
    }

    #[test]
    fn corners_are_not_cut() {
        let free = from_picture("..\n#.", |c| c == '.').unwrap();
        assert!(!is_straight_free(&free, Cell::new(0, 1), Cell::new(1, 0)));
        assert!(is_straight_free(&free, Cell::new(0, 1), Cell::new(1, 1)));
        assert!(!is_straight_free(&free, Cell::new(0, 1), Cell::new(-1, 1)));
    }

    #[test]
    fn steps_turn_once_where_they_can() {
        let free = from_picture("....\n....\n....", |c| c == '.').unwrap();
        for (from, to) in [((0, 0), (3, 2)), ((3, 0), (0, 1)), ((2, 2), (2, 2)), ((1, 2), (0, 0))] {
            let (from, to) = (Cell::new(from.0, from.1), Cell::new(to.0, to.1));
            for facing in Direction::ALL {
                let steps = steps_along(&free, from, to, facing);
                assert_eq!(steps.len() as u32, from.manhattan(to));
                let walk: Vec<Cell> = std::iter::once(from).chain(steps).collect();
                let ways: Vec<_> = walk.windows(2).map(|w| w[0].direction_to(w[1]).unwrap()).collect();
                assert!(ways.windows(2).filter(|w| w[0] != w[1]).count() <= 1);
            }
        }
        // Both ways round are shut.
        let slanted = from_picture("##..\n#..#\n..##", |c| c == '.').unwrap();
        let steps = steps_along(&slanted, Cell::new(0, 0), Cell::new(3, 2), Direction::Right);
        assert_eq!(steps.len(), 5);
        assert!(steps.iter().all(|&cell| slanted.is_set(cell)));
    }
}

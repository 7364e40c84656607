//! Distance to the nearest obstacle in king's moves.

use super::{Cell, Grid};

/// King's moves from each cell to the nearest blocked one or out of the grid, at most 255; 0 in blocked cells. So the
/// square of cells less than that far away is free.
///
/// Two passes over the cells (Rosenfeld & Pfaltz 1966). O(n).
pub fn chessboard(blocked: &Grid<bool>) -> Grid<u8> {
    let (width, height) = (blocked.width() as i32, blocked.height() as i32);
    let mut moves = blocked.map(|&is_blocked| if is_blocked { 0 } else { u8::MAX });
    let mut pass = |x: i32, y: i32, side: i32| {
        let cell = Cell::new(x, y);
        if moves[cell] > 0 {
            let before = [(side, 0), (-1, side), (0, side), (1, side)];
            let around = before.map(|(dx, dy)| moves.get(Cell::new(x + dx, y + dy)).copied().unwrap_or(0));
            let least = around.into_iter().fold(u8::MAX, u8::min);
            moves[cell] = moves[cell].min(least.saturating_add(1));
        }
    };
    for y in 0..height {
        (0..width).for_each(|x| pass(x, y, -1));
    }
    for y in (0..height).rev() {
        (0..width).rev().for_each(|x| pass(x, y, 1));
    }
    moves
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn agrees_with_brute_force(bits in proptest::collection::vec(proptest::bool::weighted(0.05), 13 * 9)) {
            let grid = Grid::from_rows(13, bits).unwrap();
            let moves = chessboard(&grid);
            for (cell, &found) in moves.iter() {
                let to = |other: Cell| (other.x - cell.x).abs().max((other.y - cell.y).abs());
                let around = (-1..=9).flat_map(|y| (-1..=13).map(move |x| Cell::new(x, y)));
                let expected = around.filter(|&c| grid.get(c) != Some(&false)).map(to).min();
                prop_assert_eq!(Some(i32::from(found)), expected, "{}", cell);
            }
        }
    }

    #[test]
    fn halls_are_no_wider_than_a_byte() {
        assert_eq!(chessboard(&Grid::filled(601, 601, false))[Cell::new(300, 300)], 255);
    }
}

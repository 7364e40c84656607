//! Distance to the nearest obstacle in king's moves.

use super::Grid;

/// King's moves from each cell to the nearest blocked one or out of the grid, at most 255; 0 in blocked cells. So the
/// square of cells less than that far away is free.
///
/// Two passes over the cells (Rosenfeld & Pfaltz 1966). O(n).
pub fn chessboard(blocked: &Grid<bool>) -> Grid<u8> {
    let mut moves = blocked.map(|&is_blocked| if is_blocked { 0 } else { u8::MAX });
    let (width, height) = (moves.width(), moves.height());
    let cells = moves.values_mut();
    // Out of the grid all is blocked.
    let outside = vec![0; width];
    for y in 0..height {
        let (below, above) = cells.split_at_mut(y * width);
        let row = &mut above[..width];
        from_row(row, if y > 0 { &below[(y - 1) * width..] } else { &outside });
        row.iter_mut().fold(0, along_row);
    }
    for y in (0..height).rev() {
        let (below, above) = cells.split_at_mut((y + 1) * width);
        let row = &mut below[y * width..];
        from_row(row, above.get(..width).unwrap_or(&outside));
        row.iter_mut().rev().fold(0, along_row);
    }
    moves
}

/// Moves by way of the row before. All cells at once, as processors do several.
fn from_row(row: &mut [u8], before: &[u8]) {
    if let Some(inner) = row.get_mut(1..before.len() - 1) {
        for (moves, around) in inner.iter_mut().zip(before.windows(3)) {
            let least = around[0].min(around[1]).min(around[2]);
            *moves = (*moves).min(least.saturating_add(1));
        }
    }
}

/// Moves by way of the cell before in the row.
fn along_row(before: u8, moves: &mut u8) -> u8 {
    *moves = (*moves).min(before.saturating_add(1));
    *moves
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Cell;
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

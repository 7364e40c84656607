//! Outlines of the set cells of a grid, so that walls can be filled as shapes with crisp edges, and written as lines.

use super::{Cell, Direction, Grid};

/// Closed outlines of the set cells, as corners of cells ((0, 0) is the lower-left corner of the grid); the set cells
/// lie to the left of each line. Corners on straight pieces are left out.
///
/// `None` if there are more than `most` corners: then a picture of the cells is cheaper to draw.
///
/// ```
/// use robovac_core::grid::{Cell, Grid, outlines};
/// let square = outlines(&Grid::filled(3, 2, true), 100).unwrap();
/// assert_eq!(square, [[Cell::new(0, 0), Cell::new(3, 0), Cell::new(3, 2), Cell::new(0, 2)]]);
/// ```
pub fn outlines(grid: &Grid<bool>, most: usize) -> Option<Vec<Vec<Cell>>> {
    let mut loops = Vec::new();
    let mut seen = Grid::filled(grid.width(), grid.height(), false);
    let mut corners = 0;
    for (cell, &is_set) in grid.iter() {
        if !is_set || seen[cell] || grid.is_set(cell.step(Direction::Down)) {
            continue;
        }
        let outline = trace(grid, &mut seen, cell);
        corners += outline.len();
        if corners > most {
            return None;
        }
        loops.push(outline);
    }
    Some(loops)
}

/// Follows the outline that runs along the lower side of `first`; marks in `seen` all cells whose lower side it takes.
fn trace(grid: &Grid<bool>, seen: &mut Grid<bool>, first: Cell) -> Vec<Cell> {
    let mut outline = Vec::new();
    let (mut corner, mut direction) = (first, Direction::Right);
    loop {
        if direction == Direction::Right {
            if seen[corner] {
                break;
            }
            seen[corner] = true;
        }
        corner = corner.step(direction);
        let (left, right) = ahead(corner, direction);
        let next = if !grid.is_set(left) {
            direction.left()
        } else if grid.is_set(right) {
            direction.right()
        } else {
            direction
        };
        if next != direction {
            outline.push(corner);
        }
        direction = next;
    }
    // The trace ends where it began, one side after the first corner in order.
    outline.rotate_right(1);
    outline
}

/// The cells ahead to the left and to the right of a corner.
fn ahead(corner: Cell, direction: Direction) -> (Cell, Cell) {
    let Cell { x, y } = corner;
    match direction {
        Direction::Right => (Cell::new(x, y), Cell::new(x, y - 1)),
        Direction::Up => (Cell::new(x - 1, y), Cell::new(x, y)),
        Direction::Left => (Cell::new(x - 1, y - 1), Cell::new(x - 1, y)),
        Direction::Down => (Cell::new(x, y - 1), Cell::new(x - 1, y - 1)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::from_picture;
    use proptest::prelude::*;

    fn grid(text: &str) -> Grid<bool> {
        from_picture(text, |c| c == '#').unwrap()
    }

    /// Twice the area that the loops enclose, holes taken off.
    fn area(loops: &[Vec<Cell>]) -> i32 {
        let pairs = loops.iter().flat_map(|l| l.iter().zip(l.iter().cycle().skip(1)));
        pairs.map(|(a, b)| a.x * b.y - b.x * a.y).sum()
    }

    #[test]
    fn a_ring_has_an_outline_and_a_hole() {
        let loops = outlines(&grid("###\n#.#\n###"), 100).unwrap();
        assert_eq!(loops.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4]);
        assert_eq!(area(&loops), 2 * 8);
    }

    #[test]
    fn cells_that_touch_at_a_corner_stay_apart() {
        let loops = outlines(&grid("#.\n.#"), 100).unwrap();
        assert_eq!(loops.len(), 2);
    }

    #[test]
    fn too_many_corners_are_refused() {
        assert_eq!(outlines(&grid("#.#.#"), 11), None);
    }

    proptest! {
        #[test]
        fn outlines_enclose_exactly_the_set_cells(cells in prop::collection::vec(any::<bool>(), 48)) {
            let grid = Grid::from_rows(8, cells).unwrap();
            let loops = outlines(&grid, 1000).unwrap();
            prop_assert_eq!(area(&loops), 2 * grid.count() as i32);
            for outline in &loops {
                for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
                    prop_assert!((a.x == b.x) != (a.y == b.y));
                }
            }
        }
    }
}

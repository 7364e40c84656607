//! A grid in a frame one cell wide, so that a search can read all neighbours without checking for the edge.

use robovac_core::grid::{Cell, Direction, Grid};

/// Numbers the cells of a grid and of the frame around it, row by row from the lower left.
#[derive(Debug, Clone, Copy)]
pub struct FramedGrid {
    /// Numbers from one row to the next.
    stride: usize,
    len: usize,
}

impl FramedGrid {
    /// The frame around `grid`.
    pub fn around<T>(grid: &Grid<T>) -> Self {
        let stride = grid.width() + 2;
        Self { stride, len: stride * (grid.height() + 2) }
    }

    /// Numbers from one row to the next.
    pub fn stride(self) -> usize {
        self.stride
    }

    /// The number of a cell of the grid.
    #[inline]
    pub fn index(self, cell: Cell) -> usize {
        (cell.y + 1) as usize * self.stride + (cell.x + 1) as usize
    }

    /// The cell with a number.
    #[inline]
    pub fn cell(self, index: usize) -> Cell {
        // Half as many bits divide faster, and there are never more cells.
        let (index, stride) = (index as u32, self.stride as u32);
        Cell::new((index % stride) as i32 - 1, (index / stride) as i32 - 1)
    }

    /// The neighbours of a cell of the grid, in the order of [`Direction::ALL`].
    #[inline]
    pub fn neighbours(self, index: usize) -> [usize; 4] {
        [index + 1, index + self.stride, index - 1, index - self.stride]
    }

    /// The neighbour of a cell of the grid in one direction.
    #[inline]
    pub fn ahead(self, index: usize, direction: Direction) -> usize {
        self.neighbours(index)[direction as usize]
    }

    /// `value` for every cell, frame included.
    pub fn filled<T: Clone>(self, value: T) -> Vec<T> {
        vec![value; self.len]
    }

    /// `floor` for free cells, `wall` for the others and for the frame.
    pub fn drawn<T: Copy>(self, free: &Grid<bool>, floor: T, wall: T) -> Vec<T> {
        let mut values = self.filled(wall);
        let rows = values.chunks_mut(self.stride).skip(1);
        for (values, row) in rows.zip(free.values().chunks(free.width())) {
            for (value, &is_free) in values[1..].iter_mut().zip(row) {
                *value = if is_free { floor } else { wall };
            }
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    #[test]
    fn numbers_lead_back_to_cells_and_the_frame_is_wall() {
        let free = from_picture("..#\n.#.", |c| c == '.').unwrap();
        let frame = FramedGrid::around(&free);
        let drawn = frame.drawn(&free, '.', '#');
        assert_eq!(drawn.iter().collect::<String>(), "######.#.##..#######");
        for (cell, &is_free) in free.iter() {
            assert_eq!(frame.cell(frame.index(cell)), cell);
            assert_eq!(drawn[frame.index(cell)] == '.', is_free);
            assert_eq!(frame.neighbours(frame.index(cell)).map(|n| frame.cell(n)), cell.neighbours());
        }
    }
}

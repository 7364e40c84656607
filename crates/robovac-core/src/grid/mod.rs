//! Rectangular grids, row 0 at the bottom, and algorithms on them.

mod cell;
mod chessboard;
mod clearance;
mod occupancy;
mod outline;
mod picture;
mod reach;

pub use cell::{Cell, Direction};
pub use chessboard::chessboard;
pub use clearance::clearance;
pub use occupancy::Occupancy;
pub use outline::outlines;
pub use picture::{from_picture, picture};
pub use reach::{largest_part, opened, reachable, reachable_from_any};

/// A rectangle of values, stored row by row from the bottom.
///
/// ```
/// use robovac_core::grid::{Cell, Grid};
/// let mut grid = Grid::filled(3, 2, 0);
/// grid[Cell::new(2, 1)] = 7;
/// assert_eq!(grid.get(Cell::new(2, 1)), Some(&7));
/// assert_eq!(grid.get(Cell::new(3, 1)), None);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Grid<T> {
    width: usize,
    height: usize,
    values: Vec<T>,
}

impl<T> Grid<T> {
    /// A grid of `width` columns from `values`, row 0 (the bottom) first; `None` unless they fill whole rows.
    pub fn from_rows(width: usize, values: Vec<T>) -> Option<Self> {
        if width == 0 || values.is_empty() || !values.len().is_multiple_of(width) {
            return None;
        }
        Some(Self { width, height: values.len() / width, values })
    }

    /// Number of columns.
    #[inline]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Number of rows.
    #[inline]
    pub fn height(&self) -> usize {
        self.height
    }

    /// Number of cells.
    #[inline]
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there is no cell at all.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Whether `cell` lies inside.
    #[inline]
    pub fn contains(&self, cell: Cell) -> bool {
        (0..self.width as i32).contains(&cell.x) && (0..self.height as i32).contains(&cell.y)
    }

    /// Position of `cell` in [`Grid::values`]. The cell must lie inside.
    #[inline]
    pub fn index(&self, cell: Cell) -> usize {
        debug_assert!(self.contains(cell), "{cell} is outside");
        cell.y as usize * self.width + cell.x as usize
    }

    /// The cell at a position in [`Grid::values`].
    #[inline]
    pub fn cell(&self, index: usize) -> Cell {
        Cell::new((index % self.width) as i32, (index / self.width) as i32)
    }

    /// The value at `cell`, or `None` outside.
    #[inline]
    pub fn get(&self, cell: Cell) -> Option<&T> {
        self.contains(cell).then(|| &self.values[self.index(cell)])
    }

    /// All values, row 0 first.
    #[inline]
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// All values, row 0 first, mutably.
    #[inline]
    pub fn values_mut(&mut self) -> &mut [T] {
        &mut self.values
    }

    /// All cells with their values, row 0 first.
    pub fn iter(&self) -> impl Iterator<Item = (Cell, &T)> {
        self.values.iter().enumerate().map(|(i, v)| (self.cell(i), v))
    }

    /// A grid of the same size with `f` applied to every value.
    pub fn map<U>(&self, f: impl FnMut(&T) -> U) -> Grid<U> {
        Grid { width: self.width, height: self.height, values: self.values.iter().map(f).collect() }
    }
}

impl<T: Clone> Grid<T> {
    /// A grid with `value` in every cell.
    pub fn filled(width: usize, height: usize, value: T) -> Self {
        Self { width, height, values: vec![value; width * height] }
    }
}

impl Grid<bool> {
    /// Whether `cell` lies inside and is set.
    #[inline]
    pub fn is_set(&self, cell: Cell) -> bool {
        self.contains(cell) && self.values[self.index(cell)]
    }

    /// Number of cells that are set.
    pub fn count(&self) -> usize {
        self.values.iter().filter(|&&v| v).count()
    }
}

impl<T> std::ops::Index<Cell> for Grid<T> {
    type Output = T;
    #[inline]
    fn index(&self, cell: Cell) -> &T {
        &self.values[self.index(cell)]
    }
}

impl<T> std::ops::IndexMut<Cell> for Grid<T> {
    #[inline]
    fn index_mut(&mut self, cell: Cell) -> &mut T {
        let index = self.index(cell);
        &mut self.values[index]
    }
}

//! An unbounded grid, stored in tiles.

use robovac_core::grid::Cell;
use std::sync::Arc;

/// Side of a tile, cells: a power of two.
const SIDE: i32 = 1 << SHIFT;
const SHIFT: u32 = 5;

/// A value for every cell of the plane, by default `T::default()`.
///
/// Clones share their tiles until one of them changes: a copy costs no more than the list of tiles, so that every particle of
/// a filter and every key frame of a recording can have a map of its own.
#[derive(Debug, Clone, Default)]
pub struct TiledLayer<T> {
    /// Tile at the lower left, in tiles from the origin.
    low: [i32; 2],
    /// Columns and rows of tiles.
    size: [i32; 2],
    tiles: Vec<Option<Arc<[T]>>>,
}

impl<T: Copy + Default + PartialEq> TiledLayer<T> {
    /// Nothing set.
    pub fn new() -> Self {
        Self { low: [0; 2], size: [0; 2], tiles: Vec::new() }
    }

    /// The value of a cell.
    #[inline]
    pub fn get(&self, cell: Cell) -> T {
        self.tile(cell).and_then(|index| self.tiles[index].as_deref()).map_or(T::default(), |tile| tile[within(cell)])
    }

    /// Sets the value of a cell to the result of `change`.
    pub fn update(&mut self, cell: Cell, change: impl FnOnce(T) -> T) {
        let before = self.get(cell);
        let after = change(before);
        if after == before {
            return;
        }
        let index = self.tile(cell).unwrap_or_else(|| self.grow(cell));
        let tile = self.tiles[index].get_or_insert_with(|| vec![T::default(); (SIDE * SIDE) as usize].into());
        Arc::make_mut(tile)[within(cell)] = after;
    }

    /// Lowest and highest cells of the tiles that have been touched; `None` if there are none.
    pub fn bounds(&self) -> Option<(Cell, Cell)> {
        let [width, height] = self.size;
        let [x, y] = self.low;
        (width > 0).then(|| (Cell::new(x * SIDE, y * SIDE), Cell::new((x + width) * SIDE - 1, (y + height) * SIDE - 1)))
    }

    /// Cells that differ from the default with their values, tile by tile from the lower left.
    pub fn iter(&self) -> impl Iterator<Item = (Cell, T)> {
        let [width, _] = self.size;
        let [x, y] = self.low;
        self.tiles.iter().enumerate().filter_map(|(i, tile)| Some((i as i32, tile.as_deref()?))).flat_map(
            move |(i, tile)| {
                let corner = Cell::new((x + i % width) * SIDE, (y + i / width) * SIDE);
                let set = tile.iter().enumerate().filter(|(_, value)| **value != T::default());
                set.map(move |(j, &value)| (Cell::new(corner.x + j as i32 % SIDE, corner.y + j as i32 / SIDE), value))
            },
        )
    }

    /// Approximate memory if nothing is shared, bytes.
    pub fn bytes(&self) -> usize {
        let tiles = self.tiles.iter().flatten().count();
        self.tiles.len() * size_of::<Option<Arc<[T]>>>() + tiles * (SIDE * SIDE) as usize * size_of::<T>()
    }

    /// Index of the tile that holds a cell, if it is within the list.
    #[inline]
    fn tile(&self, cell: Cell) -> Option<usize> {
        let (x, y) = ((cell.x >> SHIFT) - self.low[0], (cell.y >> SHIFT) - self.low[1]);
        let is_within = (0..self.size[0]).contains(&x) && (0..self.size[1]).contains(&y);
        is_within.then(|| (y * self.size[0] + x) as usize)
    }

    /// Makes the list reach as far as `cell`, and returns the index of its tile.
    fn grow(&mut self, cell: Cell) -> usize {
        let wanted = [cell.x >> SHIFT, cell.y >> SHIFT];
        let (low, size) = (self.low, self.size);
        if size[0] == 0 {
            (self.low, self.size) = (wanted, [1; 2]);
        } else {
            let from = [0, 1].map(|i| low[i].min(wanted[i]));
            let to = [0, 1].map(|i| (low[i] + size[i]).max(wanted[i] + 1));
            (self.low, self.size) = (from, [to[0] - from[0], to[1] - from[1]]);
        }
        let mut tiles = vec![None; (self.size[0] * self.size[1]) as usize];
        for (i, tile) in self.tiles.drain(..).enumerate() {
            let (x, y) = (low[0] + i as i32 % size[0] - self.low[0], low[1] + i as i32 / size[0] - self.low[1]);
            tiles[(y * self.size[0] + x) as usize] = tile;
        }
        self.tiles = tiles;
        ((wanted[1] - self.low[1]) * self.size[0] + wanted[0] - self.low[0]) as usize
    }
}

/// Index of a cell within its tile.
#[inline]
fn within(cell: Cell) -> usize {
    ((cell.y & (SIDE - 1)) * SIDE + (cell.x & (SIDE - 1))) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_grows_to_all_sides_and_keeps_what_was_there() {
        let mut layer = TiledLayer::<u8>::new();
        assert_eq!((layer.get(Cell::new(5, -7)), layer.bounds()), (0, None));
        let cells = [(0, 0), (-1, 0), (40, 3), (-200, -90), (31, 31), (32, 32), (7, 300)].map(|(x, y)| Cell::new(x, y));
        for (value, &cell) in (1..).zip(&cells) {
            layer.update(cell, |_| value);
        }
        for (value, &cell) in (1..).zip(&cells) {
            assert_eq!(layer.get(cell), value, "{cell:?}");
        }
        assert_eq!(layer.iter().count(), cells.len());
        assert!(layer.iter().all(|(cell, value)| cells[usize::from(value) - 1] == cell));
        assert_eq!(layer.bounds(), Some((Cell::new(-224, -96), Cell::new(63, 319))));
    }

    #[test]
    fn a_copy_is_left_alone_by_changes_of_the_other() {
        let mut layer = TiledLayer::<i16>::new();
        layer.update(Cell::new(3, 3), |_| 7);
        let copy = layer.clone();
        layer.update(Cell::new(3, 3), |old| old + 1);
        assert_eq!((copy.get(Cell::new(3, 3)), layer.get(Cell::new(3, 3))), (7, 8));
    }
}

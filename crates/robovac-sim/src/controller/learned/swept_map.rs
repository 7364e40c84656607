//! What the robot remembers of the floor: what it has swept, and where something keeps its middle away.
//!
//! Cells of 5 cm, which wrap round after 25.6 m, and blocks of 4 x 4 cells for the way to places that lie farther off.

use robovac_core::{geometry::Point, math};

/// Side of a cell, m.
pub(super) const CELL_M: f64 = 0.05;
/// Cells along the side of the map, as a power of two.
const BITS: u32 = 9;
const MASK: i32 = (1 << BITS) - 1;
/// Cells along the side of a block, as a power of two.
const BLOCK_BITS: u32 = 2;
/// Side of a block, m.
pub(super) const BLOCK_M: f64 = CELL_M * (1 << BLOCK_BITS) as f64;
/// Blocks along the side of the map.
pub(super) const BLOCKS: i32 = 1 << (BITS - BLOCK_BITS);
const CELLS_OF_BLOCK: u8 = 1 << (2 * BLOCK_BITS);
/// Cells of a block that must be new for it to be worth a way.
const WORTH: u8 = 6;
/// Cells of a block that may be blocked where a way leads.
const NARROW: u8 = 8;
/// How often it may be tried to get to a block.
const TRIES: u8 = 40;

const SWEPT: u8 = 1;
const BLOCKED: u8 = 2;

/// Sums over the cells of a block, and what the robot did there.
#[derive(Debug, Clone, Copy)]
struct SweptBlock {
    new: u8,
    blocked: u8,
    visits: u8,
    tries: u8,
}

/// The map.
#[derive(Debug, Clone)]
pub(super) struct SweptMap {
    cells: Vec<u8>,
    blocks: Vec<SweptBlock>,
}

/// Indices of a block, which wrap round.
pub(super) type BlockAt = (i32, i32);

impl SweptMap {
    pub(super) fn new() -> Self {
        let block = SweptBlock { new: CELLS_OF_BLOCK, blocked: 0, visits: 0, tries: 0 };
        Self { cells: vec![0; 1 << (2 * BITS)], blocks: vec![block; (BLOCKS * BLOCKS) as usize] }
    }

    /// The floor within a disc is swept.
    pub(super) fn sweep(&mut self, centre: Point, radius_m: f64) {
        disc(centre, radius_m, |x, y| self.set(x, y, |cell| cell | SWEPT));
    }

    /// The robot's middle can't be within a disc.
    pub(super) fn block(&mut self, centre: Point, radius_m: f64) {
        disc(centre, radius_m, |x, y| self.set(x, y, |cell| cell | BLOCKED));
    }

    /// The robot's middle can be within a disc.
    pub(super) fn clear(&mut self, centre: Point, radius_m: f64) {
        disc(centre, radius_m, |x, y| self.set(x, y, |cell| cell & !BLOCKED));
    }

    fn set(&mut self, x: i32, y: i32, change: impl Fn(u8) -> u8) {
        let Some(cell) = self.cells.get_mut(index(x, y)) else { return };
        let (before, after) = (*cell, change(*cell));
        if before == after {
            return;
        }
        *cell = after;
        if let Some(block) = self.blocks.get_mut(block_index((x >> BLOCK_BITS, y >> BLOCK_BITS))) {
            let count = |sum: u8, was: bool, is: bool| sum + u8::from(is) - u8::from(was);
            block.new = count(block.new, before == 0, after == 0);
            block.blocked = count(block.blocked, before & BLOCKED != 0, after & BLOCKED != 0);
        }
    }

    #[inline]
    fn cell(&self, (x, y): Fixed) -> u8 {
        self.cells.get(index(x >> FRACTION, y >> FRACTION)).copied().unwrap_or(0)
    }

    /// Whether nothing is known of a place.
    #[inline]
    pub(super) fn is_new(&self, at: Fixed) -> bool {
        self.cell(at) == 0
    }

    /// Whether the robot's middle can't be at a place.
    #[inline]
    pub(super) fn is_blocked(&self, at: Fixed) -> bool {
        self.cell(at) & BLOCKED != 0
    }

    /// Whether nothing is known to keep the robot's middle off the line between two points, m.
    pub(super) fn is_open(&self, from: Point, to: Point) -> bool {
        let way = to - from;
        let steps = math::ceil(way.norm() / CELL_M).max(1);
        (1..=steps).all(|step| !self.is_blocked(fixed(from + way * (f64::from(step) / f64::from(steps)))))
    }

    /// Whether a way to that block is worth while.
    pub(super) fn is_goal(&self, at: BlockAt) -> bool {
        self.at(at).is_some_and(|block| block.new >= WORTH && block.blocked <= NARROW && block.tries < TRIES)
    }

    /// Whether a way can lead over that block: the robot knows it, and fits there.
    pub(super) fn is_way(&self, at: BlockAt) -> bool {
        self.at(at).is_some_and(|block| block.blocked <= NARROW && (block.new < WORTH || block.tries >= TRIES))
    }

    /// The robot tries to get to that block.
    pub(super) fn try_for(&mut self, at: BlockAt) {
        if let Some(block) = self.blocks.get_mut(block_index(at)) {
            block.tries = block.tries.saturating_add(1);
        }
    }

    /// The robot is at that block.
    pub(super) fn visit(&mut self, at: BlockAt) {
        if let Some(block) = self.blocks.get_mut(block_index(at)) {
            block.visits = block.visits.saturating_add(1);
        }
    }

    /// How often it was there.
    pub(super) fn visits(&self, at: BlockAt) -> u8 {
        self.at(at).map_or(0, |block| block.visits)
    }

    fn at(&self, at: BlockAt) -> Option<&SweptBlock> {
        self.blocks.get(block_index(at))
    }
}

/// A point in cells with a binary fraction, which costs less to look up many times.
pub(super) type Fixed = (i32, i32);
/// Binary digits of the fraction.
const FRACTION: u32 = 16;

/// The point in cells.
pub(super) fn fixed(point: Point) -> Fixed {
    let [x, y] = [point.x, point.y].map(|metres| (metres / CELL_M * f64::from(1 << FRACTION)) as i64 as i32);
    (x, y)
}

/// The block of a point.
pub(super) fn block_of(point: Point) -> BlockAt {
    (math::floor(point.x / BLOCK_M), math::floor(point.y / BLOCK_M))
}

/// The middle of a block.
pub(super) fn middle((x, y): BlockAt) -> Point {
    Point::new((f64::from(x) + 0.5) * BLOCK_M, (f64::from(y) + 0.5) * BLOCK_M)
}

/// Where a block is stored.
pub(super) fn block_index((x, y): BlockAt) -> usize {
    ((y & (BLOCKS - 1)) * BLOCKS + (x & (BLOCKS - 1))) as usize
}

fn index(x: i32, y: i32) -> usize {
    (((y & MASK) << BITS) | (x & MASK)) as usize
}

/// Visits the cells whose centres lie in a disc.
fn disc(centre: Point, radius_m: f64, mut visit: impl FnMut(i32, i32)) {
    let (x, y, r) = (centre.x / CELL_M - 0.5, centre.y / CELL_M - 0.5, radius_m / CELL_M);
    for row in math::ceil(y - r)..=math::floor(y + r) {
        let off = f64::from(row) - y;
        let half = (r * r - off * off).max(0.0).sqrt();
        for column in math::ceil(x - half)..=math::floor(x + half) {
            visit(column, row);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_count_their_cells() {
        let mut map = SweptMap::new();
        let at = Point::new(-0.1, 3.1);
        let block = block_of(at);
        assert!(map.is_goal(block) && !map.is_way(block));
        map.sweep(at, 0.2);
        assert!(!map.is_goal(block) && map.is_way(block));
        map.block(at, 0.2);
        assert!(!map.is_way(block) && map.is_blocked(fixed(at)));
        map.clear(at, 0.2);
        assert!(map.is_way(block) && !map.is_new(fixed(at)));
        assert!((middle(block) - at).norm() < BLOCK_M);
    }

    #[test]
    fn places_that_are_tried_in_vain_are_given_up() {
        let mut map = SweptMap::new();
        for _ in 0..TRIES {
            assert!(map.is_goal((4, -7)));
            map.try_for((4, -7));
        }
        assert!(!map.is_goal((4, -7)));
    }
}

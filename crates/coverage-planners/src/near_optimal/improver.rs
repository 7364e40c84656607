//! Makes a walk cheaper window by window.

use super::{
    focus::Focus,
    profile_dp::DpSearch,
    region::{Ground, WalkRegion, Window},
    tour::Tour,
    ways::CellWays,
};
use rand::RngExt;
use robovac_core::{
    grid::{Cell, Grid},
    rng::Rng,
};
use std::collections::VecDeque;

/// A walk and its improvement.
pub(super) struct Improver {
    ways: CellWays,
    /// The free cells, by their numbers.
    cells: Vec<Cell>,
    pub tour: Tour,
    /// Cost of the walk, in price units.
    pub cost: i64,
    /// Ways tried in sites since the beginning.
    pub work: usize,
    site_of: Vec<u32>,
    rng: Rng,
}

/// A rectangle of the room, its upper right corner not included.
#[derive(Debug, Clone, Copy)]
pub(super) struct WindowBlock {
    low: Cell,
    high: Cell,
}

/// Work counted for every window in addition to the ways tried in it.
const WORK_PER_WINDOW: usize = 300;
/// Side of a block that is shaken at once, cells.
const BLOCK: i32 = 28;
/// Windows tried while a block is shaken.
const SHAKES: usize = 120;
/// Side of the windows that are settled after that, cells.
const SETTLED: usize = 8;
/// Number of random cells; the one where the walk is dearest is shaken.
const CANDIDATES: usize = 3;

/// Progress of settling.
pub(super) struct Settling<'t> {
    /// Ways tried since the beginning.
    pub work: usize,
    /// Approximate share of the block that is done.
    pub done: f64,
    /// The current walk; with markers in large rooms.
    pub walk: &'t [u32],
    /// Change of its cost so far, in price units.
    pub change: i64,
}

impl Improver {
    /// Nothing improved yet.
    pub fn new(cells: Vec<Cell>, tour: Tour, rng: Rng) -> Self {
        let site_of = vec![u32::MAX; cells.len()];
        Self { ways: CellWays::new(2), cells, tour, cost: 0, work: 0, site_of, rng }
    }

    /// A walk from cell to cell, begun in `start`.
    pub fn walk(&self, numbers: &[u32], start: Cell) -> Vec<Cell> {
        let mut walk: Vec<Cell> = numbers.iter().map(|&number| self.cells[number as usize]).collect();
        if self.tour.is_closed {
            let at = walk.iter().position(|&cell| cell == start).unwrap_or(0);
            walk.rotate_left(at);
            walk.push(start);
        }
        walk
    }

    /// Rebuilds the walk in a window of `tour` if that's cheaper, or seems so by noise; returns the change of cost.
    fn rebuild(
        &mut self,
        ground: &Ground<'_>,
        tour: &mut Tour,
        window: Window,
        most_states: usize,
        noise: i32,
    ) -> Option<i64> {
        self.work += WORK_PER_WINDOW;
        let mut region = WalkRegion::new(ground, tour, window, &mut self.site_of)?;
        if noise > 0 {
            region.disturb(noise, &mut self.rng);
        }
        let search = DpSearch { limit: region.seeming_cost(), most_states, is_all_or_nothing: false };
        let found = region.search(ground.costs(), &self.ways, search, |_| true);
        self.work += found.work;
        if found.ways.is_empty() {
            return None;
        }
        tour.replace(region.walk(tour, &found.ways)?);
        Some(found.cost - region.cost)
    }

    /// Blocks that cover the room and overlap by `overlap` cells: one, unless the room is large.
    pub fn blocks(&self, numbers: &Grid<u32>, overlap: usize) -> Vec<WindowBlock> {
        let (width, height) = (numbers.width() as i32, numbers.height() as i32);
        let room = WindowBlock { low: Cell::new(0, 0), high: Cell::new(width, height) };
        if self.cells.len() > FOLDED { room.parts(FOLD, overlap as i32) } else { vec![room] }
    }

    /// Rebuilds windows of `side` cells in a block until none gets cheaper; checks for cancellation before each.
    pub fn settle(
        &mut self,
        ground: &Ground<'_>,
        block: WindowBlock,
        (side, most_states): (usize, usize),
        goes_on: impl FnMut(Settling<'_>) -> bool,
    ) {
        self.within(block, |improver, tour, cost| {
            *cost += improver.settle_windows(ground, tour, block, (side, most_states), goes_on);
        });
    }

    /// Lets `act` change the walk in a block; in large rooms the rest is contracted meanwhile.
    fn within(&mut self, block: WindowBlock, act: impl FnOnce(&mut Self, &mut Tour, &mut i64)) {
        let mut cost = 0;
        if self.cells.len() > FOLDED {
            let cells = &self.cells;
            let mut focus = Focus::new(&self.tour, cells.len(), |number| block.contains(cells[number as usize]));
            act(self, &mut focus.tour, &mut cost);
            if cost != 0 {
                self.tour.replace(focus.unfold());
            }
        } else {
            let mut tour = std::mem::replace(&mut self.tour, Tour::new(0, Vec::new(), false));
            act(self, &mut tour, &mut cost);
            self.tour = tour;
        }
        self.cost += cost;
    }

    /// Returns the change of cost.
    fn settle_windows(
        &mut self,
        ground: &Ground<'_>,
        tour: &mut Tour,
        block: WindowBlock,
        (side, most_states): (usize, usize),
        mut goes_on: impl FnMut(Settling<'_>) -> bool,
    ) -> i64 {
        let mut cost = 0;
        let stride = (side as i32 / 2).max(1);
        let columns = ((block.high.x - block.low.x + stride - 1) / stride).max(1) as usize;
        let rows = ((block.high.y - block.low.y + stride - 1) / stride).max(1) as usize;
        let mut queue: VecDeque<usize> = (0..columns * rows).collect();
        let mut is_queued = vec![true; queue.len()];
        let mut tried = 0;
        while let Some(at) = queue.pop_front() {
            is_queued[at] = false;
            tried += 1;
            let done = tried as f64 / (tried + queue.len()) as f64;
            if !goes_on(Settling { work: self.work, done, walk: &tour.cells, change: cost }) {
                break;
            }
            let (column, row) = (at % columns, at / columns);
            let low = Cell::new(block.low.x + stride * column as i32, block.low.y + stride * row as i32);
            let window = block.window(low, side as i32, side as i32);
            let Some(change) = self.rebuild(ground, tour, window, most_states, 0) else { continue };
            cost += change;
            for y in row.saturating_sub(2)..(row + 3).min(rows) {
                for x in column.saturating_sub(2)..(column + 3).min(columns) {
                    let near = y * columns + x;
                    if !std::mem::replace(&mut is_queued[near], true) {
                        queue.push_back(near);
                    }
                }
            }
        }
        cost
    }

    /// Searches for the optimal walk by taking the whole room as a window, with at most `most_states` states after each
    /// cell; returns whether the walk is optimal now. `goes_on` is called regularly.
    pub fn solve(&mut self, ground: &Ground<'_>, most_states: usize, mut goes_on: impl FnMut() -> bool) -> bool {
        let (width, height) = (ground.numbers.width(), ground.numbers.height());
        let window = Window { corner: Cell::new(0, 0), width, height };
        // The turn from the robot's heading can require a third use of an edge.
        let ways = CellWays::new(if ground.counts_first_turn { 3 } else { 2 });
        let Some(region) = WalkRegion::new(ground, &self.tour, window, &mut self.site_of) else { return false };
        let search = DpSearch { limit: region.cost, most_states, is_all_or_nothing: true };
        let found = region.search(ground.costs(), &ways, search, |_| goes_on());
        if found.ways.is_empty() {
            return found.is_exact;
        }
        let Some(walk) = region.walk(&self.tour, &found.ways) else { return false };
        self.tour.replace(walk);
        self.cost += found.cost - region.cost;
        found.is_exact
    }

    /// Shakes one block: rebuilds windows with decreasing noise, and reverts everything if that made the walk dearer.
    /// Checks for cancellation before each window.
    pub fn shake(
        &mut self,
        ground: &Ground<'_>,
        noise: f64,
        (largest, most_states): (i32, usize),
        mut goes_on: impl FnMut() -> bool,
    ) {
        let centre = self.dear_cell(ground);
        let (width, height) = (ground.numbers.width() as i32, ground.numbers.height() as i32);
        let low = |at: i32, most: i32| (at - BLOCK / 2).clamp(0, (most - BLOCK).max(0));
        let low = Cell::new(low(centre.x, width), low(centre.y, height));
        let high = Cell::new((low.x + BLOCK).min(width), (low.y + BLOCK).min(height));
        let block = WindowBlock { low, high };
        self.within(block, |improver, tour, cost| {
            let before = tour.cells.clone();
            let (step, turn) = ground.costs();
            let noise = noise * f64::from(step + turn);
            for shake in 0..SHAKES {
                if !goes_on() {
                    break;
                }
                let share = 1.0 - (shake as f64 + 1.0) / SHAKES as f64;
                let side = improver.rng.random_range(6..=largest);
                let at = |low: i32, high: i32, rng: &mut Rng| rng.random_range(low - side / 2..high - side / 2);
                let corner = Cell::new(at(low.x, high.x, &mut improver.rng), at(low.y, high.y, &mut improver.rng));
                let window = block.window(corner, side, side);
                *cost += improver.rebuild(ground, tour, window, most_states, (noise * share) as i32).unwrap_or(0);
            }
            *cost += improver.settle_windows(ground, tour, block, (SETTLED, most_states), |_| goes_on());
            if *cost > 0 {
                tour.replace(before);
                *cost = 0;
            }
        });
    }

    /// A random cell, preferably one where the walk costs more than a passage must.
    fn dear_cell(&mut self, ground: &Ground<'_>) -> Cell {
        let Ground { graph, prices, .. } = *ground;
        let excess = |position: usize| {
            let [before, after] = [false, true].map(|is_after| self.tour.beside(position, is_after));
            let cell = self.tour.cells[position];
            let side = |other: Option<usize>| {
                let other = self.tour.cells[other?];
                graph.neighbours[cell as usize].iter().position(|&next| next == other)
            };
            prices.excess(cell as usize, side(before), side(after))
        };
        let tries: [usize; CANDIDATES] = std::array::from_fn(|_| self.rng.random_range(0..self.tour.cells.len()));
        let position = tries.into_iter().max_by_key(|&position| excess(position)).unwrap_or(0);
        self.cells[self.tour.cells[position] as usize]
    }
}

/// Number of cells above which the walk outside a block is contracted.
const FOLDED: usize = 4_000;
/// Side of the blocks that are settled one after the other then, cells.
const FOLD: i32 = 64;

impl WindowBlock {
    fn contains(self, cell: Cell) -> bool {
        (self.low.x..self.high.x).contains(&cell.x) && (self.low.y..self.high.y).contains(&cell.y)
    }

    /// The part of a rectangle that lies in the block.
    fn window(self, corner: Cell, width: i32, height: i32) -> Window {
        let low = Cell::new(corner.x.max(self.low.x), corner.y.max(self.low.y));
        let high = Cell::new((corner.x + width).min(self.high.x), (corner.y + height).min(self.high.y));
        Window { corner: low, width: (high.x - low.x).max(0) as usize, height: (high.y - low.y).max(0) as usize }
    }

    /// Blocks of `side` cells that cover it, and overlap by `overlap`.
    fn parts(self, side: i32, overlap: i32) -> Vec<Self> {
        let starts =
            |low: i32, high: i32| (low..(high - overlap).max(low + 1)).step_by((side - overlap).max(1) as usize);
        let mut parts = Vec::new();
        for y in starts(self.low.y, self.high.y) {
            for x in starts(self.low.x, self.high.x) {
                let high = Cell::new((x + side).min(self.high.x), (y + side).min(self.high.y));
                parts.push(Self { low: Cell::new(x, y), high });
            }
        }
        parts
    }
}

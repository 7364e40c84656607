//! Dual prices on the sides of cells, and the resulting bound, in whole numbers.

use super::{
    cut_vertices::CutVertices,
    graph::{Graph, NONE},
    primal_dual,
};
use crate::{Finish, Objective};
use robovac_core::grid::Direction;

/// Approximate number of price units in the larger weight.
const UNITS: u32 = 1 << 16;
/// Larger weights are clamped to this.
pub const MOST_WEIGHT: u32 = 4096;
/// The price of a side with a wall; above the cost of any passage without walls.
pub(super) const WALL: i32 = 1 << 20;
/// Rounds of repairing single cells.
const REPAIRS: usize = 40;

/// Prices on the sides of all cells, in price units: the reduced cost of a passage through sides a and b of a cell is
/// step + turn x (quarter turns from a to b) + the prices of both sides, and none is below 0.
#[derive(Debug, Clone)]
pub struct DualPrices {
    /// Price units in one unit of the objective.
    pub unit: i32,
    /// Cost of a step.
    pub step: i32,
    /// Cost of a quarter turn.
    pub turn: i32,
    /// Per cell and side, counter-clockwise from the right; walls have the price `WALL`.
    pub sides: Vec<[i32; 4]>,
    /// Largest price other than walls.
    pub(super) limit: i32,
    finish: Finish,
    /// Quarter turns to a first step through each side, if the objective counts them.
    first_quarters: [u8; 4],
}

impl DualPrices {
    /// All prices 0.
    pub(super) fn new(graph: &Graph, objective: Objective, heading: Direction) -> Self {
        let (step, turn) = (objective.step.min(MOST_WEIGHT), objective.turn.min(MOST_WEIGHT));
        // Even, as half a step must be a whole number.
        let unit = ((UNITS / step.max(turn).max(1)) & !1).max(2) as i32;
        let (step, turn) = (step as i32 * unit, turn as i32 * unit);
        let sides = graph.neighbours.iter().map(|n| n.map(|next| if next == NONE { WALL } else { 0 })).collect();
        let counts_first = objective.finish == Finish::Anywhere && objective.counts_first_turn;
        let first_quarters = Direction::ALL.map(|to| if counts_first { heading.quarter_turns(to) as u8 } else { 0 });
        Self { unit, step, turn, limit: step + turn + turn / 2, sides, finish: objective.finish, first_quarters }
    }

    /// Whether the walk has ends.
    pub(super) fn is_open(&self) -> bool {
        self.finish == Finish::Anywhere
    }

    /// Quarter turns to a first step through each side, if the objective counts them.
    pub(super) fn first_quarters(&self) -> [u8; 4] {
        self.first_quarters
    }

    /// Cost of a first visit that leaves through each side, at price 0.
    pub(super) fn first_costs(&self) -> [i32; 4] {
        self.first_quarters.map(|quarters| self.step / 2 + self.turn * i32::from(quarters))
    }

    /// Takes over prices from elsewhere, given for the right and the upper side of every cell, and repairs them so that
    /// no passage has a negative cost. False if that wasn't possible.
    pub(super) fn take(&mut self, graph: &Graph, right_and_upper: impl Fn(usize) -> [f64; 2]) -> bool {
        for cell in 0..graph.len() {
            for (side, price) in right_and_upper(cell).into_iter().enumerate() {
                self.set(graph, cell, side, (price + if price < 0.0 { -0.5 } else { 0.5 }) as i32);
            }
        }
        let all: Vec<u32> = (0..graph.len() as u32).collect();
        if self.mend(graph, &all) {
            return true;
        }
        // The cost of a passage is concave in the prices, and at least a step if they are 0, so somewhere between it is
        // 0.
        let least = (0..graph.len()).map(|cell| self.visits(cell).0).min().unwrap_or(0).min(0);
        let (step, all) = (i64::from(self.step), i64::from(self.step - least) + 4);
        for cell in 0..graph.len() {
            let [right, upper, ..] = self.sides[cell];
            for (side, price) in [right, upper].into_iter().enumerate() {
                self.set(graph, cell, side, (i64::from(price) * (step - 4).max(0) / all) as i32);
            }
        }
        (0..graph.len()).all(|cell| self.visits(cell).0 >= 0)
    }

    /// Shifts prices of these cells until no passage has a negative cost; returns whether that succeeded.
    pub(super) fn mend(&mut self, graph: &Graph, cells: &[u32]) -> bool {
        for round in 0..REPAIRS {
            let mut is_done = true;
            for index in 0..cells.len() {
                let cell = cells[if round.is_multiple_of(2) { index } else { cells.len() - 1 - index }] as usize;
                if self.visits(cell).0 < 0 {
                    self.repair(graph, cell);
                    is_done = false;
                }
            }
            if is_done {
                return true;
            }
        }
        false
    }

    /// The sides' prices of some cells.
    pub(super) fn of(&self, cells: &[u32]) -> Vec<[i32; 4]> {
        cells.iter().map(|&cell| self.sides[cell as usize]).collect()
    }

    /// The inverse of [`Self::of`], for cells beside which nothing has changed.
    pub(super) fn put_back(&mut self, cells: &[u32], sides: &[[i32; 4]]) {
        for (&cell, sides) in cells.iter().zip(sides) {
            self.sides[cell as usize] = *sides;
        }
    }

    /// The larger weight, in price units.
    pub(super) fn scale(&self) -> f64 {
        f64::from(self.step.max(self.turn).max(1))
    }

    /// A cell's prices as shares of the larger weight, with walls as the linear programme expects them.
    pub(super) fn scaled(&self, cell: usize) -> [f64; 4] {
        self.sides[cell].map(|price| if price >= WALL { primal_dual::WALL } else { f64::from(price) / self.scale() })
    }

    /// Sets the price of an edge, unless it's a wall.
    pub(super) fn set(&mut self, graph: &Graph, cell: usize, side: usize, price: i32) {
        let next = graph.neighbours[cell][side];
        if next != NONE {
            let price = price.clamp(-self.limit, self.limit);
            self.sides[cell][side] = price;
            self.sides[next as usize][side ^ 2] = -price;
        }
    }

    /// Raises prices of a cell, at its neighbours' cost, until no passage has a negative cost.
    fn repair(&mut self, graph: &Graph, cell: usize) {
        for _ in 0..10 {
            let [right, up, left, down] = self.sides[cell];
            let x = if right < left { 0 } else { 2 };
            let y = if up < down { 1 } else { 3 };
            let (along_x, along_y) = (right.min(left), up.min(down));
            let nearer = if along_x < along_y { x } else { y };
            let ways = [
                (right + left, [0, 2]),
                (up + down, [1, 3]),
                (self.turn + along_x + along_y, [x, y]),
                (2 * (self.turn + along_x.min(along_y)), [nearer, nearer]),
            ];
            let (cost, [a, b]) = ways.into_iter().min().unwrap_or_default();
            let missing = -(self.step + cost);
            if missing <= 0 {
                return;
            }
            let half = (missing + 1) / 2;
            self.set(graph, cell, a, self.sides[cell][a] + half);
            if a != b {
                self.set(graph, cell, b, self.sides[cell][b] + half);
            }
        }
    }

    /// Least cost of a passage, and of a last visit.
    pub(super) fn visits(&self, cell: usize) -> (i32, i32) {
        let [right, up, left, down] = self.sides[cell];
        let (along_x, along_y) = (right.min(left), up.min(down));
        let straight = i32::min(right + left, up + down);
        let back = 2 * (self.turn + along_x.min(along_y));
        let passage = straight.min(self.turn + along_x + along_y).min(back);
        (self.step + passage, self.step / 2 + along_x.min(along_y))
    }

    /// The bound by these prices, in units of the objective; 0 if they are invalid.
    pub(super) fn bound(&self, graph: &Graph, cuts: &CutVertices) -> u64 {
        if graph.len() < 2 {
            return 0;
        }
        let mut sum = 0;
        for (cell, &excess) in cuts.excess.iter().enumerate() {
            let (passage, _) = self.visits(cell);
            if passage < 0 {
                return 0;
            }
            sum += i64::from(passage) * (1 + i64::from(excess));
        }
        if self.is_open() {
            let saved = |(passage, half): (i32, i32)| i64::from(passage - half);
            let first = (0..4).map(|side| self.first_costs()[side] + self.sides[graph.start][side]).min();
            let at_start = saved((self.visits(graph.start).0, first.unwrap_or(0)));
            let below = cuts.sums_below(|cell| i64::from(self.visits(cell).0));
            let at_end = below.map(|(cell, sum)| saved(self.visits(cell)) + sum).max().unwrap_or(0);
            sum -= at_start + at_end;
        }
        (sum.max(0) as u64).div_ceil(self.unit as u64)
    }

    /// Cost of a visit through two sides beyond the cheapest passage, in price units. The walk's first and last visits
    /// have one side, or none.
    pub fn excess(&self, cell: usize, from: Option<usize>, to: Option<usize>) -> i32 {
        let (passage, half) = self.visits(cell);
        let sides = &self.sides[cell];
        match (from, to) {
            (Some(a), Some(b)) => {
                let turns = [2, 1, 0, 1][(a + 4 - b) & 3];
                self.step + self.turn * turns + sides[a] + sides[b] - passage
            }
            (Some(side), None) | (None, Some(side)) => self.step / 2 + sides[side] - half,
            (None, None) => 0,
        }
    }
}

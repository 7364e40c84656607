//! A bound on step x S + turn x T by prices on the sides of cells.
//!
//! Every visit of a walk but the first and the last enters the cell through one side and leaves it through one side,
//! perhaps the same: call that a passage. Give every side a of every cell c a price p(c, a), positive or negative, such
//! that the two prices at the edge between two neighbours add up to 0. A step uses the same edge from both its cells, so
//! the prices that a walk pays add up to 0, and its cost is also the sum of
//!
//! - step + turn x (quarter turns from a to b) + p(c, a) + p(c, b) for every passage of cell c through sides a and b,
//! - step / 2 + p(c, a) for the first and the last visit, which use one side of their cell.
//!
//! Let f(c) be the least that a passage of c can cost, and g(c) the least for a first or last visit. If all f(c) >= 0,
//! and v(c) visits to c are needed, a walk that ends in e costs at least
//!
//! > sum of v(c) f(c)  +  g(start) - f(start)  +  g(e) - f(e).
//!
//! With v(c) = 1 + excess(c) - (1 if e is below c) by [`Cuts`] and the worst e, that holds for every walk, whatever the
//! prices are: it's a Lagrangian relaxation of the constraint that passages of neighbours fit together.
//!
//! Good prices are found by going over all edges and shifting the price of each so that both its cells would gain equally
//! from using it: max-sum diffusion (Werner 2007, A linear programming approach to max-sum problem: a review). As that
//! spreads by one cell a time, the sweeps run forth and back over the rows, and leave less than half of the gain behind. What
//! comes out needn't be the best prices, but it gives a bound all the same, and no rounding spoils it, as it's reckoned in
//! whole numbers.

use super::{
    cuts::Cuts,
    graph::{Graph, NONE},
};
use crate::planner::{CoverageJob, Finish, Objective};

/// About how many price units the larger weight is.
pub const UNITS: u32 = 4096;
/// The price of a side with a wall: more than any way through others.
const WALL: i32 = 1 << 20;
/// Cells visited by all sweeps together, within the two limits below.
const EFFORT: usize = 6_000_000;
const FEWEST_SWEEPS: usize = 6;
const MOST_SWEEPS: usize = 400;
/// In 1/256: how far to shift a price of what would be right, and how much of what both cells gain stays behind. The
/// former gets far in a few sweeps; where there is time for this many, the latter gets further.
const HASTY: (i32, i32) = (410, 102);
const PATIENT: (i32, i32) = (256, 77);
const MANY_SWEEPS: usize = 50;

/// Sweeps for a room of that many cells where time is short.
pub(super) fn effort(cells: usize) -> usize {
    (EFFORT / cells.max(1)).clamp(FEWEST_SWEEPS, MOST_SWEEPS)
}

/// Prices on the sides of all cells, in price units: the reduced cost of a passage through sides a and b of a cell is
/// step + turn x (quarter turns from a to b) + the prices of both sides, and none is below 0.
pub struct Prices {
    /// Price units in one unit of the objective.
    pub unit: i32,
    /// What a step costs.
    pub step: i32,
    /// What a quarter turn costs.
    pub turn: i32,
    /// Per cell and side, counter-clockwise from the right; walls are dearer than any way.
    pub sides: Vec<[i32; 4]>,
    /// Largest price but for walls.
    limit: i32,
    objective: Objective,
    swept: usize,
}

/// A bound that rises the longer one works at it.
pub struct Relaxation {
    /// The cells.
    pub graph: Graph,
    cuts: Cuts,
    /// The prices so far.
    pub prices: Prices,
    bound: u64,
}

impl Relaxation {
    /// No work done yet; weights above [`UNITS`] count as that.
    pub fn new(job: &CoverageJob, objective: Objective) -> Self {
        let graph = Graph::new(&job.free, job.start);
        let cuts = Cuts::of(&graph);
        let prices = Prices::new(&graph, objective);
        let bound = prices.bound(&graph, &cuts);
        Self { graph, cuts, prices, bound }
    }

    /// Visits about that many cells to make prices better; whether more work may help.
    pub fn improve(&mut self, cells: usize) -> bool {
        let before = self.bound;
        self.prices.work(&self.graph, cells.div_ceil(self.graph.len().max(1)));
        self.bound = self.prices.bound(&self.graph, &self.cuts).max(before);
        self.bound > before || self.prices.swept < MOST_SWEEPS
    }

    /// No walk costs less, in the objective's weights.
    pub fn bound(&self) -> u64 {
        self.bound
    }
}

impl Prices {
    pub(super) fn new(graph: &Graph, objective: Objective) -> Self {
        let (step, turn) = (objective.step.min(UNITS), objective.turn.min(UNITS));
        // Even, as half a step is needed.
        let unit = ((UNITS / step.max(turn).max(1)) & !1).max(2) as i32;
        let (step, turn) = (step as i32 * unit, turn as i32 * unit);
        let sides = graph.neighbours.iter().map(|n| n.map(|next| if next == NONE { WALL } else { 0 })).collect();
        Self { unit, step, turn, limit: step + turn + turn / 2, sides, objective, swept: 0 }
    }

    /// That many sweeps.
    pub(super) fn work(&mut self, graph: &Graph, sweeps: usize) {
        for _ in 0..sweeps {
            self.sweep(graph, self.swept, if effort(graph.len()) < MANY_SWEEPS { HASTY } else { PATIENT });
            self.swept += 1;
        }
    }

    /// Shifts the prices of all edges once.
    fn sweep(&mut self, graph: &Graph, index: usize, (overshoot, kept): (i32, i32)) {
        let shares = if index.is_multiple_of(2) { (overshoot, kept) } else { (overshoot, 256 - kept) };
        if index.is_multiple_of(2) {
            for cell in 0..graph.len() {
                let [right, up, ..] = graph.neighbours[cell];
                self.shift::<0>(cell, right, shares);
                self.shift::<1>(cell, up, shares);
            }
        } else {
            // The other way round in every respect: a cell is given everything before it passes it on.
            for cell in (0..graph.len()).rev() {
                let [right, up, ..] = graph.neighbours[cell];
                self.shift::<1>(cell, up, shares);
                self.shift::<0>(cell, right, shares);
            }
        }
    }

    /// Shifts the price of the edge from `cell` through `SIDE` to `next`.
    #[inline]
    fn shift<const SIDE: usize>(&mut self, cell: usize, next: u32, (overshoot, kept): (i32, i32)) {
        let next = next as usize;
        if next == NONE as usize {
            return;
        }
        let opposite = SIDE ^ 2;
        let [(without, with), (next_without, next_with)] = [self.passages(cell, SIDE), self.passages(next, opposite)];
        let (step, twice) = (self.step, 2 * self.turn);
        // What using the edge costs either cell more than not using it, at price 0; at price x it's x more and less.
        let (extra, next_extra) = (with - without, next_with - next_without);
        let mut price = ((kept * (extra + next_extra)) >> 8) - extra;
        // Unless turning back through that side, which pays the price twice, is the cheapest way to use it.
        match (price < with - twice, price > twice - next_with) {
            (false, false) => {}
            (true, false) => price = (next_extra - (twice - without)) / 3,
            (false, true) => price = ((twice - next_without) - extra) / 3,
            (true, true) => price = (without - next_without) / 4,
        }
        let before = self.sides[cell][SIDE];
        price = before + ((overshoot * (price - before)) >> 8);
        // No passage may become cheaper than nothing.
        let low = i32::max(-(with + step), -(self.turn + step / 2)).max(-self.limit);
        let high = i32::min(next_with + step, self.turn + step / 2).min(self.limit);
        price = price.min(high).max(low);
        self.sides[cell][SIDE] = price;
        self.sides[next][opposite] = -price;
    }

    /// Least cost of passages, beyond a step: of those that don't use `side`, and of those that use it once, the price of
    /// `side` not counted.
    #[inline]
    fn passages(&self, cell: usize, side: usize) -> (i32, i32) {
        let sides = &self.sides[cell];
        let (turn, across) = (self.turn, sides[side ^ 2]);
        let (left, right) = (sides[(side + 1) & 3], sides[(side + 3) & 3]);
        let beside = left.min(right);
        let without = i32::min(left + right, turn + across + beside).min(2 * (turn + across.min(beside)));
        (without.min(WALL), across.min(turn + beside).min(WALL))
    }

    /// Least cost of a passage, and of a first or last visit.
    fn visits(&self, cell: usize) -> (i32, i32) {
        let [right, up, left, down] = self.sides[cell];
        let (along_x, along_y) = (right.min(left), up.min(down));
        let straight = i32::min(right + left, up + down);
        let back = 2 * (self.turn + along_x.min(along_y));
        let passage = straight.min(self.turn + along_x + along_y).min(back);
        (self.step + passage, self.step / 2 + along_x.min(along_y))
    }

    /// The bound by these prices, in units of the objective.
    pub(super) fn bound(&self, graph: &Graph, cuts: &Cuts) -> u64 {
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
        if self.objective.finish == Finish::Start {
            return (sum as u64).div_ceil(self.unit as u64);
        }
        let saved = |(passage, half): (i32, i32)| i64::from(passage - half);
        let at_start = saved(self.visits(graph.start));
        let below = cuts.sums_below(|cell| i64::from(self.visits(cell).0));
        let at_end = below.map(|(cell, sum)| saved(self.visits(cell)) + sum).max().unwrap_or(0);
        ((sum - at_start - at_end).max(0) as u64).div_ceil(self.unit as u64)
    }
}

impl Prices {
    /// By how much a visit of a cell through two sides costs more than the cheapest passage, in price units; the walk's
    /// first and last visit have one side, and none.
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

//! Initial dual prices by diffusion: fast, but purely local.
//!
//! A sweep visits all edges and shifts the price of each so that both its cells would gain equally from using it:
//! max-sum diffusion (Werner 2007, A linear programming approach to max-sum problem: a review). As gains spread by one
//! cell at a time, the sweeps run back and forth over the rows, and leave less than half of the gain behind. Prices
//! that no longer move aren't necessarily the best.

use super::{
    dual_prices::{DualPrices, WALL},
    graph::{Graph, NONE},
};

/// Cells visited by all sweeps together, within the two limits below.
const EFFORT: usize = 6_000_000;
const FEWEST_SWEEPS: usize = 6;
pub(super) const MOST_SWEEPS: usize = 400;
/// In 1/256: how far a price is shifted relative to the balancing shift, and which share of both cells' gain stays
/// behind. The former gets far in a few sweeps; the latter gets further where there is time for this many.
const HASTY: (i32, i32) = (410, 102);
const PATIENT: (i32, i32) = (256, 77);
const MANY_SWEEPS: usize = 50;

/// Number of sweeps for a room of `cells` cells when time is short.
pub(super) fn effort(cells: usize) -> usize {
    (EFFORT / cells.max(1)).clamp(FEWEST_SWEEPS, MOST_SWEEPS)
}

impl DualPrices {
    /// That many sweeps, after `done` ones.
    pub(super) fn diffuse(&mut self, graph: &Graph, done: usize, sweeps: usize) {
        for index in done..done + sweeps {
            self.sweep(graph, index, if effort(graph.len()) < MANY_SWEEPS { HASTY } else { PATIENT });
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
            // The reverse in every respect: a cell receives everything before it passes it on.
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
        // Extra cost to either cell of using the edge rather than not, at price 0; at price x it's x more and x less.
        let (extra, next_extra) = (with - without, next_with - next_without);
        let mut price = ((kept * (extra + next_extra)) >> 8) - extra;
        // Unless turning back through that side, which pays the price twice, is the cheapest use.
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

    /// Least cost of passages beyond a step: of those that don't use `side`, and of those that use it once, without the
    /// price of `side`.
    #[inline]
    fn passages(&self, cell: usize, side: usize) -> (i32, i32) {
        let sides = &self.sides[cell];
        let (turn, across) = (self.turn, sides[side ^ 2]);
        let (left, right) = (sides[(side + 1) & 3], sides[(side + 3) & 3]);
        let beside = left.min(right);
        let without = i32::min(left + right, turn + across + beside).min(2 * (turn + across.min(beside)));
        (without.min(WALL), across.min(turn + beside).min(WALL))
    }
}

//! Improves dual prices in large rooms tile by tile, with the prices around each tile fixed.
//!
//! A tile's own programme ([`super::primal_dual`]) knows the cost of leaving the tile, but not that neighbours there
//! must agree, so its prices are good for the present prices of the rest. They're kept if they raise the total cost of
//! the tile's cells. As tiles of the next round lie across the borders of those before, the whole room gains in a few
//! rounds.

use super::{
    cut_vertices::CutVertices,
    dual_prices::DualPrices,
    graph::{Graph, NONE},
    primal_dual::{PrimalDual, Programme},
};
use robovac_core::grid::{Cell, Grid};

/// Cells along a tile's side, and steps of the iteration in each.
const SIDE: i32 = 64;
const STEPS: usize = 400;
/// Cells around a tile whose prices can be shifted to keep all prices valid.
const RING: i32 = 4;
/// Rounds; each round's tiles are offset by half a side from those of the round before.
const ROUNDS: usize = 4;

/// Progress of the rounds.
#[derive(Default)]
pub(super) struct Tiles {
    round: usize,
    /// Tiles of the round that are done.
    done: usize,
}

impl Tiles {
    /// Improves the prices of the next tile; returns the cells visited for it, or `None` after the last round.
    pub fn improve(&mut self, graph: &Graph, cuts: &CutVertices, prices: &mut DualPrices) -> Option<usize> {
        if self.round == ROUNDS {
            return None;
        }
        let shift = if self.round.is_multiple_of(2) { 0 } else { SIDE / 2 };
        let across = |cells: usize| (cells + shift as usize).div_ceil(SIDE as usize);
        let (columns, rows) = (across(graph.numbers.width()), across(graph.numbers.height()));
        let corner = |at: usize| at as i32 * SIDE - shift;
        let low = Cell::new(corner(self.done % columns), corner(self.done / columns));
        self.done += 1;
        if self.done == columns * rows {
            (self.round, self.done) = (self.round + 1, 0);
        }
        Some(improve(graph, cuts, prices, low))
    }
}

/// The tile by itself, its cells numbered in the same order.
fn part(graph: &Graph, low: Cell) -> Option<Graph> {
    let inside = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| Cell::new(low.x + x, low.y + y)));
    let free = inside.map(|cell| graph.numbers.get(cell).is_some_and(|&number| number != NONE)).collect();
    Some(Graph::new(&Grid::from_rows(SIDE as usize, free)?, Cell::new(0, 0)))
}

/// Improves the prices of the tile with that lowest corner; returns the cells visited for it.
fn improve(graph: &Graph, cuts: &CutVertices, prices: &mut DualPrices, low: Cell) -> usize {
    let numbers = |margin: i32| {
        let across = -margin..SIDE + margin;
        let cells = across.clone().flat_map(move |y| across.clone().map(move |x| Cell::new(low.x + x, low.y + y)));
        cells.filter_map(|cell| graph.numbers.get(cell).copied()).filter(|&number| number != NONE)
    };
    let tile: Vec<u32> = numbers(0).collect();
    if tile.len() < 2 {
        return tile.len();
    }
    let Some(part) = part(graph, low) else { return 0 };
    let unit = prices.scale();
    let programme = Programme {
        step: f64::from(prices.step) / unit,
        turn: f64::from(prices.turn) / unit,
        visits: tile.iter().map(|&cell| 1.0 + f64::from(cuts.excess[cell as usize])).collect(),
        begin: None,
    };
    let mut iteration = PrimalDual::new(&part, programme, |index| prices.scaled(tile[index] as usize));
    for _ in 0..STEPS {
        iteration.step(&part);
    }
    // A shift can change the cells beside it, too.
    let near: Vec<u32> = numbers(RING + 1).collect();
    let shifted: Vec<u32> = numbers(RING).collect();
    let worth = |prices: &DualPrices| {
        near.iter().try_fold(0, |sum, &cell| {
            let passage = i64::from(prices.visits(cell as usize).0);
            (passage >= 0).then(|| sum + passage * (1 + i64::from(cuts.excess[cell as usize])))
        })
    };
    let (before, worth_before) = (prices.of(&near), worth(prices));
    for (index, &cell) in tile.iter().enumerate() {
        for (side, price) in iteration.edges(index).into_iter().enumerate() {
            if part.neighbours[index][side] != NONE {
                prices.set(graph, cell as usize, side, (price * unit) as i32);
            }
        }
    }
    prices.mend(graph, &shifted);
    if worth(prices) <= worth_before {
        prices.put_back(&near, &before);
    }
    tile.len() * STEPS
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Objective;
    use rand::RngExt;
    use robovac_core::{grid::Direction, rng::seeded};

    #[test]
    fn tiles_raise_what_diffusion_leaves() {
        let mut rng = seeded(1, 0);
        let pillars = (0..100 * 90).map(|index| index == 0 || rng.random_range(0..12) > 0).collect();
        let graph = Graph::new(&Grid::from_rows(100, pillars).unwrap(), Cell::new(0, 0));
        let cuts = CutVertices::of(&graph);
        let mut prices = DualPrices::new(&graph, Objective::open(1, 2), Direction::Right);
        prices.diffuse(&graph, 0, 400);
        let walls = prices.sides.clone();
        let mut bounds = vec![prices.bound(&graph, &cuts)];
        let mut tiles = Tiles::default();
        while tiles.improve(&graph, &cuts, &mut prices).is_some() {
            bounds.push(prices.bound(&graph, &cuts));
            // The conditions of a bound: neighbours' prices add up to 0, walls stay, and no passage has a negative
            // cost.
            for (cell, neighbours) in graph.neighbours.iter().enumerate() {
                assert!(prices.visits(cell).0 >= 0);
                for (side, &next) in neighbours.iter().enumerate() {
                    let price = prices.sides[cell][side];
                    let expected =
                        if next == NONE { walls[cell][side] } else { -prices.sides[next as usize][side ^ 2] };
                    assert_eq!(price, expected, "cell {cell}, side {side}");
                }
            }
        }
        // Two by two tiles, and three by two or three at half a side, twice each.
        assert_eq!(bounds.len(), 1 + 2 * (4 + 6));
        assert!(bounds.is_sorted(), "{bounds:?}");
        let (first, last) = (bounds[0] as f64, bounds[bounds.len() - 1] as f64);
        assert!(last > 1.005 * first, "{bounds:?}");
    }
}

//! A bound on step x S + turn x T by dual prices on the sides of cells.
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
//! With v(c) = 1 + excess(c) - (1 if e is below c) by [`CutVertices`] and the worst e, that holds for every walk, whatever the
//! prices are: it's a Lagrangian relaxation of the constraint that passages of neighbours fit together.
//!
//! A closed tour has no ends: its passages alone cost at least the sum of v(c) f(c), with no e to save anything.
//!
//! The best prices give the value of the linear programme of fractional walks (parts of passages, with as much use of
//! an edge from either side). They are approached in three stages: by [`super::diffusion`], by [`super::primal_dual`],
//! and then, for strips of the room instead of single cells, by [`super::subgradient`]; in rooms too large for that, by
//! diffusion and then by [`super::tiles`]. The bound is free of rounding errors, as it's computed in whole numbers from
//! whatever prices.

use super::{
    crossings::Crossings,
    cut_vertices::CutVertices,
    diffusion::{MOST_SWEEPS, effort},
    dual_prices::DualPrices,
    graph::Graph,
    primal_dual::{PrimalDual, Programme},
    subgradient::Subgradient,
    tiles::Tiles,
};
use crate::{CoverageJob, Objective};
use std::collections::VecDeque;

/// Least steps of the primal-dual iteration between two evaluations of its prices.
const PATIENCE: usize = 50;
/// Most cells for which the programme is solved as a whole.
const MOST_CELLS: usize = 60_000;
const MOST_STEPS: usize = 20_000;
/// The iteration ends when this many halves of the steps that the last success took have passed.
const LULL: usize = 3;
const LEAST_STEPS: usize = 600;
/// A success is a rise of the bound by at least one part in this many.
const RISE: u64 = 2000;

/// A bound that rises with the work spent on it.
pub struct Relaxation {
    /// The cells.
    pub graph: Graph,
    cuts: CutVertices,
    /// The best prices so far, of single cells.
    pub prices: DualPrices,
    /// The bound by these prices, and the best bound.
    cell_bound: u64,
    bound: u64,
    swept: usize,
    tiles: Tiles,
    programme: Option<PrimalDual>,
    steps: usize,
    /// The step count at which the prices are evaluated next.
    next_look: usize,
    /// The step count at which the prices last improved.
    last_rise: usize,
    risen_to: u64,
    crossings: Option<Crossings>,
    /// Subgradient ascents to be continued in turn: by rows and by columns, with increasing heights.
    subgradients: VecDeque<Subgradient>,
    is_in_strips: bool,
}

impl Relaxation {
    /// No work done yet; weights above 4,096 are clamped.
    pub fn new(job: &CoverageJob, objective: Objective) -> Self {
        let graph = Graph::new(&job.free, job.start);
        let cuts = CutVertices::of(&graph);
        let prices = DualPrices::new(&graph, objective, job.heading);
        let bound = prices.bound(&graph, &cuts);
        Self {
            graph,
            cuts,
            prices,
            cell_bound: bound,
            bound,
            swept: 0,
            tiles: Tiles::default(),
            programme: None,
            steps: 0,
            next_look: PATIENCE,
            last_rise: 0,
            risen_to: 0,
            crossings: None,
            subgradients: VecDeque::new(),
            is_in_strips: false,
        }
    }

    fn most_sweeps(&self) -> usize {
        if self.graph.len() > MOST_CELLS { MOST_SWEEPS } else { effort(self.graph.len()) }
    }

    /// Whether further work belongs to the first, quick stage.
    pub fn is_diffusing(&self) -> bool {
        self.swept < self.most_sweeps()
    }

    /// Improves the prices by visiting about `cells` cells; returns whether more work can help.
    pub fn improve(&mut self, cells: usize) -> bool {
        let rounds = cells.div_ceil(self.graph.len().max(1));
        if self.graph.len() < 2 {
            return false;
        }
        let sweeps = rounds.min(self.most_sweeps() - self.swept.min(self.most_sweeps()));
        if sweeps > 0 {
            self.prices.diffuse(&self.graph, self.swept, sweeps);
            self.swept += sweeps;
            self.cell_bound = self.prices.bound(&self.graph, &self.cuts);
            self.bound = self.bound.max(self.cell_bound);
            return true;
        }
        if self.graph.len() > MOST_CELLS {
            return self.improve_tiles(cells);
        }
        if self.steps > MOST_STEPS.min(self.last_rise.max(LEAST_STEPS) * LULL / 2) {
            self.programme = None;
            return self.ascend(cells);
        }
        let mut programme = self.programme.take().unwrap_or_else(|| self.programme());
        // In a small room a call's worth of visits is more steps than all that may be taken.
        let rounds = rounds.min(MOST_STEPS);
        for _ in 0..rounds {
            programme.step(&self.graph);
        }
        self.steps += rounds;
        if self.steps >= self.next_look {
            self.next_look = self.steps + PATIENCE.max(self.steps / 20);
            let before = self.prices.clone();
            let unit = self.prices.scale();
            if self.prices.take(&self.graph, |cell| programme.edges(cell).map(|price| price * unit)) {
                self.look(before);
            } else {
                self.prices = before;
            }
        }
        self.programme = Some(programme);
        true
    }

    /// The same, tile by tile.
    fn improve_tiles(&mut self, cells: usize) -> bool {
        let mut done = 0;
        while done < cells {
            let Some(visited) = self.tiles.improve(&self.graph, &self.cuts, &mut self.prices) else { break };
            done += visited.max(1);
        }
        if done == 0 {
            return false;
        }
        self.cell_bound = self.prices.bound(&self.graph, &self.cuts);
        self.bound = self.bound.max(self.cell_bound);
        true
    }

    /// Subgradient steps worth about `cells` visits of cells.
    fn ascend(&mut self, cells: usize) -> bool {
        let crossings = self.crossings.get_or_insert_with(|| Crossings::new(self.prices.first_quarters()));
        let mut done = 0;
        if !self.is_in_strips {
            self.is_in_strips = true;
            for upright in [false, true] {
                let mut subgradient = Subgradient::first(&self.graph, &self.prices, upright);
                subgradient.step(&self.graph, &self.cuts, crossings);
                self.bound = self.bound.max(subgradient.bound());
                done += subgradient.effort(&self.graph);
                self.subgradients.push_back(subgradient);
            }
            // The better ones first.
            if self.subgradients[0].bound() < self.subgradients[1].bound() {
                self.subgradients.swap(0, 1);
            }
        }
        while done < cells {
            let Some(mut subgradient) = self.subgradients.pop_front() else {
                return false;
            };
            done += subgradient.effort(&self.graph);
            let goes_on = subgradient.step(&self.graph, &self.cuts, crossings);
            self.bound = self.bound.max(subgradient.bound());
            if goes_on {
                self.subgradients.push_front(subgradient);
            } else if subgradient.is_final() {
                self.subgradients.clear();
            } else {
                self.subgradients.extend(subgradient.higher(&self.graph));
            }
        }
        true
    }

    /// Keeps the present prices if they're better than `before`.
    fn look(&mut self, before: DualPrices) {
        let bound = self.prices.bound(&self.graph, &self.cuts);
        if bound < self.cell_bound {
            self.prices = before;
        } else {
            if bound > self.risen_to + self.risen_to / RISE {
                (self.last_rise, self.risen_to) = (self.steps, bound);
            }
            self.cell_bound = bound;
            self.bound = self.bound.max(bound);
        }
    }

    fn programme(&self) -> PrimalDual {
        let prices = &self.prices;
        let unit = prices.scale();
        let programme = Programme {
            step: f64::from(prices.step) / unit,
            turn: f64::from(prices.turn) / unit,
            visits: self.cuts.excess.iter().map(|&excess| 1.0 + f64::from(excess)).collect(),
            begin: prices.is_open().then(|| prices.first_costs().map(|cost| f64::from(cost) / unit)),
        };
        PrimalDual::new(&self.graph, programme, |cell| prices.scaled(cell))
    }

    /// The proven bound: no walk costs less, in the objective's weights.
    pub fn bound(&self) -> u64 {
        self.bound
    }
}

//! Improves the dual prices of strips by subgradient steps.
//!
//! Where two strips use an edge of theirs differently, its price goes up for the one that uses it more. The step length
//! comes from a target level for the bound (Polyak 1969, Minimization of unsmooth functionals), which is lowered
//! whenever it hasn't been reached for some steps.

use super::{
    crossings::Crossings,
    cut_vertices::CutVertices,
    dual_prices::DualPrices,
    graph::{Graph, NONE},
    strips::{RoomStrips, WholeRoom},
};

/// Steps without success after which the target is lowered.
const PATIENCE: usize = 10;
/// Share of the last direction that is kept (Camerini, Fratta & Maffioli 1975, On improving relaxation methods).
const INERTIA: f64 = 0.7;
/// Most numbers stored while a strip is solved, two bytes each.
const MEMORY: usize = 30_000_000;
/// Cells across the first strips. Low ones take less time, and as strips of each height have their borders elsewhere,
/// the best bound of all counts.
const FIRST_HEIGHT: usize = 4;
/// Most effort of a step, so that callers can check for cancellation in between: about two seconds.
const MOST_EFFORT: usize = 30_000_000;
/// Target for the first rise, as a share of the bound.
const HOPE: f64 = 0.002;
/// Factor by which the target grows after a quarter of it was reached.
const GROWTH: f64 = 1.5;
/// The ascent ends when the target falls below this share of the bound.
const DESPAIR: f64 = 1e-4;
/// A subgradient ascent for one division of a room into strips.
pub(super) struct Subgradient {
    strips: RoomStrips,
    upright: bool,
    prices: DualPrices,
    best: DualPrices,
    /// In price units.
    bound: i64,
    hope: f64,
    failures: usize,
    /// Per cell's right and upper edge, how much more one side uses it, plus the rest of earlier steps' directions.
    direction: Vec<[f64; 2]>,
    is_begun: bool,
    /// Whether the strips agree on all edges, so that no prices are better.
    agrees: bool,
}

impl Subgradient {
    /// Begins with prices that fit and strips of a few rows or, if `upright`, columns.
    pub fn first(graph: &Graph, prices: &DualPrices, upright: bool) -> Self {
        Self::new(graph, prices, upright, FIRST_HEIGHT)
    }

    /// The same with strips of at most the given height.
    fn new(graph: &Graph, prices: &DualPrices, upright: bool, height: usize) -> Self {
        Self {
            strips: RoomStrips::new(graph, upright, height),
            upright,
            prices: prices.clone(),
            best: prices.clone(),
            bound: 0,
            hope: 0.0,
            failures: 0,
            direction: vec![[0.0; 2]; graph.len()],
            is_begun: false,
            agrees: false,
        }
    }

    /// Whether there is a single strip, or all agree, so that no prices and no strips can be better.
    pub fn is_final(&self) -> bool {
        self.strips.len() == 1 || self.agrees
    }

    /// The same with higher strips, as far as memory allows.
    pub fn higher(&self, graph: &Graph) -> Option<Self> {
        let heights = self.strips.height + 1..=graph.numbers.width().max(graph.numbers.height());
        let higher = |height| Self::new(graph, &self.best, self.upright, height);
        let mut higher = heights.map(higher).find(|higher| higher.strips.len() < self.strips.len())?;
        if higher.strips.memory(self.prices.is_open()) > MEMORY || higher.effort(graph) > MOST_EFFORT {
            return None;
        }
        higher.hope = self.bound as f64 * HOPE / 4.0;
        Some(higher)
    }

    /// Cell visits that take as long as one step.
    pub fn effort(&self, graph: &Graph) -> usize {
        let states = 3_usize.saturating_pow(self.strips.height as u32);
        let layers = if self.prices.is_open() { 3 } else { 1 };
        graph.len().saturating_mul(10 + states.saturating_mul(layers) / 2)
    }

    /// In units of the objective.
    pub fn bound(&self) -> u64 {
        (self.bound.max(0) as u64).div_ceil(self.prices.unit as u64)
    }

    /// Takes a step; returns whether more can help.
    pub fn step(&mut self, graph: &Graph, cuts: &CutVertices, crossings: &Crossings) -> bool {
        let room = WholeRoom { graph, cuts, prices: &self.prices, crossings };
        let Some(solution) = self.strips.solve(&room) else { return false };
        if solution.bound > self.bound || !self.is_begun {
            self.is_begun = true;
            if self.hope == 0.0 {
                self.hope = solution.bound as f64 * HOPE;
            }
            if (solution.bound - self.bound) as f64 > self.hope / 16.0 {
                self.failures = 0;
            }
            if self.bound > 0 && (solution.bound - self.bound) as f64 > self.hope / 4.0 {
                self.hope *= GROWTH;
            }
            self.bound = solution.bound;
            self.best.clone_from(&self.prices);
        }
        self.failures += 1;
        if self.failures > PATIENCE {
            self.failures = 0;
            self.hope /= 2.0;
            self.prices.clone_from(&self.best);
            self.direction.fill([0.0; 2]);
        }
        let mut length = 0.0;
        for cell in 0..graph.len() {
            for side in 0..2 {
                let next = graph.neighbours[cell][side];
                if next != NONE {
                    let more = f64::from(solution.crossings[cell][side])
                        - f64::from(solution.crossings[next as usize][side + 2]);
                    let direction = &mut self.direction[cell][side];
                    *direction = more + INERTIA * *direction;
                    length += *direction * *direction;
                }
            }
        }
        self.agrees = length == 0.0;
        if self.is_final() || self.hope <= self.bound as f64 * DESPAIR {
            return false;
        }
        let pace = (self.bound as f64 + self.hope - solution.bound as f64) / length;
        let before = self.prices.clone();
        let direction = &self.direction;
        let moved = |cell: usize| {
            let [right, upper, ..] = before.sides[cell];
            [f64::from(right) + pace * direction[cell][0], f64::from(upper) + pace * direction[cell][1]]
        };
        self.prices.take(graph, moved)
    }
}

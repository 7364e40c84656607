//! Approximately optimal dual prices: the linear programme of fractional walks and its dual.
//!
//! The programme has a variable for every passage of every cell through two of its sides (ten: two straight, four bent,
//! four back through the same side), one for every side of a cell where the walk may end and one for every side of the
//! start where it may begin. Each cell is to be visited as often as connection demands, neighbours are to use their edge
//! equally often, and an open walk begins and ends once. The multipliers of the edges are the prices.
//!
//! It is solved by the primal-dual hybrid gradient method (Chambolle & Pock 2011, A first-order primal-dual algorithm
//! for convex problems), with the steps of Pock & Chambolle 2011 (Diagonal preconditioning), each step reflected and
//! then drawn towards where the last restart was (Halpern's iteration: Lu & Yang 2024, Restarted Halpern PDHG for
//! linear programming), whose restarts and weight between primal and dual steps are used here. Nothing needs to be
//! exact: any prices give a bound once they're repaired, and the bound is computed in whole numbers.

use super::graph::{Graph, NONE};

/// Sides of a cell's passages, counter-clockwise from the right.
const PASSAGES: [(usize, usize); 10] = [(0, 2), (1, 3), (0, 1), (1, 2), (2, 3), (3, 0), (0, 0), (1, 1), (2, 2), (3, 3)];
/// Price of a side with a wall.
pub(super) const WALL: f64 = 1e6;
/// Step lengths: the inverse of the sum of a row or a column of the programme.
const COLUMN: f64 = 1.0 / 3.0;
const EDGE: f64 = 1.0 / 12.0;
const VISIT: f64 = 1.0 / 14.0;
const HALVES: f64 = 1.0 / 4.0;

/// Input of the programme, in an objective whose larger weight is about 1.
pub(super) struct Programme {
    pub step: f64,
    pub turn: f64,
    /// Per cell the visits it needs.
    pub visits: Vec<f64>,
    /// Cost of beginning through each side; none for a closed tour.
    pub begin: Option<[f64; 4]>,
}

/// Per cell, prices of the sides without a neighbour in the programme, which are fixed; 0 for the others.
type Outer = Vec<[f64; 4]>;

/// An iterate: the primal uses and the dual prices.
#[derive(Clone)]
struct Iterate {
    passages: Vec<[f64; 10]>,
    ends: Vec<[f64; 4]>,
    begins: [f64; 4],
    /// Per cell, prices of the right and the upper edge as seen from it.
    edges: Vec<[f64; 2]>,
    /// Per cell, the dual value of a visit.
    visits: Vec<f64>,
    /// Least costs of the first and the last visit.
    halves: [f64; 2],
}

/// The iteration.
pub(super) struct PrimalDual {
    programme: Programme,
    outer: Outer,
    now: Iterate,
    /// The iterate at the last restart.
    anchor: Iterate,
    /// How often each cell's sides are used, and how often it is visited, in the extrapolated point.
    uses: Vec<[f64; 5]>,
    /// How often the walk begins and ends, in the extrapolated point.
    totals: [f64; 2],
    /// Ratio of dual to primal step lengths.
    weight: f64,
    since_restart: usize,
    iterations: usize,
    /// Squared distances moved by the first step since the restart and by the last step.
    moved: [f64; 2],
}

impl PrimalDual {
    /// Begins with these prices of the cells' sides; [`WALL`] for walls. They are fixed where the graph has no
    /// neighbour.
    pub fn new(graph: &Graph, programme: Programme, sides: impl Fn(usize) -> [f64; 4]) -> Self {
        let count = graph.len();
        let mut visits = Vec::with_capacity(count);
        let mut edges = Vec::with_capacity(count);
        let mut outer = Vec::with_capacity(count);
        for cell in 0..count {
            let sides = sides(cell);
            let least = |(index, &(a, b)): (usize, &(usize, usize))| programme.cost(index) + sides[a] + sides[b];
            visits.push(PASSAGES.iter().enumerate().map(least).fold(f64::INFINITY, f64::min).max(0.0));
            let is_outer = |side: usize| graph.neighbours[cell][side] == NONE;
            edges.push([0, 1].map(|side| if is_outer(side) { 0.0 } else { sides[side] }));
            outer.push([0, 1, 2, 3].map(|side| if is_outer(side) { sides[side] } else { 0.0 }));
        }
        let is_open = programme.begin.is_some();
        let now = Iterate {
            passages: vec![[0.0; 10]; count],
            ends: vec![[0.0; 4]; if is_open { count } else { 0 }],
            begins: [0.0; 4],
            edges,
            visits,
            halves: [0.0; 2],
        };
        Self {
            programme,
            outer,
            anchor: now.clone(),
            now,
            uses: vec![[0.0; 5]; count],
            totals: [0.0; 2],
            weight: 1.0,
            since_restart: 0,
            iterations: 0,
            moved: [0.0; 2],
        }
    }

    /// Prices of a cell's right and upper side.
    pub fn edges(&self, cell: usize) -> [f64; 2] {
        self.now.edges[cell]
    }

    /// One step.
    pub fn step(&mut self, graph: &Graph) {
        let share = (self.since_restart + 1) as f64 / (self.since_restart + 2) as f64;
        let primal = self.primal_step(graph, share);
        let dual = self.dual_step(graph, share);
        let moved = primal * self.weight / COLUMN + dual / self.weight;
        if self.since_restart == 0 {
            self.moved = [moved; 2];
        }
        self.since_restart += 1;
        self.iterations += 1;
        let [first, last] = self.moved;
        self.moved[1] = moved;
        let is_near = moved <= 0.04 * first || (moved <= 0.64 * first && moved > last);
        if self.since_restart > 1 && (is_near || self.since_restart * 25 >= self.iterations * 9 + 1000) {
            self.restart();
        }
    }

    /// Moves the primal variables; returns the squared length of the move.
    fn primal_step(&mut self, graph: &Graph, share: f64) -> f64 {
        let pace = UpdateStep { length: -COLUMN / self.weight, share };
        let Iterate { passages, ends, begins, edges, visits, halves } = &mut self.now;
        let costs: [f64; 10] = std::array::from_fn(|index| self.programme.cost(index));
        let half = self.programme.step / 2.0;
        let mut moved = 0.0;
        self.totals = [0.0; 2];
        for cell in 0..graph.len() {
            let prices = sides(graph, edges, &self.outer, cell).map(|price| price - visits[cell] / 2.0);
            let mut uses = [0.0; 5];
            let (used, anchors) = (&mut passages[cell], &self.anchor.passages[cell]);
            for (index, &(a, b)) in PASSAGES.iter().enumerate() {
                let gradient = costs[index] + prices[a] + prices[b];
                let reflected = pace.down(&mut used[index], anchors[index], gradient, &mut moved);
                uses[a] += reflected;
                uses[b] += reflected;
                uses[4] += reflected;
            }
            if let Some(ends) = ends.get_mut(cell) {
                for side in 0..4 {
                    let gradient = half + prices[side] - visits[cell] / 2.0 - halves[1];
                    let reflected = pace.down(&mut ends[side], self.anchor.ends[cell][side], gradient, &mut moved);
                    uses[side] += reflected;
                    uses[4] += reflected;
                    self.totals[1] += reflected;
                }
            }
            if let (Some(costs), true) = (self.programme.begin, cell == graph.start) {
                for side in 0..4 {
                    let gradient = costs[side] + prices[side] - visits[cell] / 2.0 - halves[0];
                    let reflected = pace.down(&mut begins[side], self.anchor.begins[side], gradient, &mut moved);
                    uses[side] += reflected;
                    uses[4] += reflected;
                    self.totals[0] += reflected;
                }
            }
            self.uses[cell] = uses;
        }
        moved
    }

    /// Moves the dual variables; returns the squared length of the move, each component in terms of its step length.
    fn dual_step(&mut self, graph: &Graph, share: f64) -> f64 {
        let (mut at_edges, mut at_visits, mut at_halves) = (0.0, 0.0, 0.0);
        let pace = |length: f64| UpdateStep { length: length * self.weight, share };
        let (edge, visit) = (pace(EDGE), pace(VISIT));
        for cell in 0..graph.len() {
            for side in 0..2 {
                let next = graph.neighbours[cell][side];
                if next != NONE {
                    let more = self.uses[cell][side] - self.uses[next as usize][side + 2];
                    let anchor = self.anchor.edges[cell][side];
                    edge.up(&mut self.now.edges[cell][side], anchor, more, f64::NEG_INFINITY, &mut at_edges);
                }
            }
            let missing = self.programme.visits[cell] - self.uses[cell][4];
            visit.up(&mut self.now.visits[cell], self.anchor.visits[cell], missing, 0.0, &mut at_visits);
        }
        let half = HALVES / graph.len() as f64;
        if self.programme.begin.is_some() {
            for (index, length) in [1.0 / 4.0, half].into_iter().enumerate() {
                let (value, anchor) = (&mut self.now.halves[index], self.anchor.halves[index]);
                pace(length).up(value, anchor, 1.0 - self.totals[index], f64::NEG_INFINITY, &mut at_halves);
            }
        }
        at_edges / EDGE + at_visits / VISIT + at_halves / half
    }

    fn restart(&mut self) {
        let (primal, dual) = (self.now.primal_distance(&self.anchor), self.now.dual_distance(&self.anchor));
        if primal > 1e-12 && dual > 1e-12 {
            // The fourth root of the squared ratio gives the geometric mean of the old weight and the ratio.
            self.weight = (self.weight * (dual / primal).sqrt()).sqrt().clamp(1e-3, 1e3);
        }
        self.anchor.clone_from(&self.now);
        self.since_restart = 0;
    }
}

/// How far a variable moves, and its position between the anchor and its reflection.
struct UpdateStep {
    length: f64,
    share: f64,
}

impl UpdateStep {
    /// Moves a primal variable down its gradient; returns the extrapolated point for the dual step.
    #[inline]
    fn down(&self, value: &mut f64, anchor: f64, gradient: f64, moved: &mut f64) -> f64 {
        let to = (*value + self.length * gradient).max(0.0);
        let reflected = 2.0 * to - *value;
        *moved += (to - *value) * (to - *value);
        *value = self.share * reflected + (1.0 - self.share) * anchor;
        reflected
    }

    /// Moves a dual variable by the residual of its row.
    #[inline]
    fn up(&self, value: &mut f64, anchor: f64, missing: f64, least: f64, moved: &mut f64) {
        let to = (*value + self.length * missing).max(least);
        *moved += (to - *value) * (to - *value);
        *value = self.share * (2.0 * to - *value) + (1.0 - self.share) * anchor;
    }
}

impl Programme {
    fn cost(&self, passage: usize) -> f64 {
        self.step + self.turn * [0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0][passage]
    }
}

impl Iterate {
    fn primal_distance(&self, other: &Self) -> f64 {
        distance(&self.passages, &other.passages) + distance(&self.ends, &other.ends)
    }

    fn dual_distance(&self, other: &Self) -> f64 {
        let visits = self.visits.iter().zip(&other.visits).map(|(a, b)| (a - b) * (a - b));
        distance(&self.edges, &other.edges) + visits.sum::<f64>()
    }
}

/// Squared distance.
fn distance<const N: usize>(a: &[[f64; N]], b: &[[f64; N]]) -> f64 {
    a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b) * (a - b)).sum()
}

/// Prices of a cell's sides, from those of the edges.
fn sides(graph: &Graph, edges: &[[f64; 2]], outer: &Outer, cell: usize) -> [f64; 4] {
    let [_, _, left, below] = graph.neighbours[cell];
    let across = |next: u32, side: usize| if next == NONE { 0.0 } else { -edges[next as usize][side] };
    let inner = [edges[cell][0], edges[cell][1], across(left, 0), across(below, 1)];
    std::array::from_fn(|side| inner[side] + outer[cell][side])
}

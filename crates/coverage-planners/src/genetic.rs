//! A genetic algorithm that evolves walks.
//!
//! Emu & Obaida 2020 (thesis, East West University), section 4.1, describe the method: a population of chromosomes, "usually
//! coded as binary strings", made at random; a fitness function ranks it; *reproduction* copies each string in proportion
//! to its fitness; *crossover* of two parents makes children; this goes on until the solution will do. Their reference
//! for cleaning is Yakoubi & Laskri 2016 ("The path planning of cleaner robot for coverage region using genetic algorithms",
//! Journal of Innovation in Digital Ecosystems). From its abstract we have: a gene stands for a position of the robot, some
//! chromosomes for a *mini-path*, obstacles are avoided, and what counts is the number of turns and the length of the way.
//! How they cross, mutate and weigh could not be had.
//!
//! # What is ours
//!
//! - *Chromosome.* A gene for every free cell, three bits: whether the robot prefers to go along x or along y from there, and
//!   which way first along each. It is read from the start: straight on along the preferred axis while the cell ahead is
//!   left, else the first cell left in the gene's order. That makes a mini-path; where it ends, a shortest way leads to the
//!   nearest cell left, where the next one starts. So every chromosome stands for a walk that covers all.
//! - *Fitness.* Cost of the worst walk of the population less that of this one; cost is the time of steps and turns. As
//!   all is covered, revisits cost their steps and need no term of their own.
//! - *Crossover.* A rectangle of the room is taken from the other parent: what lies together in the room is inherited together.
//! - *Mutation.* A rectangle gets one gene, at random; most are small. The rate is the mean number of those a child.
//! - *Elitism.* The best two stay as they are, so that no generation is worse than the one before.
//! - *The end.* After so many generations, or [`PATIENCE`] of them without a better walk. Large rooms get fewer: no more than
//!   [`MOST_CELLS`] cells are walked in all.
//!
//! O(population x generations x n) time, O(population x n) memory for n cells.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("genetic").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>vv\n^#vv\n^<<o\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{Costs, NearestGoalBfs},
};
use rand::RngExt;
use robovac_core::{
    grid::{Cell, Direction, Grid},
    registry::{Example, Explainer, ParamKind, ParamSpec},
    rng::Rng,
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "genetic",
    title: "Genetic algorithm",
    summary: "Evolves walks: the better ones are crossed and mutated, generation after generation.",
    claims: PlannerClaims {
        complete: true,
        deterministic: false,
        fast: false,
        in_metres: None,
        search: Search::Limited { effort: "generations" },
    },
    params: &[
        number("generations", "Generations", "Number of generations.", 0.0, 2000.0, 1.0, 400.0),
        number("population", "Population", "Number of walks per generation.", 4.0, 100.0, 1.0, 30.0),
        number(
            "crossover",
            "Crossover rate",
            "Share of children with two parents; the others have one.",
            0.0,
            1.0,
            0.05,
            0.7,
        ),
        number("mutation", "Mutation rate", "Mean number of mutated patches per child.", 0.0, 5.0, 0.1, 1.0),
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "A chromosome has one gene per cell for the direction to continue in, and so encodes a whole walk. \
           Faster walks have more children, which inherit patches of the room from both parents. Sometimes a patch \
           mutates, and the best walk so far always survives.",
    complexity: "O(p · g · n) time for p walks in g generations of n cells, O(p · n) memory.",
    use_when: "To watch a solution evolve from random walks, without any rule for what makes a good one. It takes a \
               thousand times longer than lanes and seldom beats them.",
    shines: Example { room: "thesis8", why: "Small enough to find a nearly optimal walk." },
    fails: Example { room: "spiral", why: "Random mutations seldom straighten a whole lane." },
    source: "Emu & Obaida 2020, thesis, East West University: section 4.1; \
             Yakoubi & Laskri 2016, The path planning of cleaner robot, Journal of Innovation in Digital Ecosystems",
    link: "https://doi.org/10.1016/j.jides.2016.05.004",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(Genetic {
        generations: params.number("generations") as usize,
        population: params.number("population") as usize,
        crossover: params.number("crossover"),
        mutation: params.number("mutation"),
    })
};

const fn number(
    id: &'static str,
    label: &'static str,
    help: &'static str,
    min: f64,
    max: f64,
    step: f64,
    default: f64,
) -> ParamSpec {
    ParamSpec { id, label, help, kind: ParamKind::Number { min, max, step, default, unit: "" } }
}

/// The planner.
struct Genetic {
    generations: usize,
    population: usize,
    /// Share of children with two parents.
    crossover: f64,
    /// Mean number of mutations a child.
    mutation: f64,
}

/// Three bits: [`ALONG_Y`], and the sign along each axis.
type Gene = u8;

/// The gene prefers to go along y.
const ALONG_Y: Gene = 1;
/// Number of genes.
const GENES: Gene = 8;
/// Walks that are kept as they are.
const ELITE: usize = 2;
/// Most cells that are walked in all.
const MOST_CELLS: usize = 10_000_000;
/// Generations without a better walk after which it is as good as it gets.
const PATIENCE: u32 = 80;

/// A chromosome and what it costs.
#[derive(Clone)]
struct CostedWalk {
    genes: Grid<Gene>,
    cost: u64,
}

impl Planner for Genetic {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let mut reader = ChromosomeReader::new(job);
        let affordable = MOST_CELLS / (self.population * job.cells()).max(1);
        let generations = self.generations.min(affordable.max(1));
        let all = (self.population * (generations + 1)) as f64;
        let (mut done, mut best) = (0_u32, Best { cost: u64::MAX, walk: Vec::new() });
        let (width, height) = (job.free.width(), job.free.height());
        let mut parents: Vec<CostedWalk> = Vec::with_capacity(self.population);
        for _ in 0..self.population {
            let genes = (0..job.free.len()).map(|_| ctx.rng.random_range(0..GENES)).collect();
            let genes = Grid::from_rows(width, genes).unwrap_or_else(|| Grid::filled(width, height, 0));
            let cost = reader.read(&genes);
            best.take(cost, &reader.walk);
            ctx.checkpoint(f64::from(done) / all, &best.walk)?;
            done += 1;
            parents.push(CostedWalk { genes, cost });
        }
        let mut children = parents.clone();
        let mut stale = 0;
        for _ in 0..generations {
            let cost_before = best.cost;
            parents.sort_by_key(|walk| walk.cost);
            let wheel = Wheel::new(&parents);
            for (i, child) in children.iter_mut().enumerate() {
                let parent = if i < ELITE { i } else { wheel.spin(&mut ctx.rng) };
                child.clone_from(&parents[parent]);
                if i >= ELITE {
                    if ctx.rng.random_bool(self.crossover) {
                        let other = &parents[wheel.spin(&mut ctx.rng)].genes;
                        let patch = RoomPatch::new(width, height, 0, &mut ctx.rng);
                        patch.copy(other, &mut child.genes);
                    }
                    for _ in 0..poisson(self.mutation, &mut ctx.rng) {
                        let patch = RoomPatch::new(width, height, 5, &mut ctx.rng);
                        patch.fill(ctx.rng.random_range(0..GENES), &mut child.genes);
                    }
                    child.cost = reader.read(&child.genes);
                    best.take(child.cost, &reader.walk);
                }
                ctx.checkpoint(f64::from(done) / all, &best.walk)?;
                done += 1;
            }
            std::mem::swap(&mut parents, &mut children);
            stale = if best.cost < cost_before { 0 } else { stale + 1 };
            if stale == PATIENCE {
                break;
            }
        }
        Ok(CoveragePath::walk(best.walk))
    }
}

/// The best walk so far.
struct Best {
    cost: u64,
    walk: Vec<Cell>,
}

impl Best {
    fn take(&mut self, cost: u64, walk: &[Cell]) {
        if cost < self.cost {
            self.cost = cost;
            self.walk.clear();
            self.walk.extend_from_slice(walk);
        }
    }
}

/// Reads chromosomes: turns them into walks.
struct ChromosomeReader<'j> {
    job: &'j CoverageJob,
    costs: Costs,
    cells: usize,
    left: Grid<bool>,
    seeker: NearestGoalBfs,
    /// The walk read last.
    walk: Vec<Cell>,
}

impl<'j> ChromosomeReader<'j> {
    fn new(job: &'j CoverageJob) -> Self {
        Self {
            job,
            costs: Costs::of(job),
            cells: job.cells(),
            left: job.free.clone(),
            seeker: NearestGoalBfs::new(&job.free),
            walk: Vec::with_capacity(2 * job.cells()),
        }
    }

    /// Reads `genes` into `walk` and returns its cost.
    fn read(&mut self, genes: &Grid<Gene>) -> u64 {
        let (mut at, mut facing) = (self.job.start, self.job.heading);
        self.left.values_mut().copy_from_slice(self.job.free.values());
        self.left[at] = false;
        let mut left_count = self.cells - 1;
        let mut turns = 0;
        self.walk.clear();
        self.walk.push(at);
        while left_count > 0 {
            if let Some(towards) = next(genes[at], facing, |d| self.left.is_set(at.step(d))) {
                turns += facing.quarter_turns(towards);
                (at, facing) = (at.step(towards), towards);
                self.walk.push(at);
                self.left[at] = false;
                left_count -= 1;
                continue;
            }
            let left = &self.left;
            // All free cells are connected, so a way exists while one is left.
            let Some(way) = self.seeker.nearest(&self.job.free, at, facing, |cell| left[cell]) else { break };
            for cell in way {
                let towards = at.direction_to(cell).unwrap_or(facing);
                turns += facing.quarter_turns(towards);
                (at, facing) = (cell, towards);
                self.walk.push(cell);
            }
            // The way ends at the first cell left.
            self.left[at] = false;
            left_count -= 1;
        }
        self.walk.len() as u64 * u64::from(self.costs.step) + u64::from(turns) * u64::from(self.costs.turn)
    }
}

/// The direction that `gene` gives in a cell entered facing `facing`; `None` if no neighbour is left.
#[inline]
fn next(gene: Gene, facing: Direction, is_left: impl Fn(Direction) -> bool) -> Option<Direction> {
    let x = if gene & 2 == 0 { Direction::Right } else { Direction::Left };
    let y = if gene & 4 == 0 { Direction::Up } else { Direction::Down };
    let (along, across) = if gene & ALONG_Y == 0 { (x, y) } else { (y, x) };
    let goes_on = facing.is_horizontal() == along.is_horizontal();
    let along = if goes_on { facing } else { along };
    [along, along.opposite(), across, across.opposite()].into_iter().find(|&d| is_left(d))
}

/// Roulette wheel on which every walk has a share in proportion to its fitness.
struct Wheel(Vec<u64>);

impl Wheel {
    /// For walks sorted by cost.
    fn new(walks: &[CostedWalk]) -> Self {
        let worst = walks.last().map_or(0, |walk| walk.cost);
        // One more, so that equal walks are equally fit.
        let sums = walks.iter().scan(0, |sum, walk| {
            *sum += worst - walk.cost + 1;
            Some(*sum)
        });
        Self(sums.collect())
    }

    fn spin(&self, rng: &mut Rng) -> usize {
        let stop = rng.random_range(0..self.0.last().copied().unwrap_or(1));
        self.0.partition_point(|&sum| sum <= stop)
    }
}

/// A rectangle of the room.
struct RoomPatch {
    low: Cell,
    width: usize,
    height: usize,
}

impl RoomPatch {
    /// A random place, its sides at most those of the room, halved a random number of times: up to `halvings` times.
    fn new(width: usize, height: usize, halvings: u32, rng: &mut Rng) -> Self {
        let shift = rng.random_range(0..=halvings);
        let side = |length: usize, rng: &mut Rng| rng.random_range(1..=(length >> shift).max(1));
        let (w, h) = (side(width, rng), side(height, rng));
        let low = Cell::new(rng.random_range(0..=width - w) as i32, rng.random_range(0..=height - h) as i32);
        Self { low, width: w, height: h }
    }

    /// The indices of its rows.
    fn rows(&self, grid: &Grid<Gene>) -> impl Iterator<Item = std::ops::Range<usize>> + use<> {
        let first = grid.index(self.low);
        let (stride, width, height) = (grid.width(), self.width, self.height);
        (0..height).map(move |row| first + row * stride..first + row * stride + width)
    }

    fn copy(&self, from: &Grid<Gene>, to: &mut Grid<Gene>) {
        for row in self.rows(from) {
            to.values_mut()[row.clone()].copy_from_slice(&from.values()[row]);
        }
    }

    fn fill(&self, gene: Gene, to: &mut Grid<Gene>) {
        for row in self.rows(to) {
            to.values_mut()[row].fill(gene);
        }
    }
}

/// A Poisson-distributed number with mean `mean`.
fn poisson(mean: f64, rng: &mut Rng) -> u32 {
    let (mut events, mut product, limit) = (0, rng.random::<f64>(), robovac_core::math::exp(-mean));
    while product > limit {
        events += 1;
        product *= rng.random::<f64>();
    }
    events
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::WalkMetrics;
    use robovac_core::{floor_plan::generate::random_clutter, registry::ParamValue};

    /// Cost, in steps, of the best walk after `generations` generations.
    fn cost(job: &CoverageJob, generations: u32) -> u64 {
        let given = [("generations", ParamValue::Number(f64::from(generations)))];
        let params = robovac_core::registry::Params::checked(INFO.params, given).unwrap();
        let path = INFO.build(&params).plan(job, &mut PlanContext::new(1)).unwrap();
        assert_eq!(WalkMetrics::of(job, &path).visited_cells, job.cells());
        Costs::of(job).of_walk(job.heading, &path.cells) / u64::from(Costs::of(job).step)
    }

    #[test]
    fn generations_never_make_it_worse_and_soon_much_better_than_chance() {
        let rooms = [Grid::filled(15, 12, true), random_clutter(20, 15, 0.15, 3)];
        for free in rooms {
            let start = free.iter().find(|&(_, &free)| free).unwrap().0;
            let job = CoverageJob::new(&free, start, Direction::Right).unwrap();
            let costs = [0, 1, 5, 20, 60, 100].map(|generations| cost(&job, generations));
            assert!(costs.windows(2).all(|w| w[1] <= w[0]), "{costs:?}");
            assert!(100 * costs[5] < 85 * costs[0], "{costs:?}");
        }
    }

    #[test]
    fn parents_are_chosen_in_proportion_to_their_fitness() {
        let walk = |cost| CostedWalk { genes: Grid::filled(1, 1, 0), cost };
        let wheel = Wheel::new(&[walk(10), walk(10), walk(40)]);
        let mut rng = robovac_core::rng::seeded(1, 0);
        let mut chosen = [0; 3];
        (0..6300).for_each(|_| chosen[wheel.spin(&mut rng)] += 1);
        // Shares of 31, 31 and 1.
        assert!(chosen[..2].iter().all(|n| (2900..3300).contains(n)) && (50..150).contains(&chosen[2]), "{chosen:?}");
    }
}

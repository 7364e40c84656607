//! Boustrophedon: decomposes the room into parts that can be swept in parallel lanes, and orders them.
//!
//! Choset & Pignon 1998 ("Coverage path planning: the boustrophedon cellular decomposition") and Choset 2000 ("Coverage
//! of known spaces", Autonomous Robots 9). A line sweeps over the room; where its connectivity changes, a part ends or
//! begins ([`decompose`]). Every part is swept in parallel lanes from one of its corners ([`MownBlock::sweeps`]). The
//! papers visit the parts by a walk through their adjacency graph; here they are ordered like the towns of a travelling
//! salesman: nearest first, then improved by local search with a choice of corners ([`improve`]). Finally, detours over
//! floor that has been cleaned anyway are cut short ([`shortcut`]).
//!
//! Lanes run along x or y, whichever walk costs less. In a large room the choice is made by the number of lanes, and the
//! order stays nearest first unless more effort is set.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("boustrophedon").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>><\nv#o<\n>>>^\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{
        BlockSweep, Costs, Links, MAX_CELLS_FOR_ALL, MownBlock, SWEEPS, Transit, Visit, between, decompose, drive,
        improve, lanes_lie_down, nearest_first, shortcut, swap_axes, swap_walk,
    },
};
use robovac_core::{
    grid::Cell,
    registry::{Example, Explainer, ParamKind, ParamSpec},
    rng::seeded,
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "boustrophedon",
    title: "Boustrophedon (parallel lanes)",
    summary: "Decomposes the room at critical points, sweeps each part in lanes, and finds a good visiting order.",
    claims: PlannerClaims {
        complete: true,
        deterministic: true,
        fast: true,
        in_metres: None,
        search: Search::Limited { effort: "effort" },
    },
    params: &[
        ParamSpec {
            id: "lanes",
            label: "Lanes",
            help: "Direction of the lanes. Automatic takes the faster one for this robot.",
            kind: ParamKind::Choice {
                options: &[("auto", "automatic"), ("horizontal", "horizontal"), ("vertical", "vertical")],
            },
        },
        ParamSpec {
            id: "effort",
            label: "Search time",
            help: "How long to search for a better order of the parts, as a multiple of the usual time; 0 visits the nearest part first.",
            kind: ParamKind::Number { min: 0.0, max: 10.0, step: 1.0, default: 1.0, unit: "" },
        },
        MAX_JUMP,
    ],
};

/// Where parts are split.
pub(super) const MAX_JUMP: ParamSpec = ParamSpec {
    id: "max_jump",
    label: "Largest step",
    help: "A part is split where the wall beside it steps by more than this.",
    kind: ParamKind::Number { min: 0.0, max: 100.0, step: 1.0, default: 4.0, unit: "cells" },
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "A line sweeps over the room, and wherever an obstacle splits or joins it, one part ends and others \
           begin. Each part can be swept in straight lanes from one of its corners. The order of the parts is then \
           chosen as in the travelling salesman problem.",
    complexity: "Decomposition and lanes take O(n) time and memory for n cells; ordering b parts takes up to \
        O(b²).",
    use_when: "The first choice for known rooms: few turns, hardly any revisits, and fast even in a hall. Slanted \
               or ragged walls split the room into many small parts, which costs efficiency.",
    shines: Example {
        room: "empty",
        why: "Long lanes from wall to wall; hardly any cell is visited twice. \"Swept again\" can still be high: it \
              counts the strips where a tool wider than a cell overlaps the neighbouring lane.",
    },
    fails: Example {
        room: "spiral",
        why: "All lanes run one way, so half of the arms are swept crosswise, in short lanes with many turns.",
    },
    source: "Choset & Pignon 1998, Coverage path planning: the boustrophedon cellular decomposition; \
             Choset 2000, Coverage of known spaces, Autonomous Robots 9",
    link: "https://doi.org/10.1023/A:1008958800904",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(Boustrophedon {
        lanes: match params.choice("lanes") {
            "horizontal" => BoustrophedonLanes::Horizontal,
            "vertical" => BoustrophedonLanes::Vertical,
            _ => BoustrophedonLanes::Auto,
        },
        effort: params.number("effort") as usize,
        max_jump: params.number("max_jump") as i32,
    })
};

/// The planner.
struct Boustrophedon {
    lanes: BoustrophedonLanes,
    effort: usize,
    /// In cells.
    max_jump: i32,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum BoustrophedonLanes {
    Auto,
    Horizontal,
    Vertical,
}

/// Largest room, in free cells, whose order is improved, for every unit of effort.
const CELLS_PER_EFFORT: usize = 300_000;
/// Most blocks whose order is improved.
const MAX_BLOCKS_TO_IMPROVE: usize = 600;
/// Cells around every corner that are searched for shortest paths.
const REACH: usize = 2_000;
/// Rounds of local search times blocks, for every unit of effort: a round costs time in proportion to the blocks.
const ROUNDS_TIMES_BLOCKS: usize = 40_000;
/// Most rounds for every block and unit of effort: small rooms converge soon.
const ROUNDS_PER_BLOCK: usize = 4;
/// Passes over the walk to cut detours; the first one finds nearly all, and a large room gets no more.
const PASSES: usize = 3;

impl Planner for Boustrophedon {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let lies_down = match self.lanes {
            BoustrophedonLanes::Horizontal => vec![false],
            BoustrophedonLanes::Vertical => vec![true],
            BoustrophedonLanes::Auto if job.cells() <= MAX_CELLS_FOR_ALL => vec![false, true],
            BoustrophedonLanes::Auto => vec![!lanes_lie_down(&job.free)],
        };
        let share = 1.0 / lies_down.len() as f64;
        let cost = |walk: &[Cell]| Costs::of(job).of_walk(job.heading, walk);
        let mut best: Option<Vec<Cell>> = None;
        let mut progress = ShareReporter { ctx, job, from: 0.0, share, is_swapped: false, shown: Vec::new() };
        for (i, is_swapped) in lies_down.into_iter().enumerate() {
            progress.from = i as f64 * share;
            progress.is_swapped = is_swapped;
            let walk = if is_swapped {
                let mut walk = self.plan_along_rows(&swap_axes(job), &mut progress)?;
                swap_walk(&mut walk);
                walk
            } else {
                self.plan_along_rows(job, &mut progress)?
            };
            if best.as_ref().is_none_or(|best| cost(&walk) < cost(best)) {
                best = Some(walk);
            }
        }
        Ok(CoveragePath::walk(best.unwrap_or_default()))
    }
}

/// Reports the progress of a part of the work as progress of the whole.
struct ShareReporter<'r, 'c> {
    ctx: &'r mut PlanContext<'c>,
    job: &'r CoverageJob,
    from: f64,
    share: f64,
    /// Whether walks arrive with x and y swapped.
    is_swapped: bool,
    /// The best walk to be shown. The plan doesn't depend on it, as it must be the same without an observer.
    shown: Vec<Cell>,
}

impl ShareReporter<'_, '_> {
    fn report(&mut self, done: f64) -> Result<(), PlanError> {
        self.ctx.checkpoint(self.from + self.share * done.min(1.0), &self.shown)
    }

    /// Shows `walk` from the next report on if there is an observer and it's better than the walk shown before.
    fn show(&mut self, walk: &[Cell]) {
        if !self.ctx.is_observed() {
            return;
        }
        let mut walk = walk.to_vec();
        if self.is_swapped {
            swap_walk(&mut walk);
        }
        let cost = |walk: &[Cell]| Costs::of(self.job).of_walk(self.job.heading, walk);
        if self.shown.is_empty() || cost(&walk) < cost(&self.shown) {
            self.shown = walk;
        }
    }
}

/// Shares of the work that are done after each stage.
const SWEPT: f64 = 0.1;
const ORDERED: f64 = 0.3;
const LINKED: f64 = 0.4;
const IMPROVED: f64 = 0.7;
const DRIVEN: f64 = 0.8;

impl Boustrophedon {
    /// A walk with lanes along x.
    fn plan_along_rows(&self, job: &CoverageJob, progress: &mut ShareReporter<'_, '_>) -> Result<Vec<Cell>, PlanError> {
        let costs = Costs::of(job);
        let start = (job.start, job.heading);
        progress.report(0.0)?;
        let parts: Vec<MownBlock> = decompose(&job.free, self.max_jump)
            .into_iter()
            .map(|block| MownBlock { block, is_swapped: false })
            .collect();
        progress.report(SWEPT / 2.0)?;
        let sweeps: Vec<[BlockSweep; SWEEPS]> = parts.iter().map(|part| part.sweeps(costs)).collect();
        let all = parts.len() as f64;
        let mut tour = nearest_first(&job.free, &sweeps, start, costs, |done| {
            progress.report(between([SWEPT, ORDERED], done as f64 / all))
        })?;
        let mut transit = Transit::new(&job.free, costs);
        if job.cells() <= self.effort * CELLS_PER_EFFORT && parts.len() <= MAX_BLOCKS_TO_IMPROVE {
            if progress.ctx.is_observed() {
                let walk = drive(job, costs, &parts, &sweeps, &tour, &mut transit, |_| progress.report(ORDERED))?;
                progress.show(&walk);
            }
            self.improve_order(job, &sweeps, &mut tour, progress)?;
        }
        let mut walk = drive(job, costs, &parts, &sweeps, &tour, &mut transit, |done| {
            progress.report(between([IMPROVED, DRIVEN], done))
        })?;
        progress.show(&walk);
        let passes = if job.cells() <= MAX_CELLS_FOR_ALL { PASSES } else { 1 };
        for pass in 0..passes {
            let is_changed = shortcut(job, costs, &mut transit, &mut walk, |done| {
                progress.report(between([DRIVEN, 1.0], (pass as f64 + done) / passes as f64))
            })?;
            if !is_changed {
                break;
            }
        }
        progress.show(&walk);
        Ok(walk)
    }

    /// Searches for a better order of the blocks.
    fn improve_order(
        &self,
        job: &CoverageJob,
        sweeps: &[[BlockSweep; SWEEPS]],
        tour: &mut Vec<Visit>,
        progress: &mut ShareReporter<'_, '_>,
    ) -> Result<(), PlanError> {
        let start = (job.start, job.heading);
        let links = Links::new(&job.free, sweeps, start, Costs::of(job), REACH, |done| {
            progress.report(between([ORDERED, LINKED], done))
        })?;
        let rounds = (ROUNDS_TIMES_BLOCKS / tour.len()).min(ROUNDS_PER_BLOCK * tour.len());
        // A fixed seed: the result doesn't depend on the run's.
        let mut rng = seeded(0, 0);
        improve(&links, tour, self.effort * rounds, &mut rng, |done| progress.report(between([LINKED, IMPROVED], done)))
    }
}

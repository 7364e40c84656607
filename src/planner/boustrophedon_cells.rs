//! Boustrophedon with lanes along x in some parts of the room and along y in others, and every lane in its best place.
//!
//! Huang 2001 ("Optimal line-sweep-based decompositions for coverage algorithms", ICRA) lets every part of a decomposition
//! be swept in a direction of its own, as each end of a lane costs a turn. He chooses directions and parts together by
//! dynamic programming over ways to merge pieces, which takes exponential time in general. With two directions on a grid a
//! minimum cut finds the directions ([`strips`], there with its source); connected floor of one direction is then cut into
//! parts at critical points as in `boustrophedon` ([`decompose`]).
//!
//! 1. The parts are ordered nearest first, then by local search with a choice of corners ([`improve`]).
//! 2. The walk is taken apart into its lanes, and the same search puts these in order one by one ([`lanes_of`]).
//! 3. Detours are cut short ([`tighten`]), the walk is taken apart anew into straight strokes, less what others clean as
//!    well ([`strokes`]), and step 2 is repeated with these, always from the best walk. So lanes change as well: a way between
//!    two lanes may become one, and neighbours shrink by what it cleans.
//!
//! The sources say nothing of steps 2 and 3. In large rooms, with too many lanes, there is step 1 alone.
//!
//! ```
//! use robovac_playground::{grid::*, planner::*};
//! let free = from_picture("..####\n..####\n..####\n......\n......", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 4), Direction::Down).unwrap();
//! let info = find("boustrophedon_cells").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), "vo####\nv^####\nv^####\nv>>>>v\n^^<<<<\n");
//! ```

use super::{
    Build, Claims, CoverageJob, CoveragePath, Example, Explainer, ParamKind, ParamSpec, PlanContext, PlanError,
    Planner, PlannerInfo,
    stage::{
        Costs, Links, Part, SWEEPS, Sweep, Transit, Visit, decompose, drive, improve, lanes_of, nearest_first, strips,
        strokes, swap_grid, tighten,
    },
};
use crate::{
    grid::Cell,
    rng::{Rng, seeded},
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "boustrophedon_cells",
    title: "Boustrophedon, lanes turned part by part",
    summary: "Mows every part of the room in the direction that leaves fewest lane ends, in a good order.",
    source: "Huang 2001, Optimal line-sweep-based decompositions for coverage algorithms, ICRA; \
             Arkin et al. 2005, Optimal covering tours with turn costs, SIAM J. Comput. 35(3)",
    link: "https://doi.org/10.1137/S0097539703434267",
    explainer: Explainer {
        idea: "Every end of a lane costs a quarter turn, so the floor is split between lanes along x and along y such that \
               they have fewest ends, which a minimum cut finds exactly. \
               Neighbouring lanes are mown as parts, whose order is found as for a travelling salesman. \
               Then the lanes are taken one by one, and local search looks for a better order of them all.",
        complexity: "The cut takes up to O(p³) time for p rectangles between the lines of the walls, far less in practice; all else as \
                     for boustrophedon with its O(l²) for l lanes.",
        use_when: "Fewest turns of all lane mowers, in rooms whose arms and gaps run both ways. It plans for a second or so \
                   where plain lanes take a tenth.",
        shines: Example {
            room: "spiral",
            why: "Every arm is mown along its length, where plain lanes cross half of them.",
        },
        fails: Example {
            room: "ushape",
            why: "Rings along the walls go round both corners without a break and need a little less.",
        },
    },
    claims: Claims { complete: true, deterministic: true, fast: true, traces: false },
    params: &[
        ParamSpec {
            id: "effort",
            label: "Effort",
            help: "How long to look for a better order of parts and lanes; 0 takes the nearest first.",
            kind: ParamKind::Number { min: 0.0, max: 4.0, step: 1.0, default: 1.0, unit: "" },
        },
        ParamSpec {
            id: "max_jump",
            label: "Widest jump",
            help: "A part is cut in two where a wall beside it jumps by more than this.",
            kind: ParamKind::Number { min: 0.0, max: 100.0, step: 1.0, default: 4.0, unit: "cells" },
        },
    ],
};

/// Makes the planner.
pub(super) const BUILD: Build =
    |params| Box::new(Cells { effort: params.number("effort") as usize, max_jump: params.number("max_jump") as i32 });

/// The planner.
struct Cells {
    effort: usize,
    /// In cells.
    max_jump: i32,
}

/// Most parts whose order is improved.
const MAX_PARTS: usize = 800;
/// Most lanes that are taken one by one.
const MAX_LANES: usize = 1_200;
/// Cells around every end of a lane or part that shortest paths are looked for in.
const REACH: usize = 2_000;
/// Rounds of local search times parts, for every unit of effort: a round costs time in proportion to the parts.
const ROUNDS_TIMES_PARTS: usize = 100_000;
/// Most rounds for every part and unit of effort.
const ROUNDS_PER_PART: usize = 4;
/// Most rounds for the lanes each time that they are taken apart, for every unit of effort.
const ROUNDS: usize = 1_500;
/// The same for every lane, and less for few of them: small rooms are soon as good as they get.
const ROUNDS_PER_LANE: usize = 24;
/// How often the walk is taken apart into lanes.
const TIMES_APART: usize = 5;
/// How often in a row that may bring nothing.
const MOST_IN_VAIN: usize = 2;
/// Passes over the walk to cut detours; the first one finds nearly all, and a large room gets no more.
const PASSES: usize = 3;
/// Largest room, in free cells, for more than one pass.
const MAX_CELLS_FOR_PASSES: usize = 100_000;

/// Shares of the work that are done after each stage.
const ORDERED: f64 = 0.1;
const LINKED: f64 = 0.15;
const IMPROVED: f64 = 0.3;
const TIGHTENED: f64 = 0.35;

/// A share of the work between two stages.
fn between(from: f64, to: f64, done: f64) -> f64 {
    from + (to - from) * done.min(1.0)
}

impl Planner for Cells {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let mut work = Work {
            job,
            ctx,
            costs: Costs::of(job),
            transit: Transit::new(&job.free, Costs::of(job)),
            // The same numbers in every run: the seed changes nothing.
            rng: seeded(0, 0),
            best: Vec::new(),
        };
        let parts = self.parts(&mut work)?;
        let sweeps = work.sweeps(&parts);
        let mut tour = nearest_first(&job.free, &sweeps, (job.start, job.heading), work.costs, |done| {
            work.ctx.checkpoint(between(0.0, ORDERED, done as f64 / sweeps.len() as f64), &[])
        })?;
        if self.effort > 0 && (2..=MAX_PARTS).contains(&parts.len()) {
            let rounds = self.effort * (ROUNDS_TIMES_PARTS / parts.len()).min(ROUNDS_PER_PART * parts.len());
            work.improve(&sweeps, &mut tour, rounds, [ORDERED, LINKED, IMPROVED])?;
        }
        work.drive(&parts, &sweeps, &tour, [IMPROVED, TIGHTENED])?;
        let (mut lanes, mut tour) = lanes_of(&parts, &tour);
        let share = (1.0 - TIGHTENED) / TIMES_APART as f64;
        let mut in_vain = 0;
        for time in 0..TIMES_APART {
            if self.effort == 0 || in_vain >= MOST_IN_VAIN || !(2..=MAX_LANES).contains(&lanes.len()) {
                break;
            }
            let from = TIGHTENED + time as f64 * share;
            let rounds = self.effort * ROUNDS.min(ROUNDS_PER_LANE.min(lanes.len() / 2) * lanes.len());
            let sweeps = work.sweeps(&lanes);
            work.improve(&sweeps, &mut tour, rounds, [from, from + 0.1 * share, from + 0.9 * share])?;
            let is_better = work.drive(&lanes, &sweeps, &tour, [from + 0.9 * share, from + share])?;
            in_vain = if is_better { 0 } else { in_vain + 1 };
            (lanes, tour) = strokes(&job.free, &work.best);
        }
        Ok(CoveragePath { cells: work.best })
    }
}

impl Cells {
    /// The parts, each with the direction of its lanes.
    fn parts(&self, work: &mut Work<'_, '_>) -> Result<Vec<Part>, PlanError> {
        let strips = strips(&work.job.free, work.costs, || work.ctx.checkpoint(0.0, &[]))?;
        let along_y = swap_grid(&strips.along_y);
        let parts =
            |free, is_swapped| decompose(free, self.max_jump).into_iter().map(move |block| Part { block, is_swapped });
        Ok(parts(&strips.along_x, false).chain(parts(&along_y, true)).collect())
    }
}

/// What the stages share.
struct Work<'j, 'c> {
    job: &'j CoverageJob,
    ctx: &'j mut PlanContext<'c>,
    costs: Costs,
    transit: Transit,
    rng: Rng,
    /// The best walk so far.
    best: Vec<Cell>,
}

impl Work<'_, '_> {
    fn sweeps(&self, parts: &[Part]) -> Vec<[Sweep; SWEEPS]> {
        parts.iter().map(|part| part.sweeps(self.costs)).collect()
    }

    /// Looks for a better order of parts; `shares` of the work are done before, after the ways are known, and after.
    fn improve(
        &mut self,
        sweeps: &[[Sweep; SWEEPS]],
        tour: &mut Vec<Visit>,
        rounds: usize,
        [before, linked, after]: [f64; 3],
    ) -> Result<(), PlanError> {
        let Self { job, ctx, costs, rng, best, .. } = self;
        let links = Links::new(&job.free, sweeps, (job.start, job.heading), *costs, REACH, |done| {
            ctx.checkpoint(between(before, linked, done), best)
        })?;
        improve(&links, tour, rounds, rng, |done| ctx.checkpoint(between(linked, after, done), best))
    }

    /// Drives a tour, cuts detours, and keeps the walk if it's the best; whether it is.
    fn drive(
        &mut self,
        parts: &[Part],
        sweeps: &[[Sweep; SWEEPS]],
        tour: &[Visit],
        [before, after]: [f64; 2],
    ) -> Result<bool, PlanError> {
        let Self { job, ctx, costs, transit, best, .. } = self;
        let mut report = |done| ctx.checkpoint(between(before, after, done), best);
        let mut walk = drive(job, *costs, parts, sweeps, tour, transit, |done| report(done / 2.0))?;
        let passes = if job.cells() <= MAX_CELLS_FOR_PASSES { PASSES } else { 1 };
        for pass in 0..passes {
            let done_before = pass as f64 / passes as f64;
            let is_changed = tighten(job, *costs, transit, &mut walk, |done| {
                report((1.0 + done_before + done / passes as f64) / 2.0)
            })?;
            if !is_changed {
                break;
            }
        }
        let cost = |walk: &[Cell]| costs.of_walk(job.heading, walk);
        let is_better = best.is_empty() || cost(&walk) < cost(best);
        if is_better {
            *best = walk;
        }
        Ok(is_better)
    }
}

//! Near-optimal: an anytime planner that improves a walk and proves how far it is from the optimum.
//!
//! Finding the cheapest walk is NP-hard (Arkin, Bender, Demaine, Fekete, Mitchell & Sethia 2005, "Optimal covering tours
//! with turn costs", SIAM Journal on Computing 35). Krupke 2024, "Near-optimal coverage path planning with turn costs"
//! (ALENEX), solves a cycle cover by a commercial solver, merges its cycles and improves the tour by large-neighbourhood
//! search. This planner needs no solver:
//!
//! 1. *Construction and merging*: the best walk of three fast planners, closed by the cheapest way back if the
//!    objective is a tour.
//! 2. *Prices*: the [`Relaxation`] puts a price on every side of every cell. Its value is a proven bound, and by its prices
//!    every way of passing a cell has a reduced cost: what it costs more than the bound allows for. A walk whose reduced
//!    costs add up to little is near the bound, and the other way round.
//! 3. *Improvement*: large-neighbourhood search with exact repair. A window of the room is emptied, and the walk's parts
//!    outside it stay. Dynamic programming finds the cheapest way to fill the window such that all is one walk again: cell
//!    by cell, over the states of the frontier between cells that are done and others (how often each edge is used, which
//!    edges are connected). This is the frontier method known from counting paths in grids (Knuth 2011, "The Art of
//!    Computer Programming" 4A, 7.1.4), with several uses of an edge. A state that has cost more than the window's walk
//!    now, the least that the other cells can cost included, is dropped. As reduced costs of good walks are small, few states
//!    are left, and windows of 12 x 12 cells take milliseconds.
//! 4. *Shaking*: where the walk is dearest, prices are disturbed by chance, ever less (the noising method, Charon & Hudry
//!    1993), and the walk there goes back to what it was if that led to nothing.
//!
//! A walk may cross its own path or use an edge again; but no edge need be used three times. *Lemma*: if a walk uses an edge
//! three times, there is one that costs no more and uses it once. Take three uses, and the longest straight run
//! around the edge that all three share. At each end of the run one of them, A, leaves: it turns off, turns back, or the walk
//! begins or ends there. Choose another one of the three, B, cut A and B off at the run's end, and link what is left of them
//! there. If A turned off and B went straight, the link has one turn as A had; if both turned, the link is straight or has
//! two turns; if A turned back or ended, B does the rest without it. So turns don't grow, and the run is used
//! twice less, but still once, so that all its cells are visited. Of the three ways to choose a pair at one end of the run
//! at least two leave a single walk, and so do two of three at the other end whichever was chosen, so that A can be in the
//! pair at both ends. (Where the turn from the robot's heading counts, the walk's first step may be a third use.)
//!
//! The result depends on the seed and the effort alone. Cost: O(n) memory; time by the effort.

mod focus;
mod improver;
mod linker;
mod local_search;
mod profile_dp;
mod region;
mod tour;
mod ways;

use super::{
    BuildPlanner, CoverageJob, CoveragePath, Finish, Objective, PlanContext, PlanError, Planner, PlannerClaims,
    PlannerInfo, ProgressReport, Proof, Search, backtracking_spiral, boustrophedon, boustrophedon_cells,
    stage::{Costs, MAX_CELLS_FOR_ALL, between},
};
use local_search::LocalSearch;
use rand::RngExt;
use robovac_core::{
    grid::Cell,
    registry::{Example, Explainer, ParamKind, ParamSpec, Params},
    rng::seeded,
};
use std::ops::ControlFlow;

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "near_optimal",
    title: "Near-optimal",
    summary: "Improves a good walk window by window, and proves a lower bound on the cost of any walk.",
    claims: PlannerClaims {
        complete: true,
        deterministic: false,
        fast: false,
        in_metres: None,
        search: Search::Anytime { effort: "effort", turn: "turn" },
    },
    params: &[
        ParamSpec {
            id: "effort",
            label: "Search time",
            help: "How long to search for a better walk, as a multiple of the usual time; 0 keeps the first one.",
            kind: ParamKind::Number { min: 0.0, max: 100.0, step: 0.1, default: 1.0, unit: "" },
        },
        ParamSpec {
            id: "finish",
            label: "Ends",
            help: "Where the walk ends: anywhere, or at the start, for a robot that returns to its dock.",
            kind: ParamKind::Choice { options: &[("anywhere", "anywhere"), ("start", "at the start")] },
        },
        ParamSpec {
            id: "turn",
            label: "Quarter turn",
            help: "Cost of a quarter turn in steps; 0 uses the robot's turning time, and also counts the turn to its \
                   first step.",
            kind: ParamKind::Number { min: 0.0, max: 64.0, step: 0.5, default: 0.0, unit: "steps" },
        },
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "Starts from the best walk of three fast planners. Then it repeatedly clears a window where the walk is \
           expensive and refills it with the cheapest passages that still make one walk. Dual prices on the sides \
           of all cells show what is expensive and prove a lower bound on the cost of any walk.",
    complexity: "O(n) memory for n cells. A window takes about a millisecond; the effort sets their number.",
    use_when: "When a room is cleaned often, or to judge the walks of other planners. Stop it at any time: it \
               keeps the best walk so far.",
    shines: Example { room: "maze", why: "Forks and dead ends: windows find walks that lanes and rings can't." },
    fails: Example { room: "lshape", why: "Simple lanes are nearly as good and take no time." },
    source: "Objective and relaxation after Krupke 2024, Near-optimal coverage path planning with turn costs, ALENEX; \
             Arkin et al. 2005, Optimal covering tours with turn costs; the search is ours",
    link: "https://arxiv.org/abs/2310.20340",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(NearOptimal {
        effort: params.number("effort"),
        finish: if params.choice("finish") == "start" { Finish::Start } else { Finish::Anywhere },
        turn: Some(params.number("turn")).filter(|&turn| turn > 0.0),
    })
};

/// The planner.
struct NearOptimal {
    effort: f64,
    finish: Finish,
    /// Steps that a quarter turn counts as; `None` for the robot's time.
    turn: Option<f64>,
}

/// Work for every cell and unit of effort, and for all cells together, in ways tried.
const WORK_PER_CELL: f64 = 8_000.0;
const MOST_WORK: f64 = 10_000_000.0;
/// The least for every cell: less would leave most of a large room unimproved.
const LEAST_WORK_PER_CELL: f64 = 20.0;
/// Windows that settle one after the other: sides in cells, and states kept in each cell.
const FIRST_WINDOWS: (usize, usize) = (6, 200);
const WINDOWS: [(usize, usize); 3] = [(8, 500), (10, 1_000), (12, 1_000)];
/// States after each cell with which exhaustive search is tried in small rooms: when the walk has settled, and later.
const FEW_STATES: usize = 5_000;
const MANY_STATES: usize = 100_000;
/// Share of the work after which that is first tried.
const EARLY: f64 = 0.02;
/// Shares of the work that are done after the stages.
const FIRST: f64 = 0.03;
const SETTLED: f64 = 0.08;
const SECOND: f64 = 0.2;

impl Planner for NearOptimal {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        if job.cells() < 2 {
            ctx.proof = Some(Proof { cost: 0, bound: 0 });
            return Ok(CoveragePath::walk(vec![job.start]));
        }
        let job = &self.weighed(job);
        let costs = Costs::of(job);
        let objective = Objective {
            step: costs.step,
            turn: costs.turn,
            finish: self.finish,
            counts_first_turn: self.turn.is_none() && self.finish == Finish::Anywhere,
        };
        let cells = job.cells() as f64;
        let most = self.effort * (WORK_PER_CELL * cells).min(MOST_WORK).max(LEAST_WORK_PER_CELL * cells);
        let mut work = LocalSearch::new(job, objective, most as usize, seeded(ctx.rng.random(), 0));
        let half = FIRST / 2.0;
        let first = fast_walk(&boustrophedon::INFO, boustrophedon::BUILD, job, &[], [0.0, half], ctx)?;
        work.begin_with(first, ctx);
        let (info, build) = (&backtracking_spiral::INFO, backtracking_spiral::BUILD);
        let other = fast_walk(info, build, job, &work.shown, [half, FIRST], ctx)?;
        work.begin_with(other, ctx);
        work.begin_with_best();
        work.price_hastily(FIRST, ctx)?;
        if job.cells() <= MAX_CELLS_FOR_ALL {
            work.settle(FIRST_WINDOWS, FIRST, Some(SETTLED), ctx)?;
        }
        if most > 0.0 {
            let (info, build) = (&boustrophedon_cells::INFO, boustrophedon_cells::BUILD);
            let second = fast_walk(info, build, job, &work.shown, [SETTLED, SECOND], ctx)?;
            work.begin_with(second, ctx);
            work.price(SECOND, ctx)?;
            work.settle(FIRST_WINDOWS, SECOND, None, ctx)?;
            work.begin_with_best();
            for windows in WINDOWS {
                work.settle(windows, SECOND, None, ctx)?;
            }
            work.solve(FEW_STATES, SECOND, ctx)?;
            for share in [EARLY, 1.0] {
                work.shake(share, SECOND, ctx)?;
                work.solve(MANY_STATES, SECOND, ctx)?;
            }
        }
        ctx.proof = Some(work.proof());
        Ok(CoveragePath::walk(work.walk()))
    }

    fn begins_with(&self, job: &CoverageJob) -> (CoverageJob, &'static [&'static PlannerInfo]) {
        let planners: &[_] = if self.effort > 0.0 {
            &[&boustrophedon::INFO, &backtracking_spiral::INFO, &boustrophedon_cells::INFO]
        } else {
            &[&boustrophedon::INFO, &backtracking_spiral::INFO]
        };
        (self.weighed(job), planners)
    }
}

impl NearOptimal {
    /// The job in the weights of the objective.
    fn weighed(&self, job: &CoverageJob) -> CoverageJob {
        CoverageJob { step_s: 1.0, turn_s: self.turn.unwrap_or(job.turn_s / job.step_s), ..job.clone() }
    }
}

/// The walk of a fast planner; `so_far` is reported meanwhile.
fn fast_walk(
    info: &PlannerInfo,
    build: BuildPlanner,
    job: &CoverageJob,
    so_far: &[Cell],
    shares: [f64; 2],
    ctx: &mut PlanContext<'_>,
) -> Result<Vec<Cell>, PlanError> {
    let mut observe = |report: ProgressReport<'_>| {
        let walk = if so_far.is_empty() { report.walk } else { so_far };
        match ctx.checkpoint(between(shares, report.done), walk) {
            Ok(()) => ControlFlow::Continue(()),
            Err(_) => ControlFlow::Break(()),
        }
    };
    let planner = build(&Params::defaults(info.params));
    Ok(planner.plan(job, &mut PlanContext::observed(0, &mut observe))?.cells)
}

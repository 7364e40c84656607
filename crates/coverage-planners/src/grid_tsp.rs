//! Grid-point TSP: the free cells are the cities of a travelling salesman problem with turn costs.
//!
//! One of the planners that Bormann, Jordan, Hampp & Hägele 2018, "Indoor coverage path planning: survey, implementation,
//! analysis" (ICRA), compare: a tour through the grid points, by nearest neighbour or a solver, which weighs lengths only.
//! Here every move of the search weighs the turns as well.
//!
//! 1. A first tour: from each point to the nearest one left, straight on if there is a choice; or lanes. For these the
//!    points are bound to the straight lanes that cost least together ([`strips`]), the lanes are put in order nearest
//!    first, and the order is improved by local search. Whole lanes are moved where single points would have to cross a
//!    barrier of many turns.
//! 2. Detours over floor that is visited anyway are cut short, in the end once more ([`Tours`]).
//! 3. 2-opt and Or-opt moves of single steps, taken by simulated annealing from a low temperature ([`anneal`]).
//!    A point needs only one visit, so points passed again are dropped on the way.
//!
//! The authors' tour starts anywhere and is closed; here it begins at the robot and ends anywhere.
//!
//! Cost: O(n) memory for n cells, O(l²) for l lanes while these are put in order (at most 1,200). Time grows with the
//! moves tried, a thousand a cell by default and no more than twelve million.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("grid_tsp").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\n^#ov\n^<<<\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{Borders, MoveKinds, MownBlock, NearestGoalBfs, Schedule, Tours, anneal, between, strips, swap_grid},
};
use robovac_core::{
    grid::Cell,
    registry::{Example, Explainer, ParamKind, ParamSpec},
    rng::seeded,
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "grid_tsp",
    title: "Grid-point TSP",
    summary: "Finds a travelling salesman tour of all cells: a first tour, then 2-opt and Or-opt moves that count \
        turns.",
    claims: PlannerClaims {
        complete: true,
        deterministic: true,
        fast: false,
        in_metres: None,
        search: Search::Limited { effort: "effort" },
    },
    params: &[
        ParamSpec {
            id: "effort",
            label: "Search time",
            help: "How long to search for a better tour, as a multiple of the usual time; 0 keeps the first one.",
            kind: ParamKind::Number { min: 0.0, max: 10.0, step: 1.0, default: 1.0, unit: "" },
        },
        ParamSpec {
            id: "construction",
            label: "First tour",
            help: "Straight lanes in a good order, or always the nearest cell next.",
            kind: ParamKind::Choice { options: &[("lanes", "lanes"), ("nearest", "nearest cell")] },
        },
        ParamSpec {
            id: "moves",
            label: "Moves",
            help: "Reverse parts of the tour, move them elsewhere, or both.",
            kind: ParamKind::Choice { options: &[("both", "both"), ("two_opt", "2-opt"), ("or_opt", "Or-opt")] },
        },
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "Each cell is a city of a travelling salesman problem in which turns cost time. A first tour follows \
           straight lanes, chosen to have few ends. Then parts of it are reversed and moved millions of times, \
           sometimes accepting a worse tour, and the cheapest is kept.",
    complexity: "A thousand moves for each of n cells, each O(1) to evaluate and up to O(n) to apply; O(n + l²) \
                 memory for l lanes.",
    use_when: "Takes seconds and usually finds the cheapest walk of all planners here. Worth it for rooms of up to \
               some ten thousand cells that are cleaned often.",
    shines: Example {
        room: "maze",
        why: "Only forks and dead ends: moving single cells finds walks that lanes and rings can't.",
    },
    fails: Example { room: "lshape", why: "Rings along the walls need no search and are slightly better." },
    source: "Bormann, Jordan, Hampp & Hägele 2018, Indoor coverage path planning: survey, implementation, analysis, ICRA",
    link: "https://doi.org/10.1109/ICRA.2018.8460566",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(GridTsp {
        effort: params.number("effort") as usize,
        has_lanes: params.choice("construction") != "nearest",
        moves: match params.choice("moves") {
            "two_opt" => MoveKinds::Reverse,
            "or_opt" => MoveKinds::Move,
            _ => MoveKinds::Both,
        },
    })
};

/// The planner.
struct GridTsp {
    effort: usize,
    has_lanes: bool,
    moves: MoveKinds,
}

/// Most lanes whose order is improved: the links between them take memory in proportion to the square.
const MAX_LANES_TO_IMPROVE: usize = 1_200;
/// Cells around every end of a lane that are searched for shortest paths.
const REACH: usize = 4_000;
/// Rounds of local search over the lanes, for every lane and unit of effort.
const ROUNDS_PER_LANE: usize = 40;
/// Most rounds for every unit of effort.
const MAX_ROUNDS: usize = 10_000;
/// Moves tried for every cell and unit of effort.
const TRIES_PER_CELL: usize = 1_000;
/// Most moves tried for every unit of effort.
const MAX_TRIES: usize = 12_000_000;
/// Most moves tried for every pair of cells: small rooms converge soon.
const TRIES_PER_PAIR: usize = 10;
/// Temperatures at the start and at the end, in quarter turns: hot enough to try other turns, too cold to destroy the
/// lanes.
const HOT: f64 = 0.25;
const COLD: f64 = 0.05;
/// Starting temperature for a tour without lanes.
const HOT_WITHOUT_LANES: f64 = 0.5;

/// Shares of the work that are done when the first tour stands, and when its detours have been cut.
const CONSTRUCTED: f64 = 0.4;
const TIGHTENED: f64 = 0.45;
/// Shares of the work on a tour of lanes that are done after each of its stages.
const ORDERED: f64 = 0.05;
const LINKED: f64 = 0.1;
const IMPROVED: f64 = 0.9;

impl Planner for GridTsp {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let mut tours = Tours::new(job, ctx, REACH);
        if self.has_lanes {
            self.tour_lanes(job, &mut tours)?;
        } else {
            let walk = tour_cells(job, tours.ctx)?;
            tours.offer(walk, [CONSTRUCTED, TIGHTENED])?;
        }
        let (costs, mut walk) = (tours.costs, std::mem::take(&mut tours.best));
        let cells = job.cells();
        let tries = (TRIES_PER_CELL * cells).min(TRIES_PER_PAIR * cells * cells).min(MAX_TRIES);
        let schedule = Schedule {
            tries: self.effort * tries,
            hot: if self.has_lanes { HOT } else { HOT_WITHOUT_LANES },
            cold: COLD,
            moves: self.moves,
        };
        // A fixed seed: the result doesn't depend on the run's.
        anneal(job, costs, schedule, &mut walk, &mut seeded(0, 0), |done, walk| {
            tours.ctx.checkpoint(between([TIGHTENED, 1.0], done), walk)
        })?;
        tours.offer(walk, [1.0, 1.0])?;
        Ok(CoveragePath::walk(tours.best))
    }
}

/// Cells between two reports.
const REPORT_EVERY: usize = 1024;

/// From each cell to the nearest one left, straight on if there is a choice.
fn tour_cells(job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<Vec<Cell>, PlanError> {
    let mut is_left = job.free.clone();
    is_left[job.start] = false;
    let mut seeker = NearestGoalBfs::new(&job.free);
    let (mut walk, mut heading) = (vec![job.start], job.heading);
    let cells = job.cells();
    for visited in 1..=cells {
        let at = walk[walk.len() - 1];
        if visited % REPORT_EVERY == 1 {
            ctx.checkpoint(CONSTRUCTED * visited as f64 / cells as f64, &walk)?;
        }
        let Some(way) = seeker.nearest(&job.free, at, heading, |cell| is_left[cell]) else { break };
        walk.extend(way);
        let [.., before, last] = *walk else { break };
        heading = before.direction_to(last).unwrap_or(heading);
        is_left[last] = false;
    }
    Ok(walk)
}

impl GridTsp {
    /// Tours through the cheapest lanes, of which several may cost the same: those with most along x, and most along y.
    fn tour_lanes(&self, job: &CoverageJob, tours: &mut Tours<'_, '_>) -> Result<(), PlanError> {
        for (before, is_swapped) in [(0.0, false), (TIGHTENED / 2.0, true)] {
            let share = |done| before + done * TIGHTENED / 2.0;
            let (costs, ctx, best) = (tours.costs, &mut *tours.ctx, &tours.best);
            let report = || ctx.checkpoint(before, best);
            // Of several cheapest strips there are always those with least along x.
            let strips = if is_swapped {
                strips(&job.free, costs, Borders::Apart, report)?
            } else {
                strips(&swap_grid(&job.free), costs, Borders::Apart, report)?.swapped()
            };
            let lanes: Vec<MownBlock> = strips.parts(0).into_iter().flat_map(MownBlock::lanes).collect();
            let sweeps = tours.sweeps(&lanes);
            let mut tour = tours.nearest_first(&sweeps, [before, share(ORDERED)])?;
            if self.effort > 0 && lanes.len() <= MAX_LANES_TO_IMPROVE {
                let rounds = self.effort * (ROUNDS_PER_LANE * lanes.len()).min(MAX_ROUNDS);
                tours.improve(&sweeps, &mut tour, rounds, [ORDERED, LINKED, IMPROVED].map(share))?;
            }
            tours.drive(&lanes, &sweeps, &tour, [share(IMPROVED), share(1.0)])?;
        }
        Ok(())
    }
}

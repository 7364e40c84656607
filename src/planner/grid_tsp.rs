//! Grid-point TSP: the free cells are the towns of a travelling salesman who doesn't like turns.
//!
//! One of the planners that Bormann, Jordan, Hampp & Hägele 2018, "Indoor coverage path planning: survey, implementation,
//! analysis" (ICRA), compare: a tour through the grid points, by nearest neighbour or a solver, which weighs lengths only.
//! Here every move of the search weighs the turns as well.
//!
//! 1. A first tour: from each point to the nearest one left, straight on if there is a choice; or lanes. For these the
//!    points are bound to the cheapest straight lanes ([`cheapest_lanes`]), the lanes are put in order nearest first, and
//!    the order is improved by local search ([`improve`]). Whole lanes are moved where single points would have to cross
//!    a barrier of many turns.
//! 2. Detours over floor that is visited anyway are cut short ([`tighten`]).
//! 3. 2-opt and Or-opt moves of single steps, taken by simulated annealing from a low temperature ([`anneal`]).
//!    A point needs only one visit, so points passed again are dropped on the way.
//!
//! The survey starts its tour where it likes and closes it; here it begins at the robot and ends anywhere.
//!
//! Cost: O(n) memory for n cells, O(l²) for l lanes while these are put in order (at most 1,200). Time grows with the
//! moves tried, a thousand a cell by default and no more than twelve million.
//!
//! ```
//! use robovac_playground::{grid::*, planner::*};
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("grid_tsp").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\n^#ov\n^<<<\n");
//! ```

use super::{
    Build, Claims, CoverageJob, CoveragePath, Example, Explainer, ParamKind, ParamSpec, PlanContext, PlanError,
    Planner, PlannerInfo,
    stage::{
        Costs, Lane, Links, Moves, Prefer, SWEEPS, Schedule, Seeker, Stop, Sweep, Transit, Visit, anneal,
        cheapest_lanes, improve, nearest_first, tighten,
    },
};
use crate::{
    grid::{Cell, Direction},
    rng::seeded,
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "grid_tsp",
    title: "Grid-point TSP",
    summary: "Tours all cells like a travelling salesman: a first tour, then 2-opt and Or-opt moves that count turns.",
    source: "Bormann, Jordan, Hampp & Hägele 2018, Indoor coverage path planning: survey, implementation, analysis, ICRA",
    link: "https://doi.org/10.1109/ICRA.2018.8460566",
    explainer: Explainer {
        idea: "Every cell is a town, and a travelling salesman who loses time by turning looks for the cheapest tour. \
               A first tour follows straight lanes, chosen so that they have few ends. \
               Then parts of it are reversed and moved millions of times, now and then for the worse, and \
               what proves cheaper is kept.",
        complexity: "A thousand moves for each of n cells, each O(1) to weigh and up to O(n) to do; \
                     O(n + l²) memory for l lanes.",
        use_when: "Takes seconds and finds the cheapest walks of all here. \
                   Rooms of up to some ten thousand cells that are cleaned again and again are worth it.",
        shines: Example {
            room: "maze",
            why: "Nothing but forks and dead ends: moving single cells finds what lanes and rings can't.",
        },
        fails: Example {
            room: "lshape",
            why: "Rings along the walls need no search at all and end up a little better.",
        },
    },
    claims: Claims { complete: true, deterministic: true, fast: false, traces: false },
    params: &[
        ParamSpec {
            id: "effort",
            label: "Effort",
            help: "How long to look for a better tour; 0 keeps the first one.",
            kind: ParamKind::Number { min: 0.0, max: 10.0, step: 1.0, default: 1.0, unit: "" },
        },
        ParamSpec {
            id: "construction",
            label: "First tour",
            help: "Straight lanes in a good order, or always on to the nearest cell.",
            kind: ParamKind::Choice { options: &[("lanes", "lanes"), ("nearest", "nearest cell")] },
        },
        ParamSpec {
            id: "moves",
            label: "Moves",
            help: "Parts of the tour are reversed, moved elsewhere, or both.",
            kind: ParamKind::Choice { options: &[("both", "both"), ("two_opt", "2-opt"), ("or_opt", "Or-opt")] },
        },
    ],
};

/// Makes the planner.
pub(super) const BUILD: Build = |params| {
    Box::new(GridTsp {
        effort: params.number("effort") as usize,
        has_lanes: params.choice("construction") != "nearest",
        moves: match params.choice("moves") {
            "two_opt" => Moves::Reverse,
            "or_opt" => Moves::Move,
            _ => Moves::Both,
        },
    })
};

/// The planner.
struct GridTsp {
    effort: usize,
    has_lanes: bool,
    moves: Moves,
}

/// Most lanes whose order is improved: the links between them take memory in proportion to the square.
const MAX_LANES_TO_IMPROVE: usize = 1_200;
/// Cells around every end of a lane that shortest paths are looked for in.
const REACH: usize = 4_000;
/// Rounds of local search over the lanes, for every lane and unit of effort.
const ROUNDS_PER_LANE: usize = 40;
/// Most rounds for every unit of effort.
const MAX_ROUNDS: usize = 10_000;
/// Moves tried for every cell and unit of effort.
const TRIES_PER_CELL: usize = 1_000;
/// Most moves tried for every unit of effort.
const MAX_TRIES: usize = 12_000_000;
/// Small rooms are soon as good as they get: moves tried for every pair of cells.
const TRIES_PER_PAIR: usize = 10;
/// Temperatures at the start and at the end, in quarter turns: hot enough to try other ways of turning, too cold to
/// forget the lanes.
const HOT: f64 = 0.25;
const COLD: f64 = 0.05;
/// Temperature to start from with a tour that has no lanes to forget.
const HOT_WITHOUT_LANES: f64 = 0.5;
/// Passes over the walk to cut detours.
const PASSES: usize = 3;

/// Shares of the work that are done when the first tour stands, and when detours have been cut.
const CONSTRUCTED: f64 = 0.4;
const TIGHTENED: f64 = 0.45;

impl Planner for GridTsp {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let costs = Costs::of(job);
        // The same numbers in every run: the seed changes nothing.
        let mut rng = seeded(0, 0);
        let mut walk = if self.has_lanes { self.tour_lanes(job, ctx)? } else { tour_cells(job, ctx)? };
        let mut transit = Transit::new(&job.free, costs);
        for _ in 0..PASSES {
            ctx.checkpoint(CONSTRUCTED, &walk)?;
            if self.effort == 0 || !tighten(job, costs, &mut transit, &mut walk, |_| ctx.checkpoint(CONSTRUCTED, &[]))?
            {
                break;
            }
        }
        ctx.checkpoint(TIGHTENED, &walk)?;
        let cells = job.cells();
        let tries = (TRIES_PER_CELL * cells).min(TRIES_PER_PAIR * cells * cells).min(MAX_TRIES);
        let schedule = Schedule {
            tries: self.effort * tries,
            hot: if self.has_lanes { HOT } else { HOT_WITHOUT_LANES },
            cold: COLD,
            moves: self.moves,
        };
        anneal(job, costs, schedule, &mut walk, &mut rng, |done, walk| {
            ctx.checkpoint(TIGHTENED + (1.0 - TIGHTENED) * done, walk)
        })?;
        if self.effort > 0 {
            tighten(job, costs, &mut transit, &mut walk, |_| ctx.checkpoint(1.0, &[]))?;
        }
        Ok(CoveragePath { cells: walk })
    }
}

/// Cells between two reports.
const REPORT_EVERY: usize = 1024;

/// From each cell to the nearest one left, straight on if there is a choice.
fn tour_cells(job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<Vec<Cell>, PlanError> {
    let mut is_left = job.free.clone();
    is_left[job.start] = false;
    let mut seeker = Seeker::new(&job.free);
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
    /// The cheaper one of the tours through lanes that prefer x and y.
    fn tour_lanes(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<Vec<Cell>, PlanError> {
        let costs = Costs::of(job);
        let mut best: Vec<Cell> = Vec::new();
        let mut done = 0.0;
        for prefer in [Prefer::AlongX, Prefer::AlongY] {
            ctx.checkpoint(done, &best)?;
            let lanes = cheapest_lanes(&job.free, costs, prefer);
            let sweeps: Vec<[Sweep; SWEEPS]> = lanes.iter().map(|lane| sweeps_of_lane(lane, costs)).collect();
            let start = (job.start, job.heading);
            let mut tour = nearest_first(&job.free, &sweeps, start, costs, |_| ctx.checkpoint(done, &best))?;
            if self.effort > 0 && lanes.len() <= MAX_LANES_TO_IMPROVE {
                let links = Links::new(&job.free, &sweeps, start, costs, REACH, |_| ctx.checkpoint(done, &best))?;
                let rounds = self.effort * (ROUNDS_PER_LANE * lanes.len()).min(MAX_ROUNDS);
                improve(&links, &mut tour, rounds, &mut seeded(0, 0), |share| {
                    ctx.checkpoint(done + share * CONSTRUCTED / 2.0, &best)
                })?;
            }
            let walk = drive(job, &sweeps, &tour);
            let cost = |walk: &[Cell]| costs.of_walk(job.heading, walk);
            if best.is_empty() || cost(&walk) < cost(&best) {
                best = walk;
            }
            done += CONSTRUCTED / 2.0;
        }
        Ok(best)
    }
}

/// Both ways to drive a lane, as if it were a block that can be swept in no other way.
fn sweeps_of_lane(lane: &Lane, costs: Costs) -> [Sweep; SWEEPS] {
    let along = if lane.first.y == lane.last.y { Direction::Right } else { Direction::Up };
    let direction = (lane.first != lane.last).then_some(along);
    let cost = costs.step * lane.first.manhattan(lane.last);
    let ahead = Sweep { entry: lane.first, entering: direction, exit: lane.last, leaving: direction, cost };
    let back = direction.map(Direction::opposite);
    let back = Sweep { entry: lane.last, entering: back, exit: lane.first, leaving: back, cost };
    std::array::from_fn(|number| if number < SWEEPS / 2 { ahead } else { back })
}

/// The walk that a tour of lanes stands for.
fn drive(job: &CoverageJob, sweeps: &[[Sweep; SWEEPS]], tour: &[Visit]) -> Vec<Cell> {
    let mut transit = Transit::new(&job.free, Costs::of(job));
    let mut walk = vec![job.start];
    for visit in tour {
        let sweep = &sweeps[visit.block][visit.sweep];
        let heading = if let [.., before, last] = *walk { before.direction_to(last) } else { Some(job.heading) };
        let from = Stop { cell: walk[walk.len() - 1], heading };
        let to = Stop { cell: sweep.entry, heading: sweep.entering };
        // All free cells are connected, so that there is a way.
        let _ = transit.append_way(from, to, u32::MAX, &mut walk);
        let (mut at, Some(direction)) = (sweep.entry, sweep.entering) else { continue };
        while at != sweep.exit {
            at = at.step(direction);
            walk.push(at);
        }
    }
    walk
}

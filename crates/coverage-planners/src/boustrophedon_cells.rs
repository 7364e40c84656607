//! Boustrophedon with lanes along x in some parts of the room and along y in others, in an optimised order.
//!
//! Huang 2001 ("Optimal line-sweep-based decompositions for coverage algorithms", ICRA) lets every part of a decomposition
//! be swept in a direction of its own, as each end of a lane costs a turn. He chooses directions and parts together by
//! dynamic programming over ways to merge pieces, which takes exponential time in general. With two directions on a grid a
//! minimum cut finds the directions ([`strips`], there with its source); connected floor of one direction is then cut into
//! parts at critical points as in `boustrophedon` ([`decompose`](super::stage::decompose)).
//!
//! 1. The parts are ordered nearest first, then by local search with a choice of corners ([`Tours`]).
//! 2. The walk is taken apart into its lanes, and the same search puts these in order one by one ([`lanes_of`]).
//! 3. Detours are cut short ([`Tours`]), the walk is split again into straight strokes, less what others clean as
//!    well ([`strokes`]), and step 2 is repeated with these, always from the best walk. So lanes change as well: a way between
//!    two lanes may become one, and neighbours shrink by what it cleans.
//!
//! Steps 2 and 3 are not in the sources. In large rooms, with too many lanes, there is only step 1.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("..####\n..####\n..####\n......\n......", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 4), Direction::Down).unwrap();
//! let info = find("boustrophedon_cells").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), "vo####\nv^####\nv^####\nv>>>>v\n^^<<<<\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    boustrophedon::MAX_JUMP,
    stage::{Borders, Tours, lanes_of, strips, strokes},
};
use robovac_core::registry::{Example, Explainer, ParamKind, ParamSpec};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "boustrophedon_cells",
    title: "Boustrophedon, lane direction per part",
    summary: "Sweeps each part of the room in the direction with the fewest lane ends, in a good order.",
    claims: PlannerClaims {
        complete: true,
        deterministic: true,
        fast: true,
        in_metres: None,
        search: Search::Limited { effort: "effort" },
    },
    params: &[
        ParamSpec {
            id: "effort",
            label: "Search time",
            help: "How long to search for a better order of parts and lanes, as a multiple of the usual time; 0 visits the nearest part first.",
            kind: ParamKind::Number { min: 0.0, max: 4.0, step: 1.0, default: 1.0, unit: "" },
        },
        MAX_JUMP,
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "Every lane end costs a quarter turn, so a minimum cut finds the division into lanes along x and lanes along \
           y with the fewest ends. Neighbouring lanes form parts, ordered as in the travelling salesman problem. \
           Finally, local search improves the order of the single lanes.",
    complexity: "The cut takes up to O(p³) time for p rectangles between the wall lines, far less in practice; the \
                 rest as for boustrophedon, with O(l²) for l lanes.",
    use_when: "For rooms with arms in both directions: the fewest turns of all lane planners. Planning takes about \
               a second, ten times as long as plain lanes.",
    shines: Example { room: "spiral", why: "Every arm is swept lengthwise, while plain lanes cross half of them." },
    fails: Example {
        room: "ushape",
        why: "Rings along the walls pass both corners without a break and cost slightly less.",
    },
    source: "Huang 2001, Optimal line-sweep-based decompositions for coverage algorithms, ICRA; \
             Arkin et al. 2005, Optimal covering tours with turn costs, SIAM J. Comput. 35(3)",
    link: "https://doi.org/10.1137/S0097539703434267",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(BoustrophedonCells {
        effort: params.number("effort") as usize,
        max_jump: params.number("max_jump") as i32,
    })
};

/// The planner.
struct BoustrophedonCells {
    effort: usize,
    /// In cells.
    max_jump: i32,
}

/// Most parts whose order is improved.
const MAX_PARTS: usize = 800;
/// Most lanes that are ordered one by one.
const MAX_LANES: usize = 1_200;
/// Cells around every end of a lane or part that are searched for shortest paths.
const REACH: usize = 2_000;
/// Rounds of local search times parts, for every unit of effort: a round costs time in proportion to the parts.
const ROUNDS_TIMES_PARTS: usize = 100_000;
/// Most rounds for every part and unit of effort.
const ROUNDS_PER_PART: usize = 4;
/// Most rounds for the lanes each time the walk is split, for every unit of effort.
const ROUNDS: usize = 1_500;
/// The same for every lane, and less for few of them: small rooms converge soon.
const ROUNDS_PER_LANE: usize = 24;
/// How often the walk is split into lanes.
const TIMES_APART: usize = 5;
/// Consecutive splits without improvement after which the search ends.
const MOST_IN_VAIN: usize = 2;

/// Shares of the work that are done after each stage.
const ORDERED: f64 = 0.1;
const LINKED: f64 = 0.15;
const IMPROVED: f64 = 0.3;
const TIGHTENED: f64 = 0.35;

impl Planner for BoustrophedonCells {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let mut tours = Tours::new(job, ctx, REACH);
        let parts =
            strips(&job.free, tours.costs, Borders::Shared, || tours.ctx.checkpoint(0.0, &[]))?.parts(self.max_jump);
        let sweeps = tours.sweeps(&parts);
        let mut tour = tours.nearest_first(&sweeps, [0.0, ORDERED])?;
        if self.effort > 0 && (2..=MAX_PARTS).contains(&parts.len()) {
            let rounds = self.effort * (ROUNDS_TIMES_PARTS / parts.len()).min(ROUNDS_PER_PART * parts.len());
            tours.improve(&sweeps, &mut tour, rounds, [ORDERED, LINKED, IMPROVED])?;
        }
        tours.drive(&parts, &sweeps, &tour, [IMPROVED, TIGHTENED])?;
        let (mut lanes, mut tour) = lanes_of(&parts, &tour);
        let share = (1.0 - TIGHTENED) / TIMES_APART as f64;
        let mut in_vain = 0;
        for time in 0..TIMES_APART {
            if self.effort == 0 || in_vain >= MOST_IN_VAIN || !(2..=MAX_LANES).contains(&lanes.len()) {
                break;
            }
            let from = TIGHTENED + time as f64 * share;
            let rounds = self.effort * ROUNDS.min(ROUNDS_PER_LANE.min(lanes.len() / 2) * lanes.len());
            let sweeps = tours.sweeps(&lanes);
            tours.improve(&sweeps, &mut tour, rounds, [from, from + 0.1 * share, from + 0.9 * share])?;
            let is_better = tours.drive(&lanes, &sweeps, &tour, [from + 0.9 * share, from + share])?;
            in_vain = if is_better { 0 } else { in_vain + 1 };
            (lanes, tour) = strokes(&job.free, &tours.best);
        }
        Ok(CoveragePath::walk(tours.best))
    }
}

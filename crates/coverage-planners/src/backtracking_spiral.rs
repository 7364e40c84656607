//! Backtracking spiral algorithm (BSA): spirals inwards along walls and clean floor, then backtracks to the nearest
//! cell left.
//!
//! González, Álvarez, Díaz, Parra & Bustacara 2005, "BSA: a complete coverage algorithm" (IEEE International Conference on
//! Robotics and Automation). The robot has a reference side. Walls, furniture and clean cells are all obstacles to it:
//!
//! 1. if the cell on the reference side is free, it turns there and goes on;
//! 2. else it goes straight on if it can;
//! 3. else it turns to the other side; 4. with nowhere to go the spiral ends.
//!
//! Free cells that a spiral passes on its other side are backtracking points: there it can begin again. After a spiral
//! the robot goes to the nearest of them, and is done when none is left.
//!
//! Where the paper is silent:
//!
//! - *Backtracking points.* Every new cell beside a clean one is reached through one of them, so the nearest new cell
//!   is searched for instead of keeping a list; the walk is the same. Of equally near ones it takes the one that it
//!   turns least for.
//! - *Beginning.* A spiral begins in a direction in which something is on its reference side, straight on if possible, then
//!   towards the reference side; if there is none, in any that is free. The paper starts the first one beside a wall; in
//!   rooms of up to 100,000 cells all four directions are tried from where the robot stands.
//! - *Side.* In such rooms both sides are tried; the cheapest walk wins.
//! - *Partly occupied cells* don't exist here: the paper's extension for them isn't needed.
//!
//! Finally, detours over floor that is cleaned at another time anyway are cut short. O(n) for the rules; every end of a
//! spiral costs a search around it.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("backtracking_spiral").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\n^#ov\n^<<<\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{BestOf, FloorLeft, MAX_CELLS_FOR_ALL, Straight, WalkRule},
};
use robovac_core::{
    grid::Direction,
    registry::{Example, Explainer, ParamKind, ParamSpec},
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "backtracking_spiral",
    title: "Backtracking spiral (BSA)",
    summary: "Spirals inwards along walls and clean floor, then goes to the nearest uncleaned cell and spirals again.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, in_metres: None, search: Search::None },
    params: &[ParamSpec {
        id: "side",
        label: "Reference side",
        help: "Side on which it keeps walls and clean floor: the better one, or always the same.",
        kind: ParamKind::Choice { options: &[("auto", "the better"), ("left", "left"), ("right", "right")] },
    }],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "The robot keeps walls and clean floor on one side and spirals inwards until it is enclosed. Then it \
           backtracks to the nearest cell that it passed without cleaning. There the next spiral starts.",
    complexity: "O(n) time and memory for n cells, plus a local search at the end of every spiral.",
    use_when: "Uses only neighbouring cells; best in corridors and empty rooms. Slanted walls and scattered \
               furniture cause ragged spirals with many turns.",
    shines: Example {
        room: "spiral",
        why: "Follows the walls round every corner, all the way in and back, where lanes would end.",
    },
    fails: Example {
        room: "slanted",
        why: "A slanted wall is a staircase of cells, and every winding turns at each step.",
    },
    source: "González, Álvarez, Díaz, Parra & Bustacara 2005, BSA: a complete coverage algorithm, ICRA",
    link: "https://www.academia.edu/103916763/BSA_A_Complete_Coverage_Algorithm",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(BacktrackingSpiral {
        sides: match params.choice("side") {
            "left" => &[Direction::left],
            "right" => &[Direction::right],
            _ => &[Direction::left, Direction::right],
        },
    })
};

/// The side of a robot that looks in some direction.
type SideOf = fn(Direction) -> Direction;

/// The planner.
struct BacktrackingSpiral {
    /// The reference sides that are tried.
    sides: &'static [SideOf],
}

impl Planner for BacktrackingSpiral {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let is_small = job.cells() <= MAX_CELLS_FOR_ALL;
        let (sides, firsts) =
            if is_small { (self.sides, &Direction::ALL[..]) } else { (&self.sides[..1], &[job.heading][..]) };
        let mut best_of = BestOf::new(job, sides.len() * firsts.len());
        for &reference in sides {
            for &first in firsts {
                let mut rule = SpiralRule { reference, first: Some(first) };
                best_of.greedy_walk(ctx, &mut rule)?;
            }
        }
        Ok(best_of
            .finish(ctx, &mut Straight { on: "Along walls and clean floor", turn: "Round walls and clean floor" }))
    }
}

/// The rules of a spiral.
struct SpiralRule {
    /// The side on which the spiral keeps walls and clean floor.
    reference: SideOf,
    /// The direction in which to leave the start.
    first: Option<Direction>,
}

impl WalkRule for SpiralRule {
    fn next(&mut self, floor: &FloorLeft, at: usize, heading: Direction, begins: bool) -> Option<Direction> {
        let is_open = |&d: &Direction| floor.is_new_ahead(at, d);
        let side = (self.reference)(heading);
        if !begins {
            return [side, heading, side.opposite()].into_iter().find(is_open);
        }
        let is_guided = |&d: &Direction| is_open(&d) && !is_open(&(self.reference)(d));
        let looks = [heading, side, side.opposite(), heading.opposite()];
        let first = self.first.take().filter(is_open);
        first.or_else(|| looks.into_iter().find(is_guided)).or_else(|| looks.into_iter().find(is_open))
    }
}

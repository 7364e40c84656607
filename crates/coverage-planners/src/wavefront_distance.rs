//! Wavefront coverage with the distance transform: away from the goal as long as it can, then back towards it.
//!
//! Zelinsky, Jarvis, Byrne & Yuta 1993, "Planning paths of complete coverage of an unstructured environment by a mobile
//! robot" (International Conference on Advanced Robotics). A wave spreads from a goal and numbers all cells by their
//! distance to it. From the start the robot always goes to the unvisited neighbour with the highest number, so it moves
//! nearer to the goal only where all neighbours farther away are clean. Its walk follows the wave fronts and ends near
//! the goal.
//!
//! Where the paper is silent:
//!
//! - *Steps.* The wave spreads over eight neighbours, a diagonal one as near as the others, so that its fronts are straight
//!   lines; the robot takes steps to four.
//! - *Equals.* Of neighbours with the same number it takes the one straight ahead, then the one with the fewest unvisited
//!   neighbours, then left before right.
//! - *Dead ends.* The paper's walk ends where no neighbour is left. Here the robot goes on at the nearest unvisited cell, by
//!   steps; of equally near ones at the one with the highest number.
//! - *Goal.* With the start as goal the robot returns there. By default, rooms of up to 100,000 cells are planned with three
//!   goals: the start, the cell farthest from it, and the cell farthest from that one; the cheapest walk wins.
//!
//! Finally, detours over floor that is cleaned at another time anyway are cut short. Apart from that, cells are cleaned
//! in the order of the paper's rule. O(n) for the transform and the rule; every dead end costs a search around it.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("wavefront_distance").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\n^#ov\n^<<<\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{GOAL, STEP, WaveGoal, cover},
};
use robovac_core::registry::{Example, Explainer};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "wavefront_distance",
    title: "Wavefront, distance transform",
    summary: "Numbers cells by their distance to a goal and always moves to the unvisited neighbour farthest from it.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, in_metres: None, search: Search::None },
    params: &[GOAL],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "A wave spreads from a goal and numbers every cell by its distance. The robot always moves to the \
           unvisited neighbour with the highest number, so it drives along the wavefronts, from the farthest \
           inwards. Where there is none, it goes to the nearest unvisited cell.",
    complexity: "O(n) time and memory for n cells, plus a local search at every dead end.",
    use_when: "Simple, and the walk ends near a goal of your choice, such as the dock. Wavefronts bend around \
               every obstacle, which causes many turns.",
    shines: Example {
        room: "empty",
        why: "Wavefronts are right angles around a corner: hardly any revisits, but one more turn in every lane.",
    },
    fails: Example {
        room: "slanted",
        why: "Straight wavefronts meet slanted walls, and each leaves an uncleaned corner.",
    },
    source: "Zelinsky, Jarvis, Byrne & Yuta 1993, Planning paths of complete coverage of an unstructured environment by a \
             mobile robot, International Conference on Advanced Robotics",
    link: "",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| Box::new(WavefrontDistance { goal: WaveGoal::of(params) });

/// The planner.
struct WavefrontDistance {
    goal: WaveGoal,
}

impl Planner for WavefrontDistance {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        cover(job, self.goal, &|_| STEP, STEP, ctx)
    }
}

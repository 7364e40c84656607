//! Wavefront coverage with the path transform: like the distance transform, but the waves avoid obstacles.
//!
//! Zelinsky, Jarvis, Byrne & Yuta 1993, "Planning paths of complete coverage of an unstructured environment by a mobile
//! robot" (International Conference on Advanced Robotics). The path transform of a cell is the least, over all ways to the
//! goal, of the way's length plus alpha times the discomfort of its cells; discomfort is high beside obstacles and falls
//! with the distance to them, which an obstacle transform gives. The robot covers the room as with the distance
//! transform: always to the unvisited neighbour with the highest value. Cells beside obstacles have high values, so it
//! follows walls and outlines first and the middle last, with fewer turns where the room is built of corridors.
//!
//! Where the paper is silent:
//!
//! - *Discomfort.* The paper allows any function that falls with the distance. Here it is (4 - d)² at d steps from the
//!   nearest blocked cell or edge, over eight neighbours, and 0 from 4 steps on. Alpha is in steps a unit of it.
//! - *Computing it.* The paper repeats sweeps over the grid until nothing changes; Dijkstra's algorithm with buckets gives the
//!   same values at once.
//! - *Ties, dead ends and goals* are as in `wavefront_distance`, whose walk results from alpha 0.
//!
//! O(n + the largest value) for the transform.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("wavefront_path").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\n^#ov\n^<<<\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{GOAL, STEP, WaveGoal, cover, obstacle_transform},
};
use robovac_core::registry::{Example, Explainer, ParamKind, ParamSpec};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "wavefront_path",
    title: "Wavefront, path transform",
    summary: "Like the distance transform, but waves avoid obstacles, so the robot follows outlines first.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, in_metres: None, search: Search::None },
    params: &[
        ParamSpec {
            id: "alpha",
            label: "Alpha",
            help: "How strongly waves avoid obstacles: steps per unit of discomfort; 0 gives the distance transform.",
            kind: ParamKind::Number { min: 0.0, max: 4.0, step: 0.25, default: 1.0, unit: "" },
        },
        GOAL,
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "Waves spread from a goal as in the distance transform, but more slowly near obstacles, so cells along walls \
           get high numbers. The robot always moves to the unvisited neighbour with the highest number: it follows \
           outlines first and cleans the middle last. Alpha sets how strongly the waves avoid obstacles.",
    complexity: "O(n) time and memory for n cells, plus a local search at every dead end.",
    use_when: "Better than the distance transform in corridors and mazes, as it follows their walls. In furnished \
               open rooms it turns as often.",
    shines: Example { room: "spiral", why: "Down one wall and back along the other, with far fewer turns than lanes." },
    fails: Example {
        room: "slanted",
        why: "Slanted walls are staircases of cells, and following them it turns at every step.",
    },
    source: "Zelinsky, Jarvis, Byrne & Yuta 1993, Planning paths of complete coverage of an unstructured environment by a \
             mobile robot, International Conference on Advanced Robotics",
    link: "",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(WavefrontPath { alpha: (params.number("alpha") * f64::from(STEP)) as u32, goal: WaveGoal::of(params) })
};

/// The planner.
struct WavefrontPath {
    /// Cost of a unit of discomfort, in the units of [`STEP`].
    alpha: u32,
    goal: WaveGoal,
}

/// Steps from an obstacle at which discomfort ends.
const COMFORTABLE: u32 = 4;

impl Planner for WavefrontPath {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let cost = |distance: u32| STEP + self.alpha * (COMFORTABLE - distance).pow(2);
        let costs: Vec<u32> = obstacle_transform(&job.free, COMFORTABLE).into_iter().map(cost).collect();
        cover(job, self.goal, &|cell| costs[cell], cost(0), ctx)
    }
}

//! S-shaped pathway: lane beside lane, with U-turns to the left and to the right in turn.
//!
//! Emu & Obaida 2020 (thesis, East West University), section 4.1: the robot follows "a route map like the letter 'S'"; on
//! every collision it goes back, turns by 90 degrees to the right or left, goes on, and turns to the left or right. They
//! take it from Hasan, Abdullah-Al-Nahid & Reza 2014 (ICIEV), where the turns are timed. On a grid this is: one step aside and
//! back beside the lane that was driven. As the robot looks the other way by then, a step to the same side of the room is
//! a turn to the left after one to the right.
//!
//! # Where the source is silent
//!
//! - *Which side.* To the left of the first lane, and on to that side until it is blocked or clean; then to the other one.
//! - *Clean floor* ends a lane as a wall does, as in the thesis' own algorithm (section 4.2).
//! - *A longer lane.* Where the next lane reaches beyond the end of this one, what is beyond is left for later. Only where
//!   there is nothing to go back to does the robot go on in its direction.
//! - *Dead ends.* The thesis has none. Here the robot takes a shortest way to the nearest cell left and goes on from there
//!   in the direction in which it came, so that every walk covers all.
//! - *Direction of the lanes.* By default the one with fewer lanes.
//!
//! Unlike boustrophedon it plans nothing ahead and doesn't decompose the room. O(n) steps; each search for the nearest
//! cell left takes time in proportion to the cells it visits.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("s_shape").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\no#v<\n^<><\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{CoverageProgress, Straight, lanes_lie_down},
};
use robovac_core::registry::{Example, Explainer, ParamKind, ParamSpec};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "s_shape",
    title: "S-shaped pathway",
    summary: "Drives parallel lanes like the letter S; at a dead end it goes to the nearest uncleaned cell.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, in_metres: None, search: Search::None },
    params: &[ParamSpec {
        id: "lanes",
        label: "Lanes",
        help: "Direction of the lanes: the one with fewer lanes, the robot's initial heading, or always the same.",
        kind: ParamKind::Choice {
            options: &[
                ("auto", "fewer lanes"),
                ("heading", "initial heading"),
                ("horizontal", "horizontal"),
                ("vertical", "vertical"),
            ],
        },
    }],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "The robot drives straight until it is blocked, steps aside and returns beside its lane. Floor already \
           clean blocks it like a wall. At a dead end it takes a shortest path to the nearest uncleaned cell and \
           continues in lanes from there.",
    complexity: "O(n) steps and memory for n cells, plus a search at every dead end.",
    use_when: "The simplest complete method, and hard to beat in halls with few obstacles. Every obstacle leaves a \
               pocket behind it that the robot must return to.",
    shines: Example { room: "lshape", why: "Few obstacles: parallel lanes, and one return for the other arm." },
    fails: Example { room: "maze", why: "Every dead end of the maze is a dead end of the walk, too." },
    source: "Emu & Obaida 2020, thesis, East West University: section 4.1; \
             Hasan, Abdullah-Al-Nahid & Reza 2014, Path planning algorithm development, ICIEV",
    link: "",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(SShape {
        lanes: match params.choice("lanes") {
            "heading" => SShapeLanes::Heading,
            "horizontal" => SShapeLanes::Horizontal,
            "vertical" => SShapeLanes::Vertical,
            _ => SShapeLanes::Auto,
        },
    })
};

/// The planner.
struct SShape {
    lanes: SShapeLanes,
}

enum SShapeLanes {
    Auto,
    Heading,
    Horizontal,
    Vertical,
}

impl Planner for SShape {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let is_horizontal = match self.lanes {
            SShapeLanes::Auto => lanes_lie_down(&job.free),
            SShapeLanes::Heading => job.heading.is_horizontal(),
            SShapeLanes::Horizontal => true,
            SShapeLanes::Vertical => false,
        };
        let mut lane = if job.heading.is_horizontal() == is_horizontal { job.heading } else { job.heading.right() };
        let mut side = lane.left();
        let mut progress = CoverageProgress::new(job);
        while !progress.is_done() {
            progress.report(ctx)?;
            if progress.is_left(lane) {
                progress.step(lane);
            } else if let Some(open) = [side, side.opposite()].into_iter().find(|&d| progress.is_left(d)) {
                side = open;
                progress.step(side);
                if progress.is_left(lane.opposite()) || !progress.is_left(lane) {
                    lane = lane.opposite();
                }
            } else if progress.is_left(lane.opposite()) {
                lane = lane.opposite();
            } else {
                progress.go_to_nearest_left();
                if progress.facing.is_horizontal() == is_horizontal {
                    lane = progress.facing;
                } else {
                    side = progress.facing;
                }
            }
        }
        progress.tell(ctx, &mut Straight { on: "The lane goes on", turn: "The lane ends" });
        Ok(progress.into_path())
    }
}

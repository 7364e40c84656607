//! Subgoal sweep: scan lines from wall to wall and obstacle to obstacle, with their ends linked nearest-first.
//!
//! Hyun (001, Honam University): a robot of any outline, moved along scan lines through the obstacle map, records where
//! it touches walls and obstacles (section 3, [`stage::subgoals`](super::stage::subgoals)). These subgoal points are
//! linked, across the line first, then to the nearest that is left (section 4, [`SubgoalScan`]). Links that go through
//! an obstacle get a detour (section 5, [`Detours`]). Each stage documents what the paper leaves open.
//!
//! Here the obstacle map is the planning grid: cells free for the robot, all others being walls and obstacles. The tab
//! *Floor plan* works with the paper's own map, of the robot's true outline and with lines at any distance
//! ([`crate::sweep`]).
//!
//! # On a grid
//!
//! - *The start.* The paper's robot stands at the first subgoal point, in the upper left. This one may stand
//!   anywhere, and goes to the nearest.
//! - *Links* become steps to neighbouring cells: round one corner where that is free, else along the straight line.
//! - *Lines.* One on every row by default: planning cells are as wide as the strip that the robot
//!   cleans, or half as wide as the octagon, the distance that the paper gives.
//! - *What is left* between lines that are farther apart than a row, the paper leaves to the width of the robot. A
//!   stage of our own, after all links, goes to the nearest cell left and along its row, again and again: so every
//!   walk covers all.
//!
//! O(n) for n cells, and for each detour the cells that its search looks at.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture(".....\n.##..\n.....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("subgoal_sweep").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>>v\no##v<\n^<<><\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    TraceStep,
    stage::{
        Beside, CoverageProgress, Detours, FoundBy, LineEndContact, Subgoal, SubgoalScan, is_straight_free, scan_rows,
        steps_along, subgoals,
    },
};
use robovac_core::{
    cspace::ObstacleRuns,
    grid::{Cell, Direction},
    registry::{Example, Explainer, ParamKind, ParamSpec},
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "subgoal_sweep",
    title: "Subgoal sweep",
    summary: "Scans the room in lines, marks contact points as subgoals, and links each to the nearest.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, in_metres: None, search: Search::None },
    params: &[
        ParamSpec {
            id: "scan_lines",
            label: "Lane spacing",
            help: "Rows of cells between lanes, the paper's scan width; cells left in between are cleaned at the end.",
            kind: ParamKind::Number { min: 1.0, max: 10.0, step: 1.0, default: 1.0, unit: "rows" },
        },
        ParamSpec {
            id: "order",
            label: "At the end of a line",
            help: "Go to the nearest remaining point, or first check the neighbouring lines, by steps 3 to 5 of the paper.",
            kind: ParamKind::Choice { options: &[("nearest", "nearest point"), ("printed", "across, as printed")] },
        },
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "The planner scans the room along lines from the upper left to the lower right, and every contact with a \
           wall or an obstacle becomes a subgoal point. From each point the sweep crosses to the other end of its \
           line, and from there to the nearest remaining point. Links that would cross an obstacle are routed \
           around it.",
    complexity: "O(n) steps and memory for n cells, plus a search at every detour.",
    use_when: "Made for large halls known from an architect's drawing, and fast enough to plan while drawing. It \
               sweeps in one direction only and looks no further than the next point, so it must return for what it \
               left out.",
    shines: Example { room: "empty", why: "No obstacles: line after line, without revisits." },
    fails: Example { room: "maze", why: "The nearest point is often behind a wall, at the end of a long detour." },
    source: "Hyun, An Artificial Intelligent algorithm for an autonomous Cleaning Robot, Honam University: \
             sections 3 to 5",
    link: "",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(SubgoalSweep {
        distance: params.number("scan_lines"),
        beside: if params.choice("order") == "printed" { Beside::First } else { Beside::Never },
    })
};

/// The planner.
struct SubgoalSweep {
    /// Rows from one scan line to the next.
    distance: f64,
    beside: Beside,
}

/// Results of linking.
#[derive(Default)]
struct LinkTally {
    /// Links that go through an obstacle.
    collisions: usize,
    /// Of these, those with a detour.
    resolved: usize,
}

impl Planner for SubgoalSweep {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let free = &job.free;
        let points = subgoals(free, &scan_rows(free, self.distance), &ObstacleRuns::of(free), |_| true);
        ctx.trace(|| contacts(&points, job));
        let mut scan = SubgoalScan::new(&points, self.beside);
        let mut detours = Detours::new(free);
        let mut progress = CoverageProgress::new(job);
        let mut tally = LinkTally::default();
        let is_clear = |from: usize, to: usize| is_straight_free(free, points[from].at, points[to].at);
        scan.link_all(is_clear, Err(job.start), |_, to, found| {
            progress.report(ctx)?;
            let (step, at, goal) = (progress.steps(), progress.at, points[to].at);
            if is_straight_free(free, at, goal) {
                follow(&mut progress, job, &[goal]);
                ctx.trace(|| link(step, at, (&points, to), found, None, &tally));
            } else {
                tally.collisions += 1;
                // All free cells are connected, so a way exists.
                let way = detours.find(at, goal).unwrap_or_default();
                tally.resolved += usize::from(!way.is_empty());
                follow(&mut progress, job, way.get(1..).unwrap_or_default());
                ctx.trace(|| link(step, at, (&points, to), found, Some(progress.steps() - step), &tally));
            }
            Ok::<(), PlanError>(())
        })?;
        finish(&mut progress, ctx)?;
        Ok(progress.into_path())
    }
}

/// Goes along a way of straight free pieces.
fn follow(progress: &mut CoverageProgress<'_>, job: &CoverageJob, corners: &[Cell]) {
    for &corner in corners {
        for cell in steps_along(&job.free, progress.at, corner, progress.facing) {
            if let Some(direction) = progress.at.direction_to(cell) {
                progress.step(direction);
            }
        }
    }
}

/// Goes to the nearest cell left and along its row, until none is.
fn finish(progress: &mut CoverageProgress<'_>, ctx: &mut PlanContext<'_>) -> Result<(), PlanError> {
    let left = progress.left_count();
    if left > 0 {
        let (step, at, towards) = (progress.steps(), progress.at, progress.facing);
        ctx.trace(|| TraceStep {
            step,
            rule: "Finish".into(),
            at,
            towards,
            marks: Vec::new(),
            sides: None,
            note: format!("All points are linked; remaining cells between the lines: {left}, nearest first"),
        });
    }
    while !progress.is_done() {
        progress.report(ctx)?;
        progress.go_to_nearest_left();
        for side in [Direction::Right, Direction::Left] {
            while progress.is_left(side) {
                progress.step(side);
            }
        }
    }
    Ok(())
}

/// The contacts of the scan in its order, for the trace.
fn contacts(points: &[Subgoal], job: &CoverageJob) -> TraceStep {
    let count = |contact: LineEndContact| points.iter().filter(|p| p.contact == contact).count();
    let [left, right, left_solid, right_solid] = [
        LineEndContact::LeftWall,
        LineEndContact::RightWall,
        LineEndContact::LeftObstacle,
        LineEndContact::RightObstacle,
    ]
    .map(count);
    TraceStep {
        step: 0,
        rule: "Subgoal points".into(),
        at: job.start,
        towards: job.heading,
        marks: points.iter().zip(1..).map(|(point, number)| (point.at, number)).collect(),
        sides: None,
        note: format!(
            "{} points: beside walls {left} on the left and {right} on the right, beside obstacles {left_solid} and {right_solid}",
            points.len()
        ),
    }
}

/// Lines beside that of a link's end whose points are shown with it.
const SHOWN_LINES: u32 = 3;

/// A link, for the trace, with the points around its end; `detour` is the length of the way round, in steps.
fn link(
    step: usize,
    at: Cell,
    (points, to): (&[Subgoal], usize),
    found: FoundBy,
    detour: Option<usize>,
    tally: &LinkTally,
) -> TraceStep {
    let near = points.iter().zip(1..).filter(|(point, _)| point.line.abs_diff(points[to].line) <= SHOWN_LINES);
    let marks = near.map(|(point, number)| (point.at, number)).collect();
    let number = to + 1;
    let to = &points[to];
    let rule = match (found, detour) {
        (_, Some(_)) => "Detour",
        (FoundBy::Across, None) => "Across the line",
        (FoundBy::Beside, None) => "Across beside",
        (FoundBy::Nearest, None) => "Nearest point",
    };
    let (dx, dy) = (to.at.x - at.x, to.at.y - at.y);
    let towards = match (dx.abs() >= dy.abs(), dx > 0, dy > 0) {
        (true, true, _) => Direction::Right,
        (true, false, _) => Direction::Left,
        (false, _, true) => Direction::Up,
        (false, _, false) => Direction::Down,
    };
    let what = to.obstacle.map_or("the wall".to_owned(), |number| format!("obstacle {number}"));
    let side = if to.contact.is_left() { "left" } else { "right" };
    let round = detour.map_or(String::new(), |steps| {
        let LinkTally { collisions, resolved } = tally;
        format!(": the straight link collides, {steps} steps around it; collision {collisions}, {resolved} resolved")
    });
    TraceStep {
        step,
        rule: rule.into(),
        at,
        towards,
        marks,
        sides: None,
        note: format!("To point {number}, {what} on its {side}{round}"),
    }
}

//! Spanning tree coverage: cells four at a time, a tree through these, and a tour round the tree.
//!
//! Gabriely & Rimon 2001, "Spanning-tree based coverage of continuous areas by a mobile robot" (Annals of Mathematics and
//! Artificial Intelligence 31), Spiral-STC of 2002 and the full version for partly blocked mega-cells of 2003 ("Competitive
//! on-line coverage of grid environments by a mobile robot", Computational Geometry 24). The room is divided into
//! mega-cells of 2 x 2 cells. A spanning tree connects them; the robot drives round it, always with the tree on the same
//! side. In a room of whole mega-cells that visits every cell exactly once (2001).
//!
//! - *Tree.* The spiral tree of the papers grows depth first, always into the first new neighbour on one side, and is tried
//!   in both directions. It is one of many: the tour turns where the tree bends, ends or branches off a straight
//!   piece. So "few turns" joins first what adds least to steps and turns of the tour, along rows or along columns.
//! - *Partly blocked mega-cells* belong to the tree as well; two cells that touch diagonally are mega-cells of their own. Over a
//!   side that isn't free in full the robot goes there and back, which takes two steps more ([`MegaCells`]). The spiral
//!   tree goes there when nothing else is left.
//! - *Alignment.* In rooms of up to 100,000 cells mega-cells may begin at odd or even rows and columns, and the tour is tried
//!   both ways round; the cheapest walk wins. Larger rooms get one tour, its tree along rows or columns by their number.
//! - *Way home.* The robot needn't come back to its start: the tour ends with its last new cell, and detours over floor
//!   that is cleaned at another time anyway are cut short.
//!
//! O(n) but for the union of trees, which is nearly so.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("spiral_stc").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\n^#ov\n^<<<\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{Added, BestOf, MAX_CELLS_FOR_ALL, MegaCells, Straight},
};
use robovac_core::{
    grid::Direction,
    registry::{Example, Explainer, ParamKind, ParamSpec},
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "spiral_stc",
    title: "Spanning tree (Spiral-STC)",
    summary: "Divides the room into squares of 2 x 2 cells, connects them by a spanning tree and drives around it.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, in_metres: None, search: Search::None },
    params: &[ParamSpec {
        id: "tree",
        label: "Tree",
        help: "How the spanning tree is built: as in the paper, or for a tour with few turns.",
        kind: ParamKind::Choice {
            options: &[("auto", "the cheapest"), ("spiral", "spiral"), ("straight", "few turns")],
        },
    }],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "Each mega-cell has four cells, and a spanning tree connects all mega-cells. Driving around the tree, \
           with it always on the same side, visits every cell once and returns to the start. Trees with long \
           straight branches need the fewest turns.",
    complexity: "O(n α(n)) time, practically linear, and O(n) memory for n cells.",
    use_when: "Hardly any revisits, wherever the furniture stands, and it ends near the start. Passages one cell \
               wide must be driven there and back.",
    shines: Example {
        room: "dining",
        why: "Passes around every leg with hardly any revisits, where lanes end at each.",
    },
    fails: Example {
        room: "spiral",
        why: "Where 2 x 2 squares don't fit the corridor, it drives there and back, again and again.",
    },
    source: "Gabriely & Rimon 2001, Spanning-tree based coverage of continuous areas, Ann. Math. Artif. Intell. 31; \
             2003, Competitive on-line coverage of grid environments, Comput. Geom. 24",
    link: "https://doi.org/10.1023/A:1016610507833",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(SpiralStc {
        shapes: match params.choice("tree") {
            "spiral" => SPIRALS,
            "straight" => STRAIGHT,
            _ => ALL,
        },
    })
};

/// The planner.
struct SpiralStc {
    /// The trees that are tried.
    shapes: &'static [TreeShape],
}

/// How a tree grows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum TreeShape {
    /// Depth first, to the right first: a spiral that winds counter-clockwise from outside in.
    CounterClockwise,
    /// Its mirror image.
    Clockwise,
    /// Cheapest first, rows before columns.
    Rows,
    /// Cheapest first, columns before rows.
    Columns,
}

const ALL: &[TreeShape] = &[TreeShape::Rows, TreeShape::Columns, TreeShape::CounterClockwise, TreeShape::Clockwise];
const STRAIGHT: &[TreeShape] = &[TreeShape::Rows, TreeShape::Columns];
const SPIRALS: &[TreeShape] = &[TreeShape::CounterClockwise, TreeShape::Clockwise];
/// Where the lower left corners of mega-cells are: whether x and y are odd.
const ALIGNMENTS: [[bool; 2]; 4] = [[false, false], [true, false], [false, true], [true, true]];

impl Planner for SpiralStc {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        ctx.checkpoint(0.0, &[])?;
        let is_small = job.cells() <= MAX_CELLS_FOR_ALL;
        let (shapes, alignments) =
            if is_small { (self.shapes, &ALIGNMENTS[..]) } else { (&self.shapes[..1], &ALIGNMENTS[..1]) };
        let ways_round = if is_small { 2 } else { 1 };
        let mut best_of = BestOf::new(job, shapes.len() * alignments.len() * ways_round);
        for &is_odd in alignments {
            let megas = MegaCells::new(&job.free, is_odd);
            for &shape in shapes {
                best_of.report(ctx, 0.0)?;
                let is_better_along_y = !is_small
                    && shape == TreeShape::Rows
                    && lanes(&megas, Direction::Up) < lanes(&megas, Direction::Right);
                let shape = if is_better_along_y { TreeShape::Columns } else { shape };
                let mut tour = grow(megas.clone(), shape, &best_of, ctx)?.tour(job.start, job.heading);
                best_of.report(ctx, 1.0)?;
                if is_small {
                    best_of.offer(ctx, tour.clone())?;
                    tour.reverse();
                }
                best_of.offer(ctx, tour)?;
            }
        }
        Ok(best_of.finish(ctx, &mut Straight { on: "Along the tree", turn: "Round the tree" }))
    }
}

/// Number of straight pieces that mega-cells make along a direction: every one of them ends with a turn.
fn lanes(megas: &MegaCells, direction: Direction) -> usize {
    (0..megas.len()).filter(|&mega| megas.link(mega, direction).is_none_or(|link| !link.is_wide)).count()
}

/// Which mega-cells are connected.
struct Union(Vec<u32>);

impl Union {
    fn root(&mut self, mut i: usize) -> usize {
        while self.0[i] as usize != i {
            self.0[i] = self.0[self.0[i] as usize];
            i = self.0[i] as usize;
        }
        i
    }

    fn are_connected(&mut self, a: usize, b: usize) -> bool {
        self.root(a) == self.root(b)
    }

    fn connect(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a] = b as u32;
    }
}

/// Joins all mega-cells along a spanning tree.
fn grow(
    mut megas: MegaCells,
    shape: TreeShape,
    best_of: &BestOf<'_>,
    ctx: &mut PlanContext<'_>,
) -> Result<MegaCells, PlanError> {
    let job = best_of.job;
    match shape {
        TreeShape::CounterClockwise => spiral(&mut megas, job, Direction::right),
        TreeShape::Clockwise => spiral(&mut megas, job, Direction::left),
        TreeShape::Rows => straight(&mut megas, best_of, [Direction::Right, Direction::Up], ctx)?,
        TreeShape::Columns => straight(&mut megas, best_of, [Direction::Up, Direction::Right], ctx)?,
    }
    Ok(megas)
}

/// Mega-cells between two reports.
const REPORT_EVERY: usize = 1 << 16;

/// Joins what adds least to the tour first (Kruskal 1956), of equals in the first of two directions.
fn straight(
    megas: &mut MegaCells,
    best_of: &BestOf<'_>,
    directions: [Direction; 2],
    ctx: &mut PlanContext<'_>,
) -> Result<(), PlanError> {
    let mut union = Union((0..megas.len() as u32).collect());
    // What can be added, cheapest first, and the links that add it. The addition of a link changes with the links
    // beside it.
    let mut kinds: Vec<Added> = Added::all().collect();
    kinds.sort_by_key(|added| added.cost(best_of.costs));
    let rank = |added: Added| kinds.iter().position(|&kind| kind == added).unwrap_or(0);
    let mut queues: Vec<Vec<(u32, Direction)>> = vec![Vec::new(); kinds.len()];
    for direction in directions {
        for mega in 0..megas.len() {
            if let Some(link) = megas.link(mega, direction) {
                queues[rank(megas.added(link))].push((mega as u32, direction));
            }
        }
    }
    let mut looked = 0_usize;
    for i in 0..queues.len() {
        for (mega, direction) in std::mem::take(&mut queues[i]) {
            looked += 1;
            if looked.is_multiple_of(REPORT_EVERY) {
                best_of.report(ctx, 0.0)?;
            }
            let mega = mega as usize;
            let Some(link) = megas.link(mega, direction).filter(|link| !union.are_connected(mega, link.to)) else {
                continue;
            };
            let now = rank(megas.added(link));
            if now > i {
                queues[now].push((mega as u32, direction));
            } else {
                union.connect(mega, link.to);
                megas.join(link);
            }
        }
    }
    Ok(())
}

/// Depth first from the start's mega-cell, always to the first new neighbour on that side, which winds the tree up.
fn spiral(megas: &mut MegaCells, job: &CoverageJob, side: fn(Direction) -> Direction) {
    let mut is_new = vec![true; megas.len()];
    let root = megas.of_cell(job.start);
    is_new[root] = false;
    let mut reached = vec![(root, job.heading)];
    // Neighbours behind narrow links wait until no wide link is left.
    for i in 0.. {
        let Some(&(mega, heading)) = reached.get(i) else { break };
        let looks = [side(heading), heading, side(heading).opposite(), heading.opposite()];
        if i == 0 {
            wind(megas, (mega, heading), side, &mut is_new, &mut reached);
        }
        for look in looks {
            if let Some(link) = megas.link(mega, look).filter(|link| is_new[link.to]) {
                is_new[link.to] = false;
                megas.join(link);
                reached.push((link.to, look));
                wind(megas, (link.to, look), side, &mut is_new, &mut reached);
            }
        }
    }
}

/// The part of a spiral tree along wide links.
fn wind(
    megas: &mut MegaCells,
    root: (usize, Direction),
    side: fn(Direction) -> Direction,
    is_new: &mut [bool],
    reached: &mut Vec<(usize, Direction)>,
) {
    let mut stack = vec![(root, 0)];
    while let Some(((mega, heading), tried)) = stack.last_mut() {
        let looks = [side(*heading), *heading, side(*heading).opposite(), heading.opposite()];
        let Some(&look) = looks.get(*tried) else {
            stack.pop();
            continue;
        };
        *tried += 1;
        if let Some(link) = megas.link(*mega, look).filter(|link| link.is_wide && is_new[link.to]) {
            is_new[link.to] = false;
            megas.join(link);
            reached.push((link.to, look));
            stack.push(((link.to, look), 0));
        }
    }
}

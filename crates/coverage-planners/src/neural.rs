//! Bio-inspired neural network: every cell is a neuron, uncleaned floor excites it, and the robot climbs the activity.
//!
//! By Yang & Luo 2004, "A neural network approach to complete coverage path planning" (IEEE Transactions on Systems,
//! Man, and Cybernetics B 34(1)). The activity x of a neuron follows the shunting equation
//!
//! dx/dt = -A x + (B - x) (`[I]+` + Σ w `[x_j]+`) - (D + x) `[I]-`
//!
//! with the input I = E for a cell to be cleaned, -E for an obstacle, 0 for a clean cell, and lateral connections w =
//! μ / distance to the eight neurons around. The robot goes to the neighbour with the greatest x + c y, where y = 1 -
//! turn / π. By default here A = 10, B = 1, D = 1, E = 100, μ = 0.7, c = 0.5.
//!
//! # What is done here, and where the paper is silent
//!
//! - *Rest instead of time.* Robots are slow and neurons fast, so the field is kept at rest, where dx/dt = 0: x = B P /
//!   (A + P) with P the excitation, and -D E / (A + E) for obstacles, which therefore excite no other neuron. A cell
//!   that has been cleaned changes its own activity; the change is passed on to neighbours while it is more than 0.1 %
//!   of an activity. Nothing else is omitted.
//! - *Four neighbours.* A walk takes no diagonal steps; the lateral connections are still eight.
//! - *Deadlock.* With only clean neighbours, c y would outweigh the faint activity of far floor for ever, and the robot
//!   goes in circles; the program by Bormann et al. (`ipa320/ipa_coverage_planning`) gives up there. So c counts only
//!   while a neighbour is left to be cleaned; else the robot climbs by activity alone. Where no neighbour is more
//!   active than the robot's own cell (far from all floor left, or where only a diagonal leads on), it takes a shortest
//!   way to the nearest cell left. As each step climbs or cleans, every walk ends and covers all.
//! - Ties go straight on, then left, then right. At the start any direction may count as straight on: in rooms of up
//!   to 2,500 cells each is tried and the cheapest walk kept; else it's where the robot looks.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("neural").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\n^#ov\n^<<<\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{Costs, NearestGoalBfs, Reasons, tell_walk},
};
use robovac_core::{
    grid::{Cell, Direction, Grid},
    registry::{Example, Explainer, ParamKind, ParamSpec},
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "neural",
    title: "Neural network",
    summary: "A neural field excited by uncleaned floor; the robot follows the highest activity.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: false, in_metres: None, search: Search::None },
    params: &[
        ParamSpec {
            id: "straight",
            label: "Going straight (c)",
            help: "Bonus for driving straight, compared with activities of at most 1.",
            kind: ParamKind::Number { min: 0.0, max: 2.0, step: 0.01, default: 0.5, unit: "" },
        },
        ParamSpec {
            id: "lateral",
            label: "Lateral weight (μ)",
            help: "How strongly neurons excite their neighbours; higher reaches further.",
            kind: ParamKind::Number { min: 0.05, max: 1.0, step: 0.05, default: 0.7, unit: "" },
        },
        ParamSpec {
            id: "decay",
            label: "Decay (A)",
            help: "How fast activity decays.",
            kind: ParamKind::Number { min: 5.0, max: 50.0, step: 1.0, default: 10.0, unit: "" },
        },
        ParamSpec {
            id: "input",
            label: "Input (E)",
            help: "How strongly dirty floor excites its neuron.",
            kind: ParamKind::Number { min: 20.0, max: 200.0, step: 1.0, default: 100.0, unit: "" },
        },
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "Each cell is a neuron that is excited while its floor is dirty and excites its neighbours. Activity \
           spreads from dirty floor like heat, and obstacles block it. The robot moves to the most active \
           neighbour, with a bonus for driving straight.",
    complexity: "O(n) memory for n cells; each step updates the neurons whose activity changes, at worst all.",
    use_when: "Made for floors that change during cleaning: the field adapts by itself. It ignores detours and \
               turns, so other planners are cheaper in known rooms.",
    shines: Example {
        room: "empty",
        why: "Neither walls nor clean floor excite neurons, so lanes line up side by side.",
    },
    fails: Example { room: "maze", why: "Uncleaned floor on many sides pulls the robot back and forth." },
    source: "Yang & Luo 2004, A neural network approach to complete coverage path planning, \
             IEEE Trans. Systems, Man, and Cybernetics B 34(1)",
    link: "",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(Neural {
        straight: params.number("straight"),
        lateral: params.number("lateral"),
        decay: params.number("decay"),
        input: params.number("input"),
    })
};

/// The planner.
struct Neural {
    straight: f64,
    lateral: f64,
    decay: f64,
    input: f64,
}

/// Upper bound of activities. (Obstacles rest below 0, so that the lower bound D never matters.)
const B: f64 = 1.0;
/// Changes of an activity by a smaller share aren't propagated.
const TOLERANCE: f64 = 0.001;
/// Steps between two reports.
const REPORT_EVERY: usize = 256;

/// Activities at rest.
#[derive(Clone)]
struct Field<'a> {
    weights: &'a Neural,
    free: &'a Grid<bool>,
    is_left: Grid<bool>,
    activity: Grid<f64>,
    /// Neurons to be brought to rest.
    queue: std::collections::VecDeque<Cell>,
    is_queued: Grid<bool>,
}

impl<'a> Field<'a> {
    fn new(weights: &'a Neural, free: &'a Grid<bool>) -> Self {
        let dirty = B * weights.input / (weights.decay + weights.input);
        let activity = free.map(|&is_free| if is_free { dirty } else { 0.0 });
        let queue = free.iter().filter(|&(_, &is_free)| is_free).map(|(cell, _)| cell).collect();
        let mut field = Self { weights, free, is_left: free.clone(), activity, queue, is_queued: free.clone() };
        field.settle();
        field
    }

    /// Activity of a neuron at rest among its neighbours.
    fn at_rest(&self, cell: Cell) -> f64 {
        let (mut beside, mut diagonal) = (0.0, 0.0);
        for near in cell.block() {
            let activity = self.activity.get(near).copied().unwrap_or(0.0);
            match cell.manhattan(near) {
                0 => {}
                1 => beside += activity,
                _ => diagonal += activity,
            }
        }
        let lateral = self.weights.lateral * (beside + diagonal * std::f64::consts::FRAC_1_SQRT_2);
        let excitation = lateral + if self.is_left[cell] { self.weights.input } else { 0.0 };
        B * excitation / (self.weights.decay + excitation)
    }

    fn visit(&mut self, cell: Cell) {
        self.is_left[cell] = false;
        self.push(cell);
        self.settle();
    }

    fn push(&mut self, cell: Cell) {
        if self.free.is_set(cell) && !std::mem::replace(&mut self.is_queued[cell], true) {
            self.queue.push_back(cell);
        }
    }

    /// Brings all queued neurons to rest, and the neighbours of every one that changes.
    fn settle(&mut self) {
        while let Some(cell) = self.queue.pop_front() {
            self.is_queued[cell] = false;
            let (old, new) = (self.activity[cell], self.at_rest(cell));
            // Smaller activities are rounded to 0.
            let new = if new < FAINTEST { 0.0 } else { new };
            if (new - old).abs() > TOLERANCE * old.max(new) {
                self.activity[cell] = new;
                cell.block().for_each(|near| self.push(near));
            }
        }
    }

    /// The next cell: the neighbour of greatest x + c y; `None` where activity leads nowhere.
    fn next(&self, at: Cell, heading: Direction) -> Option<Direction> {
        let looks = [heading, heading.left(), heading.right(), heading.opposite()];
        let is_dirty = |d: &Direction| self.is_left.is_set(at.step(*d));
        let straight = if looks.iter().any(is_dirty) { self.weights.straight } else { 0.0 };
        let mut best = None;
        for direction in looks.into_iter().filter(|d| self.free.is_set(at.step(*d))) {
            let y = 1.0 - f64::from(heading.quarter_turns(direction)) / 2.0;
            let value = self.activity[at.step(direction)] + straight * y;
            if best.is_none_or(|(_, most)| value > most) {
                best = Some((direction, value));
            }
        }
        let climbs = |d: Direction| self.activity[at.step(d)] > self.activity[at];
        best.map(|(direction, _)| direction).filter(|&d| is_dirty(&d) || climbs(d))
    }
}

impl Reasons for Field<'_> {
    fn visit(&mut self, cell: Cell) {
        Field::visit(self, cell);
    }

    fn values(&self, at: Cell, _heading: Direction, open: &[Direction]) -> Vec<u32> {
        open.iter().map(|&look| (1000.0 * self.activity[at.step(look)]).round() as u32).collect()
    }

    fn rule(&self, _at: Cell, _heading: Direction, _towards: Direction) -> &'static str {
        "Up the slope of activity (0 to 1000)"
    }
}

/// Activities below are treated as 0.
const FAINTEST: f64 = 1e-200;

/// Largest room, in free cells, for which several walks are planned.
const MAX_CELLS_FOR_ALL: usize = 2_500;

impl Planner for Neural {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        ctx.checkpoint(0.0, &[])?;
        let fresh = Field::new(self, &job.free);
        let costs = Costs::of(job);
        let tries = if job.cells() <= MAX_CELLS_FOR_ALL { Direction::ALL.len() } else { 1 };
        let mut best: Vec<Cell> = Vec::new();
        let mut heading = job.heading;
        for number in 0..tries {
            let walk = walk(job, fresh.clone(), heading, |done, walk| {
                ctx.checkpoint((number as f64 + done) / tries as f64, if best.is_empty() { walk } else { &best })
            })?;
            if best.is_empty() || costs.of_walk(job.heading, &walk) < costs.of_walk(job.heading, &best) {
                best = walk;
            }
            heading = heading.left();
        }
        tell_walk(ctx, job, &best, &mut fresh.clone());
        Ok(CoveragePath::walk(best))
    }
}

/// The walk of a robot that looks in `heading` at the start.
fn walk(
    job: &CoverageJob,
    mut field: Field<'_>,
    mut heading: Direction,
    mut report: impl FnMut(f64, &[Cell]) -> Result<(), PlanError>,
) -> Result<Vec<Cell>, PlanError> {
    let mut at = job.start;
    let mut walk = vec![at];
    let mut seeker = NearestGoalBfs::new(&job.free);
    let cells = job.cells();
    let mut left = cells - 1;
    field.visit(at);
    let mut next_report = 0;
    while left > 0 {
        if walk.len() >= next_report {
            report(1.0 - left as f64 / cells as f64, &walk)?;
            next_report = walk.len() + REPORT_EVERY;
        }
        let way = match field.next(at, heading) {
            Some(direction) => vec![at.step(direction)],
            // All free cells are connected, so a way exists while one is left.
            None => match seeker.nearest(&job.free, at, heading, |cell| field.is_left[cell]) {
                Some(way) => way,
                None => break,
            },
        };
        for cell in way {
            heading = at.direction_to(cell).unwrap_or(heading);
            at = cell;
            walk.push(cell);
        }
        if field.is_left[at] {
            left -= 1;
            field.visit(at);
        }
    }
    Ok(walk)
}

#[cfg(test)]
mod tests {
    use super::*;

    const WEIGHTS: Neural = Neural { straight: 0.5, lateral: 0.7, decay: 10.0, input: 100.0 };

    /// Section III of the paper: activities stay in [-D, B], dirty floor has the peaks, and activity spreads from
    /// there.
    #[test]
    fn activity_falls_with_the_distance_from_dirty_floor() {
        let free = Grid::filled(9, 1, true);
        let mut field = Field::new(&WEIGHTS, &free);
        (0..8).for_each(|x| field.visit(Cell::new(x, 0)));
        let activities: Vec<f64> = (0..9).map(|x| field.activity[Cell::new(x, 0)]).collect();
        assert!(activities.windows(2).all(|w| 0.0 < w[0] && w[0] < w[1]), "{activities:?}");
        assert!(activities[8] < B);
    }

    /// The shunting equation's right side is 0 at rest, within the tolerance.
    #[test]
    fn field_rests() {
        let free = robovac_core::floor_plan::generate::random_clutter(12, 9, 0.2, 3);
        let mut field = Field::new(&WEIGHTS, &free);
        let cells: Vec<Cell> = free.iter().filter(|&(_, &f)| f).map(|(cell, _)| cell).collect();
        cells.iter().step_by(2).for_each(|&cell| field.visit(cell));
        for &cell in &cells {
            let (x, rest) = (field.activity[cell], field.at_rest(cell));
            assert!((x - rest).abs() <= 4.0 * TOLERANCE * x.max(rest), "{cell}: {x}, {rest}");
        }
    }
}

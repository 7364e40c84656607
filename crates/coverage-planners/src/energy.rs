//! Energy functional: always moves to the neighbouring cell with the least "energy".
//!
//! By Bormann, Hampp & Hägele 2015, "New brooms sweep clean - an autonomous robotic cleaning assistant for professional
//! office cleaning" (ICRA); compared with others by Bormann, Jordan, Hampp & Hägele 2018, "Indoor coverage path planning:
//! survey, implementation, analysis" (ICRA), whose program is public (`ipa320/ipa_coverage_planning`,
//! `energy_functional_explorator`). From location l the robot goes to the unvisited location n beside it with the least
//! E(l, n) = `d_t` + `d_r` + N:
//!
//! - `d_t`, the distance in cells;
//! - `d_r`, the turn in quarter turns;
//! - N = 4 - half the number of visited locations among the eight around n: floor that is nearly clean draws the robot
//!   in, so that it keeps to what it has cleaned and leaves few islands.
//!
//! Where no neighbour is left it goes to the unvisited location of least E of the whole grid.
//!
//! # Where text and program disagree, and what is done here
//!
//! - The authors' published program has a fourth term, 0.72 - 0.09 for each blocked location among the eight: walls
//!   draw the robot too, less than clean floor. Its own description of the functional doesn't mention it. Kept, as the
//!   parameter *walls*.
//! - Neighbours are the four beside the cell, as a walk takes no diagonal steps; the program has eight.
//! - Where no neighbour is left it goes to the nearest unvisited cell by a shortest path. The program weighs the
//!   straight line, which may lead through a wall.
//! - It starts where the robot is; the program starts in the corner nearest to it and first turns the room so that its
//!   main direction lies along x. Here the walk is planned for each direction in which the robot may look at the start,
//!   with ties going to the left and to the right, and the cheapest is kept. At last detours over clean floor are cut
//!   short ([`shortcut`]). In rooms of more than 100,000 cells the first walk is taken as it is.
//!
//! Energies are whole numbers, in hundredths, so that ties are ties on every target.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("energy").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\no#v<\n^<><\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{Costs, MAX_CELLS_FOR_ALL, NearestGoalBfs, Reasons, Transit, shortcut, tell_walk},
};
use robovac_core::{
    grid::{Cell, Direction, Grid},
    registry::{Example, Explainer, ParamKind, ParamSpec},
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "energy",
    title: "Energy functional",
    summary: "Moves to the neighbour with the least energy: near, straight ahead, and surrounded by clean floor.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, in_metres: None, search: Search::None },
    params: &[
        weight("rotation", "Turning", "Energy of a quarter turn; a step costs 1.", 1.0),
        weight("visited", "Clean floor", "Energy bonus for each clean cell among the eight neighbours.", 0.5),
        weight("walls", "Walls", "Energy bonus for each wall cell among the eight neighbours.", 0.09),
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "Each cell beside the robot has an energy, and the robot moves to the one with the least. Distance and \
           turning raise the energy; clean cells and walls around the cell lower it. So the robot stays close to \
           cleaned floor, and lanes emerge by themselves.",
    complexity: "O(n) time and memory for n cells, plus a search for the nearest uncleaned cell at each dead end; \
                 repeated eight times in rooms of up to 100,000 cells.",
    use_when: "Simple, fast greedy planning that also works online. It looks only one step ahead, so it leaves \
               corners that it must return to.",
    shines: Example { room: "lshape", why: "One long meander round the corner, close to the best plan." },
    fails: Example { room: "maze", why: "It can't see dead ends and drives back for cells it missed." },
    source: "Bormann, Hampp & Hägele 2015, New brooms sweep clean, ICRA; \
             Bormann, Jordan, Hampp & Hägele 2018, Indoor coverage path planning, ICRA",
    link: "https://doi.org/10.1109/ICRA.2018.8460566",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    let hundredths = |id| (params.number(id) * HUNDRED).round() as i32;
    Box::new(Energy { rotation: hundredths("rotation"), visited: hundredths("visited"), walls: hundredths("walls") })
};

const HUNDRED: f64 = 100.0;

const fn weight(id: &'static str, label: &'static str, help: &'static str, default: f64) -> ParamSpec {
    ParamSpec { id, label, help, kind: ParamKind::Number { min: 0.0, max: 4.0, step: 0.01, default, unit: "" } }
}

/// The planner: weights in hundredths of the energy of a step.
struct Energy {
    rotation: i32,
    visited: i32,
    walls: i32,
}

/// The floor and the energies of its cells.
struct EnergyFloor<'a> {
    weights: &'a Energy,
    free: &'a Grid<bool>,
    is_left: Grid<bool>,
    /// Energy of a cell: all terms except distance and turn, without the constant common to all.
    drawn: Grid<i32>,
    /// Whether ties go to the left rather than to the right.
    is_left_first: bool,
}

impl EnergyFloor<'_> {
    fn visit(&mut self, cell: Cell) {
        self.is_left[cell] = false;
        for near in cell.block().filter(|&near| near != cell && self.free.is_set(near)) {
            self.drawn[near] -= self.weights.visited;
        }
    }

    /// Energy of moving straight to `cell` in `direction` while heading `heading`, without the distance.
    fn energy(&self, heading: Direction, direction: Direction, cell: Cell) -> i32 {
        self.weights.rotation * heading.quarter_turns(direction) as i32 + self.drawn[cell]
    }

    /// The direction to the neighbour of least energy.
    fn best(&self, at: Cell, heading: Direction) -> Option<Direction> {
        let (left, right) = (heading.left(), heading.right());
        let [first, second] = if self.is_left_first { [left, right] } else { [right, left] };
        [heading, first, second, heading.opposite()]
            .into_iter()
            .filter(|&direction| self.is_left.is_set(at.step(direction)))
            .min_by_key(|&direction| self.energy(heading, direction, at.step(direction)))
    }
}

impl Reasons for EnergyFloor<'_> {
    fn visit(&mut self, cell: Cell) {
        EnergyFloor::visit(self, cell);
    }

    fn values(&self, at: Cell, heading: Direction, open: &[Direction]) -> Vec<u32> {
        let energies = open.iter().map(|&look| self.energy(heading, look, at.step(look)));
        let least = energies.clone().min().unwrap_or(0);
        energies.map(|energy| (energy - least) as u32).collect()
    }

    fn rule(&self, _at: Cell, _heading: Direction, _towards: Direction) -> &'static str {
        "Energy above the least, in hundredths"
    }
}

/// Steps between two reports.
const REPORT_EVERY: usize = 4096;

impl Planner for Energy {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let costs = Costs::of(job);
        let is_large = job.cells() > MAX_CELLS_FOR_ALL;
        let tries = if is_large { 1 } else { 2 * Direction::ALL.len() };
        let mut best: Vec<Cell> = Vec::new();
        let mut heading = job.heading;
        for number in 0..tries {
            let is_left_first = number % 2 == 0;
            let walk = self.walk(job, heading, is_left_first, |done, walk| {
                ctx.checkpoint((number as f64 + done) / tries as f64, if best.is_empty() { walk } else { &best })
            })?;
            if best.is_empty() || costs.of_walk(job.heading, &walk) < costs.of_walk(job.heading, &best) {
                best = walk;
            }
            if !is_left_first {
                heading = heading.left();
            }
        }
        if !is_large {
            let mut transit = Transit::new(&job.free, costs);
            shortcut(job, costs, &mut transit, &mut best, |_| ctx.checkpoint(1.0, &[]))?;
        }
        if ctx.is_traced() {
            tell_walk(ctx, job, &best, &mut self.floor(&job.free, true));
        }
        Ok(CoveragePath::walk(best))
    }
}

impl Energy {
    /// The floor with nothing clean yet.
    fn floor<'a>(&'a self, free: &'a Grid<bool>, is_left_first: bool) -> EnergyFloor<'a> {
        let mut drawn = Grid::filled(free.width(), free.height(), 0);
        for (cell, _) in free.iter().filter(|&(_, &is_free)| is_free) {
            let walls = cell.block().filter(|&near| !free.is_set(near)).count();
            drawn[cell] = -self.walls * walls as i32;
        }
        EnergyFloor { weights: self, free, is_left: free.clone(), drawn, is_left_first }
    }

    /// The walk of a robot that looks in `heading` at the start.
    fn walk(
        &self,
        job: &CoverageJob,
        mut heading: Direction,
        is_left_first: bool,
        mut report: impl FnMut(f64, &[Cell]) -> Result<(), PlanError>,
    ) -> Result<Vec<Cell>, PlanError> {
        let free = &job.free;
        let mut floor = self.floor(free, is_left_first);
        let mut seeker = NearestGoalBfs::new(free);
        let cells = job.cells();
        let (mut walk, mut at) = (Vec::with_capacity(cells * 9 / 8), job.start);
        walk.push(at);
        floor.visit(at);
        let mut next_report = 0;
        for visited in 1..cells {
            if walk.len() >= next_report {
                report(visited as f64 / cells as f64, &walk)?;
                next_report = walk.len() + REPORT_EVERY;
            }
            if let Some(direction) = floor.best(at, heading) {
                (at, heading) = (at.step(direction), direction);
                walk.push(at);
            } else {
                // All free cells are connected, so a way exists while one is left.
                let Some(way) = seeker.nearest(free, at, heading, |cell| floor.is_left[cell]) else { break };
                walk.extend(way);
                let [.., before, last] = *walk else { break };
                heading = before.direction_to(last).unwrap_or(heading);
                at = last;
            }
            floor.visit(at);
        }
        Ok(walk)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The terms of the functional: E = `d_t` + `d_r` + N of Bormann et al. 2015, and the program's term for walls.
    #[test]
    fn energies_differ_as_the_functional_says() {
        let weights = Energy { rotation: 100, visited: 50, walls: 9 };
        let free = Grid::filled(5, 5, true);
        let drawn = Grid::filled(5, 5, 0);
        let mut floor =
            EnergyFloor { weights: &weights, free: &free, is_left: free.clone(), drawn, is_left_first: true };
        let energy = |floor: &EnergyFloor<'_>, d: Direction| floor.energy(Direction::Right, d, Cell::new(2, 2).step(d));
        floor.visit(Cell::new(2, 2));
        assert_eq!(energy(&floor, Direction::Up) - energy(&floor, Direction::Right), 100, "a quarter turn costs 1");
        assert_eq!(energy(&floor, Direction::Left) - energy(&floor, Direction::Right), 200, "turning round costs 2");
        floor.visit(Cell::new(3, 4));
        floor.visit(Cell::new(2, 4));
        assert_eq!(energy(&floor, Direction::Up), energy(&floor, Direction::Right), "two clean cells more take 1 off");
    }
}

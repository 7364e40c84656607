//! Improved snake: go straight, turn where the way is blocked or clean, towards the least-visited neighbour.
//!
//! By Emu & Obaida 2020 (thesis, East West University), section 4.2, Table 1 and the program in Appendix B. Every cell
//! has a value: unseen, 0 for seen from a neighbouring cell, then the number of visits. The robot
//!
//! 1. goes straight on while the cell ahead has not been visited;
//! 2. else turns left or right to the neighbour of smaller value, goes one step and turns the same way once more
//!    (which makes a lawn mower's U-turn) or wherever the smaller value is by then;
//! 3. between equal neighbours takes the side with the *smaller block*, the one with fewer cells still to be cleaned;
//! 4. with nowhere to turn to goes on over cleaned cells, or back.
//!
//! On the program's own room of 8 x 8 cells this planner walks exactly as the program does: 65 steps, 12 revisits.
//!
//! # Where text, flowchart and program disagree
//!
//! - *Smaller block.* The text compares "descendants" on both sides of the robot. The program counts, when the robot
//!   faces along x, the cells of value 0 in all rows above and below its row, and when it faces along y, cells of value 0
//!   *and unseen* ones in all columns left and right of its column. Equal counts: the side whose edge of the grid is
//!   nearer. Facing along x a side without any such cell loses; facing along y it wins. All of this is kept.
//! - *Back.* The text turns round and visits the previous cell. The program keeps a stack, but pops what it has just
//!   pushed: after a straight piece between a block and a cleaned cell it backs out by one cell without turning; between
//!   two blocks, and after a turn, "back" drives *ahead*. Kept, while the cell there is free. One refinement of the
//!   program is kept as well: it sees "block on one side, cleaned on the other" only when it faces along x.
//! - *Minimum valued neighbour forward.* The text compares values; the program compares row and column *indices*.
//!   Values are compared here; on the program's room both come to the same.
//! - *Values.* The text adds one a visit; the program adds one more in some of its branches and none in others. Here a
//!   value is the number of visits.
//! - *The end.* The text has none; the program ends when both counts are 0, which may be too early (the robot's own row
//!   or column isn't counted), and goes on in the callers of the function that ended. Here it ends when all is clean.
//!
//! # Where the rules don't lead on
//!
//! Off its own room the program leaves the grid, drives through blocks or goes in circles. Here a rule that would leave
//! the free cells is not followed, and cleaned cells are crossed by the rules for at most *patience* times the
//! number of steps to the nearest cell that isn't clean (8 steps of 10 in the program's room). After that the robot takes
//! a shortest way to that cell and starts again from rule 1. So every walk ends and covers all.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("snake").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\no#v<\n^<>^\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    TraceStep, stage::NearestGoalBfs,
};
use robovac_core::{
    grid::{Cell, Direction, Grid},
    registry::{Example, Explainer, ParamKind, ParamSpec},
};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "snake",
    title: "Improved snake",
    summary: "Drives straight until the next cell is blocked or clean, then turns to the least-visited neighbour.",
    source: "Emu & Obaida 2020, thesis, East West University: section 4.2 and Appendix B",
    link: "",
    explainer: Explainer {
        idea: "The robot counts its visits to every cell and drives straight while the cell ahead is new. Otherwise it \
               turns to the least-visited neighbour and turns once more, which makes a lawn mower's U-turn. Between \
               equal neighbours it takes the side with fewer uncleaned cells, so that no small corner remains.",
        complexity: "O(n) steps by the rules, each O(width + height); O(n) memory for n cells.",
        use_when: "Uses only neighbouring cells, so it runs online on a small controller. It leaves islands that it \
                   must return to.",
        shines: Example { room: "empty", why: "No obstacles: a lawn mower's U-turns from wall to wall." },
        fails: Example { room: "maze", why: "Branches that it passes stay uncleaned, so it keeps coming back." },
    },
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, traces: true, search: Search::None },
    params: &[ParamSpec {
        id: "patience",
        label: "Patience",
        help: "How far the rules can lead over clean floor, relative to the distance to the nearest uncleaned cell.",
        kind: ParamKind::Number { min: 0.0, max: 20.0, step: 1.0, default: 2.0, unit: "" },
    }],
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| Box::new(Snake { patience: params.number("patience") as usize });

/// The planner.
struct Snake {
    /// Steps over cleaned cells that the rules may take, for each step of the shortest way to a cell that isn't clean.
    patience: usize,
}

/// Which of the program's two decisions comes next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SnakePhase {
    /// Goes straight on if it can.
    Straight,
    /// Has just turned and gone one step: decides again at once, which completes a U-turn.
    Turned,
}

/// The reason for a move, for the animation of the search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SnakeRule {
    /// The cell ahead isn't clean.
    Ahead,
    /// One side has the smaller value, or is the only one that is open.
    SmallerNeighbour,
    /// Both sides have the same value; the side with fewer cells to be cleaned wins.
    SmallerBlock,
    /// Nowhere to turn to: on over cleaned cells.
    Forward,
    /// Nowhere to turn to: out backwards.
    Back,
}

/// A step by the rules.
#[derive(Debug, Clone, Copy)]
struct SnakeMove {
    rule: SnakeRule,
    /// Where to.
    towards: Direction,
    phase: SnakePhase,
}

/// Result of the program's `findMinimumNeighbour` for the cells left and right of the robot.
enum Sides {
    /// Both are blocked.
    Shut,
    /// Facing along x, one is blocked and the other cleaned.
    CleanedOrBlocked,
    /// Both have the same value.
    Equal,
    /// This one is better.
    Better(Direction),
}

/// Value of an unseen cell.
const UNSEEN: i32 = -1;
/// Value of a cell that has been seen but not visited.
const SEEN: i32 = 0;
/// Value of a blocked cell; more than any number of visits.
const BLOCKED: i32 = i32::MAX;

/// The robot's knowledge of the room, with the counts that the smaller-block rule compares.
struct SnakeMemory {
    values: Grid<i32>,
    /// Seen cells to be cleaned in every row.
    seen_in_row: Vec<u32>,
    /// Cells to be cleaned in every column, seen or not.
    left_in_column: Vec<u32>,
    /// Cells to be cleaned.
    left: usize,
}

impl Planner for Snake {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let mut memory = SnakeMemory::new(&job.free);
        let mut seeker = NearestGoalBfs::new(&job.free);
        let mut walk = Vec::with_capacity(2 * memory.left);
        let (mut at, mut facing, mut phase) = (job.start, job.heading, SnakePhase::Straight);
        // Steps over cleaned cells that the rules can still take; `None` while the robot cleans.
        let mut budget = None;
        let cells = memory.left as f64;
        let mut next_report = 0;
        memory.visit(at);
        walk.push(at);
        while memory.left > 0 {
            if walk.len() >= next_report {
                ctx.checkpoint(1.0 - memory.left as f64 / cells, &walk)?;
                next_report = walk.len() + REPORT_EVERY;
            }
            let is_left = |cell: Cell| (UNSEEN..=SEEN).contains(&memory.values[cell]);
            let chosen = Some(memory.choose(at, facing, phase)).filter(|m| job.free.is_set(at.step(m.towards)));
            let cleans = chosen.is_some_and(|m| is_left(at.step(m.towards)));
            let mut way = None;
            if cleans {
                budget = None;
            } else if budget.is_none() {
                way = seeker.nearest(&job.free, at, facing, is_left);
                budget = Some(self.patience * way.as_ref().map_or(0, Vec::len));
            }
            if let Some(step) = chosen.filter(|_| budget != Some(0)) {
                ctx.trace(|| memory.explain(walk.len() - 1, at, facing, step));
                at = at.step(step.towards);
                if step.rule != SnakeRule::Back {
                    facing = step.towards;
                }
                phase = step.phase;
                budget = budget.map(|b| b - 1);
                memory.visit(at);
                walk.push(at);
            } else {
                // All free cells are connected, so a way exists while one is left.
                let Some(way) = way.or_else(|| seeker.nearest(&job.free, at, facing, is_left)) else { break };
                let steps = way.len();
                for (i, cell) in way.into_iter().enumerate() {
                    facing = at.direction_to(cell).unwrap_or(facing);
                    ctx.trace(|| memory.explain_way(walk.len() - 1, at, facing, steps - i));
                    at = cell;
                    memory.visit(at);
                    walk.push(at);
                }
                (phase, budget) = (SnakePhase::Straight, None);
            }
        }
        Ok(CoveragePath { cells: walk })
    }
}

/// Steps between two reports.
const REPORT_EVERY: usize = 4096;

impl SnakeMemory {
    fn new(free: &Grid<bool>) -> Self {
        let mut left_in_column = vec![0; free.width()];
        for row in free.values().chunks(free.width()) {
            row.iter().zip(&mut left_in_column).for_each(|(&is_free, count)| *count += u32::from(is_free));
        }
        Self {
            values: free.map(|&is_free| if is_free { UNSEEN } else { BLOCKED }),
            seen_in_row: vec![0; free.height()],
            left: free.count(),
            left_in_column,
        }
    }

    /// The robot comes to `cell` and sees its neighbours.
    fn visit(&mut self, cell: Cell) {
        let (column, row) = (cell.x as usize, cell.y as usize);
        let value = self.values[cell];
        if value <= SEEN {
            self.left -= 1;
            self.left_in_column[column] -= 1;
            self.seen_in_row[row] -= u32::from(value == SEEN);
        }
        self.values[cell] = value.max(SEEN) + 1;
        for next in cell.neighbours() {
            if self.value(next) == UNSEEN {
                self.values[next] = SEEN;
                self.seen_in_row[next.y as usize] += 1;
            }
        }
    }

    /// Value of a cell; outside all is blocked.
    fn value(&self, cell: Cell) -> i32 {
        self.values.get(cell).copied().unwrap_or(BLOCKED)
    }

    /// The move by the printed rules; can lead into a block.
    fn choose(&self, at: Cell, facing: Direction, phase: SnakePhase) -> SnakeMove {
        if phase == SnakePhase::Straight && self.value(at.step(facing)) <= SEEN {
            return SnakeMove { rule: SnakeRule::Ahead, towards: facing, phase };
        }
        // The first turn is followed by a second one, the second one by going straight.
        let after_turn = if phase == SnakePhase::Straight { SnakePhase::Turned } else { SnakePhase::Straight };
        match self.sides(at, facing) {
            Sides::Better(side) => SnakeMove { rule: SnakeRule::SmallerNeighbour, towards: side, phase: after_turn },
            Sides::Equal => {
                SnakeMove { rule: SnakeRule::SmallerBlock, towards: self.smaller_block(at, facing), phase: after_turn }
            }
            Sides::CleanedOrBlocked if self.is_less_ahead(at, facing) => {
                SnakeMove { rule: SnakeRule::Forward, towards: facing, phase: SnakePhase::Turned }
            }
            Sides::CleanedOrBlocked if phase == SnakePhase::Straight => {
                SnakeMove { rule: SnakeRule::Back, towards: facing.opposite(), phase }
            }
            Sides::CleanedOrBlocked | Sides::Shut => {
                SnakeMove { rule: SnakeRule::Forward, towards: facing, phase: SnakePhase::Straight }
            }
        }
    }

    /// Compares the cells left and right of the robot, as `findMinimumNeighbour` does.
    fn sides(&self, at: Cell, facing: Direction) -> Sides {
        // In the program's order: right before left, down before up.
        let (first, second) =
            if facing.is_horizontal() { (Direction::Down, Direction::Up) } else { (Direction::Right, Direction::Left) };
        let (a, b) = (self.value(at.step(first)), self.value(at.step(second)));
        let is_inside = self.values.contains(at.step(first)) && self.values.contains(at.step(second));
        match (a == BLOCKED, b == BLOCKED) {
            (true, true) => Sides::Shut,
            (true, false) | (false, true) if facing.is_horizontal() && is_inside && a.min(b) > SEEN => {
                Sides::CleanedOrBlocked
            }
            _ if a == b => Sides::Equal,
            _ => Sides::Better(if a < b { first } else { second }),
        }
    }

    /// Whether the cell ahead has been visited less often than both cells beside the robot.
    fn is_less_ahead(&self, at: Cell, facing: Direction) -> bool {
        let beside = |side| self.value(at.step(side));
        self.value(at.step(facing)) < beside(facing.left()).min(beside(facing.right()))
    }

    /// The cells to be cleaned on both sides, as `countNumberOfZeros` counts them: above and below, or left and right.
    fn blocks(&self, at: Cell, facing: Direction) -> [(Direction, u32); 2] {
        let split = |counts: &[u32], line: i32| {
            let (before, after) = counts.split_at(line as usize);
            (before.iter().sum::<u32>(), after[1..].iter().sum::<u32>())
        };
        if facing.is_horizontal() {
            let (below, above) = split(&self.seen_in_row, at.y);
            [(Direction::Up, above), (Direction::Down, below)]
        } else {
            let (left, right) = split(&self.left_in_column, at.x);
            [(Direction::Left, left), (Direction::Right, right)]
        }
    }

    /// The side with fewer cells to be cleaned, by `bothNeighbourHasSameValueWhereShouldIGo`.
    fn smaller_block(&self, at: Cell, facing: Direction) -> Direction {
        let [(first, a), (second, b)] = self.blocks(at, facing);
        let (line, lines) = if facing.is_horizontal() {
            (self.seen_in_row.len() - 1 - at.y as usize, self.seen_in_row.len())
        } else {
            (at.x as usize, self.left_in_column.len())
        };
        let is_first = match (a, b) {
            // Facing along x a side without any such cell loses.
            (0, 1..) | (1.., 0) if facing.is_horizontal() => b == 0,
            _ if a == b => is_nearer_to_first_edge(line, lines),
            _ => a < b,
        };
        if is_first { first } else { second }
    }

    /// The values around the robot that aren't blocked.
    fn marks(&self, at: Cell) -> Vec<(Cell, u32)> {
        let open = at.neighbours().map(|cell| (cell, self.value(cell)));
        open.into_iter()
            .filter(|&(_, value)| value != BLOCKED)
            .map(|(cell, value)| (cell, value.max(SEEN) as u32))
            .collect()
    }

    /// A step by the rules, for the trace.
    fn explain(&self, step: usize, at: Cell, facing: Direction, chosen: SnakeMove) -> TraceStep {
        let SnakeMove { rule, towards, .. } = chosen;
        let to = name(towards);
        let value = |side| match self.value(at.step(side)) {
            BLOCKED => "a wall".to_owned(),
            SEEN => "not cleaned".to_owned(),
            visits => format!("cleaned {visits}x"),
        };
        let mut sides = None;
        let (rule, note) = match rule {
            SnakeRule::Ahead => ("Ahead", "The cell ahead is not cleaned: straight on".to_owned()),
            SnakeRule::SmallerNeighbour => {
                let (left, right) = (value(facing.left()), value(facing.right()));
                let turn = if towards == facing.left() { "left" } else { "right" };
                ("Smaller neighbour", format!("Left {left}, right {right}: turn {turn}"))
            }
            SnakeRule::SmallerBlock => {
                let blocks = self.blocks(at, facing);
                sides = Some(blocks);
                let [(first, a), (second, b)] = blocks;
                let (first, second) = (place(first), place(second));
                let choice = if a == b { "nearer edge" } else { "smaller block" };
                let note = format!("Left and right equal; cells to clean: {a} {first}, {b} {second}; {choice}: {to}");
                ("Smaller block", note)
            }
            SnakeRule::Forward => ("Forward", format!("No better neighbour on either side: straight on, {to}")),
            SnakeRule::Back => ("Back", "No better neighbour on either side or ahead: back".to_owned()),
        };
        TraceStep { step, rule: rule.into(), at, towards, marks: self.marks(at), sides, note }
    }

    /// A step of a shortest way, for the trace.
    fn explain_way(&self, step: usize, at: Cell, towards: Direction, left: usize) -> TraceStep {
        let steps = if left == 1 { "step" } else { "steps" };
        let note = format!("The rules lead nowhere: shortest path to the nearest uncleaned cell, {left} {steps} to go");
        TraceStep { step, rule: "Shortest path".into(), at, towards, marks: self.marks(at), sides: None, note }
    }
}

/// The words for a movement in a direction.
fn name(direction: Direction) -> &'static str {
    match direction {
        Direction::Right => "to the right",
        Direction::Up => "up",
        Direction::Left => "to the left",
        Direction::Down => "down",
    }
}

/// The words for a place in a direction.
fn place(direction: Direction) -> &'static str {
    match direction {
        Direction::Right => "on the right",
        Direction::Up => "above",
        Direction::Left => "on the left",
        Direction::Down => "below",
    }
}

/// The program's test for the top and the left edge: whether line `line` of `lines` is nearer to the first.
fn is_nearer_to_first_edge(line: usize, lines: usize) -> bool {
    line < lines - line
}

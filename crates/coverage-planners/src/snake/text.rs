//! The rules of the text.

use super::memory::{BLOCKED, SEEN, SnakeMemory, UNSEEN, name, place};
use crate::{CoverageJob, CoveragePath, PlanContext, PlanError, Planner, TraceStep, stage::NearestGoalBfs};
use robovac_core::grid::{Cell, Direction};

/// The planner with the rules of the text.
pub(super) struct SnakeByText {
    /// Steps over cleaned cells that the rules may take, for each step of the shortest way to a cell that isn't clean.
    pub patience: usize,
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

impl Planner for SnakeByText {
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
        Ok(CoveragePath::walk(walk))
    }
}

/// Steps between two reports.
const REPORT_EVERY: usize = 4096;

impl SnakeMemory {
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

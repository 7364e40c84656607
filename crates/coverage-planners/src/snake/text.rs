//! The planner by the rules of the text.

use super::{
    memory::{BLOCKED, SEEN, SnakeMemory},
    walk::{SnakeMove, SnakeRule, SnakeStep, SnakeWalk},
};
use crate::{
    CoverageJob, CoveragePath, PlanContext, PlanError, Planner, TraceStep,
    stage::{NearestGoalBfs, going, place},
};
use robovac_core::grid::{Cell, Direction};

/// The planner with the rules of the text.
pub(super) struct SnakeByText {
    /// Steps over cleaned cells that the rules may take, for each step of the shortest way to a cell that isn't clean.
    pub patience: usize,
}

/// Steps between two reports.
const REPORT_EVERY: usize = 4096;

impl Planner for SnakeByText {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let mut snake = SnakeWalk::new(SnakeMemory::new(&job.free), job.start, job.heading, self.patience);
        let mut seeker = NearestGoalBfs::new(&job.free);
        let cells = job.free.count() as f64;
        let mut walk = Vec::with_capacity(2 * job.free.count());
        let mut next_report = 0;
        walk.push(snake.at);
        while snake.memory.left > 0 {
            if walk.len() >= next_report {
                ctx.checkpoint(1.0 - snake.memory.left as f64 / cells, &walk)?;
                next_report = walk.len() + REPORT_EVERY;
            }
            // All free cells are connected, so a way exists while one is left.
            let Some(step) = snake.choose(&job.free, &mut seeker) else { break };
            ctx.trace(|| snake.explain(walk.len() - 1, step));
            snake.take(step);
            walk.push(snake.at);
        }
        Ok(CoveragePath::walk(walk))
    }
}

impl SnakeWalk {
    fn explain(&self, number: usize, step: SnakeStep) -> TraceStep {
        match step {
            SnakeStep::Rule(step) => self.memory.explain(number, self.at, self.facing, step),
            SnakeStep::Way(towards, left) => self.memory.explain_way(number, self.at, towards, left),
        }
    }
}

impl SnakeMemory {
    /// A step by the rules, for the trace.
    fn explain(&self, step: usize, at: Cell, facing: Direction, chosen: SnakeMove) -> TraceStep {
        let SnakeMove { rule, towards, .. } = chosen;
        let to = going(towards);
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

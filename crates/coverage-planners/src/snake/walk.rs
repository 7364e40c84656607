//! A walk by the rules of the text, step by step, on what is known of the room.

use super::memory::{BLOCKED, SEEN, SnakeMemory};
use crate::stage::NearestGoalBfs;
use robovac_core::grid::{Cell, Direction, Grid};

/// Which of the program's two decisions comes next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SnakePhase {
    /// Goes straight on if it can.
    Straight,
    /// Has just turned and gone one step: decides again at once, which completes a U-turn.
    Turned,
}

/// The reason for a move, for the animation of the search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SnakeRule {
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
pub(super) struct SnakeMove {
    pub rule: SnakeRule,
    /// Where to.
    pub towards: Direction,
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

/// The next step of a walk.
#[derive(Debug, Clone, Copy)]
pub(super) enum SnakeStep {
    /// By the rules.
    Rule(SnakeMove),
    /// On a shortest way to the nearest cell that isn't clean, with so many steps to go.
    Way(Direction, usize),
}

impl SnakeStep {
    /// Whether the rules lead straight on after it, over cells that aren't clean.
    pub(super) fn goes_straight(self) -> bool {
        matches!(self, Self::Rule(SnakeMove { phase: SnakePhase::Straight, rule, .. }) if rule != SnakeRule::Back)
    }

    pub(super) fn towards(self) -> Direction {
        match self {
            Self::Rule(SnakeMove { towards, .. }) | Self::Way(towards, _) => towards,
        }
    }
}

/// A walk in progress.
#[derive(Debug, Clone)]
pub(super) struct SnakeWalk {
    pub memory: SnakeMemory,
    pub at: Cell,
    pub facing: Direction,
    phase: SnakePhase,
    /// Steps over cleaned cells that the rules may take, for each step of the shortest way to a cell that isn't clean.
    patience: usize,
    /// How many of them are left; `None` while the robot cleans.
    budget: Option<usize>,
    /// The rest of a shortest way, its next cell last.
    way: Vec<Cell>,
}

impl SnakeWalk {
    /// Starts on a free cell.
    pub(super) fn new(mut memory: SnakeMemory, at: Cell, facing: Direction, patience: usize) -> Self {
        memory.visit(at);
        Self { memory, at, facing, phase: SnakePhase::Straight, patience, budget: None, way: Vec::new() }
    }

    /// The next step; `None` if no cell that isn't clean can be reached over `free` cells.
    pub(super) fn choose(&mut self, free: &Grid<bool>, seeker: &mut NearestGoalBfs) -> Option<SnakeStep> {
        if self.way.is_empty() {
            let chosen = Some(self.memory.choose(self.at, self.facing, self.phase));
            let chosen = chosen.filter(|m| free.is_set(self.at.step(m.towards)));
            let is_left = |cell| self.memory.is_left(cell);
            let mut way = None;
            if chosen.is_some_and(|m| is_left(self.at.step(m.towards))) {
                self.budget = None;
            } else if self.budget.is_none() {
                way = seeker.nearest(free, self.at, self.facing, is_left);
                self.budget = Some(self.patience * way.as_ref().map_or(0, Vec::len));
            }
            if let Some(step) = chosen.filter(|_| self.budget != Some(0)) {
                return Some(SnakeStep::Rule(step));
            }
            self.way = way.or_else(|| seeker.nearest(free, self.at, self.facing, is_left))?;
            self.way.reverse();
        }
        let next = *self.way.last()?;
        Some(SnakeStep::Way(self.at.direction_to(next)?, self.way.len()))
    }

    /// Takes the step that was chosen.
    pub(super) fn take(&mut self, step: SnakeStep) {
        self.at = self.at.step(step.towards());
        match step {
            SnakeStep::Rule(SnakeMove { rule, towards, phase }) => {
                if rule != SnakeRule::Back {
                    self.facing = towards;
                }
                self.phase = phase;
                self.budget = self.budget.map(|left| left - 1);
            }
            SnakeStep::Way(towards, _) => {
                self.facing = towards;
                self.way.pop();
                if self.way.is_empty() {
                    (self.phase, self.budget) = (SnakePhase::Straight, None);
                }
            }
        }
        self.memory.visit(self.at);
    }

    /// Gives up the way that it is on: a cell of it is blocked.
    pub(super) fn forget_way(&mut self) {
        self.way.clear();
        self.budget = None;
    }

    /// The number of cells ahead on the shortest way that it is on, until it turns.
    pub(super) fn straight_way(&self) -> usize {
        let (mut at, mut towards, mut cells) = (self.at, None, 0);
        for &next in self.way.iter().rev() {
            let direction = at.direction_to(next);
            if towards.is_some() && direction != towards {
                break;
            }
            (at, towards, cells) = (next, direction, cells + 1);
        }
        cells
    }
}

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
        let is_inside = self.is_inside(at.step(first)) && self.is_inside(at.step(second));
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
}

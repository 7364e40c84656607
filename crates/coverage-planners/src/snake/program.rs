//! The rules of the program in Appendix B, to the letter.
//!
//! A line of the program and what stands here for it, where they aren't the same at first sight:
//!
//! - *Values.* `inf` is `UNSEEN`, `block` is `BLOCKED`. The program adds one to a cell when it enters `makeMove` and
//!   once more in some branches; a cell that it passes after a second turn can stay 0, and so count as not cleaned.
//! - *Calls.* `makeMove` calls itself at every step. When one of the calls returns, all the callers go on where they
//!   are: here they wait in a list.
//! - *Missing returns.* A function that ends without a `return` returns false, or 0 as the number of a direction.
//! - *Minimum valued neighbour forward.* `minimumValueForward` compares the index of the column ahead with those of the
//!   rows above and below. It is called only while the robot faces along x, so its other half never runs.
//! - *Go back.* `goBack` jumps to the cell on top of the stack. Every move pushes the cell that it leads to, so after a
//!   move "back" goes nowhere; after a push of the cell behind or ahead it goes there.
//! - *Neither of both neighbours* (`moreThanOneSameNeighbor` after case 7) can't be true, as one of them is a block and
//!   the other isn't.
//! - *A room that isn't square.* The program has one number for both sides; here columns are compared with the
//!   width and rows with the height.
//!
//! The program ends where it calls `exit` or its last call returns. Here it also ends when all cells are visited, and
//! where a robot could not follow: see [`Ending`].

use super::memory::{BLOCKED, SEEN, SnakeMemory};
use crate::{CoverageJob, CoveragePath, PlanContext, PlanError, Planner, THE_END, TraceStep, stage::going};
use robovac_core::grid::{Cell, Direction, Grid};
use std::fmt;

/// The planner with the rules of the program.
pub(super) struct SnakeByProgram;

/// Why a walk of the program ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ending {
    /// All cells are visited.
    AllVisited,
    /// The program says that it is complete.
    SaysComplete,
    /// The last call has returned.
    Returned,
    /// It would leave the grid.
    LeavesGrid,
    /// It would enter a block.
    EntersBlock,
    /// It would go back to a cell that isn't beside the robot.
    Jumps,
    /// It visits no new cell any more, as far as can be told.
    Circles,
}

/// What stops the program: its end, or whoever watches it.
enum Stop {
    End(Ending),
    Cancelled(PlanError),
}

/// What the program does next.
#[derive(Debug, Clone, Copy)]
enum NextStep {
    /// Calls `makeMove`.
    Move,
    /// Goes to the label `secondturn`.
    SecondTurn,
    /// Returns to the caller.
    Return,
}

/// Where a caller of `makeMove` goes on when the call returns. Calls at the end of `makeMove` need none.
#[derive(Debug, Clone, Copy)]
enum Caller {
    /// At the label `secondturn`.
    SecondTurn,
    /// After backing out: the branch of a neighbour found, though none was.
    TurnAfterBack,
    /// After backing out at `secondturn`: the same there.
    AheadAfterBack,
}

/// Result of `findMinimumNeighbour`.
#[derive(Debug, Clone, Copy)]
enum MinimumNeighbour {
    /// 0: neither neighbour is inside the grid.
    None,
    /// 1 to 4.
    Neighbour(Direction),
    /// 5: blocked.
    Back,
    /// 6: both have the same value.
    Equal,
    /// 7: one is blocked, the other cleaned.
    CleanedOrBlocked,
}

/// Steps without a new cell after which the walk counts as circling: so many for each cell of the room, and some more.
/// In some 100,000 random rooms of 3 to 20 cells on a side in which the program went on to visit all, it never took more than 6
/// steps for each cell of the room to find a new one.
const CIRCLING: (usize, usize) = (8, 200);

/// Steps between two reports.
const REPORT_EVERY: usize = 4096;

/// The state of the program.
struct PrintedProgram<'a, 'b> {
    memory: SnakeMemory,
    at: Cell,
    facing: Direction,
    /// `prevX` and `prevY`.
    stack: Vec<Cell>,
    callers: Vec<Caller>,
    walk: Vec<Cell>,
    visited: Grid<bool>,
    cells: usize,
    /// Cells still to be visited.
    left: usize,
    /// Length of the walk up to the last new cell.
    useful: usize,
    /// Decisions for the animation, if anybody watches.
    trace: Option<Vec<TraceStep>>,
    ctx: &'a mut PlanContext<'b>,
}

impl Planner for SnakeByProgram {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let mut program = PrintedProgram::new(job, ctx);
        let ending = match program.run(job) {
            Stop::End(ending) => ending,
            Stop::Cancelled(error) => return Err(error),
        };
        Ok(CoveragePath::walk(program.finish(ending)))
    }

    fn is_complete(&self) -> bool {
        false
    }
}

impl<'a, 'b> PrintedProgram<'a, 'b> {
    fn new(job: &CoverageJob, ctx: &'a mut PlanContext<'b>) -> Self {
        let cells = job.cells();
        Self {
            memory: SnakeMemory::new(&job.free),
            at: job.start,
            facing: job.heading,
            stack: Vec::new(),
            callers: Vec::new(),
            walk: Vec::with_capacity(2 * cells),
            visited: job.free.map(|_| false),
            cells,
            left: cells,
            useful: 0,
            trace: ctx.is_traced().then(Vec::new),
            ctx,
        }
    }

    /// Runs the program to its end.
    fn run(&mut self, job: &CoverageJob) -> Stop {
        // `main` sets the start to 0 before the first call.
        self.memory.see(job.start);
        let mut next = self.arrive().map(|()| NextStep::Move);
        loop {
            next = match next {
                Ok(NextStep::Move) => self.make_move(),
                Ok(NextStep::SecondTurn) => self.second_turn(),
                Ok(NextStep::Return) => self.go_on(),
                Err(stop) => return stop,
            };
        }
    }

    /// The walk; without the circles at its end, as they could go on for ever.
    fn finish(mut self, ending: Ending) -> Vec<Cell> {
        if ending == Ending::Circles {
            self.walk.truncate(self.useful);
        }
        let last = self.walk.len() - 1;
        for step in self.trace.take().into_iter().flatten().filter(|step| step.step < last) {
            self.ctx.trace(|| step);
        }
        if ending != Ending::AllVisited {
            let (at, towards) = (self.walk[last], self.facing);
            self.ctx.trace(|| TraceStep {
                step: last,
                rule: THE_END.into(),
                at,
                towards,
                marks: Vec::new(),
                sides: None,
                note: ending.to_string(),
            });
        }
        self.walk
    }

    // ---- makeMove

    /// `makeMove` up to its label.
    fn make_move(&mut self) -> Result<NextStep, Stop> {
        self.memory.raise(self.at);
        self.memory.see_around(self.at);
        if self.memory.value(self.ahead()) <= SEEN {
            self.advance("Ahead", "The cell ahead is not cleaned: straight on")?;
            return Ok(self.call(Caller::SecondTurn));
        }
        match self.find_minimum_neighbour() {
            MinimumNeighbour::CleanedOrBlocked if self.is_minimum_forward() => {
                self.memory.raise(self.at);
                self.stack.push(self.behind());
                self.explain(
                    "Forward",
                    self.facing,
                    "The column ahead has a smaller index than both rows: straight on",
                );
                self.at = self.ahead();
                self.arrive()?;
                self.memory.see_around(self.at);
                Ok(NextStep::SecondTurn)
            }
            MinimumNeighbour::CleanedOrBlocked => {
                self.stack.push(self.behind());
                let note = "A row has a smaller index than the column ahead: back to the cell behind";
                self.explain("Back", self.facing.opposite(), note);
                self.go_back()?;
                Ok(self.call(Caller::TurnAfterBack))
            }
            MinimumNeighbour::Back => {
                self.memory.raise(self.at);
                self.stack.push(self.ahead());
                self.explain(
                    "Back",
                    self.facing,
                    "Blocked on both sides: \"back\", to the cell ahead that was pushed last",
                );
                self.go_back()?;
                Ok(self.call(Caller::SecondTurn))
            }
            MinimumNeighbour::Equal => {
                let side = self.smaller_block().ok_or(Stop::End(Ending::SaysComplete))?;
                self.turn_to_block(side)?;
                Ok(self.turned())
            }
            MinimumNeighbour::Neighbour(side) => {
                self.facing = side;
                self.smaller_block().ok_or(Stop::End(Ending::SaysComplete))?;
                self.advance("Smaller neighbour", "The neighbour on this side has the smaller value")?;
                Ok(self.turned())
            }
            MinimumNeighbour::None => self.first_turn_without_neighbour(),
        }
    }

    /// The last branch of the first turn without a neighbour to turn to: ahead, whatever is there.
    fn first_turn_without_neighbour(&mut self) -> Result<NextStep, Stop> {
        self.smaller_block().ok_or(Stop::End(Ending::SaysComplete))?;
        self.advance("Ahead", "No neighbour was found, but the program continues as if one had been: straight on")?;
        Ok(self.turned())
    }

    /// After the step of a first turn.
    fn turned(&mut self) -> NextStep {
        self.memory.raise(self.at);
        self.memory.see_around(self.at);
        NextStep::SecondTurn
    }

    /// `makeMove` from its label `secondturn`.
    fn second_turn(&mut self) -> Result<NextStep, Stop> {
        match self.find_minimum_neighbour() {
            MinimumNeighbour::CleanedOrBlocked if self.is_minimum_forward() => {
                self.memory.raise(self.at);
                self.advance("Forward", "The column ahead has a smaller index than both rows: straight on")?;
                self.memory.see_around(self.at);
                return Ok(NextStep::SecondTurn);
            }
            MinimumNeighbour::CleanedOrBlocked => {
                self.memory.raise(self.at);
                self.memory.see_around(self.at);
                self.stack.push(self.ahead());
                let note =
                    "A row has a smaller index than the column ahead: \"back\", to the cell ahead that was pushed last";
                self.explain("Back", self.facing, note);
                self.go_back()?;
                return Ok(self.call(Caller::AheadAfterBack));
            }
            MinimumNeighbour::Back => {
                self.memory.raise(self.at);
                self.memory.see_around(self.at);
                self.explain("Back", self.facing, "Blocked on both sides: \"back\", to the last cell pushed");
                self.go_back()?;
                self.advance("Ahead", "After going \"back\" the program goes straight on")?;
            }
            MinimumNeighbour::Equal => {
                let Some(side) = self.smaller_block() else { return Ok(NextStep::Return) };
                self.turn_to_block(side)?;
            }
            MinimumNeighbour::Neighbour(side) => {
                self.facing = side;
                self.advance("Smaller neighbour", "The neighbour on this side has the smaller value")?;
            }
            MinimumNeighbour::None => self.advance("Ahead", "No neighbour is inside the grid: straight on")?,
        }
        Ok(NextStep::Move)
    }

    /// A call that isn't the last thing its caller does.
    fn call(&mut self, caller: Caller) -> NextStep {
        self.callers.push(caller);
        NextStep::Move
    }

    /// A call has returned.
    fn go_on(&mut self) -> Result<NextStep, Stop> {
        match self.callers.pop().ok_or(Stop::End(Ending::Returned))? {
            Caller::SecondTurn => Ok(NextStep::SecondTurn),
            Caller::TurnAfterBack => self.first_turn_without_neighbour(),
            Caller::AheadAfterBack => {
                self.advance("Ahead", "The call has returned, and its caller continues: straight on")?;
                Ok(NextStep::Move)
            }
        }
    }

    // ---- decisions

    fn ahead(&self) -> Cell {
        self.at.step(self.facing)
    }

    fn behind(&self) -> Cell {
        self.at.step(self.facing.opposite())
    }

    fn find_minimum_neighbour(&self) -> MinimumNeighbour {
        let (first, second) = if self.facing.is_horizontal() {
            (Direction::Down, Direction::Up)
        } else {
            (Direction::Right, Direction::Left)
        };
        let value = |side| self.memory.values.get(self.at.step(side)).copied();
        match (value(first), value(second)) {
            (None, None) => MinimumNeighbour::None,
            (Some(BLOCKED), None | Some(BLOCKED)) | (None, Some(BLOCKED)) => MinimumNeighbour::Back,
            (Some(BLOCKED), Some(1..)) | (Some(1..), Some(BLOCKED)) if self.facing.is_horizontal() => {
                MinimumNeighbour::CleanedOrBlocked
            }
            (Some(_), None | Some(BLOCKED)) => MinimumNeighbour::Neighbour(first),
            (None | Some(BLOCKED), Some(_)) => MinimumNeighbour::Neighbour(second),
            (Some(a), Some(b)) if a == b => MinimumNeighbour::Equal,
            (Some(a), Some(b)) => MinimumNeighbour::Neighbour(if a < b { first } else { second }),
        }
    }

    /// `minimumValueForward` of a robot that faces along x: indices are compared, rows counted from the top.
    fn is_minimum_forward(&self) -> bool {
        let ahead = self.ahead().x;
        let row_above = self.memory.values.height() as i32 - 1 - self.at.y - 1;
        let is_compared = match self.facing {
            Direction::Right => ahead < self.memory.values.width() as i32,
            _ => ahead > 0,
        };
        // Where the row above has a larger index, the row below has one, too.
        is_compared && row_above > ahead
    }

    /// The side with the smaller block; `None` if there is nothing to clean on both sides.
    fn smaller_block(&self) -> Option<Direction> {
        let is_any = self.memory.blocks(self.at, self.facing).iter().any(|&(_, cells)| cells > 0);
        is_any.then(|| self.memory.smaller_block(self.at, self.facing))
    }

    // ---- moves

    fn turn_to_block(&mut self, side: Direction) -> Result<(), Stop> {
        let sides = self.memory.blocks(self.at, self.facing);
        let note = format!("Left and right equal; the smaller block decides: {}", going(side));
        self.facing = side;
        self.explain("Smaller block", side, &note);
        if let Some(step) = self.trace.as_mut().and_then(|steps| steps.last_mut()) {
            step.sides = Some(sides);
        }
        self.enter()
    }

    /// Goes one step ahead, which the stack records.
    fn advance(&mut self, rule: &'static str, note: &str) -> Result<(), Stop> {
        self.explain(rule, self.facing, note);
        self.enter()
    }

    fn enter(&mut self) -> Result<(), Stop> {
        self.stack.push(self.ahead());
        self.at = self.ahead();
        self.arrive()
    }

    /// `goBack`.
    fn go_back(&mut self) -> Result<(), Stop> {
        // Never empty: every way here pushes first.
        if let Some(cell) = self.stack.pop() {
            self.at = cell;
        }
        self.arrive()
    }

    /// The program has changed its position.
    fn arrive(&mut self) -> Result<(), Stop> {
        let last = self.walk.last().copied();
        if last == Some(self.at) {
            return Ok(());
        }
        if !self.memory.values.contains(self.at) {
            return Err(Stop::End(Ending::LeavesGrid));
        }
        if self.memory.value(self.at) == BLOCKED {
            return Err(Stop::End(Ending::EntersBlock));
        }
        if last.is_some_and(|last| last.direction_to(self.at).is_none()) {
            return Err(Stop::End(Ending::Jumps));
        }
        if self.walk.len().is_multiple_of(REPORT_EVERY) {
            let done = 1.0 - self.left as f64 / self.cells as f64;
            self.ctx.checkpoint(done, &self.walk).map_err(Stop::Cancelled)?;
        }
        self.walk.push(self.at);
        if !std::mem::replace(&mut self.visited[self.at], true) {
            self.left -= 1;
            self.useful = self.walk.len();
        }
        let (each, more) = CIRCLING;
        match self.walk.len() - self.useful {
            _ if self.left == 0 => Err(Stop::End(Ending::AllVisited)),
            circling if circling > each * self.cells + more => Err(Stop::End(Ending::Circles)),
            _ => Ok(()),
        }
    }

    /// Remembers a decision. One that leads nowhere is replaced by the next at the same place.
    fn explain(&mut self, rule: &'static str, towards: Direction, note: &str) {
        let Some(steps) = &mut self.trace else { return };
        let step = self.walk.len() - 1;
        if steps.last().is_some_and(|last| last.step == step) {
            steps.pop();
        }
        let marks = self.memory.marks(self.at);
        steps.push(TraceStep {
            step,
            rule: rule.into(),
            at: self.at,
            towards,
            marks,
            sides: None,
            note: note.to_owned(),
        });
    }
}

impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::AllVisited => "All cells are visited",
            Self::SaysComplete => "The program ends here: it says that it is complete",
            Self::Returned => "The program ends here: its last call has returned",
            Self::LeavesGrid => "The walk ends here: the program would leave the grid",
            Self::EntersBlock => "The walk ends here: the program would enter a blocked cell",
            Self::Jumps => "The walk ends here: the program would jump back to a cell further away",
            Self::Circles => "The walk ends here: the program would go in circles and find no other cell",
        })
    }
}

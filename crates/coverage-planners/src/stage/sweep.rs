//! Stage: parallel lanes through one block.
//!
//! It drives along every run from end to end, then steps into the next one. Where the runs of a block differ in length it
//! drives back to where it can step over, or out to the end that it missed; which end of each run to finish at is
//! chosen by dynamic programming, so that this costs least.

use super::{
    cost::Costs,
    decompose::{Block, CellRun, RunSide},
};
use robovac_core::grid::{Cell, Direction};

/// A way through a block: its ends and its cost.
#[derive(Debug, Clone, Copy)]
pub struct BlockSweep {
    /// First cell: an end of the first run of the way.
    pub entry: Cell,
    /// Direction of its first step; `None` if it has no step.
    pub entering: Option<Direction>,
    /// Last cell: an end of the last run of the way.
    pub exit: Cell,
    /// Direction of its last step; `None` if it has no step.
    pub leaving: Option<Direction>,
    /// Cost of steps and turns between.
    pub cost: u32,
}

impl BlockSweep {
    /// The same way driven backwards.
    fn reversed(self) -> Self {
        Self {
            entry: self.exit,
            entering: self.leaving.map(Direction::opposite),
            exit: self.entry,
            leaving: self.entering.map(Direction::opposite),
            cost: self.cost,
        }
    }
}

/// Number of ways through a block: entered at one end of the lowest run and left at one end of the highest, or the same
/// backwards.
pub const SWEEPS: usize = 8;
/// Ways that go up; the others are these backwards, exactly, so that turning round a part of a tour changes nothing in it.
const UPWARDS: usize = SWEEPS / 2;

/// The way that drives sweep number `sweep` backwards.
pub const fn reversed(sweep: usize) -> usize {
    (sweep + UPWARDS) % SWEEPS
}

/// All ways through `block`; [`append_sweep`] drives them.
pub fn sweeps_of(block: &Block, costs: Costs) -> [BlockSweep; SWEEPS] {
    let upwards = RunSide::BOTH.map(|entry| {
        finish(block, entry, costs, |_| {}).map(|state| BlockSweep {
            entry: block[0].end(entry),
            entering: state.first,
            exit: state.at,
            leaving: state.heading,
            cost: state.cost,
        })
    });
    std::array::from_fn(|number| {
        let up = number % UPWARDS;
        let sweep = upwards[entry_side(up) as usize][exit_side(up) as usize];
        if number < UPWARDS { sweep } else { sweep.reversed() }
    })
}

/// Appends the cells of sweep number `number` to `walk`; its first cell only if the walk doesn't end there already.
pub fn append_sweep(block: &Block, number: usize, costs: Costs, walk: &mut Vec<Cell>) {
    let up = number % UPWARDS;
    let mut chosen_before: Vec<[RunSide; 2]> = Vec::with_capacity(block.len());
    finish(block, entry_side(up), costs, |before| chosen_before.push(before));
    // The end at which each run is finished, from the last one back.
    let mut side = exit_side(up);
    let mut sides: Vec<RunSide> = Vec::with_capacity(block.len());
    for before in chosen_before.iter().rev() {
        sides.push(side);
        side = before[side as usize];
    }
    let start = walk.len();
    let mut at = block[0].end(entry_side(up));
    walk.push(at);
    for (&run, side) in block.iter().zip(sides.into_iter().rev()) {
        if run.y != at.y {
            let crossing = at.x.clamp(run.left, run.right);
            drive(walk, &mut at, crossing);
            at.y = run.y;
            walk.push(at);
        }
        drive(walk, &mut at, run.end(side.other()).x);
        drive(walk, &mut at, run.end(side).x);
    }
    if number >= UPWARDS {
        walk[start..].reverse();
    }
    if start > 0 && walk[start - 1] == walk[start] {
        walk.remove(start);
    }
}

/// Drives along a row.
fn drive(walk: &mut Vec<Cell>, at: &mut Cell, x: i32) {
    while at.x != x {
        at.x += (x - at.x).signum();
        walk.push(*at);
    }
}

fn entry_side(sweep: usize) -> RunSide {
    RunSide::BOTH[sweep >> 1 & 1]
}

fn exit_side(sweep: usize) -> RunSide {
    RunSide::BOTH[sweep & 1]
}

/// The cheapest way so far that ends at one end of a run.
#[derive(Debug, Clone, Copy)]
struct SweepState {
    cost: u32,
    at: Cell,
    first: Option<Direction>,
    heading: Option<Direction>,
}

impl SweepState {
    fn turn_and_go(&mut self, direction: Direction, steps: u32, costs: Costs) {
        if steps > 0 {
            self.cost += steps * costs.step + self.heading.map_or(0, |h| h.quarter_turns(direction)) * costs.turn;
            self.first = self.first.or(Some(direction));
            self.heading = Some(direction);
            let (dx, dy) = direction.offset();
            self.at = Cell::new(self.at.x + dx * steps as i32, self.at.y + dy * steps as i32);
        }
    }

    fn drive(&mut self, x: i32, costs: Costs) {
        let direction = if x > self.at.x { Direction::Right } else { Direction::Left };
        self.turn_and_go(direction, x.abs_diff(self.at.x), costs);
    }

    /// Steps over into `run`, drives along all of it and ends at `side`.
    fn cover(mut self, run: CellRun, side: RunSide, costs: Costs) -> Self {
        if run.y != self.at.y {
            self.drive(self.at.x.clamp(run.left, run.right), costs);
            self.turn_and_go(Direction::Up, 1, costs);
        }
        self.drive(run.end(side.other()).x, costs);
        self.drive(run.end(side).x, costs);
        self
    }
}

/// Dynamic programming over the runs: the best ways that end at the left and at the right end of the last run. Calls
/// `chosen` for every run with the ends at which the run before was finished, if this one is finished left and right.
fn finish(block: &Block, entry: RunSide, costs: Costs, mut chosen: impl FnMut([RunSide; 2])) -> [SweepState; 2] {
    let start = SweepState { cost: 0, at: block[0].end(entry), first: None, heading: None };
    let mut states = [start; 2];
    for &run in block {
        let options = RunSide::BOTH.map(|side| states.map(|state| state.cover(run, side, costs)));
        let before =
            options.each_ref().map(|[left, right]| if right.cost < left.cost { RunSide::Right } else { RunSide::Left });
        chosen(before);
        states = [options[0][before[0] as usize], options[1][before[1] as usize]];
    }
    states
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::decompose;
    use robovac_core::grid::{Grid, from_picture};

    const COSTS: Costs = Costs { step: 16, turn: 32 };

    fn block(text: &str) -> (Grid<bool>, Block) {
        let free = from_picture(text, |c| c == '.').unwrap();
        let block = decompose(&free, i32::MAX).remove(0);
        (free, block)
    }

    #[test]
    fn every_sweep_covers_and_costs_what_it_says() {
        for text in ["....\n....\n....", "#..#\n....\n.###\n..##\n...#", ".", ".\n.\n.", "..#\n#..\n"] {
            let (free, block) = block(text);
            for (number, sweep) in sweeps_of(&block, COSTS).into_iter().enumerate() {
                let mut walk = Vec::new();
                append_sweep(&block, number, COSTS, &mut walk);
                assert_eq!((walk[0], walk[walk.len() - 1]), (sweep.entry, sweep.exit));
                assert!(walk.windows(2).all(|w| w[0].direction_to(w[1]).is_some() && free.is_set(w[1])));
                assert!(free.iter().all(|(cell, &f)| !f || walk.contains(&cell)));
                let heading = sweep.entering.unwrap_or(Direction::Up);
                assert_eq!(u64::from(sweep.cost), COSTS.of_walk(heading, &walk), "{text} {number}");
            }
        }
    }

    #[test]
    fn backwards_it_goes_from_exit_to_entry() {
        let (_, block) = block("#..#\n....\n.###\n..##\n...#");
        let sweeps = sweeps_of(&block, COSTS);
        for (number, sweep) in sweeps.iter().enumerate() {
            let back = &sweeps[reversed(number)];
            assert_eq!((sweep.entry, sweep.exit), (back.exit, back.entry));
            assert_eq!(reversed(reversed(number)), number);
        }
    }
}

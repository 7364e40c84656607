//! What steps and turns cost, in whole numbers, so that sums don't depend on their order.

use crate::{
    grid::{Cell, Direction},
    planner::CoverageJob,
};

/// Costs in units of 1/16 of the time of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Costs {
    /// One step straight on.
    pub step: u32,
    /// A quarter turn.
    pub turn: u32,
}

/// Units a step.
const STEP: u32 = 16;
/// A quarter turn counts as at most this many steps, so that sums over large rooms stay in range.
const MAX_TURN_STEPS: f64 = 64.0;

impl Costs {
    /// The costs of a job's robot.
    pub fn of(job: &CoverageJob) -> Self {
        let turn_steps = (job.turn_s / job.step_s).clamp(0.0, MAX_TURN_STEPS);
        Self { step: STEP, turn: (turn_steps * f64::from(STEP)).round() as u32 }
    }

    /// Cost of a walk, the turn from `heading` to its first step included.
    pub fn of_walk(self, heading: Direction, walk: &[Cell]) -> u64 {
        let mut cost = 0;
        let mut last = heading;
        for direction in walk.windows(2).filter_map(|w| w[0].direction_to(w[1])) {
            cost += u64::from(self.step + self.turn * last.quarter_turns(direction));
            last = direction;
        }
        cost
    }

    /// The least that a way can cost which starts looking `leaving` and ends ready to go on towards `arriving`: what it
    /// costs where nothing is in the way. `None` for directions that don't matter.
    pub fn at_least(self, from: Cell, leaving: Option<Direction>, to: Cell, arriving: Option<Direction>) -> u32 {
        self.step * from.manhattan(to) + self.turn * fewest_turns(from, leaving, to, arriving)
    }
}

/// Fewest quarter turns of a way without detour from looking `leaving` in `from` to looking `arriving` in `to`.
fn fewest_turns(from: Cell, leaving: Option<Direction>, to: Cell, arriving: Option<Direction>) -> u32 {
    let at_start = |first: Direction| leaving.map_or(0, |l| l.quarter_turns(first));
    let at_end = |last: Direction| arriving.map_or(0, |a| last.quarter_turns(a));
    let along_x = if to.x > from.x { Direction::Right } else { Direction::Left };
    let along_y = if to.y > from.y { Direction::Up } else { Direction::Down };
    match (to.x == from.x, to.y == from.y) {
        (true, true) => leaving.map_or(0, at_end),
        (false, true) => at_start(along_x) + at_end(along_x),
        (true, false) => at_start(along_y) + at_end(along_y),
        (false, false) => {
            // One corner between the legs, or two if the first leg is cut in half and resumed.
            let [x, y] = [along_x, along_y].map(at_start);
            let [x_end, y_end] = [at_end(along_x), at_end(along_y)];
            (x + 1 + y_end).min(y + 1 + x_end).min(x + 2 + x_end).min(y + 2 + y_end)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Direction::{Left, Right, Up};

    #[test]
    fn turns_of_ways_without_obstacles() {
        let (a, b) = (Cell::new(0, 0), Cell::new(3, 2));
        assert_eq!(fewest_turns(a, Some(Right), b, Some(Up)), 1);
        assert_eq!(fewest_turns(a, Some(Right), b, Some(Right)), 2);
        assert_eq!(fewest_turns(a, Some(Right), b, None), 1);
        assert_eq!(fewest_turns(a, Some(Left), b, Some(Right)), 2);
        assert_eq!(fewest_turns(a, Some(Left), a, Some(Right)), 2);
        assert_eq!(fewest_turns(a, Some(Left), Cell::new(2, 0), Some(Right)), 2);
    }

    #[test]
    fn walk_costs_steps_and_turns() {
        let walk = [(0, 0), (1, 0), (1, 1), (1, 0)].map(|(x, y)| Cell::new(x, y));
        assert_eq!(Costs { step: 16, turn: 32 }.of_walk(Up, &walk), 3 * 16 + 4 * 32);
    }
}

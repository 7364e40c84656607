//! Costs of steps and turns in whole numbers, so that sums don't depend on their order.

use crate::CoverageJob;
use robovac_core::grid::{Cell, Direction};

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

    /// Lower bound of the cost of a way that starts facing `leaving` and ends ready to continue towards `arriving`: its
    /// cost without obstacles. `None` for directions that don't matter.
    #[inline]
    pub fn at_least(self, from: Cell, leaving: Option<Direction>, to: Cell, arriving: Option<Direction>) -> u32 {
        self.step * from.manhattan(to) + self.turn * fewest_turns(from, leaving, to, arriving)
    }
}

/// Number of directions, and one for none.
const LOOKS: usize = 5;
/// The goal's position along one axis: behind, level, ahead.
const SIGNS: usize = 3;
/// [`fewest_turns`] by where the goal lies along x and y and by the directions at both ends: it's looked up millions of
/// times.
const FEWEST_TURNS: [[[[u8; LOOKS]; LOOKS]; SIGNS]; SIGNS] = table_of_turns();

/// Fewest quarter turns of a way without detour from `from`, facing `leaving`, to `to`, facing `arriving`.
#[inline]
pub(super) fn fewest_turns(from: Cell, leaving: Option<Direction>, to: Cell, arriving: Option<Direction>) -> u32 {
    let sign = |from: i32, to: i32| usize::from(to >= from) + usize::from(to > from);
    let look = |direction: Option<Direction>| direction.map_or(LOOKS - 1, |d| d as usize);
    u32::from(FEWEST_TURNS[sign(from.x, to.x)][sign(from.y, to.y)][look(leaving)][look(arriving)])
}

const fn table_of_turns() -> [[[[u8; LOOKS]; LOOKS]; SIGNS]; SIGNS] {
    let mut table = [[[[0; LOOKS]; LOOKS]; SIGNS]; SIGNS];
    let mut i = 0;
    while i < SIGNS * SIGNS * LOOKS * LOOKS {
        let (x, y, leaving, arriving) = (i / 75, i / 25 % SIGNS, i / LOOKS % LOOKS, i % LOOKS);
        table[x][y][leaving][arriving] = turns_towards(x, y, leaving, arriving) as u8;
        i += 1;
    }
    table
}

/// An entry of [`FEWEST_TURNS`].
const fn turns_towards(x: usize, y: usize, leaving: usize, arriving: usize) -> u32 {
    let along_x = if x == SIGNS - 1 { Direction::Right } else { Direction::Left } as usize;
    let along_y = if y == SIGNS - 1 { Direction::Up } else { Direction::Down } as usize;
    let [x_start, y_start] = [turns_between(leaving, along_x), turns_between(leaving, along_y)];
    let [x_end, y_end] = [turns_between(along_x, arriving), turns_between(along_y, arriving)];
    match (x == 1, y == 1) {
        (true, true) => turns_between(leaving, arriving),
        (false, true) => x_start + x_end,
        (true, false) => y_start + y_end,
        // One corner between the legs, or two if the first leg is cut in half and resumed.
        (false, false) => {
            least(least(x_start + 1 + y_end, y_start + 1 + x_end), least(x_start + 2 + x_end, y_start + 2 + y_end))
        }
    }
}

const fn turns_between(a: usize, b: usize) -> u32 {
    let is_known = a < LOOKS - 1 && b < LOOKS - 1;
    if is_known { Direction::ALL[a].quarter_turns(Direction::ALL[b]) } else { 0 }
}

const fn least(a: u32, b: u32) -> u32 {
    if a < b { a } else { b }
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

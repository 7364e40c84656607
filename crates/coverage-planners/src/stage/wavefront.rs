//! Stage: waves that spread from a goal, and the walk that covers a room against them (Zelinsky et al. 1993).

use super::{
    best_of::{BestOf, MAX_CELLS_FOR_ALL},
    frame::FramedGrid,
    greedy_walk::{FloorLeft, WalkRule},
    told::Reasons,
};
use crate::{CoverageJob, CoveragePath, PlanContext, PlanError};
use robovac_core::{
    grid::{Cell, Direction, Grid},
    registry::{ParamKind, ParamSpec, Params},
};
use std::cmp::Reverse;

/// Value of a step in a transform.
pub const STEP: u32 = 16;

/// Steps to the nearest blocked cell or edge of the room, over 8 neighbours, at most `limit`; by the frame's numbers.
pub(crate) fn obstacle_transform(free: &Grid<bool>, limit: u32) -> Vec<u32> {
    let frame = FramedGrid::around(free);
    let mut steps = frame.drawn(free, limit, 0);
    let mut wave: Vec<usize> = (0..steps.len()).filter(|&i| steps[i] == 0).collect();
    let width = frame.stride();
    for distance in 1..limit {
        let mut next_wave = Vec::new();
        for &index in &wave {
            for offset in [1, width - 1, width, width + 1] {
                for next in [index.checked_sub(offset), Some(index + offset)].into_iter().flatten() {
                    if steps.get(next).is_some_and(|&s| s > distance) {
                        steps[next] = distance;
                        next_wave.push(next);
                    }
                }
            }
        }
        wave = next_wave;
    }
    steps
}

/// Least cost of a way to every cell from `goal` over 8 neighbours, where entering a cell costs `cost(cell)`, at least 1
/// and at most `dearest`; 0 for blocked cells. By the frame's numbers.
///
/// A step to a diagonal neighbour needs both cells beside it free. Dijkstra's algorithm with a ring of buckets (Dial
/// 1969): O(n + largest value).
fn transform(free: &Grid<bool>, goal: Cell, cost: &dyn Fn(usize) -> u32, dearest: u32) -> Vec<u32> {
    let frame = FramedGrid::around(free);
    let goal = frame.index(goal);
    // A blocked cell's value can't be improved.
    let mut values = frame.drawn(free, u32::MAX, 0);
    let slots = dearest as usize + 1;
    let mut buckets: Vec<Vec<u32>> = vec![Vec::new(); slots];
    let mut waiting = 1;
    let mut value = 0_u32;
    values[goal] = 0;
    buckets[0].push(goal as u32);
    while waiting > 0 {
        let slot = value as usize % slots;
        let mut bucket = std::mem::take(&mut buckets[slot]);
        waiting -= bucket.len();
        for index in bucket.drain(..) {
            let index = index as usize;
            if values[index] != value {
                continue;
            }
            let sides = frame.neighbours(index);
            let is_free = sides.map(|side| values[side] > 0 || side == goal);
            let mut reach = |next: usize| {
                let through = value.saturating_add(cost(next));
                if values[next] > through {
                    values[next] = through;
                    buckets[through as usize % slots].push(next as u32);
                    waiting += 1;
                }
            };
            for (i, j) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
                reach(sides[i]);
                if is_free[i] && is_free[j] {
                    reach(sides[i] + sides[j] - index);
                }
            }
        }
        buckets[slot] = bucket;
        value += 1;
    }
    values
}

/// The rule of complete coverage: to the new neighbour of the highest value.
///
/// Between equals it goes straight on, then to the one with the fewest new neighbours, so that none is left alone.
struct Descent {
    /// The transform, by the frame's numbers.
    values: Vec<u32>,
    frame: FramedGrid,
}

impl Reasons for Descent {
    fn values(&self, at: Cell, _heading: Direction, open: &[Direction]) -> Vec<u32> {
        open.iter().map(|&look| self.values[self.frame.index(at.step(look))] / STEP).collect()
    }

    fn rule(&self, _at: Cell, _heading: Direction, _towards: Direction) -> &'static str {
        "Farthest from the goal"
    }
}

impl WalkRule for Descent {
    fn next(&mut self, floor: &FloorLeft, at: usize, heading: Direction, _: bool) -> Option<Direction> {
        let mut best = None;
        for direction in [heading, heading.left(), heading.right(), heading.opposite()] {
            if floor.is_new_ahead(at, direction) {
                let next = floor.frame.ahead(at, direction);
                let key = (self.values[next], direction == heading, Reverse(floor.new_around(next)));
                if best.is_none_or(|(highest, _)| key > highest) {
                    best = Some((key, direction));
                }
            }
        }
        best.map(|(_, direction)| direction)
    }

    fn rank(&self, cell: usize) -> u32 {
        self.values[cell]
    }
}

/// Where the waves start; a walk ends near it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum WaveGoal {
    /// The cheapest walk of those for several goals.
    Cheapest,
    /// The robot's start.
    Start,
    /// The cell that is farthest from the start.
    Farthest,
}

/// Parameter that chooses the [`WaveGoal`].
pub(crate) const GOAL: ParamSpec = ParamSpec {
    id: "goal",
    label: "Goal",
    help: "Origin of the waves, near which the walk ends: the cheapest of several, or always the same.",
    kind: ParamKind::Choice {
        options: &[
            ("cheapest", "the cheapest"),
            ("start", "the start: return there"),
            ("farthest", "farthest from the start"),
        ],
    },
};

impl WaveGoal {
    /// The goal that [`GOAL`] says.
    pub fn of(params: &Params) -> Self {
        match params.choice(GOAL.id) {
            "start" => Self::Start,
            "farthest" => Self::Farthest,
            _ => Self::Cheapest,
        }
    }
}

/// Covers a room against the waves from its goal; entering a cell costs `cost(cell)`, see [`transform`].
pub(crate) fn cover(
    job: &CoverageJob,
    goal: WaveGoal,
    cost: &dyn Fn(usize) -> u32,
    dearest: u32,
    ctx: &mut PlanContext<'_>,
) -> Result<CoveragePath, PlanError> {
    ctx.checkpoint(0.0, &[])?;
    let frame = FramedGrid::around(&job.free);
    let farthest_from =
        |goal| highest(&transform(&job.free, goal, cost, dearest)).map_or(goal, |index| frame.cell(index));
    let goals = match goal {
        WaveGoal::Start => vec![job.start],
        WaveGoal::Farthest => vec![farthest_from(job.start)],
        WaveGoal::Cheapest if job.cells() > MAX_CELLS_FOR_ALL => vec![job.start],
        WaveGoal::Cheapest => {
            let farthest = farthest_from(job.start);
            vec![job.start, farthest, farthest_from(farthest)]
        }
    };
    let mut best_of = BestOf::new(job, goals.len());
    let descent = |goal| Descent { values: transform(&job.free, goal, cost, dearest), frame };
    for &goal in &goals {
        best_of.greedy_walk(ctx, &mut descent(goal))?;
    }
    let mut winner = descent(goals[best_of.winner()]);
    Ok(best_of.finish(ctx, &mut winner))
}

/// The first cell of the highest value; `None` if all are 0.
fn highest(values: &[u32]) -> Option<usize> {
    let most = values.iter().copied().max().filter(|&most| most > 0)?;
    values.iter().position(|&value| value == most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::{Costs, Transit, greedy_walk::greedy_walk};
    use robovac_core::grid::{from_picture, picture};

    fn drawn(free: &Grid<bool>, values: &[u32], unit: u32) -> String {
        let frame = FramedGrid::around(free);
        let cells = free.iter().map(|(cell, _)| values[frame.index(cell)] / unit).collect();
        let values = Grid::from_rows(free.width(), cells).unwrap();
        picture(&values, |&value| char::from_digit(value, 36).unwrap_or('?'))
    }

    #[test]
    fn waves_go_round_corners_but_not_between_two_that_touch() {
        let free = from_picture(".....\n.....\n.##..\n...#.\n.....", |c| c == '.').unwrap();
        let values = transform(&free, Cell::new(4, 2), &|_| STEP, STEP);
        // Diagonal neighbours are as near as the others.
        assert_eq!(drawn(&free, &values, STEP), "43222\n43211\n50010\n65501\n65432\n");
    }

    #[test]
    fn goes_nearer_only_where_all_farther_neighbours_are_clean() {
        let free = from_picture("......#\n.##....\n.#...#.\n...#...\n.......", |c| c == '.').unwrap();
        let job = CoverageJob::new(&free, Cell::new(0, 0), Direction::Up).unwrap();
        let frame = FramedGrid::around(&free);
        let values = transform(&free, Cell::new(6, 3), &|_| STEP, STEP);
        let mut floor = FloorLeft::of(&job);
        let walk = greedy_walk(
            &job,
            &mut Transit::new(&free, Costs::of(&job)),
            &mut Descent { values: values.clone(), frame },
            &mut |_, _| Ok(()),
        )
        .unwrap();
        for step in walk.windows(2) {
            let [at, next] = [step[0], step[1]].map(|cell| frame.index(cell));
            floor.clean(at);
            for direction in Direction::ALL.into_iter().filter(|&d| floor.is_new_ahead(at, d)) {
                assert!(values[frame.ahead(at, direction)] <= values[next], "{step:?}");
            }
        }
    }

    #[test]
    fn dear_cells_are_gone_round() {
        let free = Grid::filled(5, 3, true);
        let frame = FramedGrid::around(&free);
        let dear = frame.index(Cell::new(1, 1));
        let values = transform(&free, Cell::new(0, 1), &|cell| if cell == dear { 100 } else { 1 }, 100);
        assert_eq!(values[frame.index(Cell::new(4, 1))], 4);
        assert_eq!(values[dear], 100);
    }

    #[test]
    fn obstacles_are_near_at_walls_and_at_the_edge() {
        let free = from_picture(".......\n.......\n.......\n...#...\n.......\n.......", |c| c == '.').unwrap();
        assert_eq!(
            drawn(&free, &obstacle_transform(&free, 9), 1),
            "1111111\n1222221\n1211121\n1210121\n1211121\n1111111\n"
        );
    }
}

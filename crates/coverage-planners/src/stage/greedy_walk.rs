//! Stage: greedy walk that follows a rule over new floor, and goes to the nearest cell left where the rule ends.

use super::{
    cost::Costs,
    flood::Flood,
    frame::FramedGrid,
    transit::{Transit, TransitEnd},
};
use crate::{CoverageJob, PlanError};
use robovac_core::grid::{Cell, Direction};
use std::{cmp::Reverse, ops::ControlFlow};

/// The floor still to be cleaned, by the numbers of a frame around the room.
#[derive(Debug)]
pub(crate) struct FloorLeft {
    /// Numbers of the cells.
    pub frame: FramedGrid,
    /// Free cells that haven't been visited.
    is_new: Vec<bool>,
    left: usize,
}

impl FloorLeft {
    /// A room in which nothing is clean yet.
    pub fn of(job: &CoverageJob) -> Self {
        let frame = FramedGrid::around(&job.free);
        Self { frame, is_new: frame.drawn(&job.free, true, false), left: job.cells() }
    }

    /// Whether the neighbour in one direction is free and hasn't been visited.
    #[inline]
    pub fn is_new_ahead(&self, index: usize, direction: Direction) -> bool {
        self.is_new[self.frame.ahead(index, direction)]
    }

    /// Number of new neighbours.
    #[inline]
    pub fn new_around(&self, index: usize) -> usize {
        self.frame.neighbours(index).into_iter().filter(|&next| self.is_new[next]).count()
    }

    pub(super) fn clean(&mut self, index: usize) {
        self.left -= usize::from(std::mem::take(&mut self.is_new[index]));
    }
}

/// How a robot chooses among new cells.
pub(crate) trait WalkRule {
    /// The direction to take from a cell, to new floor only; `None` if the rule ends there. `begins` at the start and
    /// after a way over clean floor.
    fn next(&mut self, floor: &FloorLeft, at: usize, heading: Direction, begins: bool) -> Option<Direction>;

    /// Rank of a new cell among equally near ones: the highest wins, else the one towards which the robot turns least.
    fn rank(&self, _cell: usize) -> u32 {
        0
    }
}

/// Receives the share of the room that is clean and the walk so far.
pub(super) type WalkReport<'a> = &'a mut dyn FnMut(f64, &[Cell]) -> Result<(), PlanError>;

/// Steps by the rule between two reports.
const REPORT_EVERY: usize = 8192;

/// The walk of a robot that follows `rule`, and goes to the nearest new cell where the rule ends, until all is clean.
/// "Nearest" is by steps; the way there is the cheapest, turns included.
pub(super) fn greedy_walk(
    job: &CoverageJob,
    transit: &mut Transit,
    rule: &mut dyn WalkRule,
    report: WalkReport<'_>,
) -> Result<Vec<Cell>, PlanError> {
    let costs = Costs::of(job);
    let mut floor = FloorLeft::of(job);
    let (frame, cells) = (floor.frame, floor.left);
    let mut flood = Flood::new(&job.free);
    let mut walk = Vec::with_capacity(cells * 17 / 16);
    let (mut at, mut heading, mut begins) = (frame.index(job.start), job.heading, true);
    let mut next_report = 0;
    walk.push(job.start);
    floor.clean(at);
    while floor.left > 0 {
        if walk.len() >= next_report {
            report(1.0 - floor.left as f64 / cells as f64, &walk)?;
            next_report = walk.len() + REPORT_EVERY;
        }
        if let Some(direction) = rule.next(&floor, at, heading, begins) {
            (at, heading, begins) = (frame.ahead(at, direction), direction, false);
            walk.push(frame.cell(at));
        } else {
            let from = frame.cell(at);
            // All free cells are connected, so a way exists while one is left.
            let Some(to) = nearest(&mut flood, &floor, costs, (from, heading), &*rule) else { break };
            let (start, goal) =
                (TransitEnd { cell: from, heading: Some(heading) }, TransitEnd { cell: to, heading: None });
            let begin = walk.len();
            let _ = transit.append_way(start, goal, u32::MAX, &mut walk);
            walk[begin..].iter().for_each(|&cell| floor.clean(frame.index(cell)));
            if let [.., before, last] = *walk {
                heading = before.direction_to(last).unwrap_or(heading);
            }
            (at, begins) = (frame.index(to), true);
        }
        floor.clean(at);
    }
    Ok(walk)
}

/// The new cell that is the fewest steps away; of several, see [`WalkRule::rank`].
fn nearest(
    flood: &mut Flood,
    floor: &FloorLeft,
    costs: Costs,
    (from, heading): (Cell, Direction),
    rule: &dyn WalkRule,
) -> Option<Cell> {
    let mut best = None;
    let mut fewest = u32::MAX;
    flood.search(from, |index, steps| {
        if steps > fewest {
            return ControlFlow::Break(());
        }
        if floor.is_new[index] {
            fewest = steps;
            let cell = floor.frame.cell(index);
            let key = (rule.rank(index), Reverse(costs.at_least(from, Some(heading), cell, None)));
            if best.is_none_or(|(highest, _)| key > highest) {
                best = Some((key, cell));
            }
        }
        ControlFlow::Continue(())
    });
    best.map(|(_, cell)| cell)
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    /// Straight on and nothing else.
    struct Ahead;

    impl WalkRule for Ahead {
        fn next(&mut self, floor: &FloorLeft, at: usize, heading: Direction, _: bool) -> Option<Direction> {
            floor.is_new_ahead(at, heading).then_some(heading)
        }
    }

    #[test]
    fn goes_to_the_nearest_new_cell_where_the_rule_ends() {
        let free = from_picture("...\n.#.\n...", |c| c == '.').unwrap();
        let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
        let walk =
            greedy_walk(&job, &mut Transit::new(&free, Costs::of(&job)), &mut Ahead, &mut |_, _| Ok(())).unwrap();
        let expected = [(0, 2), (1, 2), (2, 2), (2, 1), (2, 0), (1, 0), (0, 0), (0, 1)];
        assert_eq!(walk, expected.map(|(x, y)| Cell::new(x, y)));
    }
}

//! The way over known floor to the nearest place that isn't swept.

use super::swept_map::{BLOCK_M, BLOCKS, BlockAt, SweptMap, block_index, block_of, middle};
use robovac_core::geometry::Point;

/// Blocks along the way that are looked at for one that the robot can drive straight to.
const AHEAD: usize = 7;

/// The way, block by block; empty if there is none.
#[derive(Debug, Clone, Default)]
pub(super) struct Way {
    /// From the goal to the robot.
    blocks: Vec<BlockAt>,
    /// For each block of the map, the block before it on the way there, as an index into `queue`; only those of the
    /// present `search` count.
    before: Vec<(u32, u32)>,
    search: u32,
    queue: Vec<BlockAt>,
}

impl Way {
    /// Searches the nearest goal from a place, breadth first.
    pub(super) fn search(&mut self, map: &SweptMap, from: Point) {
        self.blocks.clear();
        self.before.resize((BLOCKS * BLOCKS) as usize, (0, 0));
        self.search += 1;
        self.queue.clear();
        let start = block_of(from);
        self.queue.push(start);
        self.note(start, 0);
        let mut next = 0;
        while let Some(&(x, y)) = self.queue.get(next) {
            for at in [(x + 1, y), (x, y + 1), (x - 1, y), (x, y - 1)] {
                let is_goal = map.is_goal(at);
                if !(is_goal || map.is_way(at)) || !self.note(at, next as u32) {
                    continue;
                }
                self.queue.push(at);
                if is_goal {
                    self.trace_back(at);
                    return;
                }
            }
            next += 1;
        }
    }

    /// Notes how a block is reached, if it hasn't been.
    fn note(&mut self, at: BlockAt, from: u32) -> bool {
        let Some(entry) = self.before.get_mut(block_index(at)).filter(|entry| entry.0 != self.search) else {
            return false;
        };
        *entry = (self.search, from);
        true
    }

    fn trace_back(&mut self, goal: BlockAt) {
        let mut at = goal;
        // The start is its own predecessor.
        while let Some(&(_, from)) = self.before.get(block_index(at)) {
            self.blocks.push(at);
            let Some(&before) = self.queue.get(from as usize).filter(|&&before| before != at) else { return };
            at = before;
        }
    }

    /// The goal.
    pub(super) fn goal(&self) -> Option<BlockAt> {
        self.blocks.first().copied()
    }

    /// Length of the way, m.
    pub(super) fn length_m(&self) -> f64 {
        self.blocks.len().saturating_sub(1) as f64 * BLOCK_M
    }

    /// The farthest point of the way, within about a metre, to which the robot can drive straight.
    pub(super) fn next(&self, map: &SweptMap, from: Point) -> Option<Point> {
        let nearest = self.blocks.len().checked_sub(2)?;
        let farthest = self.blocks.len().saturating_sub(AHEAD);
        let mut points = self.blocks.get(farthest..=nearest)?.iter().map(|&at| middle(at));
        points.clone().find(|&to| map.is_open(from, to)).or_else(|| points.next_back())
    }
}

#[cfg(test)]
mod tests {
    use super::super::swept_map::CELL_M;
    use super::*;

    #[test]
    fn the_way_leads_round_what_is_blocked() {
        let mut map = SweptMap::new();
        // A swept square with a wall across it that leaves a gap at the top.
        for i in 0..=60 {
            for j in 0..=60 {
                map.sweep(Point::new(f64::from(i) * CELL_M, f64::from(j) * CELL_M), 0.1);
            }
        }
        for j in -10..=40 {
            map.block(Point::new(1.5, f64::from(j) * CELL_M), 0.15);
        }
        // Everything to the left of the wall is swept or blocked.
        for j in -20..=80 {
            map.block(Point::new(-0.3, f64::from(j) * CELL_M), 0.3);
        }
        for i in -20..=80 {
            map.block(Point::new(f64::from(i) * CELL_M, -0.3), 0.3);
            map.block(Point::new(f64::from(i) * CELL_M, 3.3), 0.3);
        }
        let from = Point::new(0.5, 0.5);
        let mut way = Way::default();
        way.search(&map, from);
        let goal = middle(way.goal().unwrap());
        assert!(goal.x > 2.9, "{goal}");
        assert!(way.length_m() > 4.0, "{}", way.length_m());
        let next = way.next(&map, from).unwrap();
        assert!(next.y > 0.8 && next.x < 1.4, "up along the wall: {next}");
        for _ in 0..3 {
            way.search(&map, Point::new(2.5, 1.0));
        }
        assert!(way.length_m() < 1.0);
    }

    #[test]
    fn without_a_goal_there_is_no_way() {
        let mut map = SweptMap::new();
        map.block(Point::new(0.1, 0.1), 1.0);
        let mut way = Way::default();
        way.search(&map, Point::new(0.1, 0.1));
        assert_eq!((way.goal(), way.next(&map, Point::new(0.1, 0.1))), (None, None));
    }
}

//! Stage: covers the cells of a room with straight lanes that together cost least.
//!
//! Every cell is driven through along x, along y or both. A lane costs a turn at each of its ends, and a cell in two
//! lanes costs a step more. With one variable for "along x" and one for "not along y" in every cell, that is a sum over
//! pairs which are cheaper equal, so that a minimum cut has the least (Greig, Porteous & Seheult 1989). Covering with
//! strips before linking them to a tour is how Arkin et al. 2005, "Optimal covering tours with turn costs", begin.

use super::{cost::Costs, frame::Frame};
use crate::grid::{Cell, Direction, Grid};

/// Cells in a straight line from one end to the other, to the right or up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lane {
    /// Its left or lower end.
    pub first: Cell,
    /// Its right or upper end.
    pub last: Cell,
}

/// The lanes to prefer where both directions cost the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Prefer {
    /// Lanes along x.
    AlongX,
    /// Lanes along y.
    AlongY,
}

/// Cheapest lanes that cover all free cells.
pub fn cheapest_lanes(free: &Grid<bool>, costs: Costs, prefer: Prefer) -> Vec<Lane> {
    let mut cut = Cut::new(free, costs);
    cut.saturate();
    let is_source = match prefer {
        Prefer::AlongY => cut.reached(|balance| balance > 0, false),
        Prefer::AlongX => cut.reached(|balance| balance < 0, true).iter().map(|&reached| !reached).collect(),
    };
    let mut lanes = Vec::new();
    for (first, _) in free.iter().filter(|&(_, &is_free)| is_free) {
        for layer in LAYERS {
            let has_lane = |cell: Cell| {
                free.is_set(cell) && is_source[layer.node(cut.frame.index(cell))] == (layer == Layer::AlongX)
            };
            let direction = layer.forward();
            if has_lane(first) && !has_lane(first.step(direction.opposite())) {
                let mut last = first;
                while has_lane(last.step(direction)) {
                    last = last.step(direction);
                }
                lanes.push(Lane { first, last });
            }
        }
    }
    lanes
}

/// Which variable of a cell a node of the network stands for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Layer {
    /// On the source's side if a lane along x goes through the cell.
    AlongX,
    /// On the sink's side if a lane along y goes through it.
    AlongY,
}

const LAYERS: [Layer; 2] = [Layer::AlongX, Layer::AlongY];

impl Layer {
    fn forward(self) -> Direction {
        if self == Self::AlongX { Direction::Right } else { Direction::Up }
    }

    fn node(self, index: usize) -> usize {
        2 * index + self as usize
    }
}

/// Edges of a node: to the next cell of its line, to the one before, and to the cell's other node.
const EDGES: usize = 3;

/// The edge that leads back.
const BACK: [usize; EDGES] = [1, 0, 2];

/// Flow network with two nodes for every cell.
struct Cut {
    frame: Frame,
    /// What a node still has to give or, below 0, to take.
    balance: Vec<i32>,
    /// Capacity left on each edge.
    capacity: Vec<[i32; EDGES]>,
    /// Number of the last search that saw a node, [`CLOSED`] if searches end there in vain.
    seen: Vec<u32>,
    /// The edge by which a search came to a node.
    came: Vec<u8>,
    queue: Vec<u32>,
}

const CLOSED: u32 = u32::MAX;
/// More than all ends of a cell cost.
const UNLIMITED: i32 = i32::MAX / 4;

impl Cut {
    fn new(free: &Grid<bool>, costs: Costs) -> Self {
        let frame = Frame::around(free);
        let is_free = frame.drawn(free, true, false);
        let nodes = 2 * is_free.len();
        let (mut balance, mut capacity) = (vec![0; nodes], vec![[0; EDGES]; nodes]);
        let turn = costs.turn as i32;
        for (index, _) in is_free.iter().enumerate().filter(|&(_, &is_free)| is_free) {
            for layer in LAYERS {
                let node = layer.node(index);
                let forward = layer.forward();
                for (edge, direction) in [forward, forward.opposite()].into_iter().enumerate() {
                    if is_free[frame.ahead(index, direction)] {
                        capacity[node][edge] = turn;
                    } else {
                        balance[node] += if layer == Layer::AlongX { -turn } else { turn };
                    }
                }
                // Without a lane along x there must be one along y.
                capacity[node][2] = if layer == Layer::AlongX { costs.step as i32 } else { UNLIMITED };
            }
        }
        Self { frame, balance, capacity, seen: vec![0; nodes], came: vec![0; nodes], queue: Vec::new() }
    }

    fn next(&self, node: usize, edge: usize) -> usize {
        let layer = LAYERS[node % 2];
        match edge {
            0 => layer.node(self.frame.ahead(node / 2, layer.forward())),
            1 => layer.node(self.frame.ahead(node / 2, layer.forward().opposite())),
            _ => node ^ 1,
        }
    }

    /// Sends all flow that fits (Ford & Fulkerson 1956), each time along a shortest way.
    fn saturate(&mut self) {
        let mut number = 0;
        for source in 0..self.balance.len() {
            while self.balance[source] > 0 && self.seen[source] != CLOSED {
                number += 1;
                if let Some(sink) = self.search(source, number) {
                    self.send(source, sink);
                } else {
                    // Nothing flows out of what has been seen, now or later.
                    self.queue.iter().for_each(|&i| self.seen[i as usize] = CLOSED);
                }
            }
        }
    }

    /// The nearest node from `source` that can take flow.
    fn search(&mut self, source: usize, number: u32) -> Option<usize> {
        self.queue.clear();
        self.queue.push(source as u32);
        self.seen[source] = number;
        let mut next_in_queue = 0;
        while let Some(&node) = self.queue.get(next_in_queue) {
            next_in_queue += 1;
            let node = node as usize;
            if self.balance[node] < 0 {
                return Some(node);
            }
            for edge in 0..EDGES {
                // Closed nodes have the greatest number.
                if self.capacity[node][edge] > 0 && self.seen[self.next(node, edge)] < number {
                    let next = self.next(node, edge);
                    self.seen[next] = number;
                    self.came[next] = edge as u8;
                    self.queue.push(next as u32);
                }
            }
        }
        None
    }

    /// Sends as much as fits along the way of the last search.
    fn send(&mut self, source: usize, sink: usize) {
        let mut flow = self.balance[source].min(-self.balance[sink]);
        for is_sending in [false, true] {
            let mut at = sink;
            while at != source {
                let came = usize::from(self.came[at]);
                let before = self.next(at, BACK[came]);
                if is_sending {
                    self.capacity[before][came] -= flow;
                    self.capacity[at][BACK[came]] += flow;
                } else {
                    flow = flow.min(self.capacity[before][came]);
                }
                at = before;
            }
        }
        self.balance[source] -= flow;
        self.balance[sink] += flow;
    }

    /// The nodes that capacity left leads to from where `is_start`, or, backwards, that it leads from to there.
    fn reached(&self, is_start: impl Fn(i32) -> bool, is_backwards: bool) -> Vec<bool> {
        let mut reached: Vec<bool> = self.balance.iter().map(|&balance| is_start(balance)).collect();
        let mut stack: Vec<usize> = (0..reached.len()).filter(|&i| reached[i]).collect();
        while let Some(node) = stack.pop() {
            for (edge, back) in BACK.into_iter().enumerate() {
                // All edges of walls have no capacity; what a free node's edges lead to is never off the frame.
                let next = if self.capacity[node] == [0; EDGES] { node } else { self.next(node, edge) };
                let left = if is_backwards { self.capacity[next][back] } else { self.capacity[node][edge] };
                if left > 0 && !reached[next] {
                    reached[next] = true;
                    stack.push(next);
                }
            }
        }
        reached
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::from_picture;

    const COSTS: Costs = Costs { step: 16, turn: 32 };

    /// Steps of driving along all lanes once more than needed, and turns at their ends.
    fn cost(lanes: &[Lane]) -> u32 {
        let cells: u32 = lanes.iter().map(|lane| lane.first.manhattan(lane.last) + 1).sum();
        cells * COSTS.step + 2 * lanes.len() as u32 * COSTS.turn
    }

    fn lanes(text: &str) -> Vec<Lane> {
        let free = from_picture(text, |c| c == '.').unwrap();
        let [x, y] = [Prefer::AlongX, Prefer::AlongY].map(|prefer| cheapest_lanes(&free, COSTS, prefer));
        assert_eq!(cost(&x), cost(&y), "both are minimum cuts");
        x
    }

    #[test]
    fn lanes_follow_the_longer_side() {
        assert_eq!(lanes("........\n........\n").len(), 2);
        assert_eq!(lanes(".\n.\n.").len(), 1);
        assert_eq!(lanes("..####\n..####\n..####\n......\n......").len(), 4);
    }

    #[test]
    fn one_lane_crosses_another_where_two_would_cost_more() {
        assert_eq!(lanes("##.##\n##.##\n.....\n##.##\n##.##").len(), 2);
    }

    #[test]
    fn no_other_lanes_cost_less() {
        for seed in 0..8 {
            let free = crate::floorplan::generate::random_clutter(3, 3, 0.3, seed);
            let cells: Vec<Cell> = free.iter().filter(|&(_, &f)| f).map(|(cell, _)| cell).collect();
            // Along x, along y or both in every cell.
            let least = (0..3_usize.pow(cells.len() as u32)).map(|choice| {
                let way = |cell| cells.iter().position(|&c| c == cell).map(|i| choice / 3_usize.pow(i as u32) % 3);
                let mut cost = 0;
                for &cell in &cells {
                    for layer in LAYERS {
                        let has_lane = |cell| way(cell).is_some_and(|way| way != 1 - layer as usize);
                        if has_lane(cell) {
                            let ends = [layer.forward(), layer.forward().opposite()].map(|d| !has_lane(cell.step(d)));
                            cost += COSTS.step + COSTS.turn * ends.iter().map(|&end| u32::from(end)).sum::<u32>();
                        }
                    }
                }
                cost
            });
            assert_eq!(least.min(), Some(cost(&cheapest_lanes(&free, COSTS, Prefer::AlongX))));
        }
    }
}

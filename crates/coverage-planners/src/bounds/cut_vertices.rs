//! Cut vertices: cells that must be revisited because they connect others.

use super::graph::{Graph, NONE};

/// The cells in the order of a depth-first search from the start, with the parts that each cell cuts off.
///
/// In a depth-first search, what is reached through a child of c is cut off by c's removal if none of it has a neighbour
/// that was found before c (Hopcroft & Tarjan 1973, Algorithm 447). If c isn't the root, c's removal leaves one part for
/// every such child and one with the root; if it is, one for every child.
pub(super) struct CutVertices {
    /// Cells in the order in which they were found, the start first.
    order: Vec<u32>,
    /// Per cell the one from which it was found; [`NONE`] for the start.
    parents: Vec<u32>,
    /// Per cell whether its parent cuts it off from the start; not set where the parent is the start.
    is_cut_off: Vec<bool>,
    /// Per cell the visits needed beyond the first unless the walk ends below it.
    pub excess: Vec<u8>,
}

impl CutVertices {
    pub fn of(graph: &Graph) -> Self {
        let count = graph.len();
        let mut cuts = Self {
            order: Vec::with_capacity(count),
            parents: vec![NONE; count],
            is_cut_off: vec![false; count],
            excess: vec![0; count],
        };
        // When a cell was found, and the earliest cell that can be reached from what was found through it.
        let (mut found, mut low) = (vec![NONE; count], vec![0; count]);
        let mut children_of_start = 0;
        let mut trail = vec![(graph.start as u32, 0)];
        while let Some((cell, side)) = trail.last_mut() {
            let at = *cell as usize;
            if found[at] == NONE {
                (found[at], low[at]) = (cuts.order.len() as u32, cuts.order.len() as u32);
                cuts.order.push(*cell);
            }
            if let Some(&next) = graph.neighbours[at].get(*side) {
                *side += 1;
                if next == NONE {
                } else if found[next as usize] == NONE {
                    cuts.parents[next as usize] = at as u32;
                    trail.push((next, 0));
                } else {
                    low[at] = low[at].min(found[next as usize]);
                }
                continue;
            }
            trail.pop();
            let parent = cuts.parents[at] as usize;
            if parent == graph.start {
                children_of_start += 1;
            } else if parent != NONE as usize {
                low[parent] = low[parent].min(low[at]);
                if low[at] >= found[parent] {
                    cuts.is_cut_off[at] = true;
                    cuts.excess[parent] += 1;
                }
            }
        }
        cuts.excess[graph.start] = u8::max(children_of_start, 1) - 1;
        cuts
    }

    /// For every cell the sum of `value` over the cells that it is below, in the order of the search.
    pub fn sums_below(&self, value: impl Fn(usize) -> i64) -> impl Iterator<Item = (usize, i64)> {
        let mut sums = vec![0; self.order.len()];
        self.order.iter().map(move |&cell| {
            let cell = cell as usize;
            let parent = self.parents[cell] as usize;
            if let Some(&sum) = sums.get(parent) {
                sums[cell] = sum + if self.is_cut_off[cell] { value(parent) } else { 0 };
            }
            (cell, sums[cell])
        })
    }

    /// The bound by connection.
    pub fn fewest_steps(&self) -> usize {
        let excess: usize = self.excess.iter().map(|&e| usize::from(e)).sum();
        let deepest = self.sums_below(|_| 1).map(|(_, cuts)| cuts).max().unwrap_or(0);
        self.order.len() - 1 + excess - deepest as usize
    }
}

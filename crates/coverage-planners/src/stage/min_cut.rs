//! Minimum cut by blocking flows: Dinic 1970 ("Algorithm for solution of a problem of maximum flow in networks with
//! power estimation").

use crate::PlanError;

/// A flow network whose nodes are divided into a source side and a sink side such that the arcs from the first to the
/// second have the least capacity.
#[derive(Debug)]
pub(super) struct FlowNetwork {
    /// Residual capacity from the source to each node.
    from_source: Vec<u32>,
    /// Residual capacity from each node to the sink.
    to_sink: Vec<u32>,
    /// The first arc from each node, or [`NONE`].
    first: Vec<u32>,
    /// Arcs; number `i ^ 1` is number `i` backwards.
    arcs: Vec<FlowArc>,
}

#[derive(Debug, Clone, Copy)]
struct FlowArc {
    to: u32,
    /// Residual capacity.
    room: u32,
    /// The next arc from the same node, or [`NONE`].
    next: u32,
}

const NONE: u32 = u32::MAX;

impl FlowNetwork {
    /// Without arcs.
    pub fn new(nodes: usize) -> Self {
        Self { from_source: vec![0; nodes], to_sink: vec![0; nodes], first: vec![NONE; nodes], arcs: Vec::new() }
    }

    /// Additional cost of `node` on the side of the sink.
    pub fn tie_to_source(&mut self, node: usize, cost: u32) {
        self.from_source[node] = self.from_source[node].saturating_add(cost);
    }

    /// Additional cost of `node` on the side of the source.
    pub fn tie_to_sink(&mut self, node: usize, cost: u32) {
        self.to_sink[node] = self.to_sink[node].saturating_add(cost);
    }

    /// Cost of `a` on the side of the source and `b` on the side of the sink, and the reverse; both together less than
    /// 2³².
    pub fn add_edge(&mut self, a: usize, b: usize, cost: u32, cost_back: u32) {
        for (from, to, room) in [(a, b, cost), (b, a, cost_back)] {
            self.arcs.push(FlowArc { to: to as u32, room, next: self.first[from] });
            self.first[from] = self.arcs.len() as u32 - 1;
        }
    }

    /// Whether each node is on the side of the source in a cheapest cut; of several the one with fewest there.
    /// `report` is called every round.
    pub fn cut(mut self, mut report: impl FnMut() -> Result<(), PlanError>) -> Result<Vec<bool>, PlanError> {
        loop {
            report()?;
            let (levels, is_sink_reached) = self.levels();
            if !is_sink_reached {
                return Ok(levels.into_iter().map(|level| level != NONE).collect());
            }
            self.block(&levels);
        }
    }

    /// Fewest arcs with residual capacity from the source to each node, and whether one leads on to the sink.
    fn levels(&self) -> (Vec<u32>, bool) {
        let mut levels = vec![NONE; self.first.len()];
        let mut queue: Vec<u32> = (0..self.first.len() as u32).filter(|&n| self.from_source[n as usize] > 0).collect();
        for &node in &queue {
            levels[node as usize] = 0;
        }
        let (mut next_in_queue, mut last_level) = (0, NONE);
        while let Some(&node) = queue.get(next_in_queue) {
            next_in_queue += 1;
            let level = levels[node as usize];
            if level >= last_level {
                // Longer ways to the sink are for later rounds.
                break;
            }
            if self.to_sink[node as usize] > 0 {
                last_level = level + 1;
            }
            let mut number = self.first[node as usize];
            while number != NONE {
                let arc = self.arcs[number as usize];
                if arc.room > 0 && levels[arc.to as usize] == NONE {
                    levels[arc.to as usize] = level + 1;
                    queue.push(arc.to);
                }
                number = arc.next;
            }
        }
        (levels, last_level != NONE)
    }

    /// Sends a blocking flow along arcs from one level to the next.
    fn block(&mut self, levels: &[u32]) {
        // Arcs before these are exhausted.
        let mut current = self.first.clone();
        let mut way: Vec<u32> = Vec::new();
        for source in 0..self.first.len() {
            let mut node = source;
            while self.from_source[source] > 0 {
                if self.to_sink[node] > 0 {
                    self.send(source, node, &way);
                    way.clear();
                    node = source;
                    continue;
                }
                let number = current[node];
                if number == NONE {
                    // A dead end.
                    let Some(last) = way.pop() else { break };
                    node = self.arcs[last as usize ^ 1].to as usize;
                    current[node] = self.arcs[last as usize].next;
                    continue;
                }
                let arc = self.arcs[number as usize];
                if arc.room > 0 && levels[arc.to as usize] == levels[node] + 1 {
                    way.push(number);
                    node = arc.to as usize;
                } else {
                    current[node] = arc.next;
                }
            }
            way.clear();
        }
    }

    /// Sends as much flow as fits along a way.
    fn send(&mut self, source: usize, last: usize, way: &[u32]) {
        let narrowest = way.iter().map(|&arc| self.arcs[arc as usize].room).min().unwrap_or(u32::MAX);
        let amount = narrowest.min(self.from_source[source]).min(self.to_sink[last]);
        self.from_source[source] -= amount;
        self.to_sink[last] -= amount;
        for &arc in way {
            self.arcs[arc as usize].room -= amount;
            self.arcs[arc as usize ^ 1].room += amount;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn no_other_cut_is_cheaper(
            source in proptest::collection::vec(0..4_u32, 6),
            sink in proptest::collection::vec(0..4_u32, 6),
            ties in proptest::collection::vec((0..6_usize, 0..6_usize, 0..4_u32, 0..4_u32), 0..12),
        ) {
            let cost = |side: &[bool]| -> u32 {
                let ends: u32 = (0..6).map(|n| if side[n] { sink[n] } else { source[n] }).sum();
                let between: u32 = ties.iter().map(|&(a, b, there, back)| {
                    u32::from(side[a] && !side[b]) * there + u32::from(side[b] && !side[a]) * back
                }).sum();
                ends + between
            };
            let mut network = FlowNetwork::new(6);
            for n in 0..6 {
                network.tie_to_source(n, source[n]);
                network.tie_to_sink(n, sink[n]);
            }
            for &(a, b, there, back) in &ties {
                network.add_edge(a, b, there, back);
            }
            let found = network.cut(|| Ok(())).unwrap();
            let least = (0..64_usize).map(|bits| cost(&std::array::from_fn::<bool, 6, _>(|n| bits >> n & 1 == 1))).min();
            prop_assert_eq!(Some(cost(&found)), least);
        }
    }
}

//! Profile dynamic programme over a strip: cell by cell, the least cost so far for every use of the edges ahead.

use super::{
    crossings::{LABELLINGS, LABELS},
    graph::NONE,
    strips::{DEAREST, NEVER, RoomStrips, SiteCosts},
};

/// One way to label the edges of a cell.
struct LabelledWay {
    /// Index of the labelling in the cell's table.
    labelling: u8,
    /// Contribution of the labels of the edges behind and ahead to a state.
    from: u32,
    to: u32,
    /// Without and with the walk's end in this cell.
    costs: [i32; 2],
}

/// A run of the dynamic programme over a strip.
pub(super) struct DpRun {
    /// Least cost without and with the walk's end.
    pub least: [i32; 2],
    /// Per cell, the ways to label its edges.
    ways: Vec<Vec<LabelledWay>>,
    /// Per cell and for both layers of states, the best way to reach the state, and whether the walk's end is in the
    /// cell.
    taken: Vec<[Vec<u16>; 2]>,
}

/// Cells, and how often each of their sides is used.
pub(super) type DpTrace = Vec<(u32, [u8; 4])>;

const ENDS_HERE: u16 = 1 << 15;

impl RoomStrips {
    /// Solves a strip. A state is the use of the edges ahead: one digit for each edge along the strip, and one more for
    /// the edge across to the next cell.
    pub(super) fn run(&self, strip: &[u32], sites: &[SiteCosts], is_open: bool) -> DpRun {
        let height = self.height;
        let power = |exponent: usize| LABELS.pow(exponent as u32);
        let states = power(height + 1);
        let layers = 1 + usize::from(is_open);
        let mut costs = [vec![NEVER; states], vec![NEVER; if is_open { states } else { 0 }]];
        costs[0][0] = 0;
        let mut next = costs.clone();
        let mut run = DpRun { least: [NEVER; 2], ways: Vec::new(), taken: Vec::new() };
        let mut sites = sites.iter();
        for (position, &cell) in strip.iter().enumerate() {
            if cell == NONE {
                continue;
            }
            let Some(site) = sites.next() else { break };
            let row = position % height;
            let is_lowest = row == 0 || strip[position - 1] == NONE;
            let is_highest = row + 1 == height || strip[position + 1] == NONE;
            let ways = ways(site, is_open, [power(row), power(height)], [is_highest, is_lowest]);
            let mut taken = [vec![0; states], vec![0; costs[1].len()]];
            for costs in &mut next {
                costs.fill(NEVER);
            }
            let (block, blocks) = (power(row), power(height - 1 - row));
            for (index, way) in ways.iter().enumerate() {
                for middle in 0..blocks {
                    let low = middle * block * LABELS;
                    let (from, to) = (low + way.from as usize, low + way.to as usize);
                    for layer in 0..layers {
                        for ends_here in 0..=layer {
                            let cost = way.costs[ends_here];
                            if cost >= NEVER {
                                continue;
                            }
                            let code = index as u16 | if ends_here == 1 { ENDS_HERE } else { 0 };
                            let before = &costs[layer - ends_here][from..from + block];
                            let after = &mut next[layer][to..to + block];
                            let taken = &mut taken[layer][to..to + block];
                            for ((before, after), taken) in before.iter().zip(after).zip(taken) {
                                if before + cost < *after {
                                    (*after, *taken) = (before + cost, code);
                                }
                            }
                        }
                    }
                }
            }
            std::mem::swap(&mut costs, &mut next);
            run.ways.push(ways);
            run.taken.push(taken);
        }
        for (least, costs) in run.least.iter_mut().zip(&costs) {
            *least = costs.first().copied().unwrap_or(NEVER);
        }
        run
    }
}

impl DpRun {
    /// The uses of the cells' sides in the best solution.
    pub fn trace(&self, strip: &[u32], sites: &[SiteCosts], has_end: bool) -> DpTrace {
        let (mut state, mut layer) = (0, usize::from(has_end));
        let mut trace = Vec::with_capacity(sites.len());
        if self.least[layer] > DEAREST {
            return trace;
        }
        let cells = strip.iter().rev().filter(|&&cell| cell != NONE);
        let taken = self.ways.iter().zip(&self.taken).rev();
        for ((&cell, site), (ways, taken)) in cells.zip(sites.iter().rev()).zip(taken) {
            let code = taken[layer][state];
            let ends_here = usize::from(code & ENDS_HERE != 0);
            let way = &ways[usize::from(code & !ENDS_HERE)];
            state = state + way.from as usize - way.to as usize;
            layer -= ends_here;
            trace.push((cell, site.crossings(ends_here, usize::from(way.labelling))));
        }
        trace
    }
}

/// The ways to label a cell's edges; only the best of those that differ in border edges alone. `weights` of the digits
/// along and across the strip; whether the edges across, forwards and backwards, are border edges.
fn ways(site: &SiteCosts, is_open: bool, [along, across]: [usize; 2], is_border: [bool; 2]) -> Vec<LabelledWay> {
    let mut ways: Vec<LabelledWay> = Vec::new();
    for labelling in 0..LABELLINGS {
        let label = |side: usize| labelling / LABELS.pow(side as u32) % LABELS;
        let [ahead, up, behind, down] = [0, 1, 2, 3].map(label);
        let visible = |label: usize, is_border: bool| if is_border { 0 } else { label * across };
        let to = (ahead * along + visible(up, is_border[0])) as u32;
        let from = (behind * along + visible(down, is_border[1])) as u32;
        for kind in 0..=usize::from(is_open) {
            let cost = site.tables[kind][labelling];
            if cost >= NEVER {
                continue;
            }
            let mut costs = [NEVER; 2];
            costs[kind] = cost;
            // Plain and ended ways are kept apart: they can differ in their border edges.
            let same = |way: &&mut LabelledWay| way.from == from && way.to == to && way.costs[kind] < NEVER;
            match ways.iter_mut().find(same) {
                Some(way) if way.costs[kind] <= cost => {}
                Some(way) => *way = LabelledWay { labelling: labelling as u8, from, to, costs },
                None => ways.push(LabelledWay { labelling: labelling as u8, from, to, costs }),
            }
        }
    }
    ways
}

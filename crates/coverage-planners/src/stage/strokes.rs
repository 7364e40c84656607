//! Stage: a tour split into single lanes, to improve their order.

use super::{
    axis::swap_cell,
    decompose::{Block, CellRun},
    order::Visit,
    part::MownBlock,
    sweep::SWEEPS,
};
use robovac_core::grid::{Cell, Grid};
use std::cmp::Reverse;

/// Sweeps of a part of one lane, from its left to its right end and back.
const THERE: usize = 1;
const BACK: usize = 2;

/// Every lane as a part of its own, and a tour that drives them in the order in which `tour` drives its parts.
pub fn lanes_of(parts: &[MownBlock], tour: &[Visit]) -> (Vec<MownBlock>, Vec<Visit>) {
    let (mut lanes, mut visits) = (Vec::new(), Vec::new());
    for visit in tour {
        let MownBlock { block, is_swapped } = &parts[visit.block];
        let is_down = visit.sweep >= SWEEPS / 2;
        // The entry of the first lane hardly matters: the order is improved from here.
        for i in 0..block.len() {
            let run = block[if is_down { block.len() - 1 - i } else { i }];
            visits.push(Visit { block: lanes.len(), sweep: if i % 2 == 0 { THERE } else { BACK } });
            lanes.push(MownBlock { block: vec![run], is_swapped: *is_swapped });
        }
    }
    (lanes, visits)
}

/// The straight strokes of a walk over `free` as parts of one lane, less what longer ones clean at their ends as well, and the
/// tour that drives them in the walk's order.
///
/// So a way between two lanes can become a lane, and lanes shrink by the floor that ways have cleaned.
pub fn strokes(free: &Grid<bool>, walk: &[Cell]) -> (Vec<MownBlock>, Vec<Visit>) {
    // Indices of the first cell of every stroke and of the one after its last.
    let mut strokes = Vec::new();
    let mut first = 0;
    while first + 1 < walk.len() {
        let direction = walk[first].direction_to(walk[first + 1]);
        let steps = walk[first..].windows(2).take_while(|w| w[0].direction_to(w[1]) == direction).count();
        strokes.push((first, first + steps + 1));
        first += steps;
    }
    let mut by_length: Vec<usize> = (0..strokes.len()).collect();
    by_length.sort_by_key(|&i| Reverse(strokes[i].1 - strokes[i].0));
    let mut is_clean = free.map(|_| false);
    let mut lanes = vec![None; strokes.len()];
    for i in by_length {
        let stroke = &walk[strokes[i].0..strokes[i].1];
        let Some(first) = stroke.iter().position(|&cell| !is_clean[cell]) else { continue };
        let last = stroke.iter().rposition(|&cell| !is_clean[cell]).unwrap_or(first);
        for &cell in &stroke[first..=last] {
            is_clean[cell] = true;
        }
        lanes[i] = Some((lane(stroke[first], stroke[last], stroke[0].x == stroke[1].x), stroke[0] < stroke[1]));
    }
    let lanes = lanes.into_iter().flatten().enumerate();
    lanes.map(|(block, (lane, is_there))| (lane, Visit { block, sweep: if is_there { THERE } else { BACK } })).unzip()
}

/// The lane between two cells.
fn lane(a: Cell, b: Cell, is_swapped: bool) -> MownBlock {
    let (a, b) = if is_swapped { (swap_cell(a), swap_cell(b)) } else { (a, b) };
    let block: Block = vec![CellRun { y: a.y, left: a.x.min(b.x), right: a.x.max(b.x) }];
    MownBlock { block, is_swapped }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_that_lanes_clean_are_no_strokes() {
        let free = Grid::filled(4, 3, true);
        let walk = [(0, 0), (1, 0), (2, 0), (3, 0), (3, 1), (2, 1), (1, 1), (0, 1), (0, 2), (1, 2), (2, 2), (3, 2)];
        let walk = walk.map(|(x, y)| Cell::new(x, y));
        let (lanes, tour) = strokes(&free, &walk);
        assert_eq!(lanes.iter().map(|lane| lane.block[0].y).collect::<Vec<_>>(), [0, 1, 2]);
        assert_eq!(tour.iter().map(|visit| visit.sweep).collect::<Vec<_>>(), [THERE, BACK, THERE]);
        let (lanes, _) = strokes(&free, &walk[..7]);
        let runs: Vec<_> = lanes.iter().map(|lane| (lane.block[0].left, lane.block[0].right)).collect();
        assert_eq!(runs, [(0, 3), (1, 3)]);
    }
}

//! Stage: a better order in which to visit blocks, and from which of their corners.

use super::{
    distances::Links,
    sweep::{SWEEPS, reversed},
};
use crate::PlanError;
use rand::RngExt;
use robovac_core::rng::Rng;

/// One block of a tour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Visit {
    /// Its number.
    pub block: usize,
    /// Number of the sweep through it.
    pub sweep: usize,
}

/// Improves a tour by local search: moves of up to three blocks (Or 1976) and reversals of a part (2-opt, Croes 1958),
/// tried between neighbours only; then corners by dynamic programming; then again from small random changes, `rounds`
/// times, each undone if the tour is worse than the best one by more than a leeway, which shrinks to 0
/// (record-to-record travel, Dueck 1993).
pub fn improve(
    links: &Links<'_>,
    tour: &mut Vec<Visit>,
    rounds: usize,
    rng: &mut Rng,
    mut report: impl FnMut(f64) -> Result<(), PlanError>,
) -> Result<(), PlanError> {
    if tour.len() < 2 {
        return Ok(());
    }
    let mut search = OrOpt::new(links, tour);
    let everything: Vec<usize> = (0..search.tour.len()).collect();
    search.settle(everything, &mut report)?;
    search.choose_corners();
    let mut best = search.tour.clone();
    let mut least = search.cost();
    let mut current = best.clone();
    let leeway = LEEWAY_TURNS * u64::from(links.costs().turn);
    for round in 0..rounds {
        if round % REPORT_EVERY == 0 {
            report(round as f64 / rounds as f64)?;
        }
        let disturbed = search.disturb(rng);
        search.settle(disturbed, &mut |_| Ok(()))?;
        let mut cost = search.cost();
        if cost < least {
            search.choose_corners();
            cost = search.cost();
        }
        if cost > least + leeway * (rounds - round) as u64 / rounds as u64 {
            search.restore(&current);
            continue;
        }
        current.clone_from(&search.tour);
        if cost <= least {
            least = cost;
            best.clone_from(&search.tour);
        }
    }
    search.restore(&best);
    search.choose_corners();
    *tour = search.tour;
    Ok(())
}

/// Rounds between two reports: one costs time in proportion to the blocks.
const REPORT_EVERY: usize = 16;
/// Number of neighbours next to which a block is tried.
const NEIGHBOURS: usize = 10;
/// Longest parts that are exchanged at random.
const LONGEST_EXCHANGE: usize = 30;
/// Initial leeway: turns by which a tour can be worse than the best one.
const LEEWAY_TURNS: u64 = 2;
/// Longest part that is moved.
const LONGEST_MOVE: usize = 3;
/// Number of parts up to that length that contain a block.
const PARTS: usize = LONGEST_MOVE * (LONGEST_MOVE + 1) / 2;

struct OrOpt<'a> {
    links: &'a Links<'a>,
    tour: Vec<Visit>,
    /// Where each block stands in the tour.
    position: Vec<usize>,
    /// The nearest blocks of every block.
    near: Vec<Vec<usize>>,
}

impl<'a> OrOpt<'a> {
    fn new(links: &'a Links<'a>, tour: &[Visit]) -> Self {
        let near = (0..tour.len()).map(|block| nearest_blocks(links, block, tour.len())).collect();
        let mut search = Self { links, position: vec![0; tour.len()], tour: Vec::new(), near };
        search.restore(tour);
        search
    }

    fn restore(&mut self, tour: &[Visit]) {
        self.tour.clear();
        self.tour.extend_from_slice(tour);
        self.number(0, tour.len());
    }

    fn number(&mut self, from: usize, to: usize) {
        for i in from..to {
            self.position[self.tour[i].block] = i;
        }
    }

    fn at(&self, index: usize) -> Option<Visit> {
        self.tour.get(index).copied()
    }

    fn before(&self, index: usize) -> Option<Visit> {
        index.checked_sub(1).and_then(|i| self.at(i))
    }

    fn cost(&self) -> u64 {
        let sweeps: u64 = self.tour.iter().map(|&v| u64::from(self.links.sweep(v).cost)).sum();
        let ways: u64 = (0..self.tour.len()).map(|i| u64::from(self.links.between(self.before(i), self.at(i)))).sum();
        sweeps + ways
    }

    /// Improves around the blocks in `queue` until no move helps.
    fn settle(
        &mut self,
        mut queue: Vec<usize>,
        report: &mut impl FnMut(f64) -> Result<(), PlanError>,
    ) -> Result<(), PlanError> {
        let mut tries = 0;
        let mut is_queued = vec![false; self.tour.len()];
        for &block in &queue {
            is_queued[block] = true;
        }
        while let Some(block) = queue.pop() {
            is_queued[block] = false;
            tries += 1;
            if tries % 64 == 0 {
                report(0.0)?;
            }
            while let Some(touched) = self.improve_at(block) {
                for visit in touched.into_iter().flatten() {
                    if !std::mem::replace(&mut is_queued[visit.block], true) {
                        queue.push(visit.block);
                    }
                }
            }
        }
        Ok(())
    }

    /// The first move found that helps; the blocks at its seams, or `None` if there is no such move.
    fn improve_at(&mut self, block: usize) -> Option<[Option<Visit>; 6]> {
        let longest = self.longest_way_at(block);
        // Computed when the first neighbour needs them; the same for all.
        let mut parts = None;
        for n in 0..self.near[block].len() {
            let other = self.near[block][n];
            if !self.is_promising(longest, block, other) {
                continue;
            }
            for part in parts.get_or_insert_with(|| self.parts_around(block)).iter().flatten() {
                if let Some(touched) = self.try_move(*part, block, other) {
                    return Some(touched);
                }
            }
            if let Some(touched) = self.try_reverse(block, other) {
                return Some(touched);
            }
        }
        None
    }

    /// The longer one of the ways to a block and on from it.
    fn longest_way_at(&self, block: usize) -> u32 {
        let i = self.position[block];
        self.links.between(self.before(i), self.at(i)).max(self.links.between(self.at(i), self.at(i + 1)))
    }

    /// Whether going directly between the two blocks is shorter than a way that one of them has now. A heuristic to skip
    /// most pairs: exact for moves of one block whose sweep stays, and nearly always right for the others. No move that helps
    /// puts only longer ways in place of those it takes out.
    fn is_promising(&self, longest: u32, block: usize, other: usize) -> bool {
        let direct = self.links.nearest_cost(block, other);
        longest > direct || self.longest_way_at(other) > direct
    }

    /// The parts with `block` in them whose move could help.
    fn parts_around(&self, block: usize) -> [Option<TourPart>; PARTS] {
        let lengths = (1..=LONGEST_MOVE).flat_map(|length| (0..length).map(move |shift| (length, shift)));
        let mut parts = [None; PARTS];
        for (part, (length, shift)) in parts.iter_mut().zip(lengths) {
            *part = self.part(block, length, shift);
        }
        parts
    }

    /// The `length` blocks of which `block` is number `shift`, unless removing them gains nothing.
    fn part(&self, block: usize, length: usize, shift: usize) -> Option<TourPart> {
        let first = self.position[block].checked_sub(shift)?;
        let end = first + length;
        if end > self.tour.len() || length == self.tour.len() {
            return None;
        }
        let (before, after) = (self.before(first), self.at(end));
        let (head, tail) = (self.tour[first], self.tour[end - 1]);
        let link = |a, b| i64::from(self.links.between(a, b));
        let removal = link(before, Some(head)) + link(Some(tail), after) - link(before, after);
        let slack = if length == 1 { self.own(head) - i64::from(self.links.cheapest(block)) } else { 0 };
        (removal + slack > 0).then_some(TourPart { first, end, removal, slack })
    }

    /// Cost of a visit's sweep.
    fn own(&self, visit: Visit) -> i64 {
        i64::from(self.links.sweep(visit).cost)
    }

    /// Moves a part with `block` in it to before or after `other`.
    fn try_move(&mut self, part: TourPart, block: usize, other: usize) -> Option<[Option<Visit>; 6]> {
        let TourPart { first, end, removal, slack } = part;
        let is_single = end == first + 1;
        let target = self.position[other];
        if (first..end).contains(&target) {
            return None;
        }
        let (before, after) = (self.before(first), self.at(end));
        let (head, tail) = (self.tour[first], self.tour[end - 1]);
        let link = |a, b| i64::from(self.links.between(a, b));
        // Seams left and right of `other`, as indices of the visit after the seam.
        for seam in [target, target + 1] {
            if seam >= first && seam <= end {
                continue;
            }
            let (left, right) = (self.before(seam), self.at(seam));
            let opened = link(left, right);
            // The way to `other` is new in any case.
            if is_single && removal + slack + opened <= i64::from(self.links.nearest_cost(block, other)) {
                continue;
            }
            let gain = |h, t| removal + opened - link(left, Some(h)) - link(Some(t), right);
            let turned = |v: Visit| Visit { sweep: reversed(v.sweep), ..v };
            let best = if is_single {
                // Sweeps that cost more than the possible gain are skipped.
                let most = removal + opened + self.own(head) - i64::from(self.links.nearest_cost(block, other));
                (0..SWEEPS)
                    .map(|sweep| Visit { sweep, ..head })
                    .filter(|&v| self.own(v) < most)
                    .map(|v| (gain(v, v) + self.own(head) - self.own(v), SegmentChange::Sweep(v.sweep)))
                    .max_by_key(|(gain, _)| *gain)
                    .unwrap_or((0, SegmentChange::Keep))
            } else {
                let (kept, back) = (gain(head, tail), gain(turned(tail), turned(head)));
                if back > kept { (back, SegmentChange::Reverse) } else { (kept, SegmentChange::Keep) }
            };
            if best.0 > 0 {
                self.apply_move(first, end, seam, best.1);
                return Some([before, after, left, right, Some(head), Some(tail)]);
            }
        }
        None
    }

    fn apply_move(&mut self, first: usize, end: usize, seam: usize, change: SegmentChange) {
        match change {
            SegmentChange::Keep => {}
            SegmentChange::Sweep(sweep) => self.tour[first].sweep = sweep,
            SegmentChange::Reverse => self.reverse(first, end),
        }
        let (low, high) = if seam < first {
            self.tour[seam..end].rotate_right(end - first);
            (seam, end)
        } else {
            self.tour[first..seam].rotate_left(end - first);
            (first, seam)
        };
        self.number(low, high);
    }

    /// Reverses the part between the two blocks, so that they become neighbours.
    fn try_reverse(&mut self, block: usize, other: usize) -> Option<[Option<Visit>; 6]> {
        let (a, b) = (self.position[block], self.position[other]);
        let (a, b) = (a.min(b), a.max(b));
        for (first, end) in [(a + 1, b + 1), (a, b), (a, b + 1)] {
            if end <= first {
                continue;
            }
            let (before, after) = (self.before(first), self.at(end));
            let (head, tail) = (self.tour[first], self.tour[end - 1]);
            let turned = |v: Visit| Some(Visit { sweep: reversed(v.sweep), ..v });
            let link = |a, b| i64::from(self.links.between(a, b));
            let old = link(before, Some(head)) + link(Some(tail), after);
            let new = link(before, turned(tail)) + link(turned(head), after);
            // Inside the part nothing changes: ways and sweeps cost the same in both directions.
            if new < old {
                self.reverse(first, end);
                return Some([before, after, Some(head), Some(tail), None, None]);
            }
        }
        None
    }

    fn reverse(&mut self, first: usize, end: usize) {
        self.tour[first..end].reverse();
        self.tour[first..end].iter_mut().for_each(|visit| visit.sweep = reversed(visit.sweep));
        self.number(first, end);
    }

    /// Exchanges two short neighbouring parts at random; returns the blocks at the seams.
    fn disturb(&mut self, rng: &mut Rng) -> Vec<usize> {
        let longest = (self.tour.len() / 2).clamp(1, LONGEST_EXCHANGE);
        let (a, b) = (rng.random_range(1..=longest), rng.random_range(1..=longest));
        if a + b > self.tour.len() {
            return Vec::new();
        }
        let first = rng.random_range(0..=self.tour.len() - a - b);
        self.tour[first..first + a + b].rotate_left(a);
        self.number(first, first + a + b);
        let seams = [first.wrapping_sub(1), first, first + b - 1, first + b, first + a + b - 1, first + a + b];
        seams.into_iter().filter_map(|i| self.at(i)).map(|visit| visit.block).collect()
    }

    /// The best sweep of every block for this order, by dynamic programming.
    fn choose_corners(&mut self) {
        let mut came_from: Vec<[usize; SWEEPS]> = Vec::with_capacity(self.tour.len());
        let mut least = [0_u64; SWEEPS];
        for (i, visit) in self.tour.iter().enumerate() {
            let mut sources = [0; SWEEPS];
            let costs = std::array::from_fn(|sweep| {
                let to = Visit { sweep, ..*visit };
                let way = |source: usize| match i.checked_sub(1) {
                    None => u64::from(self.links.between(None, Some(to))),
                    Some(before) => {
                        let from = Visit { sweep: source, ..self.tour[before] };
                        least[source] + u64::from(self.links.between(Some(from), Some(to)))
                    }
                };
                let (cost, source) = (0..SWEEPS).map(|s| (way(s), s)).min().unwrap_or((0, 0));
                sources[sweep] = source;
                cost + u64::from(self.links.sweep(to).cost)
            });
            least = costs;
            came_from.push(sources);
        }
        let mut sweep = (0..SWEEPS).min_by_key(|&s| least[s]).unwrap_or(0);
        for (visit, sources) in self.tour.iter_mut().zip(came_from).rev() {
            visit.sweep = sweep;
            sweep = sources[sweep];
        }
    }
}

/// Consecutive visits of a tour that may be moved.
#[derive(Clone, Copy)]
struct TourPart {
    first: usize,
    /// Index after the last one.
    end: usize,
    /// Cost of the ways removed with the part, less the new one in their place.
    removal: i64,
    /// Most that another sweep could save.
    slack: i64,
}

/// Change of a part that is moved.
#[derive(Clone, Copy)]
enum SegmentChange {
    Keep,
    Reverse,
    Sweep(usize),
}

/// The blocks that are nearest to `block`, by the cheapest way from any of its corners.
fn nearest_blocks(links: &Links<'_>, block: usize, blocks: usize) -> Vec<usize> {
    let mut near: Vec<(u32, usize)> =
        (0..blocks).filter(|&other| other != block).map(|other| (links.nearest_cost(block, other), other)).collect();
    let keep = NEIGHBOURS.min(near.len());
    if keep < near.len() {
        near.select_nth_unstable(keep);
    }
    near.truncate(keep);
    near.sort_unstable();
    near.into_iter().map(|(_, other)| other).collect()
}

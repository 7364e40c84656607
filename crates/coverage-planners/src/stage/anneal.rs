//! Stage: improves a walk cell by cell with moves of the travelling salesman problem, including turn costs.
//!
//! Reversals of a part of the walk (2-opt, Croes 1958) and moves of a part to elsewhere (Or 1976) are tried where cells
//! lie side by side, so that both ends of a part can be linked by single steps. A part whose own ends touch is a
//! loop, which may be opened at any of its steps. Cells that are visited elsewhere too may be left out. Moves are taken
//! by simulated annealing (Kirkpatrick, Gelatt & Vecchi 1983).

use super::{cost::Costs, frame::FramedGrid};
use crate::{CoverageJob, PlanError};
use rand::RngExt;
use robovac_core::{
    grid::{Cell, Direction, Grid},
    math,
    rng::Rng,
};

/// Parameters of the annealing.
#[derive(Debug, Clone, Copy)]
pub struct Schedule {
    /// Moves to try; rounded up to thousands.
    pub tries: usize,
    /// Temperature at the start, in quarter turns.
    pub hot: f64,
    /// Temperature at the end, in quarter turns.
    pub cold: f64,
    /// Moves to choose from.
    pub moves: MoveKinds,
}

/// Kinds of moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MoveKinds {
    /// All.
    Both,
    /// Parts are driven backwards (2-opt).
    Reverse,
    /// Parts are moved or left out (Or-opt).
    Move,
}

/// Improves `walk`, which must be one from the job's start over all its cells; never makes it worse. `report` receives
/// the share of the work done and the best walk so far.
pub fn anneal(
    job: &CoverageJob,
    costs: Costs,
    schedule: Schedule,
    walk: &mut Vec<Cell>,
    rng: &mut Rng,
    mut report: impl FnMut(f64, &[Cell]) -> Result<(), PlanError>,
) -> Result<(), PlanError> {
    let mut state = AnnealedWalk::new(&job.free, job.heading, costs, walk);
    let mut best = state.cost;
    // Most that a move can cost: the temperature times an exponential deviate.
    let deviates: [f64; DEVIATES] = std::array::from_fn(|i| -math::ln((i as f64 + 0.5) / DEVIATES as f64));
    let mut limits = [0; DEVIATES];
    let batches = schedule.tries.div_ceil(BATCH);
    for batch in 0..batches {
        let done = batch as f64 / batches as f64;
        report(done, walk)?;
        let temperature = f64::from(costs.turn) * (schedule.hot + (schedule.cold - schedule.hot) * done);
        for (limit, deviate) in limits.iter_mut().zip(deviates) {
            *limit = (temperature * deviate) as i32;
        }
        for _ in 0..BATCH {
            let random = rng.random::<u64>();
            state.try_move(random, schedule.moves, limits[(random >> 56) as usize % DEVIATES]);
        }
        if state.cost < best {
            best = state.cost;
            state.store(walk);
        }
    }
    Ok(())
}

/// Moves between two reports.
const BATCH: usize = 4_096;
const DEVIATES: usize = 256;
/// Steps of a loop at which opening it is tried.
const OPENINGS: usize = 24;
/// Longest part that is left out at once.
const LONGEST_CUT: usize = 8;
/// No cell: behind the end of the walk.
const END: usize = 0;

/// A walk that is being changed. Position 0 is the cell behind the start, from which the robot seems to come, 1 the
/// start.
struct AnnealedWalk {
    frame: FramedGrid,
    stride: usize,
    step: i32,
    turn: i32,
    /// Cells by the frame's numbers, and at last [`END`] twice.
    cells: Vec<usize>,
    /// Per cell, a position at which the walk visits it.
    position: Vec<u32>,
    /// Per cell, how often the walk visits it.
    visits: Vec<u32>,
    /// Cost up to a constant.
    cost: i64,
}

/// A part of the walk to be moved: from `first` to `last`.
#[derive(Clone, Copy)]
struct WalkPart {
    first: usize,
    last: usize,
}

/// Where and how a part is inserted.
#[derive(Clone, Copy)]
struct Target {
    /// Change of cost.
    gain: i32,
    /// The position of the step of the loop at which it's opened.
    open: usize,
    /// The position after which it's inserted.
    after: usize,
    is_reversed: bool,
}

impl AnnealedWalk {
    fn new(free: &Grid<bool>, heading: Direction, costs: Costs, walk: &[Cell]) -> Self {
        let frame = FramedGrid::around(free);
        let start = frame.index(walk[0]);
        let mut cells = vec![frame.ahead(start, heading.opposite())];
        cells.extend(walk.iter().map(|&cell| frame.index(cell)));
        cells.extend([END; 2]);
        let stride = frame.neighbours(start)[1] - start;
        let mut visits = frame.filled(0);
        cells[1..cells.len() - 2].iter().for_each(|&cell| visits[cell] += 1);
        let (step, turn) = (costs.step as i32, costs.turn as i32);
        let mut state = Self { frame, stride, step, turn, cells, position: frame.filled(0), visits, cost: 0 };
        state.number(1, state.end());
        state
    }

    /// The position behind the last cell.
    fn end(&self) -> usize {
        self.cells.len() - 2
    }

    fn store(&self, walk: &mut Vec<Cell>) {
        walk.clear();
        walk.extend(self.cells[1..self.end()].iter().map(|&cell| self.frame.cell(cell)));
    }

    fn number(&mut self, from: usize, to: usize) {
        for (i, &cell) in self.cells[from..to].iter().enumerate() {
            self.position[cell] = (from + i) as u32;
        }
    }

    fn touch(&self, a: usize, b: usize) -> bool {
        let distance = a.abs_diff(b);
        distance == 1 || distance == self.stride
    }

    /// Quarter turns from the step `a`-`b` to the step `b`-`c`.
    #[inline]
    fn turns(a: usize, b: usize, c: usize) -> i32 {
        if b == END || c == END {
            return 0;
        }
        let (came, goes) = (b as i32 - a as i32, c as i32 - b as i32);
        if came == goes { 0 } else { 1 + i32::from(came == -goes) }
    }

    /// Quarter turns at both ends of the step from the second to the third of four cells.
    #[inline]
    fn turns_at_link([before, a, b, after]: [usize; 4]) -> i32 {
        Self::turns(before, a, b) + Self::turns(a, b, after)
    }

    /// Tries a random move; does it if it costs at most `limit`.
    fn try_move(&mut self, random: u64, moves: MoveKinds, limit: i32) {
        let end = self.end();
        let mut at = 1 + (((random & 0xffff_ffff) * (end as u64 - 1)) >> 32) as usize;
        let kind = (random >> 32) & 0xff;
        if kind == 0 {
            at = end - 1;
        }
        let other = if kind == 2 {
            end
        } else {
            let next = self.frame.neighbours(self.cells[at])[((random >> 40) & 3) as usize];
            if self.visits[next] == 0 {
                return;
            }
            self.position[next] as usize
        };
        let (low, high) = (at.min(other), at.max(other));
        if high < low + 3 {
            if high == end && self.visits[self.cells[end - 1]] > 1 && end > 2 {
                self.leave_out(end - 1, end, limit);
            }
            return;
        }
        let is_reversal = match moves {
            MoveKinds::Both => kind & 2 == 0,
            MoveKinds::Reverse => true,
            MoveKinds::Move => false,
        };
        if is_reversal {
            if high < end && (high + 1 == end || self.touch(self.cells[low + 1], self.cells[high + 1])) {
                self.reverse(low, high, limit);
            } else if high < end && low > 1 && self.touch(self.cells[low - 1], self.cells[high - 1]) {
                self.reverse(low - 1, high - 1, limit);
            }
        } else if !(high - low - 1 <= LONGEST_CUT && self.leave_out(low + 1, high, limit)) {
            self.move_part(WalkPart { first: low + 1, last: high - 1 }, (random >> 42) as usize & 0x3fff, limit);
        }
    }

    /// Reverses the part after `low` up to `high`.
    fn reverse(&mut self, low: usize, high: usize, limit: i32) {
        let c = &self.cells;
        let old = Self::turns_at_link([c[low - 1], c[low], c[low + 1], c[low + 2]])
            + Self::turns_at_link([c[high - 1], c[high], c[high + 1], c[high + 2]]);
        let new = Self::turns_at_link([c[low - 1], c[low], c[high], c[high - 1]])
            + Self::turns_at_link([c[low + 2], c[low + 1], c[high + 1], c[high + 2]]);
        let change = (new - old) * self.turn;
        if change <= limit {
            self.cells[low + 1..=high].reverse();
            self.number(low + 1, high + 1);
            self.cost += i64::from(change);
        }
    }

    /// Leaves out the cells from `first` to before `end` if they are visited elsewhere too.
    fn leave_out(&mut self, first: usize, end: usize, limit: i32) -> bool {
        let mut left = first;
        while left < end && self.visits[self.cells[left]] > 1 {
            self.visits[self.cells[left]] -= 1;
            left += 1;
        }
        let part = WalkPart { first, last: end - 1 };
        let inside = (first + 1..part.last).map(|i| Self::turns(self.cells[i - 1], self.cells[i], self.cells[i + 1]));
        let turns = self.turns_by_gap(part) - inside.sum::<i32>();
        let change = self.turn * turns - self.step * (end - first) as i32;
        if left < end || change > limit {
            self.cells[first..left].iter().for_each(|&cell| self.visits[cell] += 1);
            return false;
        }
        self.cells.drain(first..end);
        self.cost += i64::from(change);
        self.number(1, self.end());
        true
    }

    /// Quarter turns added by linking the neighbours of a part; those inside it stay.
    fn turns_by_gap(&self, WalkPart { first, last }: WalkPart) -> i32 {
        let c = &self.cells;
        // The turns at both ends of the part, which are one turn if it is a single cell.
        let at_first = Self::turns(c[first - 1], c[first], c[first + 1]);
        let at_last = if first == last { 0 } else { Self::turns(c[last - 1], c[last], c[last + 1]) };
        Self::turns(c[first - 2], c[first - 1], c[last + 1]) + Self::turns(c[first - 1], c[last + 1], c[last + 2])
            - Self::turns(c[first - 2], c[first - 1], c[first])
            - at_first
            - at_last
            - Self::turns(c[last], c[last + 1], c[last + 2])
    }

    /// Removes a part of at least two cells and inserts it at the best place found.
    fn move_part(&mut self, part: WalkPart, random: usize, limit: i32) {
        let WalkPart { first, last } = part;
        let length = last - first + 1;
        // As if it were a loop, whether or not its ends touch: opening it there saves these turns.
        let closing = Self::turns(self.cells[last - 1], self.cells[last], self.cells[first])
            + Self::turns(self.cells[last], self.cells[first], self.cells[first + 1]);
        let taken = self.turns_by_gap(part) + closing;
        let mut best: Option<Target> = None;
        if self.touch(self.cells[first], self.cells[last]) {
            let tried = length.min(OPENINGS);
            let begin = if tried < length { random % length } else { 0 };
            for i in 0..tried {
                let open = first + (begin + i) % length;
                let next = if open == last { first } else { open + 1 };
                let (u, v) = (self.cells[open], self.cells[next]);
                let aside = if u.abs_diff(v) == 1 { self.stride } else { 1 };
                for (x, y) in [(u + aside, v + aside), (u - aside, v - aside)] {
                    if self.visits[x] > 0 && self.visits[y] > 0 {
                        self.consider(part, open, self.position[x] as usize, y, taken, &mut best);
                    }
                }
            }
        } else {
            for x in self.frame.neighbours(self.cells[last]) {
                if self.visits[x] == 0 {
                    continue;
                }
                for y in self.frame.neighbours(self.cells[first]) {
                    if self.visits[y] > 0 && self.touch(x, y) {
                        self.consider(part, last, self.position[x] as usize, y, taken, &mut best);
                    }
                }
            }
        }
        if let Some(target) = best.filter(|target| target.gain * self.turn <= limit) {
            self.put(part, target);
        }
    }

    fn before(part: WalkPart, position: usize) -> usize {
        if position == part.last + 1 { part.first - 1 } else { position - 1 }
    }

    fn after(part: WalkPart, position: usize) -> usize {
        if position + 1 == part.first { part.last + 1 } else { position + 1 }
    }

    /// Evaluates inserting the part, opened after position `open`, between the cell at position `x` and a cell `y`
    /// beside it.
    fn consider(&self, part: WalkPart, open: usize, x: usize, y: usize, taken: i32, best: &mut Option<Target>) {
        let WalkPart { first, last } = part;
        if (first..=last).contains(&x) {
            return;
        }
        let c = &self.cells;
        let next = if open == last { first } else { open + 1 };
        let before_open = c[if open == first { last } else { open - 1 }];
        let after_next = c[if next == last { first } else { next + 1 }];
        let (u, v, at) = (c[open], c[next], c[x]);
        let opened = Self::turns_at_link([before_open, u, v, after_next]);
        let (ahead, behind) = (Self::after(part, x), Self::before(part, x));
        let is_same = |p: usize| open == last && p + 1 == first;
        let mut target = |turns: i32, after: usize, is_reversed: bool| {
            let gain = taken - opened + turns;
            if best.is_none_or(|best| gain < best.gain) {
                *best = Some(Target { gain, open, after, is_reversed });
            }
        };
        if c[ahead] == y && ahead != END {
            let (b, n) = (c[Self::before(part, x)], c[Self::after(part, ahead)]);
            let new = Self::turns_at_link([b, at, u, before_open]) + Self::turns_at_link([after_next, v, y, n]);
            target(new - Self::turns_at_link([b, at, y, n]), x, true);
        }
        if behind > 0 && c[behind] == y && !is_same(behind) {
            let (b, n) = (c[Self::before(part, behind)], c[ahead]);
            let new = Self::turns_at_link([b, y, v, after_next]) + Self::turns_at_link([before_open, u, at, n]);
            target(new - Self::turns_at_link([b, y, at, n]), behind, false);
        }
    }

    fn put(&mut self, WalkPart { first, last }: WalkPart, target: Target) {
        let length = last - first + 1;
        let part = &mut self.cells[first..=last];
        part.rotate_left((target.open + 1 - first) % length);
        if target.is_reversed {
            part.reverse();
        }
        let (from, to) = if target.after < first {
            self.cells[target.after + 1..=last].rotate_right(length);
            (target.after + 1, last + 1)
        } else {
            self.cells[first..=target.after].rotate_left(length);
            (first, target.after + 1)
        };
        self.number(from, to);
        self.cost += i64::from(target.gain * self.turn);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{floor_plan::generate::random_clutter, rng::seeded};

    /// A walk through all cells that is easy to improve: depth first, with the way back.
    fn depth_first(free: &Grid<bool>, at: Cell, seen: &mut Grid<bool>, walk: &mut Vec<Cell>) {
        walk.push(at);
        seen[at] = true;
        for next in at.neighbours() {
            if free.is_set(next) && !seen[next] {
                depth_first(free, next, seen, walk);
                walk.push(at);
            }
        }
    }

    #[test]
    fn walks_stay_walks_and_cost_what_the_moves_say() {
        for seed in 0..8 {
            let free = random_clutter(9, 7, 0.2, seed);
            let Some((start, _)) = free.iter().find(|&(_, &f)| f) else { continue };
            let job = CoverageJob::new(&free, start, Direction::Left).unwrap();
            let costs = Costs::of(&job);
            let mut walk = Vec::new();
            depth_first(&job.free, start, &mut job.free.map(|_| false), &mut walk);
            let cost = |walk: &[Cell]| costs.of_walk(job.heading, walk) as i64;
            let before = cost(&walk);
            let mut state = AnnealedWalk::new(&job.free, job.heading, costs, &walk);
            let mut rng = seeded(seed, 0);
            let mut least = before;
            for _ in 0..20_000 {
                state.try_move(rng.random(), MoveKinds::Both, 20);
                state.store(&mut walk);
                let path = crate::CoveragePath::walk(walk.clone());
                assert_eq!(path.check(&job), Ok(()));
                assert_eq!(cost(&walk), before + state.cost);
                least = least.min(cost(&walk));
            }
            let path = crate::CoveragePath::walk(walk);
            let visits = path.visits(&job);
            assert!(job.free.iter().all(|(cell, &f)| !f || visits[cell] > 0));
            assert!(job.cells() < 9 || least < before * 3 / 4, "{least} of {before}");
        }
    }
}

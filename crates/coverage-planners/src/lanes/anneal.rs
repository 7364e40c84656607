//! Simulated annealing of a finished path.

use super::{
    LanesObserver, LanesProgress, LanesSetup,
    cost::MotionTimes,
    free_space::FreeSpace,
    moves::{Edit, FewPoints, SweptPath},
    nearby::Nearby,
    raster::SweptRaster,
    scan::FloorLines,
};
use rand::RngExt;
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Vector, nearest_on_segment},
    math,
    rng::{Rng, seeded},
};
use std::ops::ControlFlow;

/// Moves for every metre of a descent that begins at a temperature of 1 s, with the root of more, and limits of it, s: what is
/// melted in a large room doesn't set in time.
const HOT: (f64, f64, f64) = (8000.0, 0.5, 2.0);
/// Temperature at the end, s.
const COLD: f64 = 0.03;
/// Share of the search in which all first paths are tried, for as long each, and the temperatures then, s. Before that, nothing tells
/// which layout of lanes will be the best: their first paths differ most in how they are linked, which is mended soon.
const TRIAL: f64 = 0.16;
const TRIAL_TEMPERATURES: (f64, f64) = (0.4, 0.06);
/// Moves for every metre that are worth another descent, from another first path, and most descents.
const DESCENT: f64 = 30_000.0;
const MOST_DESCENTS: f64 = 6.0;
/// Price of floor that isn't swept, s/m²: at first, and its limits.
const PRICE: (f64, f64, f64) = (80.0, 20.0, 3000.0);
/// Moves between two adjustments of the price, and at least between two updates of what is near what.
const ADJUST: u64 = 500;
/// Moves between two reports.
const REPORT: u64 = 4096;
/// Shares of the search after which the best path is measured.
const MEASURE: f64 = 0.02;
/// Most rounds of mending at the end, for a path that sweeps less than the samples say, and the part of the moves for each.
const MENDING: (u32, u64) = (8, 100);
/// Improvements that are worth a copy of the path, as a share of its time.
const WORTH_KEEPING: f64 = 3e-5;
/// Largest shift, m, halved up to so many times.
const SHIFT: (f64, usize) = (0.4, 8);

/// Corners among which moves are drawn, and moves before others are: those near each other need the same memory.
const STRETCH: (usize, u32) = (64, 256);

/// What a search needs.
pub(super) struct LaneSearch<'a> {
    pub floor: &'a ReachableFloor,
    pub space: &'a FreeSpace,
    pub times: &'a MotionTimes,
    pub heading: Vector,
    pub setup: &'a LanesSetup,
}

/// A path that was measured.
struct MeasuredPath {
    points: Vec<Point>,
    seconds: f64,
    coverage: f64,
    /// Seconds and the price of what is missing.
    value: f64,
}

impl LaneSearch<'_> {
    fn measure(&self, lines: &mut FloorLines, points: &[Point]) -> MeasuredPath {
        let seconds = self.times.path(points, self.heading, Some(self.space));
        let coverage = lines.swept_share(points);
        let missing = (self.setup.coverage - coverage).max(0.0) * self.floor.area();
        MeasuredPath { points: points.to_vec(), seconds, coverage, value: seconds + PRICE.2 * missing }
    }
}

/// Whether a round of mending ends at `step`, the first when the effort is spent. `mending` keeps the moves of a round, and when
/// the next one ends.
fn ends_round(mending: &mut Option<(u64, u64)>, is_spent: bool, step: u64) -> bool {
    let moves = match *mending {
        None if is_spent => step / MENDING.1 + REPORT,
        Some((moves, end)) if step >= end => moves,
        _ => return false,
    };
    *mending = Some((moves, step + moves));
    true
}

/// Improves the first of `starts` until the effort is spent or the observer stops it, and where there is time for more than one
/// descent the others as well; returns the best path that was measured.
pub(super) fn anneal(
    search: &LaneSearch<'_>,
    raster: &SweptRaster,
    starts: &[Vec<Point>],
    observer: LanesObserver<'_>,
) -> Vec<Point> {
    let LaneSearch { floor, setup, .. } = *search;
    let Some(points) = starts.first() else { return Vec::new() };
    let mut lines = FloorLines::new(floor);
    let mut best = search.measure(&mut lines, points);
    let mut tell = |done: f64, best: &MeasuredPath| {
        observer(LanesProgress { done, path: &best.points, duration_s: best.seconds, coverage: best.coverage })
    };
    if tell(0.0, &best).is_break() {
        return best.points;
    }
    let width = 2.0 * floor.tool_radius;
    let metres = setup.coverage * floor.area() / width;
    let total = (setup.effort * metres.max(1.0)) as u64;
    if points.is_empty() || total == 0 {
        return best.points;
    }
    let mut starts: Vec<FirstPath> = starts.iter().map(|points| FirstPath::new(points)).collect();
    let begin = |start: &FirstPath| {
        SweptPath::new(start.points.clone(), raster.clone(), search.space, search.times, search.heading)
    };
    let mut walker = Walker {
        path: begin(&starts[0]),
        nearby: Nearby::default(),
        rng: seeded(setup.seed, 0),
        radius: floor.tool_radius,
        price: PRICE.0,
        first: 0,
        stays: 0,
    };
    let mut seconds = walker.path.seconds();
    // The samples' floor that may stay unswept, m².
    let all = walker.path.raster.floor_area();
    let mut allowed = (1.0 - setup.coverage) * all;
    let mut candidate: Option<(f64, Vec<Point>)> = None;
    let (mut share, mut temperature, mut next_measure) = (0.0_f64, TRIAL_TEMPERATURES.0, MEASURE);
    let mut mending: Option<(u64, u64)> = None;
    let mut rounds = 0;
    let mut stage = Stage::Trial(0);
    let mut next_rebuild = 0;
    for step in 0.. {
        if step % ADJUST == 0 {
            walker.adjust(allowed, all);
        }
        if step >= next_rebuild {
            walker.nearby.rebuild(&walker.path.points);
            // In large rooms, seldom enough that it takes no time.
            next_rebuild = step + ADJUST.max(walker.path.points.len() as u64);
        }
        if step % REPORT == 0 {
            match tell(share, &best) {
                ControlFlow::Continue(spent) => share = share.max(spent).max(step as f64 / total as f64).min(1.0),
                ControlFlow::Break(()) => return best.points,
            }
            let moves = step as f64 / (share.max(1e-9) * metres.max(1.0));
            let (next, part) = stage.at(share, starts.len(), moves);
            if next != stage && share < 1.0 {
                if let Some((_, points)) = candidate.take() {
                    let found = search.measure(&mut lines, &points);
                    best = if found.value < best.value { found } else { best };
                }
                let start = match (stage, next) {
                    (Stage::Trial(tried), _) => {
                        let missing = (walker.path.raster.unswept_area() - allowed).max(0.0);
                        let value = seconds + PRICE.0 * missing;
                        let points = std::mem::take(&mut walker.path.points);
                        starts[tried] = FirstPath { points, price: walker.price, value };
                        if let Stage::Trial(next) = next {
                            next
                        } else {
                            starts.sort_by(|one, other| one.value.total_cmp(&other.value));
                            0
                        }
                    }
                    (_, Stage::Descent(descent, _)) => descent % starts.len(),
                    _ => 0,
                };
                stage = next;
                (walker.path, walker.price) = (begin(&starts[start]), starts[start].price);
                (seconds, allowed) = (walker.path.seconds(), (1.0 - setup.coverage) * all);
                next_rebuild = step;
                walker.nearby.rebuild(&walker.path.points);
            }
            let (hot, cold) = match stage {
                Stage::Trial(_) => TRIAL_TEMPERATURES,
                Stage::Descent(_, descents) => ((moves / descents / HOT.0).sqrt().clamp(HOT.1, HOT.2), COLD),
            };
            temperature = hot * math::exp(part * math::ln(cold / hot));
        }
        let ends_round = ends_round(&mut mending, share >= 1.0, step);
        if ends_round || mending.is_none() && share >= next_measure {
            next_measure = share + MEASURE;
            let found = match candidate.take() {
                // Another path is the best anyway.
                Some((seconds, _)) if !ends_round && seconds >= best.value => None,
                Some((_, points)) => {
                    let found = search.measure(&mut lines, &points);
                    // The samples flatter, or are too strict.
                    let short = setup.coverage - found.coverage;
                    allowed = (allowed - 0.7 * short.max(-2e-4) * all).max(0.0);
                    Some(found)
                }
                // Perhaps no path sweeps enough.
                None => Some(search.measure(&mut lines, &walker.path.points)),
            };
            let is_enough = found.as_ref().is_some_and(|found| found.coverage >= setup.coverage);
            best = found.filter(|found| found.value < best.value).unwrap_or(best);
            rounds += u32::from(ends_round);
            if ends_round && (is_enough || rounds > MENDING.0) {
                break;
            }
        }
        seconds += walker.try_move(temperature);
        let is_swept = walker.path.raster.unswept_area() <= allowed;
        if is_swept && candidate.as_ref().is_none_or(|(least, _)| seconds < least * (1.0 - WORTH_KEEPING)) {
            candidate = Some((seconds, walker.path.points.clone()));
        }
    }
    let _ = tell(1.0, &best);
    best.points
}

/// A path to begin with.
struct FirstPath {
    points: Vec<Point>,
    /// Price of floor that isn't swept, s/m².
    price: f64,
    /// Seconds and the price of what is missing, after its trial.
    value: f64,
}

impl FirstPath {
    fn new(points: &[Point]) -> Self {
        let points = if let [only] = *points { vec![only; 2] } else { points.to_vec() };
        Self { points, price: PRICE.0, value: f64::INFINITY }
    }
}

/// What the search does at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Stage {
    /// A short descent from a first path, by its number.
    Trial(usize),
    /// A descent from one that was among the best, its number, and the number of descents.
    Descent(usize, f64),
}

impl Stage {
    /// The stage at a share of the search, with so many first paths and moves for every metre in all, and the part of it that
    /// is done.
    fn at(self, share: f64, starts: usize, moves: f64) -> (Self, f64) {
        if share < TRIAL {
            let place = share / TRIAL * starts as f64;
            return (Self::Trial(place as usize), place.fract());
        }
        let descents = match self {
            Self::Trial(_) => (moves / DESCENT).floor().clamp(1.0, MOST_DESCENTS),
            Self::Descent(_, descents) => descents,
        };
        let place = (share - TRIAL) / (1.0 - TRIAL) * descents;
        let number = place.floor().min(descents - 1.0);
        (Self::Descent(number as usize, descents), place - number)
    }
}

/// The path at the present temperature.
struct Walker<'a> {
    path: SweptPath<'a>,
    nearby: Nearby,
    rng: Rng,
    radius: f64,
    /// s/m².
    price: f64,
    /// Corners are drawn from a stretch of the path that begins at this one, so many times more before the next stretch.
    first: usize,
    stays: u32,
}

impl Walker<'_> {
    /// Tries one move; returns by how much the path's time changes, s.
    fn try_move(&mut self, temperature: f64) -> f64 {
        let Some(edit) = self.propose() else { return 0.0 };
        if !self.path.is_valid(&edit) {
            return 0.0;
        }
        let limit = -temperature * math::ln(1.0 - self.rng.random::<f64>());
        let exchange = self.path.exchange(&edit);
        let mut seconds = self.path.seconds_by(&edit, &exchange, None);
        // So much may be missed, if as much more is swept anew as there is to sweep.
        let mut may_miss = (limit - seconds) / self.price;
        if may_miss + self.path.raster.unswept_area() < 0.0 {
            return 0.0;
        }
        let most = may_miss + self.path.could_win(&exchange);
        if most < 0.0 {
            return 0.0;
        }
        if !exchange.is_free(self.path.space) {
            return 0.0;
        }
        if self.path.times.has_curves() {
            // Now that it may be worth it.
            seconds = self.path.seconds_by(&edit, &exchange, Some(self.path.space));
            may_miss = (limit - seconds) / self.price;
        }
        let missed = self.path.missed_by(&exchange, most);
        if missed > may_miss {
            return 0.0;
        }
        self.path.apply(&edit);
        seconds
    }

    /// Makes unswept floor dearer or cheaper, so that as much stays as is allowed, m²; `all` is the floor.
    fn adjust(&mut self, allowed: f64, all: f64) {
        let missing = self.path.raster.unswept_area() - allowed;
        let rate = (missing / (0.004 * all)).clamp(-1.0, 1.0);
        self.price = (self.price * math::exp(0.05 * rate)).clamp(PRICE.1, PRICE.2);
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.rng.random::<f64>() * count as f64) as usize).min(count.saturating_sub(1))
    }

    /// A distance with either sign; small ones are as likely as large ones.
    fn shift(&mut self) -> f64 {
        let parts = 1_u32 << self.below(SHIFT.1);
        (2.0 * self.rng.random::<f64>() - 1.0) * SHIFT.0 / f64::from(parts)
    }

    fn propose(&mut self) -> Option<Edit> {
        match self.below(100) {
            0..16 => self.shift_corner(),
            16..20 => self.slide_corner(),
            20..30 => self.shift_piece(),
            30..46 => self.leave_out(),
            46..52 => self.join_corners(),
            52..55 => self.insert(),
            55..71 => self.reach_for_floor(),
            71..83 => self.reverse(),
            _ => self.carry(),
        }
    }

    #[expect(clippy::unnecessary_wraps, reason = "every proposal is optional")]
    fn splice(from: usize, to: usize, new: &[Point]) -> Option<Edit> {
        Some(Edit::Splice { from, to, new: FewPoints::new(new) })
    }

    /// Any corner but the start.
    fn corner(&mut self) -> Option<usize> {
        let n = self.path.points.len();
        if n < 2 {
            return None;
        }
        if self.stays == 0 {
            (self.first, self.stays) = (self.below(n - 1), STRETCH.1);
        }
        self.stays -= 1;
        Some(1 + (self.first + self.below(STRETCH.0.min(n - 1))) % (n - 1))
    }

    fn shift_corner(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let by = Vector::new(self.shift(), self.shift());
        Self::splice(i - 1, i + 1, &[self.path.points[i] + by])
    }

    /// Along one of its pieces, which keeps its direction.
    fn slide_corner(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let p = &self.path.points;
        let other = if i + 1 < p.len() && self.rng.random::<f64>() < 0.5 { p[i + 1] } else { p[i - 1] };
        let along = self.path.points[i] - other;
        let length = along.norm();
        if length < 1e-6 {
            return None;
        }
        let by = along * (self.shift() / length);
        Self::splice(i - 1, i + 1, &[self.path.points[i] + by])
    }

    /// A piece sideways: both ends by the same vector, or along their other pieces.
    fn shift_piece(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let n = self.path.points.len();
        if i + 1 >= n {
            return None;
        }
        let (a, b) = (self.path.points[i], self.path.points[i + 1]);
        let along = b - a;
        let length = along.norm();
        if length < 1e-6 {
            return None;
        }
        let aside = Vector::new(-along.y, along.x) / length;
        let by = self.shift();
        let slides = self.rng.random::<f64>() < 0.5;
        // Along a neighbouring piece, so far that the shift across is the same.
        let slide = |end: Point, other: Option<Point>| {
            let way = other
                .map(|other| other - end)
                .filter(|way| slides && way.dot(&aside).abs() > 0.3 * way.norm() && way.norm() > 1e-6);
            way.map_or(aside * by, |way| way * (by / way.dot(&aside)))
        };
        let (before, after) = (self.path.points[i - 1], self.path.points.get(i + 2).copied());
        Self::splice(i - 1, i + 2, &[a + slide(a, Some(before)), b + slide(b, after)])
    }

    fn leave_out(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let count = [1, 1, 1, 2, 2, 3, 4][self.below(7)];
        Self::splice(i - 1, (i + count).min(self.path.points.len()), &[])
    }

    /// One corner instead of two or three.
    fn join_corners(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let count = 2 + self.below(2);
        if i + count > self.path.points.len() {
            return None;
        }
        let (a, b) = (self.path.points[i], self.path.points[i + count - 1]);
        let at = a + (b - a) * self.rng.random::<f64>() + Vector::new(self.shift(), self.shift()) * 0.3;
        Self::splice(i - 1, i + count, &[at])
    }

    fn insert(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let (a, b) = (self.path.points[i - 1], self.path.points[i]);
        let at = a + (b - a) * self.rng.random::<f64>() + Vector::new(self.shift(), self.shift());
        Self::splice(i - 1, i, &[at])
    }

    /// Floor that isn't swept, and a piece near it: a corner of it, a new corner, a spur or a short lane.
    fn reach_for_floor(&mut self) -> Option<Edit> {
        let goal = (0..60).find_map(|_| {
            let (word, sample) = (self.rng.random(), self.rng.random());
            self.path.raster.unswept_at(word, sample)
        })?;
        let choice = self.below(3);
        // Where the robot is when its tool is at the goal; then the piece, and the nearest point on it.
        let mut near: Option<(f64, Point, usize, Point)> = None;
        for &piece in self.nearby.around(goal) {
            let i = piece as usize;
            if i == 0 || i >= self.path.points.len() {
                continue;
            }
            let (a, b) = (self.path.points[i - 1], self.path.points[i]);
            let goal = goal - self.path.raster.tool.along(b - a);
            let at = nearest_on_segment(a, b, goal);
            // Not always the nearest piece.
            let distance = (at - goal).norm() * (1.0 + if choice == 0 { 0.0 } else { self.rng.random::<f64>() });
            if near.is_none_or(|(least, ..)| distance < least) {
                near = Some((distance, goal, i, at));
            }
        }
        let (_, goal, i, at) = near?;
        let way = goal - at;
        let distance = way.norm();
        if distance < 1e-6 {
            return None;
        }
        // Where the tool's edge reaches the floor, or goes beyond.
        let reach = at + way * (1.0 - self.radius * self.rng.random::<f64>() / distance);
        let (a, b) = (self.path.points[i - 1], self.path.points[i]);
        match self.below(6) {
            0 | 1 if i > 1 && (at - a).norm() < (at - b).norm() => Self::splice(i - 2, i, &[a + (reach - at)]),
            0 | 1 => Self::splice(i - 1, i + 1, &[b + (reach - at)]),
            2 => Self::splice(i - 1, i, &[reach]),
            3 => Self::splice(i - 1, i, &[at, reach, at]),
            4 => {
                let along = b - a;
                let length = along.norm();
                if length < 0.05 {
                    return None;
                }
                let half = along * ((0.05 + self.shift().abs()) / length);
                Self::splice(i - 1, i, &[reach - half, reach + half])
            }
            _ if i > 1 => Self::splice(i - 2, i + 1, &[a + (reach - at), b + (reach - at)]),
            _ => None,
        }
    }

    /// A corner, and one near it.
    fn two_near(&mut self) -> Option<(usize, usize)> {
        let i = self.corner()?;
        let at = self.path.points[i];
        let near = self.nearby.around(at);
        if near.is_empty() {
            return None;
        }
        let pick = ((self.rng.random::<f64>() * near.len() as f64) as usize).min(near.len() - 1);
        let j = near[pick] as usize;
        (j < self.path.points.len() && j != i).then_some((i, j))
    }

    fn reverse(&mut self) -> Option<Edit> {
        let (i, j) = self.two_near()?;
        if self.below(12) == 0 {
            return Some(Edit::Reverse { first: i, last: self.path.points.len() - 1 });
        }
        let (i, j) = (i.min(j), i.max(j));
        // The new pieces lead from i to j, or from i - 1 to j - 1.
        let (first, last) = if self.rng.random::<f64>() < 0.5 { (i + 1, j) } else { (i, j - 1) };
        Some(Edit::Reverse { first, last })
    }

    fn carry(&mut self) -> Option<Edit> {
        let (i, j) = self.two_near()?;
        let length = [1, 2, 2, 2, 3, 4, 4, 6, 8, 12][self.below(10)];
        // The part begins or ends at i.
        let (first, last) =
            if self.rng.random::<f64>() < 0.5 { (i, i + length - 1) } else { ((i + 1).checked_sub(length)?, i) };
        let after = if self.rng.random::<f64>() < 0.7 { j.checked_sub(1)? } else { j };
        Some(Edit::Carry { first, last, after, is_reversed: self.rng.random::<f64>() < 0.5 })
    }
}

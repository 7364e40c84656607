//! Simulated annealing of a finished path.

use super::{
    LanesObserver, LanesProgress, LanesSetup,
    cost::MotionTimes,
    free_space::FreeSpace,
    moves::SweptPath,
    raster::SweptRaster,
    scan::FloorLines,
    walker::{PRICE, Walker},
};
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Vector},
    math,
    rng::seeded,
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
/// Moves for every metre that are worth another descent, and most descents. The first half of them begins with another first path each,
/// the others with the best path so far, at this share of the temperature.
const DESCENT: f64 = 30_000.0;
const MOST_DESCENTS: f64 = 6.0;
const REHEAT: f64 = 0.25;
/// Temperature at which a path begins that is changed for another coverage, s: its lanes stay.
const WARM: f64 = 0.12;
/// Moves between two adjustments of the price, and at least between two updates of what is near what.
const ADJUST: u64 = 500;
/// Moves between two reports.
const REPORT: u64 = 4096;
/// Shares of the search after which the best path is measured.
const MEASURE: f64 = 0.02;
/// Most rounds of mending at the end, for a path that sweeps less than the samples say, and the part of the moves for each.
const MENDING: (u32, u64) = (8, 100);
/// A path that sweeps too little must be better by this share of its time, too.
const SHORT: f64 = 0.02;
/// Improvements that are worth a copy of the path, as a share of its time.
const WORTH_KEEPING: f64 = 3e-5;

/// What a search needs.
pub(super) struct LaneSearch<'a> {
    pub floor: &'a ReachableFloor,
    pub space: &'a FreeSpace,
    /// What is minimised.
    pub times: &'a MotionTimes,
    /// The robot's time.
    pub clock: &'a MotionTimes,
    pub heading: Vector,
    pub setup: &'a LanesSetup,
}

/// A path that was measured.
struct MeasuredPath {
    points: Vec<Point>,
    duration_s: f64,
    coverage: f64,
    /// What is minimised, s, and the price of what is missing.
    value: f64,
}

impl MeasuredPath {
    fn or_better(self, other: Self) -> Self {
        if other.value < self.value { other } else { self }
    }
}

impl LaneSearch<'_> {
    fn measure(&self, lines: &mut FloorLines, points: &[Point]) -> MeasuredPath {
        let seconds = self.times.path(points, self.heading, Some(self.space));
        let coverage = lines.swept_share(points);
        let missing = (self.setup.coverage - coverage).max(0.0) * self.floor.area();
        let excess = if missing > 0.0 { 1.0 + SHORT } else { 1.0 };
        MeasuredPath {
            points: points.to_vec(),
            duration_s: self.clock.path(points, self.heading, Some(self.space)),
            coverage,
            value: seconds * excess + PRICE.2 * missing,
        }
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
/// descent the others as well; returns the best path that was measured. Begins with `stage`.
pub(super) fn anneal(
    search: &LaneSearch<'_>,
    raster: &SweptRaster,
    starts: &[Vec<Point>],
    mut stage: SearchStage,
    observer: LanesObserver<'_>,
) -> Vec<Point> {
    let LaneSearch { floor, setup, .. } = *search;
    let Some(points) = starts.first() else { return Vec::new() };
    let mut lines = FloorLines::new(floor);
    let mut best = search.measure(&mut lines, points);
    let mut tell = |done: f64, best: &MeasuredPath| {
        observer(LanesProgress { done, path: &best.points, duration_s: best.duration_s, coverage: best.coverage })
    };
    if tell(0.0, &best).is_break() {
        return best.points;
    }
    let metres = setup.coverage * floor.area() / (2.0 * floor.tool_radius);
    let total = (setup.effort * metres.max(1.0)) as u64;
    if points.is_empty() || total == 0 {
        return best.points;
    }
    let mut starts: Vec<FirstPath> = starts.iter().map(|points| FirstPath::new(points)).collect();
    let begin =
        |points: &[Point]| SweptPath::new(points.to_vec(), raster.clone(), search.space, search.times, search.heading);
    let mut walker = Walker::new(begin(&starts[0].points), seeded(setup.seed, 0), floor.tool_radius);
    let mut seconds = walker.path.seconds();
    // The samples' floor that may stay unswept, m².
    let all = walker.path.raster.floor_area();
    let mut allowed = (1.0 - setup.coverage) * all;
    let mut candidate: Option<(f64, Vec<Point>)> = None;
    let (mut share, mut temperature, mut next_measure) = (0.0_f64, TRIAL_TEMPERATURES.0, MEASURE);
    let mut mending: Option<(u64, u64)> = None;
    let (mut rounds, mut next_rebuild) = (0, 0);
    // Whether the present descent has cooled down: it is mended before the next one. And the price when the best path was found,
    // with what was allowed.
    let (mut is_cold, mut of_best) = (false, (PRICE.0, allowed));
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
            let is_next = next != stage && share < 1.0;
            is_cold |= share >= 1.0 || is_next && matches!(stage, SearchStage::Descent(..));
            if let SearchStage::Trial(tried) = stage
                && is_next
            {
                if let Some((_, points)) = candidate.take() {
                    best = best.or_better(search.measure(&mut lines, &points));
                }
                starts[tried] = FirstPath::tried(&mut walker, seconds, allowed);
                if matches!(next, SearchStage::Descent(..)) {
                    starts.sort_by(|one, other| one.value.total_cmp(&other.value));
                }
                let start = &starts[next.first_path().unwrap_or(0)];
                (seconds, allowed) = (walker.begin(begin(&start.points), start.price), (1.0 - setup.coverage) * all);
                (stage, next_rebuild) = (next, step);
            }
            temperature = stage.temperature(if is_cold { 1.0 } else { part }, moves);
        }
        let ends_round = ends_round(&mut mending, is_cold, step);
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
            if let Some(found) = found.filter(|found| found.value < best.value) {
                (best, of_best) = (found, (walker.price, allowed));
            }
            rounds += u32::from(ends_round);
            if ends_round && (is_enough || rounds > MENDING.0) {
                if share >= 1.0 {
                    break;
                }
                (mending, rounds, is_cold) = (None, 0, false);
                stage = stage.at(share, starts.len(), 0.0).0;
                let first = stage.first_path().map(|number| &starts[number % starts.len()]);
                let (points, price) = first.map_or((&best.points, of_best.0), |start| (&start.points, start.price));
                allowed = if first.is_some() { (1.0 - setup.coverage) * all } else { of_best.1 };
                seconds = walker.begin(begin(points), price);
                next_rebuild = step;
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

    /// What came of its trial.
    fn tried(walker: &mut Walker<'_>, seconds: f64, allowed: f64) -> Self {
        let missing = (walker.path.raster.unswept_area() - allowed).max(0.0);
        let points = std::mem::take(&mut walker.path.points);
        Self { points, price: walker.price, value: seconds + PRICE.0 * missing }
    }
}

/// What the search does at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum SearchStage {
    /// A short descent from a first path, by its number.
    Trial(usize),
    /// A descent, its number, and the number of descents.
    Descent(usize, f64),
    /// All of the search changes a path that was good for another coverage.
    Change,
}

impl SearchStage {
    /// The stage at a share of the search, with so many first paths and moves for every metre in all, and the part of it that
    /// is done.
    fn at(self, share: f64, starts: usize, moves: f64) -> (Self, f64) {
        let descents = match self {
            Self::Change => return (self, share),
            _ if share < TRIAL => {
                let place = share / TRIAL * starts as f64;
                return (Self::Trial(place as usize), place.fract());
            }
            Self::Trial(_) => (moves / DESCENT).floor().clamp(1.0, MOST_DESCENTS),
            Self::Descent(_, descents) => descents,
        };
        let place = (share - TRIAL) / (1.0 - TRIAL) * descents;
        let number = place.floor().min(descents - 1.0);
        (Self::Descent(number as usize, descents), place - number)
    }

    /// The first path, by its rank, that the stage begins with; `None` for the best path so far.
    fn first_path(self) -> Option<usize> {
        match self {
            Self::Trial(number) => Some(number),
            Self::Change => None,
            Self::Descent(number, descents) => ((number as f64) < (0.5 * descents).ceil()).then_some(number),
        }
    }

    /// The temperature when a part of the stage is done, s, with so many moves for every metre in all.
    fn temperature(self, part: f64, moves: f64) -> f64 {
        let (hot, cold) = match self {
            Self::Trial(_) => TRIAL_TEMPERATURES,
            Self::Change => (WARM, COLD),
            Self::Descent(_, descents) => {
                let share = if self.first_path().is_some() { 1.0 } else { REHEAT };
                (share * (moves / descents / HOT.0).sqrt().clamp(HOT.1, HOT.2), COLD)
            }
        };
        hot * math::exp(part * math::ln(cold / hot))
    }
}

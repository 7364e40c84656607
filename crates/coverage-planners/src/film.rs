//! Recording of a film: the paths of a planner, each better than the one before.

use crate::{
    Bounds, CoverageJob, CoveragePath, PlanContext, PlannerInfo, ProgressReport, Proof,
    metrics::{WalkMetrics, line_seconds},
};
use robovac_core::registry::Params;

/// Most walks that are kept; beyond them the smallest improvements are merged.
const MOST_FRAMES: usize = 120;

/// The best path at one moment of the search.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmFrame {
    /// The walk, or the path in metres.
    pub path: CoveragePath,
    /// Its proof; for a path in metres its time in milliseconds, with a stop at each corner, and no bound. `None` for a path that
    /// the search could start from.
    pub proof: Option<Proof>,
    /// The planner that made such a first path; empty for others.
    pub planner: String,
    /// How many improvements had been made.
    pub number: u32,
}

/// Records the improvements of a planner.
#[derive(Debug, Default)]
pub struct Film {
    frames: Vec<FilmFrame>,
    /// The latest walk of the search.
    last: Option<FilmFrame>,
    /// Proves paths of a planner that doesn't.
    prover: Option<Prover>,
}

/// What it takes to compare paths with each other, and walks with the bound.
#[derive(Debug)]
struct Prover {
    job: CoverageJob,
    /// 0 for paths in metres.
    bound: u64,
    /// Title of the planner.
    planner: &'static str,
}

impl Prover {
    fn new(planner: &PlannerInfo, job: &CoverageJob) -> Self {
        let bound = if planner.is_in_metres() { 0 } else { Bounds::of(job).cost as u64 };
        Self { job: job.clone(), bound, planner: planner.title }
    }

    /// The proof of a path; `None` for a walk that isn't complete yet.
    fn proof(&self, path: &CoveragePath) -> Option<Proof> {
        if path.is_in_metres() {
            let place = self.job.place.as_ref()?;
            let seconds = line_seconds(&place.robot, &path.line, place.floor.start.heading);
            return Some(Proof { cost: (1000.0 * seconds) as u64, bound: self.bound });
        }
        let metrics = WalkMetrics::of(&self.job, path);
        let is_complete = metrics.visited_cells == metrics.reachable_cells;
        is_complete.then(|| Proof { cost: metrics.cost() as u64, bound: self.bound })
    }
}

impl Film {
    /// Begins with the walks that `planner` can start from.
    pub fn of(planner: &PlannerInfo, params: &Params, job: &CoverageJob) -> Self {
        let mut film = Self::with(planner, job, Vec::new());
        let (job, planners) = planner.build(params).begins_with(job);
        for first in planners {
            let plan = first.build(&Params::defaults(first.params)).plan(&job, &mut PlanContext::new(0));
            if let Ok(path) = plan {
                film.add(FilmFrame { path, proof: None, planner: first.title.to_owned(), number: 0 });
            }
        }
        film
    }

    /// Goes on from recorded frames.
    pub fn with(planner: &PlannerInfo, job: &CoverageJob, frames: Vec<FilmFrame>) -> Self {
        let prover = (!planner.is_anytime()).then(|| Prover::new(planner, job));
        let mut film = Self { prover, ..Self::default() };
        for frame in frames {
            film.add(frame);
        }
        film
    }

    /// Takes a report. Only a better path, or a better proof of it, counts.
    pub fn take(&mut self, report: &ProgressReport<'_>) {
        let is_known =
            self.last.as_ref().is_some_and(|last| last.path.cells == report.walk && last.path.line == report.line);
        let path = || CoveragePath { cells: report.walk.to_vec(), line: report.line.to_vec() };
        let is_path = !(report.walk.is_empty() && report.line.is_empty());
        let prover = self.prover.as_ref().filter(|_| !is_known && is_path);
        let Some(proof) = report.proof.or_else(|| prover?.proof(&path())) else { return };
        if let (Some(prover), None) = (prover, &self.last) {
            let planner = prover.planner.to_owned();
            self.frames.push(FilmFrame { path: path(), proof: None, planner, number: 0 });
        }
        let number = match &self.last {
            None => 0,
            Some(last) if is_known => last.number,
            // What is chosen in the end is shown, even if the planner compares otherwise.
            Some(FilmFrame { proof: Some(known), .. }) if proof.cost >= known.cost && report.done < 1.0 => return,
            Some(last) => last.number + 1,
        };
        if self.last.as_ref().is_some_and(|last| last.number == number && last.proof == Some(proof)) {
            return;
        }
        self.add(FilmFrame { path: path(), proof: Some(proof), planner: String::new(), number });
    }

    /// Appends the next frame.
    pub fn add(&mut self, frame: FilmFrame) {
        if frame.proof.is_some() {
            if self.last.as_ref().is_some_and(|last| last.number == frame.number) {
                // The same walk with a better proof.
                self.frames.pop_if(|last| last.proof.is_some());
            }
            self.last = Some(frame.clone());
        }
        self.frames.push(frame);
        if self.frames.len() > MOST_FRAMES {
            self.drop_least();
        }
    }

    /// Leaves out the walk between the two smallest improvements.
    fn drop_least(&mut self) {
        let cost = |frame: &FilmFrame| frame.proof.map(|proof| proof.cost);
        let won = |three: &[FilmFrame]| Some(cost(&three[0])?.saturating_sub(cost(&three[2])?));
        let triples = self.frames.windows(3).enumerate();
        let least = triples.filter_map(|(index, three)| Some((won(three)?, index))).min();
        if let Some((_, index)) = least {
            self.frames.remove(index + 1);
        }
    }

    /// All frames, once the search has ended with a path.
    pub fn ended(mut self, path: &CoveragePath, proof: Option<Proof>) -> Vec<FilmFrame> {
        self.take(&ProgressReport { done: 1.0, walk: &path.cells, line: &path.line, proof });
        self.frames
    }

    /// The frames since the last call.
    pub fn take_frames(&mut self) -> Vec<FilmFrame> {
        std::mem::take(&mut self.frames)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::Cell;

    fn frames(improvements: i32, won: impl Fn(i32) -> u64) -> Vec<FilmFrame> {
        let mut film = Film::default();
        let mut cost = 1_000_000;
        for i in 0..improvements {
            cost -= won(i);
            let walk = [Cell::new(i, 0)];
            let report = ProgressReport { done: 0.0, walk: &walk, line: &[], proof: Some(Proof { cost, bound: 1 }) };
            film.take(&ProgressReport { proof: None, ..report });
            film.take(&report);
            film.take(&report);
            film.take(&ProgressReport { walk: &[Cell::new(i, 1)], ..report });
        }
        film.take_frames()
    }

    #[test]
    fn films_of_any_length_keep_beginning_order_and_the_largest_improvements() {
        let large = [17, 400, 777];
        let x = |frame: &FilmFrame| frame.path.cells[0].x;
        let frames = frames(1000, |i| if large.contains(&i) { 500 } else { 1 });
        assert_eq!(frames.len(), MOST_FRAMES);
        assert_eq!((x(&frames[0]), x(&frames[frames.len() - 1])), (0, 999));
        assert!(frames.windows(2).all(|pair| pair[0].number < pair[1].number));
        for i in large {
            let alone = frames.windows(2).any(|pair| x(&pair[1]) == i && x(&pair[0]) == i - 1);
            assert!(alone, "improvement {i} isn't told by itself");
        }
    }

    #[test]
    fn better_proof_is_no_other_walk() {
        let mut film = Film::default();
        let walk = [Cell::new(0, 0)];
        for bound in [1, 5, 5, 7] {
            film.take(&ProgressReport { done: 0.0, walk: &walk, line: &[], proof: Some(Proof { cost: 9, bound }) });
        }
        let frames = film.take_frames();
        assert_eq!(frames.len(), 1);
        assert_eq!(frames[0].proof, Some(Proof { cost: 9, bound: 7 }));
        // Frames that were handed on meanwhile come again, and are merged there.
        let mut there = Film::default();
        there.add(frames[0].clone());
        film.take(&ProgressReport { done: 0.0, walk: &walk, line: &[], proof: Some(Proof { cost: 9, bound: 8 }) });
        for frame in film.take_frames() {
            there.add(frame);
        }
        assert_eq!(there.take_frames().len(), 1);
    }
}

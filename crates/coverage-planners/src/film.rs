//! Recording of a film: the walks of a planner, each better than the one before.

use crate::{Bounds, CoverageJob, CoveragePath, PlanContext, PlannerInfo, ProgressReport, Proof, metrics::WalkMetrics};
use robovac_core::{grid::Cell, registry::Params};

/// Most free cells of a filmed room: in larger ones single improvements can't be seen.
pub const MOST_FILMED_CELLS: usize = 2_000;
/// Most walks that are kept; beyond them the smallest improvements are merged.
const MOST_FRAMES: usize = 120;

/// The best walk at one moment of the search.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmFrame {
    /// The walk.
    pub walk: Vec<Cell>,
    /// Its proof; `None` for a walk that the search could start from.
    pub proof: Option<Proof>,
    /// The planner that made such a starting walk; empty for others.
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
    /// Proves walks of a planner that doesn't.
    prover: Option<Prover>,
}

/// What it takes to compare walks with the bound.
#[derive(Debug)]
struct Prover {
    job: CoverageJob,
    bound: u64,
    /// Title of the planner.
    planner: &'static str,
}

impl Prover {
    /// The proof of a walk; `None` for one that isn't complete yet.
    fn proof(&self, walk: &[Cell]) -> Option<Proof> {
        let metrics = WalkMetrics::of(&self.job, &CoveragePath::walk(walk.to_vec()));
        let is_complete = metrics.visited_cells == metrics.reachable_cells;
        is_complete.then(|| Proof { cost: metrics.cost() as u64, bound: self.bound })
    }
}

impl Film {
    /// Begins with the walks that `planner` can start from.
    pub fn of(planner: &PlannerInfo, params: &Params, job: &CoverageJob) -> Self {
        let mut film = Self::default();
        if !planner.is_anytime() {
            let (job, bound) = (job.clone(), Bounds::of(job).cost as u64);
            film.prover = Some(Prover { job, bound, planner: planner.title });
        }
        let (job, planners) = planner.build(params).begins_with(job);
        for first in planners {
            let plan = first.build(&Params::defaults(first.params)).plan(&job, &mut PlanContext::new(0));
            if let Ok(path) = plan {
                film.add(FilmFrame { walk: path.cells, proof: None, planner: first.title.to_owned(), number: 0 });
            }
        }
        film
    }

    /// Takes a report. Only a better walk, or a better proof of it, counts.
    pub fn take(&mut self, report: &ProgressReport<'_>) {
        let is_known = self.last.as_ref().is_some_and(|last| last.walk == report.walk);
        let prover = self.prover.as_ref().filter(|_| !is_known && !report.walk.is_empty());
        let Some(proof) = report.proof.or_else(|| prover?.proof(report.walk)) else { return };
        if let (Some(prover), None) = (prover, &self.last) {
            let (walk, planner) = (report.walk.to_vec(), prover.planner.to_owned());
            self.frames.push(FilmFrame { walk, proof: None, planner, number: 0 });
        }
        let number = match &self.last {
            None => 0,
            Some(last) if last.walk == report.walk => last.number,
            // What is chosen in the end is shown, even if the planner compares otherwise.
            Some(FilmFrame { proof: Some(known), .. }) if proof.cost >= known.cost && report.done < 1.0 => return,
            Some(last) => last.number + 1,
        };
        if self.last.as_ref().is_some_and(|last| last.number == number && last.proof == Some(proof)) {
            return;
        }
        self.add(FilmFrame { walk: report.walk.to_vec(), proof: Some(proof), planner: String::new(), number });
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

    /// The frames since the last call.
    pub fn take_frames(&mut self) -> Vec<FilmFrame> {
        std::mem::take(&mut self.frames)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let frames = frames(1000, |i| if large.contains(&i) { 500 } else { 1 });
        assert_eq!(frames.len(), MOST_FRAMES);
        assert_eq!((frames[0].walk[0].x, frames[frames.len() - 1].walk[0].x), (0, 999));
        assert!(frames.windows(2).all(|pair| pair[0].number < pair[1].number));
        for i in large {
            let alone = frames.windows(2).any(|pair| pair[1].walk[0].x == i && pair[0].walk[0].x == i - 1);
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

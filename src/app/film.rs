//! How a walk came to be: what a planner that improves its walk had on its way, to be watched afterwards.

use crate::{
    coverage::Lattice,
    geometry::Point,
    grid::Cell,
    planner::{Proof, Report},
};

/// Free cells up to which a search is filmed: in larger rooms one doesn't see what a single improvement changes.
pub const MOST_FILMED_CELLS: usize = 2_000;
/// Most frames; of more every second one goes.
const MOST_FRAMES: usize = 120;
/// How long a frame is shown, and all of them at most, s (ours).
const FRAME_S: f64 = 0.8;
const ALL_S: f64 = 15.0;

/// The best walk at one moment of the search.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// The walk; before there is a first one, as far as it goes.
    pub walk: Vec<Cell>,
    /// How good it was known to be.
    pub proof: Option<Proof>,
}

/// A film in the making.
#[derive(Debug)]
pub struct Film {
    frames: Vec<Frame>,
    /// Of so many new walks one is kept, and so many have come since the last.
    every: usize,
    since: usize,
}

impl Default for Film {
    fn default() -> Self {
        Self { frames: Vec::new(), every: 1, since: 0 }
    }
}

impl Film {
    /// Looks at a report; a walk that is shown already, and no better proof of it, is nothing new.
    pub fn take(&mut self, Report { walk, proof, .. }: &Report<'_>) {
        if walk.is_empty() || self.frames.last().is_some_and(|last| last.walk == *walk && last.proof == *proof) {
            return;
        }
        self.since += 1;
        if self.since < self.every {
            return;
        }
        self.since = 0;
        self.frames.push(Frame { walk: walk.to_vec(), proof: *proof });
        if self.frames.len() > MOST_FRAMES {
            self.every *= 2;
            let mut is_kept = false;
            self.frames.retain(|_| {
                is_kept = !is_kept;
                is_kept
            });
        }
    }

    /// What was taken.
    pub fn into_frames(self) -> Vec<Frame> {
        self.frames
    }
}

/// A film that is shown.
#[derive(Debug)]
pub struct Showing {
    frames: Vec<(Vec<Point>, Option<Proof>)>,
    /// Time since it began, s.
    time: f64,
}

impl Showing {
    /// From the beginning; `None` if there is nothing to be seen.
    pub fn new(frames: &[Frame], lattice: &Lattice) -> Option<Self> {
        let frames: Vec<_> = frames.iter().map(|frame| (lattice.anchors(&frame.walk), frame.proof)).collect();
        (!frames.is_empty()).then_some(Self { frames, time: 0.0 })
    }

    /// Begins again.
    pub fn rewind(&mut self) {
        self.time = 0.0;
    }

    /// Lets time pass; whether another frame is shown then.
    pub fn go_on(&mut self, elapsed_s: f64) -> bool {
        let before = self.index();
        self.time += elapsed_s.max(0.0);
        self.index() != before
    }

    /// The number of the frame that is shown; `None` once it's over.
    fn index(&self) -> Option<usize> {
        let each = FRAME_S.min(ALL_S / self.frames.len() as f64);
        // At the latest then.
        let index = (self.time / each).min(1e6) as usize;
        (index < self.frames.len()).then_some(index)
    }

    /// The line that is shown instead of the plan; empty once it's over.
    pub fn line(&self) -> &[Point] {
        self.index().and_then(|index| self.frames.get(index)).map_or(&[], |frame| &frame.0)
    }

    /// What is shown, in words; `end` is what is proven of the plan.
    pub fn text(&self, end: Option<Proof>) -> String {
        let good = |proof: Option<Proof>| match proof.map(Proof::gap) {
            None => "nothing is proven yet".to_owned(),
            Some(gap) if gap <= 0.0 => "proven optimal".to_owned(),
            Some(gap) => format!("{:.1} % above the proven bound", 100.0 * gap),
        };
        match self.index().and_then(|index| Some((index, self.frames.get(index)?))) {
            Some((index, frame)) => format!("Walk {} of {}: {}.", index + 1, self.frames.len(), good(frame.1)),
            None => format!("The search is over, the plan is {}. Switch it off and on to see it again.", good(end)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn films_of_any_length_keep_beginning_and_order() {
        let mut film = Film::default();
        for i in 0..1000 {
            let walk = [Cell::new(i, 0)];
            let report = Report { done: 0.0, walk: &walk, proof: None };
            film.take(&report);
            film.take(&report);
        }
        film.take(&Report { done: 0.0, walk: &[], proof: None });
        let frames = film.into_frames();
        assert!((MOST_FRAMES / 2..=MOST_FRAMES).contains(&frames.len()), "{}", frames.len());
        assert_eq!(frames[0].walk[0].x, 0);
        let steps: Vec<i32> = frames.windows(2).map(|pair| pair[1].walk[0].x - pair[0].walk[0].x).collect();
        assert!(steps.iter().all(|&step| step > 0), "{steps:?}");
    }
}

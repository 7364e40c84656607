//! Playback of a film: pictures with durations and captions.

use super::FilmPicture;
use coverage_planners::Proof;

/// Time to look at a picture, s (ours).
const LOOK_S: f64 = 1.5;
/// Characters of a caption that are read in a second: 160 to 180 words a minute, as in subtitles (BBC Subtitle
/// Guidelines), are 15 to 18.
const READ: f64 = 15.0;

/// A film being shown.
#[derive(Debug)]
pub struct Showing {
    pictures: Vec<FilmPicture>,
    /// Index of the current picture; the number of pictures once the film is over.
    at: usize,
    /// Time since it appeared, s.
    since: f64,
    /// Whether it waits for the user.
    is_held: bool,
}

impl Showing {
    /// A film at its beginning; `None` without pictures. If `is_held` it waits for the user.
    pub fn new(pictures: Vec<FilmPicture>, is_held: bool) -> Option<Self> {
        (!pictures.is_empty()).then_some(Self { pictures, at: 0, since: 0.0, is_held })
    }

    /// Rewinds to the beginning.
    pub fn rewind(&mut self) {
        (self.at, self.since) = (0, 0.0);
    }

    /// Goes to the end.
    pub fn skip(&mut self) {
        (self.at, self.since) = (self.pictures.len(), 0.0);
    }

    /// Advances by a time, s.
    pub fn go_on(&mut self, elapsed_s: f64) {
        let Some(picture) = self.picture().filter(|_| !self.is_held) else { return };
        let seconds = LOOK_S + picture.text.chars().count() as f64 / READ;
        self.since += elapsed_s.max(0.0);
        if self.since >= seconds {
            (self.at, self.since) = (self.at + 1, 0.0);
        }
    }

    /// Goes to the next or the previous picture, and holds.
    pub fn turn(&mut self, forward: bool) {
        let at = if forward { self.at + 1 } else { self.at.saturating_sub(1) };
        (self.at, self.since, self.is_held) = (at.min(self.pictures.len()), 0.0, true);
    }

    /// Holds, or continues; from the beginning if it was over.
    pub fn hold(&mut self, is_held: bool) {
        self.is_held = is_held;
        if !is_held && self.is_over() {
            self.rewind();
        }
    }

    /// Whether it waits for the user.
    pub fn is_held(&self) -> bool {
        self.is_held
    }

    /// Whether the film is over.
    pub fn is_over(&self) -> bool {
        self.at >= self.pictures.len()
    }

    /// Index of the picture, and number of pictures.
    pub fn place(&self) -> [usize; 2] {
        [self.at, self.pictures.len()]
    }

    /// The current picture; `None` once the film is over.
    pub fn picture(&self) -> Option<&FilmPicture> {
        self.pictures.get(self.at)
    }

    /// The caption; `end` is the proof of the final plan, and whether comparisons weigh turns otherwise. One in metres has none.
    pub fn text(&self, end: Option<(Proof, bool)>) -> String {
        match (self.picture(), end) {
            (Some(picture), _) => picture.text.clone(),
            (None, Some((proof, is_own))) => {
                let by = if is_own { ", by the planner's own turn cost" } else { "" };
                format!("Search finished: a plan {}{by}.", good(proof))
            }
            (None, None) => "Search finished.".to_owned(),
        }
    }
}

/// The proof of a walk, in words.
pub(super) fn good(proof: Proof) -> String {
    let gap = proof.gap();
    if gap <= 0.0 {
        return "proven optimal".to_owned();
    }
    // Rounded up, as on the page: only an optimal walk is 0 % above.
    format!("at most {:.1} % above the minimum", (1000.0 * gap - 1e-6).ceil() / 10.0)
}

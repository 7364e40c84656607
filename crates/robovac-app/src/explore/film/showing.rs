//! Playback of a film: pictures with durations and captions.

use super::{
    WalkDiff,
    change::{steps, turns},
};
use crate::amount::amount;
use coverage_planners::{FilmFrame, Proof};
use robovac_core::{coverage::PlanningGrid, geometry::Point, grid::Cell};

/// Most improvements that are shown, the largest ones and the last; together they last about a minute (ours).
const MOST_SHOWN: usize = 4;
/// Time to look at a picture, s (ours).
const LOOK_S: f64 = 1.5;
/// Characters of a caption that are read in a second: 160 to 180 words a minute, as in subtitles (BBC Subtitle
/// Guidelines), are 15 to 18.
const READ: f64 = 15.0;

/// Kind of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilmInk {
    /// A walk.
    Walk,
    /// A part of a walk that is taken apart, by its number.
    Part(usize),
    /// A new part of a walk.
    New,
}

/// One picture of a film.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmPicture {
    /// Lines, m, the later ones above the earlier.
    pub lines: Vec<(FilmInk, Vec<Point>)>,
    /// Cells where the walk changes.
    pub tinted: Vec<Cell>,
    /// Its caption, which sets for how long it is shown.
    text: String,
}

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
    pub fn new(frames: &[FilmFrame], planning_grid: &PlanningGrid, is_held: bool) -> Option<Self> {
        let (firsts, search): (Vec<&FilmFrame>, Vec<&FilmFrame>) =
            frames.iter().partition(|frame| frame.proof.is_none());
        // A closed tour continues from there, back to the start.
        let begun =
            search.first().and_then(|begun| firsts.iter().position(|frame| begun.walk.starts_with(&frame.walk)));
        let mut pictures: Vec<FilmPicture> = Vec::new();
        for (index, frame) in firsts.iter().enumerate() {
            pictures.push(first(frame, (index + 1, firsts.len()), begun == Some(index), planning_grid));
        }
        for pair in largest(&search) {
            let total = search.last().map_or(0, |last| last.number);
            pictures.extend(improvement(pair, total, planning_grid));
        }
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

    /// The caption; `end` is the proof of the final plan.
    pub fn text(&self, end: Option<Proof>) -> String {
        self.picture().map_or_else(|| format!("Search finished: a plan {}.", good(end)), |it| it.text.clone())
    }
}

/// The largest improvements, and the last, which leads to the plan; in their order.
fn largest<'f>(search: &[&'f FilmFrame]) -> Vec<[&'f FilmFrame; 2]> {
    // Few are kept: a sort would be more code in the page than all of this.
    let mut pairs: Vec<(f64, [&FilmFrame; 2])> = Vec::new();
    for (index, pair) in search.windows(2).enumerate() {
        let is_last = index + 2 == search.len();
        let gain = if is_last { f64::INFINITY } else { won(pair[0], pair[1]) };
        let at = pairs.iter().position(|(other, _)| other.total_cmp(&gain).is_lt()).unwrap_or(pairs.len());
        pairs.insert(at, (gain, [pair[0], pair[1]]));
        pairs.truncate(MOST_SHOWN);
    }
    let mut in_order: Vec<[&FilmFrame; 2]> = Vec::new();
    for (_, pair) in pairs {
        let at = in_order.iter().position(|other| other[1].number > pair[1].number).unwrap_or(in_order.len());
        in_order.insert(at, pair);
    }
    in_order
}

/// The improvement from one walk to the next, as a share of the bound.
fn won(former: &FilmFrame, latter: &FilmFrame) -> f64 {
    let (Some(former), Some(latter)) = (former.proof, latter.proof) else { return 0.0 };
    former.cost.saturating_sub(latter.cost) as f64 / latter.bound.max(1) as f64
}

/// The picture of a walk that the search could start from.
fn first(
    frame: &FilmFrame,
    (number, all): (usize, usize),
    is_chosen: bool,
    planning_grid: &PlanningGrid,
) -> FilmPicture {
    let FilmFrame { walk, planner, .. } = frame;
    let (steps, turns) = (amount(steps(walk), "step"), amount(turns(walk), "turn"));
    let which = if all == 1 { "First walk".to_owned() } else { format!("Construction, {number} of {all}") };
    let chosen = if is_chosen { " The search starts from it." } else { "" };
    FilmPicture {
        lines: vec![(FilmInk::Walk, planning_grid.anchors(walk))],
        tinted: Vec::new(),
        text: format!("{which}: {planner} needs {steps} and {turns}.{chosen}"),
    }
}

/// The pictures of an improvement: the walk before with the changing parts, the parts that stay, and the walk after.
fn improvement([former, latter]: [&FilmFrame; 2], total: u32, planning_grid: &PlanningGrid) -> [FilmPicture; 3] {
    let change = WalkDiff::between(&former.walk, &latter.walk);
    let which = if latter.number > former.number + 1 {
        format!("Improvements {} to {} of {total}", former.number + 1, latter.number)
    } else {
        format!("Improvement {} of {total}", latter.number)
    };
    let parts = change.parts.iter().enumerate();
    let parts: Vec<_> = parts.map(|(index, part)| (FilmInk::Part(index), planning_grid.anchors(part))).collect();
    let mut merged = vec![(FilmInk::Walk, planning_grid.anchors(&latter.walk))];
    merged.extend(change.links.iter().map(|link| (FilmInk::New, planning_grid.anchors(link))));
    let (stay, s) = (parts.len(), if parts.len() == 1 { "s" } else { "" });
    let share = 100.0 * won(former, latter);
    let share = if share < 0.05 { "less than 0.1".to_owned() } else { format!("{share:.1}") };
    let texts = [
        format!("{which}: the tinted cells will change."),
        format!("{which}: the walk is cut there; {} remain{s}.", amount(stay as i64, "part")),
        format!("{which}: rejoined, {} ({share} % of the bound); now {}.", less(&change), good(latter.proof)),
    ];
    let [marked, apart, merged_text] = texts;
    let picture = |lines, text| FilmPicture { lines, tinted: change.cells.clone(), text };
    [
        picture(vec![(FilmInk::Walk, planning_grid.anchors(&former.walk))], marked),
        picture(parts, apart),
        picture(merged, merged_text),
    ]
}

/// Savings in steps and turns, in words.
fn less(change: &WalkDiff) -> String {
    let (steps, turns) = (change.steps, change.turns);
    let each = |difference: i64, unit: &str| {
        let more = if difference < 0 { "more" } else { "fewer" };
        format!("{} {more}", amount(difference.abs(), unit))
    };
    match (steps, turns) {
        (0, 0) => "the turn to its first step saved".to_owned(),
        (0, _) => each(turns, "turn"),
        (_, 0) => each(steps, "step"),
        _ if (steps > 0) == (turns > 0) => format!("{} and {}", amount(steps.abs(), "step"), each(turns, "turn")),
        _ => format!("{} and {}", each(steps, "step"), each(turns, "turn")),
    }
}

/// The proof of a walk, in words.
fn good(proof: Option<Proof>) -> String {
    match proof.map(Proof::gap) {
        None => "not yet compared with a bound".to_owned(),
        Some(gap) if gap <= 0.0 => "proven optimal".to_owned(),
        // Rounded up, as on the page: only an optimal walk is 0 % above.
        Some(gap) => format!("with an optimality gap of {:.1} %", (1000.0 * gap - 1e-6).ceil() / 10.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_improvement_is_shown_though_it_is_the_least() {
        let costs = [100, 90, 89, 80, 79, 60, 55, 54];
        let frame = |(number, &cost): (usize, &u64)| FilmFrame {
            walk: Vec::new(),
            proof: Some(Proof { cost, bound: 50 }),
            planner: String::new(),
            number: number as u32,
        };
        let frames: Vec<FilmFrame> = costs.iter().enumerate().map(frame).collect();
        let search: Vec<&FilmFrame> = frames.iter().collect();
        let shown = |search: &[&FilmFrame]| largest(search).iter().map(|pair| pair[1].number).collect::<Vec<_>>();
        assert_eq!(shown(&search), [1, 3, 5, 7]);
        assert_eq!((shown(&search[..2]), shown(&search[..1]), shown(&[])), (vec![1], vec![], vec![]));
    }
}

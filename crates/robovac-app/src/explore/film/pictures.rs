//! The pictures that a film consists of.

use super::{
    FilmInk, FilmPicture,
    line_diff::LineDiff,
    showing::good,
    walk_diff::{WalkDiff, steps, turns},
};
use crate::amount::amount;
use coverage_planners::{CoveragePath, FilmFrame};
use robovac_core::{coverage::PlanningGrid, geometry::Point};

/// Most improvements that are shown, the largest ones and the last; together they last about a minute (ours).
const MOST_SHOWN: usize = 4;

/// The pictures of a search whose paths are these; walks lie on `planning_grid`.
pub fn pictures(frames: &[FilmFrame], planning_grid: &PlanningGrid) -> Vec<FilmPicture> {
    let (firsts, search): (Vec<&FilmFrame>, Vec<&FilmFrame>) = frames.iter().partition(|frame| frame.proof.is_none());
    // A closed tour continues from there, back to the start.
    let begun = search.first().and_then(|begun| {
        firsts
            .iter()
            .position(|frame| begun.path.cells.starts_with(&frame.path.cells) && begun.path.line == frame.path.line)
    });
    let mut pictures: Vec<FilmPicture> = Vec::new();
    for (index, frame) in firsts.iter().enumerate() {
        let is_chosen = begun == Some(index);
        let seconds = search.first().filter(|begun| is_chosen && begun.path.is_in_metres()).map(|begun| seconds(begun));
        let chosen = match (is_chosen, search.len()) {
            (false, _) => "",
            (true, 1) => " The search finds nothing better.",
            (true, _) => " The search starts from it.",
        };
        pictures.push(first(frame, (index + 1, firsts.len()), chosen, seconds, planning_grid));
    }
    let total = search.last().map_or(0, |last| last.number);
    for pair in largest(&search) {
        let which = which(pair, total);
        if pair[1].path.is_in_metres() {
            pictures.extend(improved_line(pair, &which));
        } else {
            pictures.extend(improved_walk(pair, &which, planning_grid));
        }
    }
    pictures
}

/// The largest improvements, and the last, which leads to the plan; in their order.
fn largest<'f>(search: &[&'f FilmFrame]) -> Vec<[&'f FilmFrame; 2]> {
    let mut pairs: Vec<(usize, [&FilmFrame; 2])> =
        search.windows(2).enumerate().map(|(index, pair)| (index, [pair[0], pair[1]])).collect();
    let last = pairs.len().wrapping_sub(1);
    pairs.sort_by_key(|&(index, [former, latter])| {
        let won = former.proof.zip(latter.proof).map_or(0, |(former, latter)| former.cost.saturating_sub(latter.cost));
        std::cmp::Reverse((index == last, won))
    });
    pairs.truncate(MOST_SHOWN);
    pairs.sort_unstable_by_key(|&(index, _)| index);
    pairs.into_iter().map(|(_, pair)| pair).collect()
}

/// The picture of a path that the search could start from; one in metres takes so many seconds.
fn first(
    frame: &FilmFrame,
    (number, all): (usize, usize),
    chosen: &str,
    seconds: Option<f64>,
    planning_grid: &PlanningGrid,
) -> FilmPicture {
    let FilmFrame { path, planner, .. } = frame;
    let which = match all {
        1 if path.is_in_metres() => "First path".to_owned(),
        1 => "First walk".to_owned(),
        _ => format!("Construction, {number} of {all}"),
    };
    let needs = seconds.map_or_else(
        || format!("{} and {}", amount(steps(&path.cells), "step"), amount(turns(&path.cells), "turn")),
        |seconds| format!("{}, with a stop at each corner", time(seconds)),
    );
    FilmPicture {
        lines: vec![(FilmInk::Path, line(path, planning_grid))],
        tinted: Vec::new(),
        text: format!("{which}: {planner} needs {needs}.{chosen}"),
    }
}

/// A path's line, m.
fn line(path: &CoveragePath, planning_grid: &PlanningGrid) -> Vec<Point> {
    if path.is_in_metres() { path.line.clone() } else { planning_grid.anchors(&path.cells) }
}

/// Time of a path in metres, s.
fn seconds(frame: &FilmFrame) -> f64 {
    frame.proof.map_or(0.0, |proof| proof.cost as f64 / 1000.0)
}

/// Which improvements lie between two frames, of so many.
fn which([former, latter]: [&FilmFrame; 2], total: u32) -> String {
    if latter.number > former.number + 1 {
        format!("Improvements {} to {} of {total}", former.number + 1, latter.number)
    } else {
        format!("Improvement {} of {total}", latter.number)
    }
}

/// The pictures of an improvement in metres: the parts that stay, if any, and the path after.
fn improved_line([former, latter]: [&FilmFrame; 2], which: &str) -> Vec<FilmPicture> {
    let LineDiff { parts, links } = LineDiff::between(&former.path.line, &latter.path.line);
    let picture = |lines, text| FilmPicture { lines, tinted: Vec::new(), text };
    let mut pictures = Vec::new();
    let how = if parts.is_empty() { "every piece moved" } else { "rejoined" };
    if !parts.is_empty() {
        let text = remaining(which, parts.len());
        let parts = parts.into_iter().enumerate().map(|(index, part)| (FilmInk::Part(index), part));
        pictures.push(picture(parts.collect(), text));
    }
    let mut merged = vec![(FilmInk::Path, latter.path.line.clone())];
    merged.extend(links.into_iter().map(|link| (FilmInk::New, link)));
    let (before, now) = (seconds(former), seconds(latter));
    let saved = if before > now { format!("{} saved", time(before - now)) } else { "no time saved".to_owned() };
    pictures.push(picture(merged, format!("{which}: {how}, {saved}; now {}.", time(now))));
    pictures
}

/// A time, as "8.4 s" or "26:47 min".
fn time(seconds: f64) -> String {
    if seconds < 60.0 {
        return format!("{seconds:.1} s");
    }
    let seconds = seconds.round() as u64;
    format!("{}:{:02} min", seconds / 60, seconds % 60)
}

fn remaining(which: &str, parts: usize) -> String {
    let s = if parts == 1 { "s" } else { "" };
    format!("{which}: the path is cut where it changes; {} remain{s}.", amount(parts as i64, "part"))
}

/// The pictures of an improvement: the walk before with the changing parts, the parts that stay, and the walk after.
fn improved_walk([former, latter]: [&FilmFrame; 2], which: &str, planning_grid: &PlanningGrid) -> [FilmPicture; 3] {
    let change = WalkDiff::between(&former.path.cells, &latter.path.cells);
    let parts = change.parts.iter().enumerate();
    let parts: Vec<_> = parts.map(|(index, part)| (FilmInk::Part(index), planning_grid.anchors(part))).collect();
    let mut merged = vec![(FilmInk::Path, planning_grid.anchors(&latter.path.cells))];
    merged.extend(change.links.iter().map(|link| (FilmInk::New, planning_grid.anchors(link))));
    let won = former
        .proof
        .zip(latter.proof)
        .map_or(0.0, |(former, latter)| former.cost.saturating_sub(latter.cost) as f64 / latter.bound.max(1) as f64);
    let share = 100.0 * won;
    let share = if share < 0.05 { "less than 0.1".to_owned() } else { format!("{share:.1}") };
    // Planners that go by the robot's times take longer ways where these have fewer turns.
    let is_dearer = former.proof.zip(latter.proof).is_some_and(|(former, latter)| latter.cost > former.cost);
    let won = if is_dearer { "in less time".to_owned() } else { format!("{share} % of the bound") };
    let texts = [
        format!("{which}: the tinted cells will change."),
        remaining(which, parts.len()),
        format!("{which}: rejoined, {} ({won}); now {}.", less(&change), latter.proof.map_or_else(String::new, good)),
    ];
    let [marked, apart, merged_text] = texts;
    let picture = |lines, text| FilmPicture { lines, tinted: change.cells.clone(), text };
    [
        picture(vec![(FilmInk::Path, planning_grid.anchors(&former.path.cells))], marked),
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

#[cfg(test)]
mod tests {
    use super::*;
    use coverage_planners::Proof;
    use robovac_sim::experiment::planning::RoomSetup;

    fn frame(number: u32, cost: u64, path: CoveragePath) -> FilmFrame {
        FilmFrame { path, proof: Some(Proof { cost, bound: 50 }), planner: String::new(), number }
    }

    #[test]
    fn the_last_improvement_is_shown_though_it_is_the_least() {
        let costs = [100, 90, 89, 80, 79, 60, 55, 54];
        let frames: Vec<FilmFrame> =
            costs.iter().enumerate().map(|(i, &cost)| frame(i as u32, cost, CoveragePath::default())).collect();
        let search: Vec<&FilmFrame> = frames.iter().collect();
        let shown = |search: &[&FilmFrame]| largest(search).iter().map(|pair| pair[1].number).collect::<Vec<_>>();
        assert_eq!(shown(&search), [1, 3, 5, 7]);
        assert_eq!((shown(&search[..2]), shown(&search[..1]), shown(&[])), (vec![1], vec![], vec![]));
    }

    #[test]
    fn a_search_in_metres_shows_what_stays_and_what_is_new() {
        let line = |corners: &[(f64, f64)]| {
            CoveragePath::in_metres(corners.iter().map(|&(x, y)| Point::new(x, y)).collect::<Vec<_>>())
        };
        let former = line(&[(0.0, 0.0), (3.0, 0.0), (3.0, 0.2), (0.0, 0.2)]);
        let latter = line(&[(0.0, 0.0), (3.0, 0.0), (3.0, 0.1)]);
        let begun = FilmFrame { path: former.clone(), proof: None, planner: "Lanes".to_owned(), number: 0 };
        let frames = [begun, frame(0, 61_000, former.clone()), frame(1, 58_500, latter.clone())];
        let room = (robovac_core::floor_plan::room("empty").unwrap().build)();
        let room = RoomSetup::new(&room, robovac_core::robot::model("roomba600").unwrap(), 0.2, None).unwrap();
        let shown = pictures(&frames, &room.planning_grid);
        let texts: Vec<&str> = shown.iter().map(|picture| picture.text.as_str()).collect();
        assert_eq!(
            texts,
            [
                "First path: Lanes needs 1:01 min, with a stop at each corner. The search starts from it.",
                "Improvement 1 of 1: the path is cut where it changes; 1 part remains.",
                "Improvement 1 of 1: rejoined, 2.5 s saved; now 58.5 s.",
            ]
        );
        let alone = pictures(&frames[..2], &room.planning_grid);
        assert!(alone.len() == 1 && alone[0].text.ends_with(" The search finds nothing better."), "{}", alone[0].text);
        assert_eq!(shown[1].lines, [(FilmInk::Part(0), former.line[..2].to_vec())]);
        assert_eq!(shown[2].lines, [(FilmInk::Path, latter.line.clone()), (FilmInk::New, latter.line[1..].to_vec())]);
    }
}

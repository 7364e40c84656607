//! Closes small gaps between the ends of walls.

use robovac_core::{
    geometry::{Point, nearest_on_segment},
    math::{ceil, floor},
};
use std::ops::ControlFlow;

/// Most comparisons of an end with an end or a segment, and squares visited for them (ours). Only drawings with crowded
/// ends need more; ends not compared by then are left open.
const MAX_COMPARISONS: usize = 40_000_000;

/// A point of an end's own wall is the other side of a gap if the way to it along the wall is this many times the
/// straight distance (ours): around a right angle it is 1.4 times, around a half circle 1.6 times.
const DETOUR: f64 = 3.0;

/// Most squares along a side of the grid of ends.
const MAX_SQUARES: usize = 1024;

/// A wall's stroke as its corners; `is_closed` if its last corner is joined to its first.
pub(super) struct WallStroke<'a> {
    pub corners: &'a [Point],
    pub is_closed: bool,
    /// Half its width.
    pub half: f64,
}

/// Lines that close gaps of up to `gap`: from ends of strokes that nothing touches to the nearest such end or wall,
/// nearest first, one for every end. Ends closer than `touching`, and those within a wide wall, count as joined. All in the same unit.
pub(super) fn bridges(walls: &[WallStroke<'_>], gap: f64, touching: f64) -> Vec<[Point; 2]> {
    let mut ends: Vec<StrokeEnd> = Vec::new();
    for (wall, stroke) in walls.iter().enumerate().filter(|(_, stroke)| !stroke.is_closed) {
        let last = stroke.corners.len().saturating_sub(1);
        let both = [(0, stroke.corners.first()), (last, stroke.corners.last())];
        ends.extend(
            both.into_iter().filter_map(|(corner, at)| Some(StrokeEnd { at: *at?, wall, corner, nearest: None })),
        );
    }
    let widest = walls.iter().map(|wall| wall.half).fold(0.0, f64::max);
    let Some(squares) = Squares::of(&ends, gap.max(touching) + widest) else { return Vec::new() };
    let mut left = MAX_COMPARISONS;
    // The nearest point of another wall for every end; and of its own wall, unless the wall leads straight there.
    for (wall, stroke) in walls.iter().enumerate() {
        let count = stroke.corners.len();
        let segments = if stroke.is_closed { count } else { count.saturating_sub(1) };
        let length = length(stroke);
        let mut before = 0.0;
        for i in 0..segments {
            let (a, b) = (stroke.corners[i], stroke.corners[(i + 1) % count]);
            let searched = squares.near(a, b, &mut left, |index| {
                let end = &mut ends[index];
                let at = nearest_on_segment(a, b, end.at);
                let away = (at - end.at).norm();
                if end.wall == wall {
                    let along = before + (at - a).norm();
                    let along = if end.corner == 0 { along } else { length - along };
                    if along <= DETOUR * away.max(touching) {
                        return;
                    }
                }
                // To the wall's face.
                let away = (away - stroke.half).max(0.0);
                if away <= gap.max(touching) && end.nearest.is_none_or(|(best, _)| away < best) {
                    end.nearest = Some((away, at));
                }
            });
            if searched.is_break() {
                // No end has been compared with all walls.
                return Vec::new();
            }
            before += (b - a).norm();
        }
    }
    let mut candidates: Vec<Candidate> = Vec::new();
    let is_free = |end: &StrokeEnd| end.nearest.is_none_or(|(away, _)| away > touching);
    for (index, end) in ends.iter().enumerate().filter(|(_, end)| is_free(end)) {
        let finished = candidates.len();
        let mut searched = ControlFlow::Continue(());
        if let Some((away, at)) = end.nearest {
            // The nearest point can be the end of a wall.
            let mut to = None;
            searched = squares.near(at, at, &mut left, |other| {
                if other != index && is_free(&ends[other]) && (ends[other].at - at).norm() <= touching {
                    to = Some(other);
                }
            });
            candidates.push(Candidate { away, from: index, to, needs_end: false, at });
        }
        if searched.is_continue() {
            searched = squares.near(end.at, end.at, &mut left, |other| {
                let away = (ends[other].at - end.at).norm();
                // The two ends of a short wall are no gap.
                let is_short = ends[other].wall == end.wall && length(&walls[end.wall]) <= DETOUR * away;
                if other > index && is_free(&ends[other]) && away <= gap && !is_short {
                    let at = ends[other].at;
                    candidates.push(Candidate { away, from: index, to: Some(other), needs_end: true, at });
                }
            });
        }
        if searched.is_break() {
            candidates.truncate(finished);
            break;
        }
    }
    // Two ends that meet close two gaps at once, so they precede an end and a wall at the same distance.
    candidates.sort_by(|one, other| {
        one.away.total_cmp(&other.away).then(other.to.cmp(&one.to)).then(one.from.cmp(&other.from))
    });
    let mut is_used = vec![false; ends.len()];
    let mut bridges = Vec::new();
    for Candidate { from, to, needs_end, at, .. } in candidates {
        if is_used[from] || needs_end && to.is_some_and(|to| is_used[to]) {
            continue;
        }
        is_used[from] = true;
        if let Some(to) = to {
            is_used[to] = true;
        }
        bridges.push([ends[from].at, to.map_or(at, |to| ends[to].at)]);
    }
    bridges
}

/// Length of a stroke from its first corner to its last; a closed one has no ends.
fn length(stroke: &WallStroke<'_>) -> f64 {
    if stroke.is_closed { 0.0 } else { stroke.corners.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum() }
}

struct StrokeEnd {
    at: Point,
    wall: usize,
    /// Index of its corner in its wall.
    corner: usize,
    /// Distance of the nearest point of a wall, and the point.
    nearest: Option<(f64, Point)>,
}

struct Candidate {
    away: f64,
    from: usize,
    /// The other end, if there is one.
    to: Option<usize>,
    /// Whether that end must be unjoined: the nearest wall can be joined more than once.
    needs_end: bool,
    at: Point,
}

/// Ends, indexed by square.
struct Squares {
    low: Point,
    side: f64,
    reach: f64,
    columns: usize,
    rows: usize,
    /// Where every square's ends begin in `ends`, and the end of the last one's.
    starts: Vec<u32>,
    ends: Vec<u32>,
}

impl Squares {
    fn of(ends: &[StrokeEnd], reach: f64) -> Option<Self> {
        let low = ends.iter().map(|end| end.at).reduce(|low, at| low.inf(&at))?;
        let high = ends.iter().map(|end| end.at).reduce(|high, at| high.sup(&at))?;
        let size = high - low;
        let side = reach.max(size.x.max(size.y) / MAX_SQUARES as f64).max(f64::MIN_POSITIVE);
        let count = |length: f64| (floor(length / side).max(0) as usize + 1).min(MAX_SQUARES + 1);
        let (columns, rows) = (count(size.x), count(size.y));
        let mut squares =
            Self { low, side, reach, columns, rows, starts: vec![0; columns * rows + 1], ends: vec![0; ends.len()] };
        let square = |end: &StrokeEnd| {
            let cell = (end.at - low) / side;
            let [x, y] = [cell.x as usize, cell.y as usize];
            y.min(rows - 1) * columns + x.min(columns - 1)
        };
        for end in ends {
            squares.starts[square(end) + 1] += 1;
        }
        for i in 0..columns * rows {
            squares.starts[i + 1] += squares.starts[i];
        }
        let mut next = squares.starts.clone();
        for (index, end) in ends.iter().enumerate() {
            let slot = &mut next[square(end)];
            squares.ends[*slot as usize] = index as u32;
            *slot += 1;
        }
        Some(squares)
    }

    /// All ends that can be within reach of the segment; some can appear twice. Stops when no comparisons are `left`.
    fn near(&self, a: Point, b: Point, left: &mut usize, mut found: impl FnMut(usize)) -> ControlFlow<()> {
        let (from, to) = ((a - self.low) / self.side, (b - self.low) / self.side);
        let reach = self.reach / self.side;
        // Only what crosses the squares, in pieces no longer than a few of them.
        let Some((from, to)) = clip(Point::from(from), Point::from(to), self.columns as f64, self.rows as f64, reach)
        else {
            return ControlFlow::Continue(());
        };
        let pieces = ceil((to - from).norm() / 4.0).max(1);
        for piece in 0..pieces {
            let at = |i: i32| from + (to - from) * (f64::from(i) / f64::from(pieces));
            let (one, other) = (at(piece), at(piece + 1));
            let range = |low: f64, high: f64, count: usize| {
                let first = floor(low - reach).clamp(0, count as i32 - 1) as usize;
                first..=floor(high + reach).clamp(0, count as i32 - 1) as usize
            };
            for row in range(one.y.min(other.y), one.y.max(other.y), self.rows) {
                for column in range(one.x.min(other.x), one.x.max(other.x), self.columns) {
                    let square = row * self.columns + column;
                    let ends = &self.ends[self.starts[square] as usize..self.starts[square + 1] as usize];
                    let Some(rest) = left.checked_sub(1 + ends.len()) else {
                        *left = 0;
                        return ControlFlow::Break(());
                    };
                    *left = rest;
                    for &end in ends {
                        found(end as usize);
                    }
                }
            }
        }
        ControlFlow::Continue(())
    }
}

/// The part of a segment within the rectangle from the origin to (width, height), widened by `reach` (Liang and Barsky's
/// clipping).
fn clip(a: Point, b: Point, width: f64, height: f64, reach: f64) -> Option<(Point, Point)> {
    let way = b - a;
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    let sides =
        [(-way.x, a.x + reach), (way.x, width + reach - a.x), (-way.y, a.y + reach), (way.y, height + reach - a.y)];
    for (speed, room) in sides {
        if speed == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if speed < 0.0 {
            first = first.max(room / speed);
        } else {
            last = last.min(room / speed);
        }
    }
    (first <= last).then(|| (a + way * first, a + way * last))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn closed(strokes: &[&[(f64, f64)]], gap: f64) -> Vec<[(f64, f64); 2]> {
        let corners: Vec<Vec<Point>> =
            strokes.iter().map(|stroke| stroke.iter().map(|&(x, y)| Point::new(x, y)).collect()).collect();
        let walls: Vec<WallStroke<'_>> =
            corners.iter().map(|corners| WallStroke { corners, is_closed: false, half: 0.0 }).collect();
        bridges(&walls, gap, 0.001).into_iter().map(|ends| ends.map(|end| (end.x, end.y))).collect()
    }

    #[test]
    fn ends_are_joined_if_they_are_near() {
        let walls: &[&[(f64, f64)]] = &[&[(0.0, 0.0), (1.0, 0.0)], &[(1.8, 0.0), (3.0, 0.0)]];
        assert_eq!(closed(walls, 0.9), [[(1.0, 0.0), (1.8, 0.0)]]);
        assert!(closed(walls, 0.7).is_empty());
        // The door in the outline of a room.
        let room: &[&[(f64, f64)]] = &[&[(1.0, 0.0), (0.0, 0.0), (0.0, 3.0), (4.0, 3.0), (4.0, 0.0), (1.8, 0.0)]];
        assert_eq!(closed(room, 0.9), [[(1.0, 0.0), (1.8, 0.0)]]);
    }

    #[test]
    fn an_end_is_joined_to_a_wall() {
        let walls: &[&[(f64, f64)]] = &[&[(0.0, 0.0), (5.0, 0.0)], &[(2.0, 0.3), (2.0, 4.0)]];
        assert_eq!(closed(walls, 0.5), [[(2.0, 0.3), (2.0, 0.0)]]);
    }

    #[test]
    fn what_touches_is_joined_already() {
        let corner: &[&[(f64, f64)]] = &[&[(0.0, 0.0), (1.0, 0.0)], &[(1.0, 0.000_5), (1.0, 1.0)]];
        assert!(closed(corner, 0.5).is_empty());
        let tee: &[&[(f64, f64)]] = &[&[(0.0, 0.0), (2.0, 0.0)], &[(1.0, 0.0), (1.0, 1.0)]];
        assert!(closed(tee, 0.5).is_empty());
    }

    #[test]
    fn the_nearest_come_first_and_an_end_is_taken_once() {
        let walls: &[&[(f64, f64)]] =
            &[&[(-1.0, 0.0), (0.0, 0.0)], &[(0.2, 0.0), (0.25, 5.0)], &[(0.2, -0.3), (0.25, -5.0)]];
        assert_eq!(closed(walls, 0.4), [[(0.0, 0.0), (0.2, 0.0)], [(0.2, -0.3), (0.2, 0.0)]]);
    }

    #[test]
    fn ends_of_a_curved_wall_are_not_joined_to_the_wall_itself() {
        let at = |degrees: i32| {
            let angle = f64::from(degrees).to_radians();
            (2.0 * angle.cos(), 2.0 * angle.sin())
        };
        let arc: Vec<(f64, f64)> = (13..=347).step_by(2).map(at).collect();
        assert_eq!(closed(&[&arc], 1.0), [[at(13), at(347)]]);
        assert!(closed(&[&arc], 0.8).is_empty());
        // Nor is a short wall joined to itself.
        assert!(closed(&[&[(0.0, 0.0), (0.5, 0.0)]], 1.0).is_empty());
    }

    #[test]
    fn a_spent_budget_ends_the_search_and_joins_no_ends() {
        // 7000 strokes with all their ends near one another.
        let strokes: Vec<[Point; 2]> = (0..7000)
            .map(|i| [0.0, 0.5].map(|y| Point::new(f64::from(i) * 1e-4, y + f64::from(i % 7) * 0.01)))
            .collect();
        let walls: Vec<WallStroke<'_>> =
            strokes.iter().map(|corners| WallStroke { corners, is_closed: false, half: 0.0 }).collect();
        assert!(bridges(&walls, 1.0, 1e-6).is_empty());
        let ends: Vec<StrokeEnd> =
            strokes.iter().map(|corners| StrokeEnd { at: corners[0], wall: 0, corner: 0, nearest: None }).collect();
        let squares = Squares::of(&ends, 1.0).unwrap();
        let (mut left, mut seen) = (6999, 0);
        assert!(squares.near(ends[0].at, ends[0].at, &mut left, |_| seen += 1).is_break());
        assert_eq!((left, seen), (0, 0));
    }
}

//! Outlines of furniture whose sides are strokes of their own, as many drawing programs write them.

use super::TOUCHING;
use crate::{Drawing, Role, Tracing, model::Stroke};
use robovac_core::{
    floor_plan::encloses,
    geometry::{Point, nearest_on_segment},
};
use std::{
    borrow::Cow,
    collections::{BTreeMap, BTreeSet},
};

/// Most area of a piece of furniture, m² (ours): a double bed covers 4, a corner kitchen 6. What lines of obstacles enclose
/// beyond that is a part of the floor.
const MOST: f64 = 15.0;
/// A wall deeper than this inside an outline tells that it is a room, m (ours): furniture stands against walls.
const DEEP: f64 = 0.1;
/// Most comparisons of ends with ends and of corners of walls with outlines (ours); beyond that, strokes stay as drawn.
const MAX_COMPARISONS: usize = 40_000_000;

/// The drawing with one closed outline in place of the open strokes of obstacles that go round a piece of furniture from end
/// to end. Open strokes that don't, and those round more than furniture, stay.
pub(super) fn joined<'a>(drawing: &'a Drawing, how: &Tracing) -> Cow<'a, Drawing> {
    let role = |stroke: &Stroke| how.roles.get(stroke.layer as usize).copied();
    let is_open = |stroke: &&Stroke| !stroke.is_closed && role(stroke) == Some(Role::Obstacle);
    let strokes: Vec<&Stroke> = drawing.strokes.iter().filter(is_open).collect();
    let mut left = MAX_COMPARISONS;
    let Some(graph) = StrokeGraph::new(drawing, &strokes, TOUCHING / how.metre, &mut left) else {
        return Cow::Borrowed(drawing);
    };
    let mut outlines: BTreeMap<usize, JoinedOutline> = BTreeMap::new();
    for (part, outline) in graph.outlines() {
        // Crossing strokes can have several.
        if outlines.get(&part).is_none_or(|other| other.area < outline.area) {
            outlines.insert(part, outline);
        }
    }
    outlines.retain(|_, outline| outline.area > 0.0 && outline.area * how.metre * how.metre <= MOST);
    if outlines.is_empty() {
        return Cow::Borrowed(drawing);
    }
    let mut walls: Vec<Point> = drawing
        .strokes
        .iter()
        .filter(|stroke| role(stroke) == Some(Role::Wall))
        .flat_map(|stroke| drawing.corners(stroke).iter().copied())
        .collect();
    walls.sort_by(|one, other| one.x.total_cmp(&other.x));
    outlines.retain(|_, outline| !outline.holds(&walls, DEEP / how.metre, &mut left));
    let replaced: BTreeSet<u32> = (0..strokes.len())
        .filter(|&edge| graph.part(edge).is_some_and(|part| outlines.contains_key(&part)))
        .map(|edge| strokes[edge].points.start)
        .collect();
    let mut drawing = drawing.clone();
    drawing.strokes.retain(|stroke| !replaced.contains(&stroke.points.start));
    for JoinedOutline { corners, edge, .. } in outlines.into_values() {
        let start = drawing.points.len() as u32;
        drawing.points.extend(corners);
        let points = start..drawing.points.len() as u32;
        drawing.strokes.push(Stroke { is_closed: true, points, ..strokes[edge].clone() });
    }
    Cow::Owned(drawing)
}

/// What goes round connected strokes.
struct JoinedOutline {
    corners: Vec<Point>,
    /// Drawing units².
    area: f64,
    /// One of its strokes.
    edge: usize,
}

impl JoinedOutline {
    /// Whether one of the points, sorted by x, lies deeper inside than `deep`; if the comparisons run out, it may.
    fn holds(&self, points: &[Point], deep: f64, left: &mut usize) -> bool {
        let (low, high) =
            self.corners.iter().fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at.x), high.max(at.x)));
        let [first, end] = [low, high].map(|x| points.partition_point(|at| at.x < x));
        let work = (end - first).saturating_mul(self.corners.len());
        if work > *left {
            return true;
        }
        *left -= work;
        let edges = || self.corners.iter().zip(self.corners.iter().cycle().skip(1));
        let is_deep = |at: &Point| edges().all(|(&a, &b)| (nearest_on_segment(a, b, *at) - at).norm() > deep);
        points[first..end].iter().any(|at| encloses(&self.corners, *at) && is_deep(at))
    }
}

/// Strokes joined at their ends, without those that lead nowhere.
struct StrokeGraph<'a> {
    corners: Vec<&'a [Point]>,
    /// The joints at both ends of every stroke.
    ends: Vec<[usize; 2]>,
    /// Whether a stroke is a part of a way round.
    leads_on: Vec<bool>,
    /// The strokes that leave a joint, counter-clockwise: twice the stroke's index, plus 1 where it is left at its last corner.
    leaving: Vec<Vec<usize>>,
    /// The connected part of every joint.
    parts: Vec<usize>,
}

impl<'a> StrokeGraph<'a> {
    /// `None` if there are too many ends in one place.
    fn new(drawing: &'a Drawing, strokes: &[&Stroke], touching: f64, left: &mut usize) -> Option<Self> {
        let corners: Vec<&[Point]> = strokes.iter().map(|stroke| drawing.corners(stroke)).collect();
        let mut joints = Joints { at: Vec::new(), squares: BTreeMap::new(), touching };
        let mut ends = Vec::with_capacity(corners.len());
        for stroke in &corners {
            let (&first, &last) = (stroke.first()?, stroke.last()?);
            ends.push([joints.of(first, left)?, joints.of(last, left)?]);
        }
        let mut leaving: Vec<Vec<usize>> = vec![Vec::new(); joints.at.len()];
        for (edge, [a, b]) in ends.iter().enumerate() {
            leaving[*a].push(2 * edge);
            leaving[*b].push(2 * edge + 1);
        }
        let mut degrees: Vec<usize> = leaving.iter().map(Vec::len).collect();
        let mut leads_on = vec![true; ends.len()];
        let mut dead: Vec<usize> = (0..leaving.len()).filter(|&joint| degrees[joint] == 1).collect();
        while let Some(joint) = dead.pop() {
            let Some(&half) = leaving[joint].iter().find(|&&half| leads_on[half / 2]) else { continue };
            leads_on[half / 2] = false;
            let other = ends[half / 2][1 - half % 2];
            degrees[other] -= 1;
            if degrees[other] == 1 {
                dead.push(other);
            }
        }
        for halves in &mut leaving {
            halves.retain(|half| leads_on[half / 2]);
        }
        let parts = vec![usize::MAX; joints.at.len()];
        let mut graph = Self { corners, ends, leads_on, leaving, parts };
        for joint in 0..graph.leaving.len() {
            let mut halves = std::mem::take(&mut graph.leaving[joint]);
            halves.sort_by(|&one, &other| graph.direction(one).total_cmp(&graph.direction(other)));
            graph.leaving[joint] = halves;
            let mut waiting = vec![joint];
            while let Some(next) = waiting.pop() {
                if graph.parts[next] == usize::MAX {
                    graph.parts[next] = joint;
                    waiting.extend(graph.leaving[next].iter().map(|&half| graph.target(half)));
                }
            }
        }
        Some(graph)
    }

    /// The joint that half a stroke leads to.
    fn target(&self, half: usize) -> usize {
        self.ends[half / 2][1 - half % 2]
    }

    /// The connected part that a stroke belongs to, unless it leads nowhere.
    fn part(&self, edge: usize) -> Option<usize> {
        self.leads_on[edge].then_some(self.parts[self.ends[edge][0]])
    }

    /// The corners of half a stroke in its direction.
    fn along(&self, half: usize) -> impl Iterator<Item = Point> + '_ {
        let corners = self.corners[half / 2];
        let count = corners.len();
        (0..count).map(move |i| corners[if half.is_multiple_of(2) { i } else { count - 1 - i }])
    }

    /// A measure of the direction in which half a stroke leaves its joint, 0 to 4, that grows counter-clockwise from +x.
    fn direction(&self, half: usize) -> f64 {
        let mut ends = self.along(half);
        let (Some(from), Some(to)) = (ends.next(), ends.next()) else { return 0.0 };
        let way = to - from;
        let x = way.x / (way.x.abs() + way.y.abs());
        if way.y < 0.0 { 3.0 + x } else { 1.0 - x }
    }

    /// What goes round every connected part: walks that always turn left as sharply as they can go counter-clockwise
    /// round the areas between strokes, but clockwise round all of them.
    fn outlines(&self) -> Vec<(usize, JoinedOutline)> {
        let mut place = vec![0; 2 * self.ends.len()];
        for halves in &self.leaving {
            for (i, &half) in halves.iter().enumerate() {
                place[half] = i;
            }
        }
        let mut outlines = Vec::new();
        let mut is_walked = vec![false; place.len()];
        for &first in self.leaving.iter().flatten() {
            let mut corners: Vec<Point> = Vec::new();
            let mut half = first;
            while !is_walked[half] {
                is_walked[half] = true;
                corners.extend(self.along(half));
                // Its last corner is the first one of the next.
                corners.pop();
                let around = &self.leaving[self.target(half)];
                half = around[(place[half ^ 1] + around.len() - 1) % around.len()];
            }
            let Some(&origin) = corners.first() else { continue };
            let edges = corners.iter().zip(corners.iter().cycle().skip(1));
            let twice: f64 = edges.map(|(a, b)| (a - origin).perp(&(b - origin))).sum();
            if twice < 0.0 {
                outlines.push((
                    self.parts[self.target(first)],
                    JoinedOutline { area: -0.5 * twice, corners, edge: first / 2 },
                ));
            }
        }
        outlines
    }
}

/// Places where ends of strokes meet.
struct Joints {
    at: Vec<Point>,
    squares: BTreeMap<[i64; 2], Vec<usize>>,
    touching: f64,
}

impl Joints {
    /// The joint of an end.
    fn of(&mut self, end: Point, left: &mut usize) -> Option<usize> {
        let square = [end.x, end.y].map(|value| (value / self.touching) as i64);
        for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
            let near = [square[0].saturating_add(dx), square[1].saturating_add(dy)];
            for &joint in self.squares.get(&near).into_iter().flatten() {
                *left = left.checked_sub(1)?;
                if (self.at[joint] - end).norm() <= self.touching {
                    return Some(joint);
                }
            }
        }
        self.squares.entry(square).or_default().push(self.at.len());
        self.at.push(end);
        Some(self.at.len() - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AreaFill, DrawingLayer, DrawingRegion};

    /// A drawing of open strokes in metres: walls on the first layer, obstacles on the second.
    fn drawn(lines: &[(u32, &[(f64, f64)])]) -> (Drawing, Tracing) {
        let (mut strokes, mut points) = (Vec::new(), Vec::new());
        for (layer, corners) in lines {
            let start = points.len() as u32;
            points.extend(corners.iter().map(|&(x, y)| Point::new(x, y)));
            strokes.push(Stroke {
                layer: *layer,
                entity: 1,
                is_closed: false,
                width: 0.0,
                fill: AreaFill::None,
                points: start..points.len() as u32,
            });
        }
        let roles = vec![Role::Wall, Role::Obstacle];
        let layer = |role: &Role| DrawingLayer { name: String::new(), colour: [0; 3], strokes: 1, role: *role };
        let layers = roles.iter().map(layer).collect();
        let drawing = Drawing { name: String::new(), metre: None, layers, strokes, points, left_out: Vec::new() };
        (drawing, Tracing { roles, metre: 1.0, gap: 0.0, resolution: 0.05, region: DrawingRegion::WHOLE })
    }

    /// Numbers of corners of the closed outlines, and number of open strokes.
    fn counts(lines: &[(u32, &[(f64, f64)])]) -> (Vec<usize>, usize) {
        let (drawing, how) = drawn(lines);
        let joined = joined(&drawing, &how);
        let closed = joined.strokes.iter().filter(|stroke| stroke.is_closed);
        let open = joined.strokes.iter().filter(|stroke| !stroke.is_closed).count();
        (closed.map(|stroke| joined.corners(stroke).len()).collect(), open)
    }

    const BED: [(u32, &[(f64, f64)]); 4] = [
        (1, &[(0.0, 0.0), (1.6, 0.0)]),
        (1, &[(1.6, 2.0), (1.6, 0.0)]),
        (1, &[(1.6, 2.0), (0.0, 2.0)]),
        (1, &[(0.0, 0.0), (0.0, 2.0)]),
    ];

    #[test]
    fn a_bed_of_four_lines_has_one_outline() {
        assert_eq!(counts(&BED), (vec![4], 0));
        // With a fold in the blanket from corner to corner, and a line that leads nowhere.
        let more: [(u32, &[(f64, f64)]); 2] = [(1, &[(0.0, 0.0), (1.6, 2.0)]), (1, &[(1.6, 2.0), (2.0, 2.5)])];
        assert_eq!(counts(&[&BED[..], &more[..]].concat()), (vec![4], 1));
        // An outline that is drawn back to its start, and two that meet in a corner.
        let round: (u32, &[(f64, f64)]) = (1, &[(1.6, 2.0), (2.6, 2.0), (2.6, 3.0), (1.6, 2.0)]);
        assert_eq!(counts(&[round]), (vec![3], 0));
        assert_eq!(counts(&[&BED[..], &[round]].concat()), (vec![7], 0));
        assert_eq!(counts(&BED[1..]), (vec![], 3));
    }

    #[test]
    fn what_holds_more_than_furniture_stays_open() {
        let scaled = |factor: f64| -> Vec<Vec<(f64, f64)>> {
            BED.iter().map(|(_, line)| line.iter().map(|(x, y)| (factor * x, factor * y)).collect()).collect()
        };
        // 12.8 and 20 m².
        for (factor, expected) in [(2.0, (vec![4], 0)), (2.5, (vec![], 4))] {
            let lines = scaled(factor);
            let lines: Vec<(u32, &[(f64, f64)])> = lines.iter().map(|line| (1, &line[..])).collect();
            assert_eq!(counts(&lines), expected, "{factor}");
        }
        // A wall inside, but not one behind it; and walls have no outlines of their own.
        let with = |wall: &'static [(f64, f64)]| counts(&[&BED[..], &[(0, wall)]].concat());
        assert_eq!(with(&[(-1.0, 1.0), (0.8, 1.0)]), (vec![], 5));
        assert_eq!(with(&[(-1.0, 0.05), (0.8, 0.05)]), (vec![4], 1));
        assert_eq!(counts(&BED.map(|(_, line)| (0, line))), (vec![], 4));
    }
}

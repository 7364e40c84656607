//! A line of corners with rounded corners.

use super::{
    DriveLimits,
    clothoid::{advance, unit_end},
    profile::{squares, time},
};
use crate::{
    geometry::{Point, Pose, Vector, difference},
    math,
};

/// Turns below are none, rad.
const NO_TURN: f64 = 1e-9;
/// Sharpest turn that can be rounded, rad: a reversal has no inner side.
const SHARPEST: f64 = 3.0;
/// Sharpest first or second half of a U-turn, rad.
const SHARPEST_HALF: f64 = 2.2;
/// Longest stretch of a curve, m, and fewest stretches of a clothoid.
const CURVE_STEP: (f64, u32) = (0.004, 4);
/// Longest stretch of a straight piece near its ends, m, and how far that is, m: there the speed can change.
const STRAIGHT_STEP: (f64, f64) = (0.005, 0.08);

/// How a corner is driven.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Rounding {
    /// Stop there, and turn on the spot.
    #[default]
    Stop,
    /// Two clothoids that begin and end this far from it, m.
    Alone(f64),
    /// One clothoid to the middle of a U-turn with the next corner, whose shape must be [`Rounding::Second`].
    First,
    /// The second half of a U-turn.
    Second,
}

/// What a rounded corner takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CornerShape {
    /// How far before and behind the corner the curve begins and ends, m.
    pub tangents: [f64; 2],
    /// Its greatest curvature, 1/m.
    pub curvature: f64,
    /// How far it passes from the corner, m.
    pub cut: f64,
}

/// A short part of a path; along it the curvature changes linearly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Where it begins.
    pub start: Pose,
    /// Its length, m.
    pub length: f64,
    /// Curvature at its start and end, 1/m, positive to the left.
    pub curvature: [f64; 2],
    /// Number of the corner that it leads to or round.
    pub corner: usize,
}

impl Stretch {
    /// The pose after a share of it, 0 to 1.
    pub fn at(&self, share: f64) -> Pose {
        let [from, to] = self.curvature;
        let (length, to) = (self.length * share, from + (to - from) * share);
        let [x, y] = advance(self.start.heading, length, [from, to]);
        Pose::new(self.start.x + x, self.start.y + y, self.start.heading + 0.5 * length * (from + to))
    }

    /// Whether it is part of a curve.
    pub fn is_curved(&self) -> bool {
        self.curvature != [0.0; 2]
    }
}

/// A part of a rounded line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Part {
    Go(Stretch),
    /// A turn on the spot at a pose, by an angle, rad, at that corner.
    Turn(Pose, f64, usize),
}

/// A line whose corners are rounded or are turns on the spot.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RoundedLine {
    pub(super) parts: Vec<Part>,
    pub(super) end: Option<Pose>,
}

impl Part {
    fn stretch(&self) -> Option<&Stretch> {
        match self {
            Self::Go(stretch) => Some(stretch),
            Self::Turn(..) => None,
        }
    }
}

impl CornerShape {
    /// Two clothoids round a corner that turns by `turn` radians, from `tangent` metres before it to as far behind it; `None` if it
    /// can't be rounded.
    pub fn alone(turn: f64, tangent: f64) -> Option<Self> {
        let half = 0.5 * turn.abs();
        if !(NO_TURN..=SHARPEST).contains(&turn.abs()) || tangent <= 0.0 {
            return None;
        }
        let [x, y] = unit_end(half);
        let (sin, cos) = math::sin_cos(half);
        let curvature = (x + y * sin / cos) / tangent;
        Some(Self { tangents: [tangent; 2], curvature, cut: y / cos / curvature })
    }

    /// The halves of a U-turn: two corners that turn by `turns` in the same sense, with `between` metres from one to the other.
    /// `None` if they aren't the halves of one.
    pub fn u_turn(turns: [f64; 2], between: f64) -> Option<[Self; 2]> {
        let sizes = turns.map(f64::abs);
        if turns[0] * turns[1] <= 0.0
            || sizes.iter().any(|size| !(0.2..=SHARPEST_HALF).contains(size))
            || between <= 0.0
        {
            return None;
        }
        // From the corner, the middle of the turn is so far along the piece between, for a curvature of 1.
        let halves = sizes.map(|size| {
            let [x, y] = unit_end(size);
            let (sin, cos) = math::sin_cos(size);
            (size, x - y * cos / sin, y / sin)
        });
        let curvature = (halves[0].2 + halves[1].2) / between;
        let shape = |(size, outer, inner): (f64, f64, f64)| Self {
            tangents: [outer / curvature, inner / curvature],
            curvature,
            cut: nearest(size, outer) / curvature,
        };
        let [first, second] = halves.map(shape);
        Some([first, Self { tangents: [second.tangents[1], second.tangents[0]], ..second }])
    }
}

/// How near a unit clothoid that turns by `turn` comes to the point `ahead` of its start.
fn nearest(turn: f64, ahead: f64) -> f64 {
    const STEPS: u32 = 32;
    let (mut x, mut y, mut least) = (0.0, 0.0, ahead.abs());
    let step = 2.0 * turn / f64::from(STEPS);
    for i in 0..STEPS {
        let share = [i, i + 1].map(|i| f64::from(i) / f64::from(STEPS));
        let [dx, dy] = advance(turn * share[0] * share[0], step, share);
        (x, y) = (x + dx, y + dy);
        least = least.min(math::hypot(x - ahead, y));
    }
    least
}

/// The turn at each corner of a line, rad, counter-clockwise positive; 0 at its ends, where no length is, and nearly 0 for none.
pub(super) fn turns(line: &[Point]) -> Vec<f64> {
    let mut turns = vec![0.0; line.len()];
    for (i, three) in line.windows(3).enumerate() {
        let (a, b) = (three[1] - three[0], three[2] - three[1]);
        let turn = math::atan2(a.perp(&b), a.dot(&b));
        turns[i + 1] = if turn.abs() > NO_TURN { turn } else { 0.0 };
    }
    turns
}

impl RoundedLine {
    /// The turns at the corners of a line, rad, counter-clockwise positive; 0 at its ends.
    pub fn turns(line: &[Point]) -> Vec<f64> {
        turns(line)
    }

    /// Rounds `line` (corners in metres, no two in a row in the same place), for a robot that looks along `heading` at its start.
    /// `roundings` has one entry for each corner, the ends included; those that don't fit are stops.
    pub fn new(line: &[Point], heading: f64, roundings: &[Rounding]) -> Self {
        let mut rounded = Self::default();
        let turns = turns(line);
        let length = |i: usize| (line[i + 1] - line[i]).norm();
        let shapes: Vec<Option<(CornerShape, Rounding)>> = (0..line.len())
            .map(|i| {
                let rounding = roundings.get(i).copied().unwrap_or_default();
                let shape = match rounding {
                    Rounding::Alone(tangent) => CornerShape::alone(turns[i], tangent),
                    Rounding::First if i + 1 < line.len() => {
                        CornerShape::u_turn([turns[i], turns[i + 1]], length(i)).map(|[first, _]| first)
                    }
                    Rounding::Second if i > 0 => {
                        CornerShape::u_turn([turns[i - 1], turns[i]], length(i - 1)).map(|[_, second]| second)
                    }
                    Rounding::Stop | Rounding::First | Rounding::Second => None,
                };
                shape.map(|shape| (shape, rounding))
            })
            .collect();
        let mut heading = heading;
        for i in 0..line.len().saturating_sub(1) {
            let whole = line[i + 1] - line[i];
            if whole.norm() < 1e-9 {
                continue;
            }
            let towards = math::atan2(whole.y, whole.x);
            let taken = |i: usize, side: usize| shapes[i].map_or(0.0, |(shape, _)| shape.tangents[side]);
            let turn = difference(heading, towards);
            match shapes[i] {
                Some((shape, rounding)) => rounded.curve(line[i], [heading, towards], (shape, rounding), i),
                None if turn.abs() > NO_TURN => {
                    rounded.parts.push(Part::Turn(Pose::new(line[i].x, line[i].y, heading), turn, i));
                }
                None => {}
            }
            heading = towards;
            let along = whole / whole.norm();
            let (before, behind) = (taken(i, 1), taken(i + 1, 0));
            rounded.straight(line[i] + along * before, heading, whole.norm() - before - behind, i + 1);
        }
        rounded.end = line.last().map(|end| Pose::new(end.x, end.y, heading));
        rounded
    }

    /// Adds a straight piece: short stretches near its ends, one between them.
    fn straight(&mut self, from: Point, heading: f64, length: f64, corner: usize) {
        if length < 1e-9 {
            return;
        }
        let (step, ramp) = STRAIGHT_STEP;
        let pieces = |length: f64| ((length / step).ceil().max(1.0) as u32, length);
        let parts = if length > 3.0 * ramp {
            vec![pieces(ramp), (1, length - 2.0 * ramp), pieces(ramp)]
        } else {
            vec![pieces(length)]
        };
        let (sin, cos) = math::sin_cos(heading);
        let mut at = from;
        for (count, length) in parts {
            for _ in 0..count {
                let length = length / f64::from(count);
                let start = Pose::new(at.x, at.y, heading);
                self.parts.push(Part::Go(Stretch { start, length, curvature: [0.0; 2], corner }));
                at += Vector::new(cos, sin) * length;
            }
        }
    }

    /// Adds the curve round a corner between two headings.
    fn curve(&mut self, at: Point, headings: [f64; 2], (shape, rounding): (CornerShape, Rounding), corner: usize) {
        let turn = difference(headings[0], headings[1]);
        let curvature = shape.curvature * turn.signum();
        let (sin, cos) = math::sin_cos(headings[0]);
        let start = at - Vector::new(cos, sin) * shape.tangents[0];
        let start = Pose::new(start.x, start.y, headings[0]);
        match rounding {
            Rounding::Stop => {}
            Rounding::Alone(_) => {
                let middle = self.clothoid(start, 0.5 * turn, [0.0, curvature], corner);
                self.clothoid(middle, 0.5 * turn, [curvature, 0.0], corner);
            }
            Rounding::First => {
                self.clothoid(start, turn, [0.0, curvature], corner);
            }
            Rounding::Second => {
                self.clothoid(start, turn, [curvature, 0.0], corner);
            }
        }
    }

    /// Adds a clothoid; returns its end.
    fn clothoid(&mut self, start: Pose, turn: f64, [from, to]: [f64; 2], corner: usize) -> Pose {
        let length = 2.0 * (turn / (from + to)).abs();
        let count = (length / CURVE_STEP.0).ceil().max(f64::from(CURVE_STEP.1));
        let mut pose = start;
        for i in 0..count as u32 {
            let [a, b] = [i, i + 1].map(|i| from + (to - from) * f64::from(i) / count);
            let length = length / count;
            self.parts.push(Part::Go(Stretch { start: pose, length, curvature: [a, b], corner }));
            pose = Stretch { start: pose, length, curvature: [a, b], corner }.at(1.0);
        }
        pose
    }

    /// Seconds at the fastest speeds within `limits`, if the robot may already be moving at its start and still be moving at its
    /// end: to compare ways round a corner.
    pub fn passing_time(&self, limits: &DriveLimits) -> f64 {
        let runs = self.parts.split(|part| matches!(part, Part::Turn(..)));
        let last = runs.clone().count() - 1;
        let go = |(i, run): (usize, &[Part])| {
            let run: Vec<Stretch> = run.iter().filter_map(Part::stretch).copied().collect();
            let end = |is_free: bool| if is_free { f64::MAX } else { 0.0 };
            let found = squares(&run, limits, [end(i == 0), end(i == last)]);
            run.iter().zip(found.windows(2)).map(|(stretch, x)| time(stretch.length, x[0], x[1])).sum::<f64>()
        };
        let turns = self.parts.iter().map(|part| match part {
            Part::Turn(_, turn, _) => limits.turn_time(*turn),
            Part::Go(_) => 0.0,
        });
        runs.enumerate().map(go).sum::<f64>() + turns.sum::<f64>()
    }

    /// The stretches, without the turns on the spot between them.
    pub fn stretches(&self) -> impl Iterator<Item = &Stretch> + Clone {
        self.parts.iter().filter_map(Part::stretch)
    }

    /// The middle's way as points, at most 4 mm apart in curves, m: what the tool sweeps along.
    pub fn points(&self) -> Vec<Point> {
        let mut points: Vec<Point> = Vec::with_capacity(self.parts.len() + 1);
        let starts = self.parts.iter().map(|part| match part {
            Part::Go(stretch) => stretch.start.position(),
            Part::Turn(pose, ..) => pose.position(),
        });
        for point in starts.chain(self.end.map(|end| end.position())) {
            // Points on a straight piece aren't needed.
            if let [.., before, last] = points[..] {
                let (a, b): (Vector, Vector) = (last - before, point - last);
                if a.perp(&b).abs() < 1e-12 && a.dot(&b) >= 0.0 {
                    points.pop();
                }
            }
            points.push(point);
        }
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn zigzag() -> Vec<Point> {
        [[0.0, 0.0], [1.0, 0.0], [1.0, 0.165], [0.0, 0.165], [0.2, 0.9], [0.2, 0.4], [1.5, 0.4]]
            .map(|[x, y]| Point::new(x, y))
            .to_vec()
    }

    /// Curves end where the straight piece behind them begins.
    #[test]
    fn parts_meet_in_place_heading_and_curvature() {
        let line = zigzag();
        let roundings = [
            Rounding::Stop,
            Rounding::First,
            Rounding::Second,
            Rounding::Alone(0.05),
            Rounding::Stop,
            Rounding::Alone(0.1),
            Rounding::Stop,
        ];
        let rounded = RoundedLine::new(&line, 0.4, &roundings);
        let mut end: Option<(Pose, f64)> = None;
        let mut spins = 0;
        for part in &rounded.parts {
            match *part {
                Part::Go(Stretch { start, length, curvature: [a, b], .. }) => {
                    let (at, curvature) = end.unwrap_or((start, 0.0));
                    assert!((at.position() - start.position()).norm() < 1e-7, "{at} {start}");
                    assert!(difference(at.heading, start.heading).abs() < 1e-7 && (curvature - a).abs() < 1e-7);
                    end = Some((Stretch { start, length, curvature: [a, b], corner: 0 }.at(1.0), b));
                }
                Part::Turn(at, turn, _) => {
                    spins += 1;
                    end = Some((Pose::new(at.x, at.y, at.heading + turn), 0.0));
                }
            }
        }
        assert_eq!(spins, 2, "at the start and at the reversal");
        assert!((end.unwrap().0.position() - line[6]).norm() < 1e-7);
    }

    #[test]
    fn curves_pass_corners_as_near_as_their_shape_says() {
        for turn in [0.3, 1.0, math::FRAC_PI_2, 2.5] {
            let shape = CornerShape::alone(turn, 0.1).unwrap();
            let (sin, cos) = math::sin_cos(turn);
            let line = [Point::new(-1.0, 0.0), Point::origin(), Point::new(cos, sin)];
            let rounded = RoundedLine::new(&line, 0.0, &[Rounding::Stop, Rounding::Alone(0.1), Rounding::Stop]);
            let nearest = rounded.points().iter().map(|p| p.coords.norm()).fold(f64::MAX, f64::min);
            assert!((nearest - shape.cut).abs() < 2e-4, "{turn}: {nearest} {}", shape.cut);
            let peak = rounded.stretches().map(|s| s.curvature[1].abs()).fold(0.0, f64::max);
            assert!((peak - shape.curvature).abs() < 1e-9);
        }
        assert!(CornerShape::alone(math::PI, 0.1).is_none() && CornerShape::alone(1.0, 0.0).is_none());
    }

    #[test]
    fn a_u_turn_passes_both_corners_and_keeps_to_the_lanes() {
        let [first, second] = CornerShape::u_turn([1.4, 1.7], 0.165).unwrap();
        assert!((first.tangents[1] + second.tangents[0] - 0.165).abs() < 1e-12 && first.curvature == second.curvature);
        let corner = Point::new(1.0, 0.0);
        let next = corner + Vector::new(math::cos(1.4), math::sin(1.4)) * 0.165;
        let last = next + Vector::new(math::cos(3.1), math::sin(3.1));
        let line = [Point::origin(), corner, next, last];
        let rounded =
            RoundedLine::new(&line, 0.0, &[Rounding::Stop, Rounding::First, Rounding::Second, Rounding::Stop]);
        for (corner, shape) in [(corner, first), (next, second)] {
            let nearest = rounded.points().iter().map(|p| (p - corner).norm()).fold(f64::MAX, f64::min);
            assert!((nearest - shape.cut).abs() < 5e-4, "{nearest} {}", shape.cut);
        }
        assert!((rounded.points().last().unwrap() - last).norm() < 1e-9);
        assert!(CornerShape::u_turn([1.4, -1.7], 0.165).is_none());
    }
}

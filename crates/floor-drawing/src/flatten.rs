//! Curves as chords.
//!
//! As a drawing's unit isn't known when it is read, curves are divided by angle: at least every [`STEP`]. The chords of
//! an arc then lie within 0.1 % of its radius from it.

use super::model::MAX_POINTS;
use robovac_core::{
    geometry::{Point, Vector},
    math::{PI, TAU, atan2, ceil, sin_cos},
};

/// Widest angle of a chord, radians: 5°, so that 1 - cos(2.5°) = 0.095 % (ours).
pub(super) const STEP: f64 = PI / 36.0;

/// Highest degree of a spline that is evaluated; CAD programs stop far below.
const MAX_DEGREE: usize = 15;

/// An ellipse from parameter `start` counter-clockwise to `end`, radians: centre + cos t major + sin t minor. A full
/// ellipse is without its last point.
pub(super) fn ellipse(centre: Point, major: Vector, minor: Vector, start: f64, end: f64) -> (Vec<Point>, bool) {
    let turn = (end - start) % TAU;
    let turn = if turn <= 1e-9 { turn + TAU } else { turn };
    let is_closed = turn > TAU - 1e-9;
    let count = ceil(turn / STEP - 1e-9).max(1);
    let last = if is_closed { count - 1 } else { count };
    let at = |i: i32| {
        let (sin, cos) = sin_cos(start + turn * f64::from(i) / f64::from(count));
        centre + major * cos + minor * sin
    };
    ((0..=last).map(at).collect(), is_closed)
}

/// Points of an arc strictly between `from` and `to`. Its bulge is the tangent of a quarter of its angle, positive if
/// it turns counter-clockwise.
pub(super) fn bulge(from: Point, to: Point, bulge: f64, points: &mut Vec<Point>) {
    let chord = to - from;
    if bulge.abs() < 1e-9 || chord == Vector::zeros() {
        return;
    }
    let turn = 4.0 * atan2(bulge, 1.0);
    let centre = from + chord * 0.5 + Vector::new(-chord.y, chord.x) * (0.25 * (1.0 / bulge - bulge));
    let count = ceil(turn.abs() / STEP - 1e-9).max(1);
    let spoke = from - centre;
    points.extend((1..count).map(|i| {
        let (sin, cos) = sin_cos(turn * f64::from(i) / f64::from(count));
        centre + Vector::new(spoke.x * cos - spoke.y * sin, spoke.x * sin + spoke.y * cos)
    }));
}

/// Parts into which a span of a spline is divided at first, so that no bend between its ends is missed.
const PIECES: u32 = 4;
/// How often a part is halved at most; corners and tiny loops would never end.
const MAX_HALVINGS: u32 = 8;

/// A B-spline, rational if it has weights.
pub(super) struct Nurbs<'a> {
    /// Degree, from 1.
    pub degree: usize,
    /// Knots; replaced by uniform ones if their number is wrong.
    pub knots: &'a [f64],
    /// Weights, as many as controls, or none.
    pub weights: &'a [f64],
    /// Control points.
    pub controls: &'a [Point],
}

impl Nurbs<'_> {
    /// The curve from its first point to its last; at most a little more than [`MAX_POINTS`], which is then refused.
    pub fn flatten(&self) -> Vec<Point> {
        let (count, degree) = (self.controls.len(), self.degree);
        if !(2..=MAX_DEGREE).contains(&degree) || count <= degree {
            return self.controls.to_vec();
        }
        let fits = self.knots.len() == count + degree + 1 && self.knots.windows(2).all(|pair| pair[0] <= pair[1]);
        let even: Vec<f64>;
        let knots = if fits && self.knots[degree] < self.knots[count] {
            self.knots
        } else {
            let inner = (count - degree) as f64;
            even = (0..=count + degree).map(|i| (i as f64 - degree as f64).clamp(0.0, inner)).collect();
            &even
        };
        let mut points = Vec::new();
        for span in degree..count {
            let (low, high) = (knots[span], knots[span + 1]);
            if points.len() > MAX_POINTS {
                break;
            }
            if low >= high {
                continue;
            }
            let mut from = (low, self.at(knots, span, low));
            if points.is_empty() {
                points.push(from.1);
            }
            for i in 1..=PIECES {
                let u = low + (high - low) * f64::from(i) / f64::from(PIECES);
                let to = (u, self.at(knots, span, u));
                self.divide(knots, span, from, to, MAX_HALVINGS, &mut points);
                from = to;
            }
        }
        points
    }

    /// Adds points up to `to`, enough for chords to turn by at most half a step where they meet.
    fn divide(
        &self,
        knots: &[f64],
        span: usize,
        from: (f64, Point),
        to: (f64, Point),
        halvings: u32,
        points: &mut Vec<Point>,
    ) {
        let u = 0.5 * (from.0 + to.0);
        let middle = self.at(knots, span, u);
        let (there, on) = (middle - from.1, to.1 - middle);
        if halvings > 0 && atan2(there.perp(&on).abs(), there.dot(&on)) > 0.5 * STEP {
            self.divide(knots, span, from, (u, middle), halvings - 1, points);
            self.divide(knots, span, (u, middle), to, halvings - 1, points);
        } else {
            points.push(to.1);
        }
    }

    /// De Boor's algorithm on homogeneous coordinates.
    fn at(&self, knots: &[f64], span: usize, u: f64) -> Point {
        let degree = self.degree;
        let first = span - degree;
        let is_rational = self.weights.len() == self.controls.len();
        let mut work = [(Vector::zeros(), 0.0); MAX_DEGREE + 1];
        for (i, slot) in work.iter_mut().take(degree + 1).enumerate() {
            let weight = if is_rational { self.weights[first + i] } else { 1.0 };
            *slot = (self.controls[first + i].coords * weight, weight);
        }
        for round in 1..=degree {
            for i in (round..=degree).rev() {
                let (low, high) = (knots[first + i], knots[first + i + degree + 1 - round]);
                let share = if high > low { (u - low) / (high - low) } else { 0.0 };
                let (before, here) = (work[i - 1], work[i]);
                work[i] = (before.0 * (1.0 - share) + here.0 * share, before.1 * (1.0 - share) + here.1 * share);
            }
        }
        let (sum, weight) = work[degree];
        if weight == 0.0 { self.controls[first] } else { Point::from(sum / weight) }
    }
}

/// A curve through all `points` (Catmull-Rom spline), for splines that have fit points only. At most a little more than
/// [`MAX_POINTS`].
pub(super) fn through(points: &[Point], is_closed: bool) -> Vec<Point> {
    let count = points.len();
    if count < 3 {
        return points.to_vec();
    }
    let at = |i: isize| {
        let index = if is_closed { i.rem_euclid(count as isize) } else { i.clamp(0, count as isize - 1) };
        points[index as usize].coords
    };
    let spans = if is_closed { count } else { count - 1 };
    let mut curve = Vec::new();
    for i in 0..spans.min(MAX_POINTS / 8 + 1) as isize {
        let [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
        curve.extend((0..8).map(|step| {
            let t = f64::from(step) / 8.0;
            let cubic = b * 2.0
                + (c - a) * t
                + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (t * t)
                + (b * 3.0 - a - c * 3.0 + d) * (t * t * t);
            Point::from(cubic * 0.5)
        }));
    }
    if !is_closed {
        curve.extend(points.last());
    }
    curve
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Greatest distance of points and of the middles of chords from the unit circle.
    fn off_circle(points: &[Point]) -> f64 {
        let middles = points.windows(2).map(|pair| nalgebra::center(&pair[0], &pair[1]));
        points.iter().copied().chain(middles).map(|p| (p.coords.norm() - 1.0).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn circles_and_arcs_are_within_a_thousandth() {
        let (circle, is_closed) = ellipse(Point::origin(), Vector::x(), Vector::y(), 0.0, TAU);
        assert!(is_closed && circle.len() == 72 && off_circle(&circle) < 0.001);
        let (arc, is_closed) = ellipse(Point::origin(), Vector::x(), Vector::y(), 1.5 * PI, 0.5 * PI);
        assert!(!is_closed && arc.len() == 37);
        assert!((arc[0] - Point::new(0.0, -1.0)).norm() < 1e-12 && (arc[36] - Point::new(0.0, 1.0)).norm() < 1e-12);
        assert!((arc[18] - Point::new(1.0, 0.0)).norm() < 1e-12);
    }

    #[test]
    fn a_bulge_of_one_is_half_a_circle_to_the_right_of_the_way() {
        let (from, to) = (Point::new(-1.0, 0.0), Point::new(1.0, 0.0));
        let mut points = vec![from];
        bulge(from, to, 1.0, &mut points);
        points.push(to);
        assert!(off_circle(&points) < 0.001 && points.iter().all(|p| p.y <= 1e-12), "counter-clockwise");
        let mut points = Vec::new();
        bulge(from, to, -(PI / 8.0).tan(), &mut points);
        // A quarter turn clockwise bulges up by (√2 - 1) of half the chord.
        let top = points.iter().map(|p| p.y).fold(0.0, f64::max);
        assert!((top - (2.0_f64.sqrt() - 1.0)).abs() < 0.001, "{top}");
    }

    #[test]
    fn a_rational_spline_is_a_circle() {
        let w = 0.5_f64.sqrt();
        let corners = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
        let controls: Vec<Point> = corners.iter().map(|&(x, y)| Point::new(f64::from(x), f64::from(y))).collect();
        let circle = Nurbs {
            degree: 2,
            knots: &[0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0],
            weights: &[1.0, w, 1.0, w, 1.0, w, 1.0, w, 1.0],
            controls: &controls,
        };
        assert!(off_circle(&circle.flatten()) < 0.001);
        // A wrong number of knots is replaced; the ends stay.
        let bent = Nurbs { knots: &[3.0, 1.0], weights: &[], ..circle };
        assert_eq!(bent.flatten().last(), controls.last());
    }

    #[test]
    fn a_long_spline_is_not_flattened_far_beyond_the_limit() {
        let controls: Vec<Point> =
            (0..400).map(|i| Point::new(f64::from(i % 2), f64::from(u8::from(i % 8 < 3)))).collect();
        let spline = |degree, controls| Nurbs { degree, knots: &[], weights: &[], controls };
        let each = spline(2, &controls[..102]).flatten().len() / 100;
        let long: Vec<Point> = controls.iter().copied().cycle().take(2 * MAX_POINTS / each).collect();
        let count = spline(2, &long).flatten().len();
        assert!((MAX_POINTS + 1..MAX_POINTS + 1100).contains(&count), "{count}, {each} a span");
        let count = through(&vec![Point::origin(); MAX_POINTS], false).len();
        assert!((MAX_POINTS + 1..MAX_POINTS + 20).contains(&count), "{count}");
    }

    #[test]
    fn a_curve_through_points_passes_them() {
        let points = [(0.0, 0.0), (1.0, 2.0), (3.0, 1.0)].map(|(x, y)| Point::new(x, y));
        let curve = through(&points, false);
        assert_eq!((curve.len(), curve[0], curve[8], curve[16]), (17, points[0], points[1], points[2]));
        assert_eq!(through(&points, true).len(), 24);
    }
}

//! Outlines of objects: closed lines of corners, in either direction.

use crate::geometry::{Point, Vector};

/// Smallest area of an outline, m²: a square centimetre.
const LEAST_AREA: f64 = 1e-4;

/// Whether `point` lies inside; undefined on an edge.
pub fn encloses(outline: &[Point], point: Point) -> bool {
    let crossed = edges(outline).filter(|(a, b)| {
        (a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossed.count() % 2 == 1
}

/// Centre of the bounding box of the points; the origin if there are none.
pub fn middle(points: &[Point]) -> Point {
    let Some((&first, rest)) = points.split_first() else { return Point::origin() };
    let (low, high) = rest.iter().fold((first, first), |(low, high), p| (low.inf(p), high.sup(p)));
    nalgebra::center(&low, &high)
}

/// Whether the outline has an area of at least a square centimetre.
pub fn has_area(outline: &[Point]) -> bool {
    // Relative to the first corner, so that rooms far from the origin lose no precision.
    let Some(&origin) = outline.first() else { return false };
    let twice: f64 = edges(outline).map(|(a, b)| cross(a - origin, b - origin)).sum();
    twice.abs() > 2.0 * LEAST_AREA
}

/// The first two edges that meet other than in a common corner, by the index of their first corners.
pub fn crossing(outline: &[Point]) -> Option<(usize, usize)> {
    let count = outline.len();
    let edge = |i: usize| (outline[i], outline[(i + 1) % count]);
    (0..count).find_map(|i| {
        let j = (i + 1..count).find(|&j| {
            let (one, other) = (edge(i), edge(j));
            if j == i + 1 {
                folds_back(one.0, one.1, other.1)
            } else if (j + 1) % count == i {
                folds_back(other.0, other.1, one.1)
            } else {
                meet(one, other)
            }
        })?;
        Some((i, j))
    })
}

fn edges(outline: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    outline.iter().copied().zip(outline.iter().copied().cycle().skip(1))
}

fn cross(a: Vector, b: Vector) -> f64 {
    a.x * b.y - a.y * b.x
}

/// Whether the way from `a` to `b` goes back on itself to `c`.
fn folds_back(a: Point, b: Point, c: Point) -> bool {
    let (there, on) = (b - a, c - b);
    cross(there, on) == 0.0 && there.dot(&on) <= 0.0
}

/// Whether two segments have a point in common.
fn meet((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let side = |from: Point, to: Point, point: Point| cross(to - from, point - from);
    let between =
        |from: Point, to: Point, point: Point| side(from, to, point) == 0.0 && (from - point).dot(&(to - point)) <= 0.0;
    let apart = |one: f64, other: f64| (one > 0.0 && other < 0.0) || (one < 0.0 && other > 0.0);
    (apart(side(a, b, c), side(a, b, d)) && apart(side(c, d, a), side(c, d, b)))
        || between(a, b, c)
        || between(a, b, d)
        || between(c, d, a)
        || between(c, d, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(corners: &[(f64, f64)]) -> Vec<Point> {
        corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    #[test]
    fn inside_and_outside_of_a_notch() {
        let notched = outline(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)]);
        let inside = |x, y| encloses(&notched, Point::new(x, y));
        assert!(inside(0.5, 2.0) && inside(3.5, 2.0) && inside(2.0, 0.5));
        assert!(!inside(2.0, 2.0) && !inside(-0.1, 1.0) && !inside(5.0, 1.0));
        assert_eq!(middle(&notched), Point::new(2.0, 2.0));
    }

    #[test]
    fn crossings_are_found_but_corners_are_none() {
        for (corners, expected) in [
            (&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)][..], None),
            (&[(0.0, 0.0), (1.0, 0.0), (0.5, 1.0)], None),
            // An edge that goes on straight is no crossing, one that turns back is.
            (&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (1.0, 1.0)], None),
            (&[(0.0, 0.0), (2.0, 0.0), (1.0, 0.0), (1.0, 1.0)], Some((0, 1))),
            (&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)], Some((0, 2))),
            // A corner on another edge, and a corner that comes twice.
            (&[(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 0.0), (0.0, 2.0)], Some((0, 2))),
            (&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (0.5, 1.0)], Some((0, 1))),
        ] {
            assert_eq!(crossing(&outline(corners)), expected, "{corners:?}");
        }
    }

    #[test]
    fn slivers_have_no_area() {
        assert!(has_area(&outline(&[(9.0, 9.0), (9.02, 9.0), (9.02, 9.02), (9.0, 9.02)])));
        assert!(!has_area(&outline(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)])));
        assert!(!has_area(&outline(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.00001)])));
    }
}

//! Simple polygons as lists of corners, in either direction; the last corner is joined to the first.

use super::{Point, Vector};

/// Area of a polygon, m²: positive if its corners run counter-clockwise.
pub fn signed_area(outline: &[Point]) -> f64 {
    0.5 * edges(outline).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>()
}

/// Whether a point lies in a polygon (even-odd rule). Undefined on the outline.
///
/// ```
/// use robovac_core::geometry::{Point, contains};
/// let triangle = [Point::new(0.0, 0.0), Point::new(2.0, 0.0), Point::new(0.0, 2.0)];
/// assert!(contains(&triangle, Point::new(0.5, 0.5)));
/// assert!(!contains(&triangle, Point::new(1.5, 1.5)));
/// ```
#[inline]
pub fn contains(outline: &[Point], point: Point) -> bool {
    let mut is_inside = false;
    let Some(mut from) = outline.last() else { return false };
    for to in outline {
        if (from.y > point.y) != (to.y > point.y) {
            let x = from.x + (point.y - from.y) / (to.y - from.y) * (to.x - from.x);
            is_inside ^= point.x < x;
        }
        from = to;
    }
    is_inside
}

/// Sides of a polygon, in the order of its corners.
#[inline]
pub fn edges(outline: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    let next = outline.iter().skip(1).chain(outline.first());
    outline.iter().copied().zip(next.copied())
}

/// The point of the segment from `a` to `b` that is nearest to `point`.
#[inline]
pub fn nearest_on_segment(a: Point, b: Point, point: Point) -> Point {
    let along = b - a;
    let length_squared = along.norm_squared();
    if length_squared <= 0.0 {
        return a;
    }
    a + along * ((point - a).dot(&along) / length_squared).clamp(0.0, 1.0)
}

/// Cuts a simple polygon into convex pieces with counter-clockwise corners that cover it without overlap.
///
/// Ears are cut off one by one (Meisters 1975), then triangles are joined over every diagonal that convexity can do
/// without (Hertel & Mehlhorn 1983): at most four times as many pieces as there must be. An outline that crosses itself
/// gives pieces that cover about the same floor; one without area gives none. O(n³) at worst, for the few corners of
/// furniture.
pub fn convex_pieces(outline: &[Point]) -> Vec<Vec<Point>> {
    let mut corners: Vec<Point> = outline.to_vec();
    corners.dedup();
    if corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    if signed_area(&corners) < 0.0 {
        corners.reverse();
    }
    if corners.len() < 3 {
        return Vec::new();
    }
    if is_convex(&corners) {
        return vec![corners];
    }
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    while corners.len() > 3 {
        let n = corners.len();
        let ear = (0..n).find(|&i| is_ear(&corners, i)).or_else(|| (0..n).find(|&i| turn_at(&corners, i) > 0.0));
        let Some(ear) = ear else { break };
        pieces.push(vec![corners[(ear + n - 1) % n], corners[ear], corners[(ear + 1) % n]]);
        corners.remove(ear);
    }
    pieces.push(corners);
    pieces.retain(|piece| signed_area(piece) > 1e-12);
    let mut joined: Vec<Vec<Point>> = Vec::new();
    for mut piece in pieces {
        while let Some((index, both)) = joined.iter().enumerate().find_map(|(i, other)| Some((i, join(other, &piece)?)))
        {
            joined.swap_remove(index);
            piece = both;
        }
        joined.push(piece);
    }
    joined
}

/// Twice the area of the triangle at corner `i`: positive for a left turn.
fn turn_at(corners: &[Point], i: usize) -> f64 {
    let n = corners.len();
    let (before, at, after) = (corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]);
    (at - before).perp(&(after - at))
}

fn is_convex(corners: &[Point]) -> bool {
    // All turns to the left, and only once round: a star turns left all the time too.
    let is_left = (0..corners.len()).all(|i| turn_at(corners, i) >= 0.0);
    let sign_changes = edges(corners).zip(edges(corners).skip(1).chain(edges(corners).take(1)));
    let is_falling = |(a, b): (Point, Point)| (b.y - a.y, b.x - a.x) < (0.0, 0.0);
    is_left && sign_changes.filter(|&(a, b)| is_falling(a) != is_falling(b)).count() <= 2
}

/// Whether the triangle at corner `i` lies in the polygon and holds no other corner.
fn is_ear(corners: &[Point], i: usize) -> bool {
    if turn_at(corners, i) <= 0.0 {
        return false;
    }
    let n = corners.len();
    let triangle = [corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]];
    let is_in = |p: Point| edges(&triangle).all(|(a, b)| (b - a).perp(&(p - a)) >= 0.0);
    !corners.iter().any(|&p| !triangle.contains(&p) && is_in(p))
}

/// The union of two convex polygons that share a side, if it is convex.
fn join(a: &[Point], b: &[Point]) -> Option<Vec<Point>> {
    for i in 0..a.len() {
        for j in 0..b.len() {
            if a[i] == b[(j + 1) % b.len()] && a[(i + 1) % a.len()] == b[j] {
                // Round `a` from the end of the shared side to its start, then round `b` without the two shared corners.
                let mut both: Vec<Point> = (1..=a.len()).map(|k| a[(i + k) % a.len()]).collect();
                both.extend((2..b.len()).map(|k| b[(j + k) % b.len()]));
                return is_convex(&both).then_some(both);
            }
        }
    }
    None
}

/// The outward normal of a side from `a` to `b` of a counter-clockwise polygon, of length 1; zero for a side without length.
#[inline]
pub fn outward(a: Point, b: Point) -> Vector {
    let along = b - a;
    let length = along.norm();
    if length > 0.0 { Vector::new(along.y, -along.x) / length } else { Vector::zeros() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(corners: &[[f64; 2]]) -> Vec<Point> {
        corners.iter().map(|&[x, y]| Point::new(x, y)).collect()
    }

    fn area(pieces: &[Vec<Point>]) -> f64 {
        pieces.iter().map(|p| signed_area(p)).sum()
    }

    #[test]
    fn an_l_is_two_pieces() {
        let mut outline = points(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]);
        for _ in 0..2 {
            let pieces = convex_pieces(&outline);
            assert_eq!(pieces.len(), 2, "{pieces:?}");
            assert!((area(&pieces) - 3.0).abs() < 1e-12);
            outline.reverse();
        }
    }

    #[test]
    fn pieces_cover_what_the_outline_holds() {
        // A comb with slanted teeth, and a spiral.
        let comb = points(&[[0.0, 0.0], [7.0, 0.0], [6.5, 3.0], [5.0, 1.0], [4.0, 3.2], [3.0, 1.0], [1.0, 4.0]]);
        let spiral = points(&[
            [0.0, 0.0],
            [5.0, 0.0],
            [5.0, 5.0],
            [1.0, 5.0],
            [1.0, 2.0],
            [3.0, 2.0],
            [3.0, 3.0],
            [2.0, 3.0],
            [2.0, 4.0],
            [4.0, 4.0],
            [4.0, 1.0],
            [0.0, 1.0],
        ]);
        for outline in [comb, spiral] {
            let pieces = convex_pieces(&outline);
            assert!((area(&pieces) - signed_area(&outline).abs()).abs() < 1e-9);
            assert!(pieces.iter().all(|p| is_convex(p)), "{pieces:?}");
            for i in 0..80 {
                for j in 0..60 {
                    let at = Point::new(f64::from(i) * 0.1 - 0.033, f64::from(j) * 0.1 - 0.037);
                    let in_pieces = pieces.iter().filter(|p| contains(p, at)).count();
                    assert_eq!(in_pieces, usize::from(contains(&outline, at)), "{at}");
                }
            }
        }
    }

    #[test]
    fn odd_outlines_neither_hang_nor_panic() {
        let bow_tie = points(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]]);
        let star = points(&[[0.0, 3.0], [-2.0, -3.0], [3.0, 1.0], [-3.0, 1.0], [2.0, -3.0]]);
        let line = points(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]);
        for outline in [bow_tie, star, line, points(&[[1.0, 1.0]]), Vec::new()] {
            for piece in convex_pieces(&outline) {
                assert!(piece.len() > 2);
            }
        }
    }
}

//! What wide strokes cover.

use robovac_core::geometry::{Point, Vector};

/// The rectangles that a stroke covers, one a segment; none if it has no width. At corners they reach as far as a mitre, and no
/// further than half the width.
pub(super) fn pieces(corners: &[Point], is_closed: bool, width: f64) -> Vec<[Point; 4]> {
    let (half, count) = (0.5 * width, corners.len());
    if half <= 0.0 || count < 2 {
        return Vec::new();
    }
    let at = |index: usize| corners[index % count];
    let along = |index: usize| (at(index + 1) - at(index)).try_normalize(0.0).unwrap_or_default();
    let segments = if is_closed { count } else { count - 1 };
    let is_end = |corner: usize| !is_closed && (corner == 0 || corner == count - 1);
    let reach = |corner: usize| {
        if is_end(corner) { 0.0 } else { half * mitre(along(corner + count - 1), along(corner)) }
    };
    let piece = |index: usize| {
        let ahead = along(index);
        let aside = Vector::new(-ahead.y, ahead.x) * half;
        let from = at(index) - ahead * reach(index % count);
        let to = at(index + 1) + ahead * reach((index + 1) % count);
        [from - aside, to - aside, to + aside, from + aside]
    };
    (0..segments).map(piece).collect()
}

/// How far a mitre reaches beyond a corner between two directions, in half widths: 1 at a right angle, at most.
fn mitre(before: Vector, after: Vector) -> f64 {
    // The tangent of half the angle between them.
    let (sine, cosine) = (before.perp(&after).abs(), before.dot(&after));
    if cosine <= 0.0 { 1.0 } else { sine / (1.0 + cosine) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(corners: &[(f64, f64)]) -> Vec<Point> {
        corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    #[test]
    fn a_wide_stroke_is_filled_to_the_tip_of_its_corners_and_no_further_than_its_ends() {
        let angle = pieces(&points(&[(0.0, 0.0), (10.0, 0.0), (10.0, 5.0)]), false, 2.0);
        assert_eq!(angle[0].to_vec(), points(&[(0.0, -1.0), (11.0, -1.0), (11.0, 1.0), (0.0, 1.0)]));
        assert_eq!(angle[1].to_vec(), points(&[(11.0, -1.0), (11.0, 5.0), (9.0, 5.0), (9.0, -1.0)]));
        // On a curve of short segments hardly at all, at the way back no more than at a right angle.
        assert!(mitre(Vector::new(1.0, 0.0), Vector::new(1.0, 0.02)) < 0.02);
        assert_eq!(mitre(Vector::new(1.0, 0.0), Vector::new(-1.0, 0.0)), 1.0);
    }

    #[test]
    fn a_closed_stroke_has_a_mitre_at_every_corner_and_one_without_width_covers_nothing() {
        let square = points(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let pieces_of = pieces(&square, true, 1.0);
        assert_eq!(pieces_of.len(), 4);
        assert_eq!(pieces_of[3][0], Point::new(-0.5, 4.5));
        assert!(pieces(&square, true, 0.0).is_empty());
    }
}

//! Minkowski sums of an obstacle and the mirrored outline: the places of the outline's origin at which both overlap.

use super::outline::{bounds, support};
use crate::geometry::{Point, Vector, edges, nearest_on_segment, outward};

/// An open convex region that is evaluated row by row.
#[derive(Debug, Clone)]
pub(super) enum Sum {
    /// All points with `normal . p < reach` for every plane.
    Planes {
        /// Normals of length 1, and how far the region reaches along them.
        planes: Vec<(Vector, f64)>,
        /// Its lowest and highest y.
        rows: (f64, f64),
    },
    /// All points nearer than `radius` to a convex polygon with counter-clockwise corners, or to a point.
    Rounded {
        /// The polygon's corners.
        corners: Vec<Point>,
        /// The radius, m.
        radius: f64,
    },
}

/// A convex piece of an outline, with data shared by all its sums.
#[derive(Debug, Clone)]
pub(super) struct ConvexPiece {
    pub corners: Vec<Point>,
    /// Normals of the sides of its mirror image, and how far that reaches along them.
    sides: Vec<(Vector, f64)>,
    /// The box around it.
    bounds: (Point, Point),
}

impl ConvexPiece {
    /// With counter-clockwise corners.
    pub fn new(corners: Vec<Point>) -> Self {
        let normals = edges(&corners).map(|(a, b)| -outward(a, b)).filter(|normal| *normal != Vector::zeros());
        let sides = normals.map(|normal| (normal, support(&corners, -normal))).collect();
        Self { sides, bounds: bounds(&corners), corners }
    }
}

impl Sum {
    /// Overlap of a convex piece of the outline with a convex polygon, or a distance below `margin`, m; below 0 an
    /// overlap by more than that. Only sides of the two can separate them, as in [`crate::geometry::overlap`].
    pub fn of_polygons(obstacle: &[Point], piece: &ConvexPiece, margin: f64) -> Self {
        // A side without length separates nothing.
        let own = edges(obstacle).map(|(a, b)| outward(a, b)).filter(|normal| *normal != Vector::zeros());
        let own = own.map(|normal| (normal, support(&piece.corners, -normal)));
        let plane = |(normal, reach): (Vector, f64)| (normal, support(obstacle, normal) + reach + margin);
        let planes = own.chain(piece.sides.iter().copied()).map(plane).collect();
        let ((low, high), (own_low, own_high)) = (bounds(obstacle), piece.bounds);
        Self::Planes { planes, rows: (low.y - own_high.y - margin, high.y - own_low.y + margin) }
    }

    /// Overlap of a convex piece of the outline with a disc, or a distance below `margin`.
    pub fn of_disc(centre: Point, radius: f64, piece: &ConvexPiece, margin: f64) -> Self {
        let corners = piece.corners.iter().map(|p| centre - p.coords).collect();
        Self::Rounded { corners, radius: radius + margin }
    }

    /// Overlap of a round outline with a convex polygon or, if that has one corner, a point, or a distance below
    /// `margin`.
    pub fn of_round(corners: &[Point], radius: f64, margin: f64) -> Self {
        Self::Rounded { corners: corners.to_vec(), radius: radius + margin }
    }

    /// The lowest and highest y of the region.
    pub fn rows(&self) -> (f64, f64) {
        match self {
            Self::Planes { rows, .. } => *rows,
            Self::Rounded { corners, radius } => {
                let (low, high) = bounds(corners);
                (low.y - radius, high.y + radius)
            }
        }
    }

    /// Whether the straight line between two points goes through the region, or, for the sum of a vertical line,
    /// through the region when that line is extended from `left` to `right`.
    pub fn meets(&self, from: Point, to: Point, (left, right): (f64, f64)) -> bool {
        match self {
            Self::Planes { planes, rows } => {
                let drawn_out = planes
                    .iter()
                    .map(|&(normal, reach)| (normal, reach + normal.x * if normal.x < 0.0 { left } else { right }));
                let level = [(Vector::y(), rows.1), (-Vector::y(), -rows.0)];
                enters(from, to, drawn_out.chain(level))
            }
            Self::Rounded { corners, radius } => {
                let at = |corner: &Point, x: f64| corner + Vector::new(x, 0.0);
                match corners[..] {
                    [low, high] if left < right => {
                        let corners = [at(&low, left), at(&low, right), at(&high, right), at(&high, left)];
                        comes_near(&corners, *radius, from, to)
                    }
                    _ => {
                        let corners: Vec<Point> = corners.iter().map(|corner| at(corner, left)).collect();
                        comes_near(&corners, *radius, from, to)
                    }
                }
            }
        }
    }

    /// Left and right end of the region at height `y`; for an empty row the left one isn't below the right one.
    #[inline]
    pub fn across(&self, y: f64) -> (f64, f64) {
        match self {
            Self::Planes { planes, .. } => {
                let (mut low, mut high) = (f64::MIN, f64::MAX);
                for &(normal, reach) in planes {
                    let left = reach - normal.y * y;
                    if normal.x < 0.0 {
                        low = low.max(left / normal.x);
                    } else if normal.x > 0.0 {
                        high = high.min(left / normal.x);
                    } else if left <= 0.0 {
                        return (f64::MAX, f64::MIN);
                    }
                }
                (low, high)
            }
            Self::Rounded { corners, radius } => rounded(corners, *radius, y),
        }
    }
}

/// Whether a straight line has a piece that is behind all planes (Cyrus & Beck 1978).
fn enters(from: Point, to: Point, planes: impl Iterator<Item = (Vector, f64)>) -> bool {
    let along = to - from;
    let (mut begin, mut end) = (0.0_f64, 1.0_f64);
    for (normal, reach) in planes {
        let (left, speed) = (reach - from.coords.dot(&normal), along.dot(&normal));
        if speed > 0.0 {
            end = end.min(left / speed);
        } else if speed < 0.0 {
            begin = begin.max(left / speed);
        } else if left <= 0.0 {
            return false;
        }
    }
    begin < end
}

/// Whether a straight line comes nearer than `radius` to a convex polygon or, if that has one corner, a point.
fn comes_near(corners: &[Point], radius: f64, from: Point, to: Point) -> bool {
    let is_near = |a: Point, b: Point| (a - b).norm_squared() < radius * radius;
    let sides = || edges(corners).map(|(a, b)| (outward(a, b), a)).filter(|(normal, _)| *normal != Vector::zeros());
    corners.iter().any(|&corner| is_near(nearest_on_segment(from, to, corner), corner))
        || edges(corners).any(|(a, b)| [from, to].into_iter().any(|end| is_near(nearest_on_segment(a, b, end), end)))
        || (corners.len() > 2 && enters(from, to, sides().map(|(normal, a)| (normal, a.coords.dot(&normal)))))
}

/// The part of a row that is nearer than `radius` to a convex polygon: discs around its corners, and its sides moved
/// outwards.
fn rounded(corners: &[Point], radius: f64, y: f64) -> (f64, f64) {
    let (mut low, mut high) = (f64::MAX, f64::MIN);
    for corner in corners {
        let dy = y - corner.y;
        let half = radius * radius - dy * dy;
        if half > 0.0 {
            low = low.min(corner.x - half.sqrt());
            high = high.max(corner.x + half.sqrt());
        }
    }
    for (a, b) in edges(corners) {
        let away = outward(a, b) * radius;
        let (from, to) = (a + away, b + away);
        if from.y != to.y && (from.y.min(to.y)..=from.y.max(to.y)).contains(&y) {
            let x = from.x + (y - from.y) / (to.y - from.y) * (to.x - from.x);
            low = low.min(x);
            high = high.max(x);
        }
    }
    (low, high)
}

//! Minkowski sums of an obstacle and the mirrored outline: the places of the outline's origin at which both overlap.

use super::{
    HAIR,
    outline::{bounds, support},
};
use crate::geometry::{Point, Vector, edges, outward};

/// An open convex region that is asked row by row.
#[derive(Debug, Clone)]
pub(super) enum Sum {
    /// Where all of `normal . p < reach`.
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
        /// m.
        radius: f64,
    },
}

impl Sum {
    /// Where a convex piece of the outline overlaps a convex polygon by more than a hair. The sides of both are all that can part
    /// them, as in [`crate::geometry::overlap`].
    pub fn of_polygons(obstacle: &[Point], piece: &[Point]) -> Self {
        let plane = |normal: Vector| (normal, support(obstacle, normal) + support(piece, -normal) - HAIR);
        let own = edges(obstacle).map(|(a, b)| outward(a, b));
        let mirrored = edges(piece).map(|(a, b)| -outward(a, b));
        // A side without length parts nothing.
        let planes = own.chain(mirrored).filter(|n| *n != Vector::zeros()).map(plane).collect();
        let ((low, high), (own_low, own_high)) = (bounds(obstacle), bounds(piece));
        Self::Planes { planes, rows: (low.y - own_high.y + HAIR, high.y - own_low.y - HAIR) }
    }

    /// Where a convex piece of the outline overlaps a disc.
    pub fn of_disc(centre: Point, radius: f64, piece: &[Point]) -> Self {
        let corners = piece.iter().map(|p| centre - p.coords).collect();
        Self::Rounded { corners, radius: radius - HAIR }
    }

    /// Where a round outline overlaps a convex polygon or, if that has one corner, a point.
    pub fn of_round(corners: &[Point], radius: f64) -> Self {
        Self::Rounded { corners: corners.to_vec(), radius: radius - HAIR }
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

    /// Where the region begins and ends at height `y`: below and above every x if the one isn't below the other.
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

/// The part of a row that is nearer than `radius` to a convex polygon: discs around its corners, and its sides moved outwards.
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

//! Convex obstacles: discs and polygons.

use super::{Point, Vector, contains, edges, nearest_on_segment, outward};

/// A convex obstacle.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A disc.
    Disc {
        /// Its centre.
        centre: Point,
        /// Its radius, m.
        radius: f64,
    },
    /// A convex polygon with counter-clockwise corners.
    Convex(Vec<Point>),
}

impl Shape {
    /// The point of it that is nearest to `point`: the point itself if it lies inside.
    pub fn nearest(&self, point: Point) -> Point {
        match self {
            Self::Disc { centre, radius } => nearest_on_disc(*centre, *radius, point),
            Self::Convex(corners) => nearest_on_convex(corners, point),
        }
    }

    /// Whether a point lies inside.
    pub fn contains(&self, point: Point) -> bool {
        match self {
            Self::Disc { centre, radius } => (point - centre).norm_squared() < radius * radius,
            Self::Convex(corners) => contains(corners, point),
        }
    }

    /// Distance at which a ray from `from` in the direction of the unit vector `direction` enters it, m, and the cosine of the
    /// angle to the surface's normal there; 0 and 1 for a ray that begins inside.
    pub fn entry(&self, from: Point, direction: Vector) -> Option<(f64, f64)> {
        match self {
            Self::Disc { centre, radius } => {
                let to_centre = centre - from;
                let along = to_centre.dot(&direction);
                let outside = to_centre.norm_squared() - radius * radius;
                if outside <= 0.0 {
                    return Some((0.0, 1.0));
                }
                let under_root = along * along - outside;
                // The chord's half over the radius is the cosine at which the ray enters.
                (along > 0.0 && under_root > 0.0).then(|| (along - under_root.sqrt(), under_root.sqrt() / radius))
            }
            Self::Convex(corners) => {
                let (mut enter, mut leave) = ((0.0, 1.0), f64::INFINITY);
                for (a, b) in edges(corners) {
                    let normal = outward(a, b);
                    let (outside, speed) = ((from - a).dot(&normal), direction.dot(&normal));
                    if speed < 0.0 {
                        if outside / -speed > enter.0 {
                            enter = (outside / -speed, -speed);
                        }
                    } else if speed > 0.0 {
                        leave = leave.min(-outside / speed);
                    } else if outside > 0.0 {
                        return None;
                    }
                }
                (enter.0 < leave).then_some(enter)
            }
        }
    }

    /// Lower left and upper right corner of the box around it.
    pub fn bounds(&self) -> (Point, Point) {
        match self {
            Self::Disc { centre, radius } => {
                let r = Vector::new(*radius, *radius);
                (centre - r, centre + r)
            }
            Self::Convex(corners) => corners
                .iter()
                .fold((Point::new(f64::MAX, f64::MAX), Point::new(f64::MIN, f64::MIN)), |(low, high), p| {
                    (low.inf(p), high.sup(p))
                }),
        }
    }

    /// Whether it overlaps the box between `low` and `high` by more than a nanometre.
    pub fn overlaps_box(&self, low: Point, high: Point) -> bool {
        match self {
            Self::Disc { centre, radius } => {
                let near = Point::new(centre.x.clamp(low.x, high.x), centre.y.clamp(low.y, high.y));
                (near - centre).norm() < radius - 1e-9
            }
            Self::Convex(corners) => {
                let normals: Vec<Vector> = edges(corners).map(|(a, b)| outward(a, b)).collect();
                overlap_box(corners, &normals, low, high).is_some_and(|(depth, _)| depth > 1e-9)
            }
        }
    }
}

/// The point of a disc that is nearest to `point`.
#[inline]
pub fn nearest_on_disc(centre: Point, radius: f64, point: Point) -> Point {
    let away = point - centre;
    let distance = away.norm();
    if distance <= radius { point } else { centre + away * (radius / distance) }
}

/// The point of a convex polygon that is nearest to `point`.
#[inline]
pub fn nearest_on_convex(corners: &[Point], point: Point) -> Point {
    let mut is_inside = true;
    let mut best = (f64::MAX, point);
    for (a, b) in edges(corners) {
        if (b - a).perp(&(point - a)) < 0.0 {
            is_inside = false;
            let near = nearest_on_segment(a, b, point);
            let distance = (near - point).norm_squared();
            if distance < best.0 {
                best = (distance, near);
            }
        }
    }
    if is_inside { point } else { best.1 }
}

/// How deep convex polygon `a`, with the outward `normals` of its sides, overlaps convex polygon `b`, m, and the unit vector
/// along which `a` leaves `b` by the shortest way (separating axes, Gottschalk, Lin & Manocha 1996); `None` if they don't
/// overlap.
pub fn overlap(a: &[Point], normals: &[Vector], b: &[Point]) -> Option<(f64, Vector)> {
    let mut best = (f64::MAX, Vector::zeros());
    for (from, normal) in a.iter().zip(normals) {
        let depth = b.iter().fold(f64::MIN, |deepest, p| deepest.max((from - p).dot(normal)));
        narrow(&mut best, depth, -normal)?;
    }
    for (from, to) in edges(b) {
        // Only a side that could separate them needs a square root.
        let along = to - from;
        let across = Vector::new(along.y, -along.x);
        let depth = a.iter().fold(f64::MIN, |deepest, p| deepest.max((from - p).dot(&across)));
        if depth <= 0.0 {
            return None;
        }
        let length = across.norm();
        narrow(&mut best, depth / length, across / length)?;
    }
    Some(best)
}

/// Like [`overlap`], of a polygon and the box between `low` and `high`.
#[inline]
pub fn overlap_box(polygon: &[Point], normals: &[Vector], low: Point, high: Point) -> Option<(f64, Vector)> {
    let first = *polygon.first()?;
    let (own_low, own_high) = polygon.iter().fold((first, first), |all, p| (all.0.inf(p), all.1.sup(p)));
    let mut best = (f64::MAX, Vector::zeros());
    narrow(&mut best, own_high.x - low.x, Vector::new(-1.0, 0.0))?;
    narrow(&mut best, high.x - own_low.x, Vector::new(1.0, 0.0))?;
    narrow(&mut best, own_high.y - low.y, Vector::new(0.0, -1.0))?;
    narrow(&mut best, high.y - own_low.y, Vector::new(0.0, 1.0))?;
    for (from, normal) in polygon.iter().zip(normals) {
        // The corner of the box that lies deepest behind this side.
        let x = if normal.x > 0.0 { low.x } else { high.x };
        let y = if normal.y > 0.0 { low.y } else { high.y };
        narrow(&mut best, (from - Point::new(x, y)).dot(normal), -normal)?;
    }
    Some(best)
}

/// Keeps a way out that is shorter than the best so far; `None` if there is no overlap.
#[inline]
fn narrow(best: &mut (f64, Vector), depth: f64, away: Vector) -> Option<()> {
    if depth <= 0.0 {
        return None;
    }
    // A side without length separates nothing.
    if depth < best.0 && away != Vector::zeros() {
        *best = (depth, away);
    }
    Some(())
}

/// How deep a convex polygon overlaps a disc, m, and the unit vector along which the polygon leaves it by the shortest way;
/// `None` if it doesn't.
pub fn overlap_disc(polygon: &[Point], centre: Point, radius: f64) -> Option<(f64, Vector)> {
    let near = nearest_on_convex(polygon, centre);
    let away = near - centre;
    let distance = away.norm();
    if distance >= radius {
        return None;
    }
    if distance > 1e-12 {
        return Some((radius - distance, away / distance));
    }
    // The centre lies in the polygon: out through the nearest side.
    let sides = edges(polygon).map(|(a, b)| {
        let normal = outward(a, b);
        ((a - centre).dot(&normal), normal)
    });
    let (depth, normal) = sides.min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((radius + depth, -normal))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn normals(polygon: &[Point]) -> Vec<Vector> {
        edges(polygon).map(|(a, b)| outward(a, b)).collect()
    }

    fn square(x: f64, y: f64) -> Vec<Point> {
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[dx, dy]| Point::new(x + dx, y + dy)).to_vec()
    }

    #[test]
    fn squares_leave_each_other_by_the_shortest_way() {
        let (a, sides) = (square(0.0, 0.0), normals(&square(0.0, 0.0)));
        let by_box = |low: Point| overlap_box(&a, &sides, low, low + Vector::new(1.0, 1.0));
        for found in [overlap(&a, &sides, &square(0.9, 0.3)), by_box(Point::new(0.9, 0.3))] {
            let (depth, away) = found.unwrap();
            assert!((depth - 0.1).abs() < 1e-12 && (away - Vector::new(-1.0, 0.0)).norm() < 1e-12, "{depth} {away}");
        }
        assert_eq!(overlap(&a, &sides, &square(1.0, 0.3)), None);
        assert_eq!(by_box(Point::new(1.0, 0.3)), None);
    }

    #[test]
    fn discs_are_left_over_sides_and_corners() {
        let (depth, away) = overlap_disc(&square(0.0, 0.0), Point::new(1.05, 0.5), 0.1).unwrap();
        assert!((depth - 0.05).abs() < 1e-12 && (away - Vector::new(-1.0, 0.0)).norm() < 1e-12);
        assert_eq!(overlap_disc(&square(0.0, 0.0), Point::new(1.08, 1.08), 0.1), None);
        let (depth, away) = overlap_disc(&square(0.0, 0.0), Point::new(0.95, 0.5), 0.1).unwrap();
        assert!((depth - 0.15).abs() < 1e-12 && (away - Vector::new(-1.0, 0.0)).norm() < 1e-12);
    }

    #[test]
    fn box_that_only_touches_is_not_overlapped() {
        let shape = Shape::Convex(square(0.0, 0.0));
        assert!(!shape.overlaps_box(Point::new(1.0, 0.0), Point::new(2.0, 1.0)));
        assert!(shape.overlaps_box(Point::new(0.99, 0.99), Point::new(2.0, 2.0)));
    }
}

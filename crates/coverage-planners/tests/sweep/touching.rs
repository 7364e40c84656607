//! A check of paths that shares no code with the planner: how near a body comes to anything while it drives.
//!
//! A body that moves straight without turning is nearest to an obstacle when a corner of one meets a side of the other.
//! So its distance is the least of those between the traces of its corners and the obstacle's sides, and between its
//! sides and the traces of the obstacle's corners as seen from it; unless one is inside the other at the start.

use robovac_core::{
    cspace::Outline,
    floor_plan::{FloorPlan, Object},
    geometry::{Point, Vector},
};

/// What stands in a room.
pub enum Solid {
    Disc(Point, f64),
    Polygon(Vec<Point>),
}

/// Everything that a body must not touch but the outside: cells that aren't free, run by run, and objects.
pub fn solids(plan: &FloorPlan) -> Vec<Solid> {
    let mut all = Vec::new();
    let (side, columns) = (plan.resolution, plan.occupancy.width());
    for (y, row) in plan.occupancy.values().chunks(columns).enumerate() {
        let mut x = 0;
        while x < columns {
            let first = x;
            while x < columns && !row[x].is_free() {
                x += 1;
            }
            if x > first {
                let [left, right] = [first, x].map(|x| x as f64 * side);
                let [low, high] = [y, y + 1].map(|y| y as f64 * side);
                let corners = [(left, low), (right, low), (right, high), (left, high)];
                all.push(Solid::Polygon(corners.map(|(x, y)| Point::new(x, y)).to_vec()));
            }
            x += 1;
        }
    }
    all.extend(plan.objects.iter().filter_map(|object| match object {
        Object::Leg { at, radius } => Some(Solid::Disc(*at, *radius)),
        Object::Furniture { outline } | Object::DropOff { outline } => Some(Solid::Polygon(outline.clone())),
        _ => None,
    }));
    all
}

/// How near a body comes to anything on its way along `path`, m; 0 or less if it touches. `turns` tells a body that faces
/// where it drives, and may turn either way round at every corner, from one that keeps heading 0.
pub fn nearest(plan: &FloorPlan, solids: &[Solid], outline: &Outline, turns: bool, path: &[Point]) -> f64 {
    let size = Vector::new(plan.width_m(), plan.height_m());
    let (round, corners) = match outline {
        Outline::Circle { radius } => (*radius, vec![Point::origin()]),
        Outline::Polygon(corners) => (0.0, corners.clone()),
    };
    let reach = corners.iter().map(|corner| corner.coords.norm()).fold(0.0, f64::max);
    let mut least = f64::MAX;
    let mut take = |distance: f64| least = least.min(distance);
    let single = [path[0], path[0]];
    let pieces = if path.len() == 1 { single.windows(2) } else { path.windows(2) };
    for piece in pieces {
        let (from, to) = (piece[0], piece[1]);
        let along = to - from;
        let (sin, cos) = if turns && along.norm() > 0.0 { along.y.atan2(along.x).sin_cos() } else { (0.0, 1.0) };
        let body: Vec<Point> =
            corners.iter().map(|p| Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y) + from.coords).collect();
        for corner in &body {
            for at in [*corner, corner + along] {
                take(at.x.min(at.y).min(size.x - at.x).min(size.y - at.y) - round);
            }
        }
        // In turning, the corners stay on a circle.
        let turn = if turns { reach } else { 0.0 };
        if turns {
            for at in [from, to] {
                take(at.x.min(at.y).min(size.x - at.x).min(size.y - at.y) - round.max(turn));
            }
        }
        for solid in solids {
            let (other, own) = match solid {
                Solid::Disc(centre, radius) => (std::slice::from_ref(centre), *radius),
                Solid::Polygon(corners) => (corners.as_slice(), 0.0),
            };
            // Too far away to matter: the boxes around both.
            let far = other.iter().map(|p| off_box(*p, from, to)).fold(f64::MAX, f64::min);
            let extent = other.iter().map(|p| (p - other[0]).norm()).fold(0.0, f64::max);
            if far - extent - own - reach - round > 0.1 {
                continue;
            }
            take(translated(&body, along, other) - round - own);
            if turns {
                for at in [from, to] {
                    take(translated(&[at], Vector::zeros(), other) - own - turn.max(round));
                }
            }
        }
    }
    least
}

/// Distance of a point from the box around a segment.
fn off_box(point: Point, a: Point, b: Point) -> f64 {
    let off = |p: f64, a: f64, b: f64| (a.min(b) - p).max(p - a.max(b)).max(0.0);
    off(point.x, a.x, b.x).hypot(off(point.y, a.y, b.y))
}

/// Least distance of two polygons (or points) while the first moves along a way; -1 if one is inside the other.
fn translated(body: &[Point], along: Vector, other: &[Point]) -> f64 {
    if contains(other, body[0]) || contains(body, other[0]) {
        return -1.0;
    }
    let mut least = f64::MAX;
    for corner in body {
        for (a, b) in sides(other) {
            least = least.min(between((*corner, corner + along), (a, b)));
        }
    }
    for corner in other {
        for (a, b) in sides(body) {
            least = least.min(between((*corner, corner - along), (a, b)));
        }
    }
    least
}

fn sides(corners: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    (0..corners.len()).map(|i| (corners[i], corners[(i + 1) % corners.len()]))
}

fn contains(corners: &[Point], at: Point) -> bool {
    let crosses =
        |(a, b): (Point, Point)| (a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x);
    corners.len() > 2 && sides(corners).filter(|&side| crosses(side)).count() % 2 == 1
}

/// Distance between two segments: 0 if they cross.
fn between((a, b): (Point, Point), (c, d): (Point, Point)) -> f64 {
    let side = |a: Point, b: Point, p: Point| (b - a).perp(&(p - a));
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    let off = |p: Point, a: Point, b: Point| {
        let along = b - a;
        let square = along.norm_squared();
        let share = if square > 0.0 { ((p - a).dot(&along) / square).clamp(0.0, 1.0) } else { 0.0 };
        (p - (a + share * along)).norm()
    };
    off(a, c, d).min(off(b, c, d)).min(off(c, a, b)).min(off(d, a, b))
}

#[test]
fn distances_of_moving_bodies_are_those_by_hand() {
    let square =
        |x: f64, y: f64| [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(dx, dy)| Point::new(x + dx, y + dy));
    // It passes 0.5 m below, though neither end is that near.
    assert_eq!(translated(&square(0.0, 0.0), Vector::new(9.0, 0.0), &square(4.0, 1.5)), 0.5);
    // It passes through.
    assert_eq!(translated(&square(0.0, 0.0), Vector::new(9.0, 0.0), &square(4.0, 0.5)), 0.0);
    // It begins inside.
    assert!(translated(&[Point::new(4.5, 0.75)], Vector::new(9.0, 0.0), &square(4.0, 0.5)) < 0.0);
}

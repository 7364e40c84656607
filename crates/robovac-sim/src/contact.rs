//! Exact contact of a body (circle or polygon, convex or not) with walls, furniture and movers.

use super::Touch;
use robovac_core::{
    coverage::{Obstacle, Walls},
    geometry::{
        Point, Pose, Shape, Vector, convex_pieces, difference, edges, nearest_on_convex, nearest_on_disc, outward,
        overlap, overlap_box, overlap_disc,
    },
    robot::{Body, RobotModel},
};

/// The bumper is pressed where something is nearer than this to the body, m: its play before the switch opens.
const BUMPER_PLAY: f64 = 0.001;
/// Pushing a body out of one obstacle can push it into the next; an overlap that this many rounds don't resolve is a
/// dead end.
const ROUNDS: usize = 10;
/// Overlap that is tolerated where a body is wedged, m: too small to be seen or to press the bumper. On paths that may
/// touch, none is.
const TOLERANCE: f64 = 0.0002;
const NONE: f64 = 1e-6;
/// Cosine of the angle within which contacts of a circle count as one, given the play of the bumper.
const SAME: f64 = 0.95;
/// Longest motion of any point of a body between two checks, m. Corners of polygons must not jump over thin legs;
/// circles can't.
const STRIDE: (f64, f64) = (0.004, 0.02);

/// Obstacles for a body.
#[derive(Clone, Copy)]
pub(super) struct CollisionObstacles<'a> {
    /// Walls and furniture.
    pub walls: &'a Walls,
    /// Discs that move: centre and radius, m.
    pub movers: &'a [(Point, f64)],
}

/// Result of a motion: the final pose, and the contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Collision {
    /// The pose without overlap.
    pub pose: Pose,
    /// The contacts.
    pub touch: Touch,
}

/// The outline of a body, for contact.
#[derive(Debug, Clone)]
pub(crate) struct Footprint {
    radius: f64,
    stride: f64,
    tolerance: f64,
    /// Convex pieces of a polygon; none for a circle.
    pieces: Vec<BodyPiece>,
    /// Contact points of a polygon; a buffer for reuse.
    touched: Vec<Point>,
}

/// A convex piece of a body.
#[derive(Debug, Clone)]
struct BodyPiece {
    /// Its corners and the outward normals of its sides at the last pose, m, and in the body's frame.
    corners: Vec<Point>,
    normals: Vec<Vector>,
    local: (Vec<Point>, Vec<Vector>),
}

impl BodyPiece {
    fn new(corners: Vec<Point>) -> Self {
        let normals: Vec<Vector> = edges(&corners).map(|(a, b)| outward(a, b)).collect();
        Self { corners: corners.clone(), normals: normals.clone(), local: (corners, normals) }
    }

    /// Its least extent in any direction that a side faces, m.
    fn width(&self) -> f64 {
        let extent = |normal: &Vector| {
            let along = self.local.0.iter().map(|p| p.coords.dot(normal));
            let (low, high) = along.fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at), high.max(at)));
            high - low
        };
        self.normals.iter().map(extent).fold(f64::MAX, f64::min)
    }
}

impl<'a> CollisionObstacles<'a> {
    /// Whether a disc certainly touches nothing; a quick test.
    #[inline]
    fn are_far_from(&self, point: Point, radius: f64) -> bool {
        let is_far = |&(centre, mover): &(Point, f64)| {
            let reach = mover + radius;
            (centre - point).norm_squared() > reach * reach
        };
        self.walls.has_room_around_cell(point, radius) && self.movers.iter().all(is_far)
    }

    /// The nearest point of an obstacle less than `reach` metres from `point`, and its distance.
    fn nearest(&self, point: Point, reach: f64) -> Option<(Point, f64)> {
        let mut best = self.walls.nearest(point, reach);
        for &(centre, radius) in self.movers {
            let near = nearest_on_disc(centre, radius, point);
            let distance = (near - point).norm();
            if distance < best.map_or(reach, |(_, nearest)| nearest) {
                best = Some((near, distance));
            }
        }
        best
    }

    /// Calls `visit` with the nearest point of each obstacle less than `reach` metres from `point`, and its distance.
    fn nearest_of_each(&self, point: Point, reach: f64, mut visit: impl FnMut(Point, f64)) {
        let mut look = |near: Point| {
            let distance = (near - point).norm();
            if distance < reach && distance > 1e-12 {
                visit(near, distance);
            }
        };
        let around = Vector::new(reach, reach);
        self.walls.near(point - around, point + around, |obstacle| {
            look(match obstacle {
                Obstacle::Squares(low, high) => Point::new(point.x.clamp(low.x, high.x), point.y.clamp(low.y, high.y)),
                Obstacle::Shape(shape) => shape.nearest(point),
            });
        });
        self.movers.iter().for_each(|&(centre, radius)| look(nearest_on_disc(centre, radius, point)));
    }

    /// Calls `visit` with every obstacle that can reach into the box between `low` and `high`.
    #[inline]
    fn near(&self, low: Point, high: Point, mut visit: impl FnMut(Thing<'a>)) {
        self.walls.near(low, high, |obstacle| match obstacle {
            Obstacle::Squares(low, high) => visit(Thing::Box(low, high)),
            Obstacle::Shape(Shape::Convex(corners)) => visit(Thing::Polygon(corners)),
            Obstacle::Shape(&Shape::Disc { centre, radius }) => visit(Thing::Disc(centre, radius)),
        });
        for &(centre, radius) in self.movers {
            let r = Vector::new(radius, radius);
            let (mover_low, mover_high) = (centre - r, centre + r);
            if mover_low.x < high.x && mover_low.y < high.y && mover_high.x > low.x && mover_high.y > low.y {
                visit(Thing::Disc(centre, radius));
            }
        }
    }
}

/// A convex obstacle for contact with a polygon.
enum Thing<'a> {
    /// Lower left and upper right corner.
    Box(Point, Point),
    Polygon(&'a [Point]),
    Disc(Point, f64),
}

impl Thing<'_> {
    #[inline]
    fn overlap(&self, body: &[Point], normals: &[Vector]) -> Option<(f64, Vector)> {
        match self {
            Self::Box(low, high) => overlap_box(body, normals, *low, *high),
            Self::Polygon(corners) => overlap(body, normals, corners),
            Self::Disc(centre, radius) => overlap_disc(body, *centre, *radius),
        }
    }

    /// Adds the points at which it is less than `play` metres from a polygon.
    fn touch(&self, body: &[Point], play: f64, touched: &mut Vec<Point>) {
        let of_box;
        let corners: &[Point] = match self {
            Self::Box(low, high) => {
                of_box = [*low, Point::new(high.x, low.y), *high, Point::new(low.x, high.y)];
                &of_box
            }
            Self::Polygon(corners) => corners,
            Self::Disc(centre, radius) => {
                let near = nearest_on_convex(body, *centre);
                if (near - centre).norm() < radius + play {
                    touched.push(near);
                }
                return;
            }
        };
        let is_near = |polygon: &[Point], p: Point| (nearest_on_convex(polygon, p) - p).norm_squared() < play * play;
        touched.extend(body.iter().filter(|&&p| is_near(corners, p)));
        touched.extend(corners.iter().filter(|&&p| is_near(body, p)));
    }
}

impl Footprint {
    pub fn new(model: &RobotModel) -> Self {
        let (stride, pieces) = match model.body {
            Body::Round => (STRIDE.1.min(0.5 * model.radius), Vec::new()),
            Body::Polygon(local) => {
                let corners: Vec<Point> = local.iter().map(|&[x, y]| Point::new(x, y)).collect();
                let inner = edges(&corners).map(|(a, b)| (a - Point::origin()).dot(&outward(a, b)));
                let inner = inner.fold(f64::MAX, f64::min);
                let pieces: Vec<BodyPiece> = convex_pieces(&corners).into_iter().map(BodyPiece::new).collect();
                // At most half the distance from the origin to the nearest side, and never 0. A thin piece of a body that
                // isn't convex must not jump over something.
                let thin = if let [_] = pieces[..] {
                    inner
                } else {
                    0.5 * pieces.iter().map(BodyPiece::width).fold(f64::MAX, f64::min)
                };
                (STRIDE.0.min(0.5 * thin).max(1e-4), pieces)
            }
        };
        Self { radius: model.radius, stride, tolerance: TOLERANCE, pieces, touched: Vec::new() }
    }

    /// From now on it stays where it is rather than overlap anything.
    pub fn make_exact(&mut self) {
        self.tolerance = NONE;
    }

    /// Moves the body from one pose, where it overlaps nothing, towards another, as far as obstacles allow, sliding
    /// along them. If there is no way to resolve an overlap, it stays where it was.
    #[inline]
    pub fn slide(&mut self, obstacles: CollisionObstacles<'_>, from: Pose, to: Pose) -> Collision {
        let way = (to.position() - from.position()).norm();
        let margin = if way < self.stride { BUMPER_PLAY } else { BUMPER_PLAY + way };
        if obstacles.are_far_from(to.position(), self.radius + margin) {
            return Collision { pose: to, touch: Touch::NONE };
        }
        self.slide_near_obstacles(obstacles, from, to)
    }

    fn slide_near_obstacles(&mut self, obstacles: CollisionObstacles<'_>, from: Pose, to: Pose) -> Collision {
        let way = to.position() - from.position();
        if self.is_round() && way.norm_squared() < self.stride * self.stride {
            // Usually it passes without contact.
            let at = to.position();
            match obstacles.nearest(at, self.radius + BUMPER_PLAY) {
                None => return Collision { pose: to, touch: Touch::NONE },
                Some((_, distance)) if self.radius - distance <= 1e-12 => {
                    return Collision { pose: to, touch: self.touch(obstacles, to) };
                }
                Some(_) => {}
            }
        }
        let turn = difference(from.heading, to.heading);
        let rim = if self.is_round() { 0.0 } else { turn.abs() * self.radius };
        let strides = ((way.norm() + rim) / self.stride).ceil().max(1.0);
        let mut pose = from;
        for _ in 0..strides as u32 {
            let next = pose.position() + way / strides;
            let next = if strides > 1.0 { Pose::new(next.x, next.y, pose.heading + turn / strides) } else { to };
            pose = self.settle(obstacles, pose, next);
        }
        Collision { pose, touch: self.touch(obstacles, pose) }
    }

    fn is_round(&self) -> bool {
        self.pieces.is_empty()
    }

    /// One stride: the pose after pushing out, or else after only the motion or only the turn, or else the old pose.
    fn settle(&mut self, obstacles: CollisionObstacles<'_>, from: Pose, to: Pose) -> Pose {
        if obstacles.are_far_from(to.position(), self.radius) {
            return to;
        }
        let tries = [to, Pose { heading: from.heading, ..to }, Pose { heading: to.heading, ..from }];
        let tries = if self.is_round() { &tries[..1] } else { &tries[..] };
        let pushed = tries.iter().find_map(|&pose| self.push_out(obstacles, pose));
        pushed.unwrap_or(if self.is_round() { Pose { heading: to.heading, ..from } } else { from })
    }

    /// The pose moved out of all obstacles by the shortest way, the deepest overlap first; `None` if there is no such
    /// pose.
    ///
    /// The tangential part of a motion remains, so the robot slides along walls.
    fn push_out(&mut self, obstacles: CollisionObstacles<'_>, mut pose: Pose) -> Option<Pose> {
        let wanted = pose.position();
        for _ in 0..ROUNDS {
            let Some((depth, away)) = self.deepest(obstacles, pose) else { return Some(pose) };
            pose.x += depth * away.x;
            pose.y += depth * away.y;
        }
        let is_near = (pose.position() - wanted).norm() < 4.0 * self.stride;
        let left = self.deepest(obstacles, pose).map_or(0.0, |(depth, _)| depth);
        (is_near && left < self.tolerance).then_some(pose)
    }

    /// The deepest overlap with an obstacle, m, and the direction out of it.
    fn deepest(&mut self, obstacles: CollisionObstacles<'_>, pose: Pose) -> Option<(f64, Vector)> {
        let at = pose.position();
        if self.is_round() {
            let (wall, distance) = obstacles.nearest(at, self.radius)?;
            let away = if distance > 1e-12 { (at - wall) / distance } else { Vector::new(1.0, 0.0) };
            return (self.radius - distance > 1e-12).then_some((self.radius - distance, away));
        }
        let (low, high) = self.place(pose);
        let mut deepest = (1e-9, Vector::zeros());
        obstacles.near(low, high, |thing| {
            for piece in &self.pieces {
                if let Some(found) = thing.overlap(&piece.corners, &piece.normals).filter(|found| found.0 > deepest.0) {
                    deepest = found;
                }
            }
        });
        (deepest.0 > 1e-9).then_some(deepest)
    }

    /// The contacts of the body: for a circle, the nearest point of every obstacle. For a side of a polygon that lies
    /// flat against a wall, or both of whose ends touch, the middle of all contact points on that side.
    fn touch(&mut self, obstacles: CollisionObstacles<'_>, pose: Pose) -> Touch {
        let at = pose.position();
        let mut touch = Touch::NONE;
        if self.is_round() {
            // The cells of a flat wall beside its nearest point are almost as near.
            let mut near: Vec<(f64, Vector)> = Vec::new();
            obstacles.nearest_of_each(at, self.radius + BUMPER_PLAY, |wall, distance| {
                let index = near.iter().position(|other| other.0.total_cmp(&distance).is_gt()).unwrap_or(near.len());
                near.insert(index, (distance, (wall - at) / distance));
            });
            for (_, direction) in near {
                if touch.iter().all(|other| other.dot(&direction) < SAME) {
                    touch.add(direction);
                }
            }
            return touch;
        }
        self.touch_within(obstacles, pose, BUMPER_PLAY);
        // The farthest point ahead decides between front and rear.
        let ahead = |p: &Point| (p - at).dot(&pose.direction());
        let Some(first) = self.touched.iter().max_by(|a, b| ahead(a).total_cmp(&ahead(b))) else { return touch };
        let first = first - at;
        let same_side = self.touched.iter().map(|p| p - at).filter(|p| p.dot(&first) > 0.0);
        let sum: Vector = same_side.sum();
        let length = sum.norm();
        if length > 1e-12 {
            touch.add(sum / length);
        }
        touch
    }

    /// Collects the points at which a polygon is less than `play` metres from an obstacle.
    fn touch_within(&mut self, obstacles: CollisionObstacles<'_>, pose: Pose, play: f64) {
        let (low, high) = self.place(pose);
        let around = Vector::new(play, play);
        let Self { pieces, touched, .. } = self;
        touched.clear();
        obstacles.near(low - around, high + around, |thing| {
            for piece in pieces.iter() {
                thing.touch(&piece.corners, play, touched);
            }
        });
    }

    /// Whether the body, at `pose`, is less than `gap` metres from a wall or furniture.
    pub fn is_near_walls(&mut self, walls: &Walls, pose: Pose, gap: f64) -> bool {
        let obstacles = CollisionObstacles { walls, movers: &[] };
        if self.is_round() {
            return obstacles.nearest(pose.position(), self.radius + gap).is_some();
        }
        self.touch_within(obstacles, pose, gap);
        !self.touched.is_empty()
    }

    /// Whether the body, at `pose`, overlaps a disc or is nearer to it than `gap` metres.
    pub fn is_near_disc(&mut self, pose: Pose, centre: Point, radius: f64, gap: f64) -> bool {
        let reach = radius + gap;
        let to_origin = (centre - pose.position()).norm();
        if self.is_round() || to_origin >= self.radius + reach {
            return to_origin < self.radius + reach;
        }
        self.place(pose);
        self.pieces.iter().any(|piece| (nearest_on_convex(&piece.corners, centre) - centre).norm() < reach)
    }

    /// Puts the corners of a polygon where they are at `pose`; returns the box around them.
    fn place(&mut self, pose: Pose) -> (Point, Point) {
        let (mut low, mut high) = (pose.position(), pose.position());
        let d = pose.direction();
        for BodyPiece { corners, normals, local } in &mut self.pieces {
            for (corner, &Point { coords: at }) in corners.iter_mut().zip(&local.0) {
                *corner = Point::new(pose.x + d.x * at.x - d.y * at.y, pose.y + d.y * at.x + d.x * at.y);
                low = low.inf(corner);
                high = high.sup(corner);
            }
            for (normal, n) in normals.iter_mut().zip(&local.1) {
                *normal = Vector::new(d.x * n.x - d.y * n.y, d.y * n.x + d.x * n.y);
            }
        }
        (low, high)
    }
}

//! Shapes of objects in a room, with a spatial index.

use super::Walls;
use crate::{
    floor_plan::{FloorPlan, Object},
    geometry::{Point, Pose, Shape, convex_pieces},
    math,
    robot::RobotModel,
};

/// Width and depth of the solid back of a dock, m. iRobot's Home Base is about 15 cm wide; robots drive onto the flat plate
/// in front of its back, which stands 2 cm off the wall (the depth is ours).
pub const DOCK_BACK: [f64; 2] = [0.15, 0.02];
/// Radius of the lighthouse of a virtual wall, m: they fit in a hand (ours).
pub const LIGHTHOUSE_RADIUS: f64 = 0.04;
/// Half the width of a virtual wall's beam at its lighthouse, m, and how much it grows with every metre: 5 degrees (ours).
pub const FENCE: (f64, f64) = (0.02, 0.087_488_663_525_924);
/// Radius of the halo around a lighthouse, m: it keeps robots from pushing it away (owners report that there is one;
/// the radius is ours).
pub const HALO: f64 = 0.4;
/// Slices of a halo.
const SLICES: u32 = 16;
/// Least side of a bucket of the index, m: about the size of a query.
const BUCKET: f64 = 0.5;
/// Most buckets along a side.
const MOST_BUCKETS: f64 = 256.0;

/// The shapes of the objects of `plan` that are obstacles.
pub fn obstacles(plan: &FloorPlan) -> Vec<Shape> {
    plan.objects.iter().flat_map(solid).collect()
}

/// The same without low obstacles that pass under the bumper of `robot`.
pub fn obstacles_for(plan: &FloorPlan, robot: &RobotModel) -> Vec<Shape> {
    let clears = robot.sensors.bumper.map_or(0.0, |bumper| bumper.height);
    let is_felt = |object: &&Object| !matches!(object, Object::LowObstacle { height, .. } if *height < clears);
    plan.objects.iter().filter(is_felt).flat_map(solid).collect()
}

/// The shapes of drop-offs in `plan`.
pub fn drop_offs(plan: &FloorPlan) -> Vec<Shape> {
    let outlines = plan.objects.iter().filter_map(|object| match object {
        Object::DropOff { outline } => Some(outline),
        _ => None,
    });
    outlines.flat_map(|outline| pieces(outline)).collect()
}

/// The floor lit by virtual walls, beam and halo, up to `walls`, in convex pieces.
pub fn beams(plan: &FloorPlan, walls: &Walls) -> Vec<Shape> {
    let mut lit = Vec::new();
    for object in &plan.objects {
        let Object::VirtualWall { pose, length } = *object else { continue };
        let centre = pose.position();
        // Light begins outside the lighthouse, which is solid.
        let skip = LIGHTHOUSE_RADIUS + 1e-3;
        let reach = |angle: f64, most: f64| {
            let way = Pose::new(0.0, 0.0, angle).direction();
            let end = walls.ray(centre + way * skip, way, most - skip).map_or(most, |hit| skip + hit.distance);
            centre + way * end
        };
        let slice = math::TAU / f64::from(SLICES);
        for i in 0..SLICES {
            let from = pose.heading + slice * f64::from(i);
            lit.push(Shape::Convex(vec![centre, reach(from, HALO), reach(from + slice, HALO)]));
        }
        let half = math::atan2(FENCE.0 + FENCE.1 * length, length);
        for (from, to) in [(-half, 0.0), (0.0, half)] {
            let [from, to] = [from, to].map(|angle| reach(pose.heading + angle, length));
            lit.push(Shape::Convex(vec![centre, from, to]));
        }
    }
    // A slice in a wall has no area.
    let area = |c: &[Point]| (c[1] - c[0]).perp(&(c[2] - c[0]));
    lit.retain(|shape| matches!(shape, Shape::Convex(corners) if area(corners) > 1e-6));
    lit
}

/// The solid parts of an object.
fn solid(object: &Object) -> Vec<Shape> {
    match object {
        Object::Furniture { outline } | Object::LowObstacle { outline, .. } => pieces(outline),
        Object::Leg { at, radius } => vec![Shape::Disc { centre: *at, radius: *radius }],
        Object::Dock { pose } => vec![dock_back(*pose)],
        Object::VirtualWall { pose, .. } => {
            vec![Shape::Disc { centre: pose.position(), radius: LIGHTHOUSE_RADIUS }]
        }
        Object::DropOff { .. } | Object::Carpet { .. } | Object::Dirt { .. } | Object::Mover { .. } => Vec::new(),
    }
}

fn pieces(outline: &[Point]) -> Vec<Shape> {
    convex_pieces(outline).into_iter().map(Shape::Convex).collect()
}

/// The solid back of a dock that stands at `pose`.
pub fn dock_back(pose: Pose) -> Shape {
    let [width, depth] = DOCK_BACK;
    let corners = [[0.0, -0.5], [1.0, -0.5], [1.0, 0.5], [0.0, 0.5]];
    Shape::Convex(corners.map(|[x, y]| pose.to_world(Point::new(x * depth, y * width))).to_vec())
}

/// Shapes in buckets of about half a metre, for box queries.
#[derive(Debug, Clone, Default)]
pub(super) struct ShapeIndex {
    shapes: Vec<Shape>,
    bounds: Vec<(Point, Point)>,
    low: Point,
    side: f64,
    width: usize,
    height: usize,
    /// Start of each bucket's shapes in `members`.
    starts: Vec<u32>,
    members: Vec<u32>,
}

impl ShapeIndex {
    pub fn new(shapes: Vec<Shape>) -> Self {
        let bounds: Vec<_> = shapes.iter().map(Shape::bounds).collect();
        let Some(&first) = bounds.first() else { return Self::default() };
        let (low, high) = bounds.iter().fold(first, |all, b| (all.0.inf(&b.0), all.1.sup(&b.1)));
        let extent = high - low;
        let side = (extent.max() / MOST_BUCKETS).max(BUCKET);
        let buckets = |length: f64| (length / side) as usize + 1;
        let (width, height) = (buckets(extent.x), buckets(extent.y));
        let mut index = Self { shapes, bounds, low, side, width, height, starts: vec![0], members: Vec::new() };
        for row in 0..height {
            for column in 0..width {
                for (number, &(low, high)) in index.bounds.iter().enumerate() {
                    let ((x0, y0), (x1, y1)) = (index.bucket(low), index.bucket(high));
                    if (x0..=x1).contains(&column) && (y0..=y1).contains(&row) {
                        index.members.push(number as u32);
                    }
                }
                index.starts.push(index.members.len() as u32);
            }
        }
        index
    }

    pub fn all(&self) -> &[Shape] {
        &self.shapes
    }

    /// Calls `visit` once with every shape whose own box meets the one between `low` and `high`.
    #[inline]
    pub fn in_box<'a>(&'a self, low: Point, high: Point, mut visit: impl FnMut(&'a Shape)) {
        if self.shapes.is_empty() {
            return;
        }
        let ((x0, y0), (x1, y1)) = (self.bucket(low), self.bucket(high));
        for y in y0..=y1 {
            for x in x0..=x1 {
                let bucket = y * self.width + x;
                for &number in &self.members[self.starts[bucket] as usize..self.starts[bucket + 1] as usize] {
                    let (shape_low, shape_high) = self.bounds[number as usize];
                    let apart =
                        shape_low.x > high.x || shape_low.y > high.y || shape_high.x < low.x || shape_high.y < low.y;
                    // A shape in several buckets is visited in the first that it shares with the box.
                    let (first_x, first_y) = self.bucket(shape_low);
                    if !apart && (x, y) == (first_x.max(x0), first_y.max(y0)) {
                        visit(&self.shapes[number as usize]);
                    }
                }
            }
        }
    }

    /// Column and row of the bucket nearest to a point.
    fn bucket(&self, point: Point) -> (usize, usize) {
        let at = (point - self.low) / self.side;
        ((at.x.max(0.0) as usize).min(self.width - 1), (at.y.max(0.0) as usize).min(self.height - 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn index_finds_every_shape_once() {
        use rand::RngExt;
        let mut rng = crate::rng::seeded(3, 99);
        let discs = (0..60).map(|_| Shape::Disc {
            centre: Point::new(rng.random_range(-3.0..9.0), rng.random_range(-3.0..9.0)),
            radius: rng.random_range(0.002..1.5),
        });
        let index = ShapeIndex::new(discs.collect());
        for _ in 0..200 {
            let low = Point::new(rng.random_range(-5.0..10.0), rng.random_range(-5.0..10.0));
            let high = low + crate::geometry::Vector::new(rng.random_range(0.0..2.0), rng.random_range(0.0..2.0));
            let mut found = Vec::new();
            index.in_box(low, high, |shape| found.push(shape.bounds()));
            let meets = |b: &(Point, Point)| b.0.x <= high.x && b.0.y <= high.y && b.1.x >= low.x && b.1.y >= low.y;
            let expected = index.bounds.iter().filter(|b| meets(b)).count();
            assert_eq!(found.len(), expected);
        }
    }
}

//! The free space of a disc between rectangles, polygons and discs: exact distances of straight pieces from obstacles.

use robovac_core::{
    coverage::Walls,
    geometry::{Point, Shape, Vector, contains, edges, nearest_on_convex, nearest_on_segment},
    grid::{Cell, Grid},
};

/// Side of a bucket of the index, m.
const BUCKET: f64 = 0.4;
/// Most buckets along a side.
const MOST_BUCKETS: f64 = 1024.0;
/// What rounding may take off a distance, m.
const ROUNDING: f64 = 1e-9;

/// A convex obstacle.
#[derive(Debug, Clone)]
enum ConvexObstacle {
    /// A rectangle of the grid: its lower left and upper right corner.
    Rectangle(Point, Point),
    Shape(Shape),
}

/// Where the centre of a disc can be: at least `reach` from every obstacle, and from the edge of the map.
#[derive(Debug, Clone)]
pub struct FreeSpace {
    obstacles: Vec<ConvexObstacle>,
    /// Boxes around the obstacles, larger by the reach.
    boxes: Vec<(Point, Point)>,
    reach: f64,
    size: Vector,
    side: f64,
    columns: usize,
    /// Start of each bucket's obstacles in `members`.
    starts: Vec<u32>,
    members: Vec<u32>,
}

impl FreeSpace {
    /// The space of a disc's centre that keeps `reach` metres (radius and clearance) away from `walls`.
    pub fn new(walls: &Walls, reach: f64) -> Self {
        let size = Vector::new(walls.squares().width() as f64, walls.squares().height() as f64) * walls.resolution;
        let rectangles = rectangles(walls.squares(), walls.resolution);
        let mut obstacles: Vec<ConvexObstacle> =
            rectangles.into_iter().map(|(a, b)| ConvexObstacle::Rectangle(a, b)).collect();
        obstacles.extend(walls.shapes().iter().cloned().map(ConvexObstacle::Shape));
        let margin = Vector::new(reach, reach);
        let boxes: Vec<_> = obstacles
            .iter()
            .map(|obstacle| {
                let (low, high) = obstacle.bounds();
                (low - margin, high + margin)
            })
            .collect();
        let side = (size.max() / MOST_BUCKETS).max(BUCKET);
        let buckets = |length: f64| (length / side) as usize + 1;
        let (columns, rows) = (buckets(size.x), buckets(size.y));
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); columns * rows];
        let bucket = |metres: f64, most: usize| ((metres / side).max(0.0) as usize).min(most - 1);
        for (number, (low, high)) in boxes.iter().enumerate() {
            for row in bucket(low.y, rows)..=bucket(high.y, rows) {
                for column in bucket(low.x, columns)..=bucket(high.x, columns) {
                    lists[row * columns + column].push(number as u32);
                }
            }
        }
        let mut starts = vec![0];
        let mut members = Vec::new();
        for list in lists {
            members.extend(list);
            starts.push(members.len() as u32);
        }
        Self { obstacles, boxes, reach, size, side, columns, starts, members }
    }

    /// Width and height of the map, m.
    pub fn size(&self) -> Vector {
        self.size
    }

    /// Whether the disc's centre can be at a point.
    pub fn has_room(&self, point: Point) -> bool {
        self.is_free(point, point)
    }

    /// Whether the disc's centre can move from `a` straight to `b`; exact.
    pub fn is_free(&self, a: Point, b: Point) -> bool {
        self.is_inside(a, self.reach) && self.is_inside(b, self.reach) && self.is_clear(a, b)
    }

    /// Distance from the nearest obstacle of the way from `a` straight to `b`, m, 0 if it meets one; exact. For checks:
    /// it looks at every obstacle.
    pub fn distance(&self, a: Point, b: Point) -> f64 {
        let outside = [a, b].map(|p| p.x.min(p.y).min(self.size.x - p.x).min(self.size.y - p.y));
        let to_edge = outside[0].min(outside[1]).max(0.0);
        self.obstacles.iter().fold(to_edge, |least, obstacle| least.min(obstacle.distance(a, b)))
    }

    fn is_inside(&self, p: Point, reach: f64) -> bool {
        let reach = reach - ROUNDING;
        p.x >= reach && p.y >= reach && p.x <= self.size.x - reach && p.y <= self.size.y - reach
    }

    /// Whether the way keeps the reach from all obstacles, the edge of the map aside. Both ends lie inside the map.
    fn is_clear(&self, a: Point, b: Point) -> bool {
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        let (first, last) = ((low.y / self.side) as usize, (high.y / self.side) as usize);
        let slope = if high.y > low.y { (high.x - low.x) / (high.y - low.y) } else { 0.0 };
        for row in first..=last {
            // The part of the way within this row of buckets.
            let from = if row == first { low.x } else { low.x + slope * (row as f64 * self.side - low.y) };
            let to = if row == last { high.x } else { low.x + slope * ((row + 1) as f64 * self.side - low.y) };
            let (left, right) = if from <= to { (from, to) } else { (to, from) };
            // Rounding must not skip a bucket.
            let column = |x: f64| ((x / self.side).max(0.0) as usize).min(self.columns - 1);
            for column in column(left - ROUNDING)..=column(right + ROUNDING) {
                let bucket = row * self.columns + column;
                for &number in &self.members[self.starts[bucket] as usize..self.starts[bucket + 1] as usize] {
                    if !self.keeps_off(number as usize, a, b) {
                        return false;
                    }
                }
            }
        }
        true
    }

    #[inline]
    fn keeps_off(&self, number: usize, a: Point, b: Point) -> bool {
        let (low, high) = self.boxes[number];
        if a.x.max(b.x) <= low.x || a.x.min(b.x) >= high.x || a.y.max(b.y) <= low.y || a.y.min(b.y) >= high.y {
            return true;
        }
        self.obstacles[number].distance(a, b) >= self.reach - ROUNDING
    }
}

impl ConvexObstacle {
    fn bounds(&self) -> (Point, Point) {
        match self {
            Self::Rectangle(low, high) => (*low, *high),
            Self::Shape(shape) => shape.bounds(),
        }
    }

    /// Distance of a segment, m; 0 if they meet.
    fn distance(&self, a: Point, b: Point) -> f64 {
        match self {
            Self::Rectangle(low, high) => to_rectangle(*low, *high, a, b),
            Self::Shape(Shape::Disc { centre, radius }) => {
                ((nearest_on_segment(a, b, *centre) - centre).norm() - radius).max(0.0)
            }
            Self::Shape(Shape::Convex(corners)) => to_convex(corners, a, b),
        }
    }
}

/// Distance of a segment from a rectangle. That of disjoint convex sets is taken at a corner of one of them.
fn to_rectangle(low: Point, high: Point, a: Point, b: Point) -> f64 {
    if crosses(low, high, a, b) {
        return 0.0;
    }
    let end = |p: Point| {
        let dx = (low.x - p.x).max(p.x - high.x).max(0.0);
        let dy = (low.y - p.y).max(p.y - high.y).max(0.0);
        dx * dx + dy * dy
    };
    let corner = |x: f64, y: f64| {
        let p = Point::new(x, y);
        (nearest_on_segment(a, b, p) - p).norm_squared()
    };
    let ends = end(a).min(end(b));
    let corners =
        corner(low.x, low.y).min(corner(high.x, low.y)).min(corner(low.x, high.y)).min(corner(high.x, high.y));
    ends.min(corners).sqrt()
}

/// Whether a segment meets a rectangle (slabs).
fn crosses(low: Point, high: Point, a: Point, b: Point) -> bool {
    let along = b - a;
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        if along[axis].abs() < 1e-12 {
            if a[axis] < low[axis] || a[axis] > high[axis] {
                return false;
            }
        } else {
            let (one, other) = ((low[axis] - a[axis]) / along[axis], (high[axis] - a[axis]) / along[axis]);
            enter = enter.max(one.min(other));
            leave = leave.min(one.max(other));
        }
    }
    enter <= leave
}

fn to_convex(corners: &[Point], a: Point, b: Point) -> f64 {
    if contains(corners, a) || contains(corners, b) {
        return 0.0;
    }
    let crossed = edges(corners).any(|(c, d)| {
        let (along, side) = (b - a, d - c);
        (along.perp(&(c - a)) > 0.0) != (along.perp(&(d - a)) > 0.0)
            && (side.perp(&(a - c)) > 0.0) != (side.perp(&(b - c)) > 0.0)
    });
    if crossed {
        return 0.0;
    }
    let ends = [a, b].map(|p| (nearest_on_convex(corners, p) - p).norm());
    let near = corners.iter().map(|&p| (nearest_on_segment(a, b, p) - p).norm());
    near.fold(ends[0].min(ends[1]), f64::min)
}

/// Rectangles that cover the set cells without overlap: runs of a row, joined with equal runs above.
fn rectangles(squares: &Grid<bool>, resolution: f64) -> Vec<(Point, Point)> {
    let mut taken = squares.map(|_| false);
    let mut found = Vec::new();
    let (width, height) = (squares.width() as i32, squares.height() as i32);
    for y in 0..height {
        let mut x = 0;
        while x < width {
            let is_new =
                |x: i32, y: i32, taken: &Grid<bool>| squares.is_set(Cell::new(x, y)) && !taken[Cell::new(x, y)];
            if !is_new(x, y, &taken) {
                x += 1;
                continue;
            }
            let mut right = x;
            while right < width && is_new(right, y, &taken) {
                right += 1;
            }
            let mut top = y;
            while top < height && (x..right).all(|column| is_new(column, top, &taken)) {
                (x..right).for_each(|column| taken[Cell::new(column, top)] = true);
                top += 1;
            }
            let corner = |x: i32, y: i32| Point::new(f64::from(x) * resolution, f64::from(y) * resolution);
            found.push((corner(x, y), corner(right, top)));
            x = right;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::RngExt;
    use robovac_core::{
        coverage::ReachableFloor,
        floor_plan::Sketch,
        rng::seeded,
        robot::{Body, Corners, RobotModel, WheelLayout, model},
    };

    #[test]
    fn ways_keep_off_every_square_and_shape_or_are_refused() {
        let mut rng = seeded(11, 0);
        for _ in 0..20 {
            let mut squares = Grid::filled(40, 30, false);
            squares.values_mut().iter_mut().for_each(|square| *square = rng.random_bool(0.01));
            let mut at = |margin: f64| {
                Point::new(rng.random_range(margin..4.0 - margin), rng.random_range(margin..3.0 - margin))
            };
            let corner = at(0.0);
            let triangle = vec![corner, corner + Vector::new(0.3, 0.1), corner + Vector::new(0.1, 0.2)];
            let shapes = vec![Shape::Convex(triangle), Shape::Disc { centre: at(0.0), radius: 0.05 }];
            let walls = Walls::new(squares, shapes, 0.1, 0.17);
            let space = FreeSpace::new(&walls, 0.18);
            let mut free = 0;
            for _ in 0..300 {
                let (a, b) = (at(0.0), at(0.0));
                // Walls know the distance of a point; a way is as near as its nearest point.
                let nearest = (0..=2000).map(|i| {
                    let p = a + (b - a) * (f64::from(i) / 2000.0);
                    walls.nearest(p, 0.4).map_or(0.4, |(_, distance)| distance)
                });
                let sampled = nearest.fold(0.4, f64::min);
                let exact = space.distance(a, b).min(0.4);
                assert!(exact <= sampled + 1e-9 && sampled - exact < 0.002, "{exact} {sampled}");
                assert_eq!(space.is_free(a, b), space.distance(a, b) >= 0.18 - ROUNDING);
                free += u32::from(space.is_free(a, b));
            }
            assert!(free > 0);
        }
    }

    #[test]
    fn a_body_that_fits_where_its_disc_does_not_gains_no_floor() {
        let corners = Corners::of(&[[-0.25, -0.1], [0.25, -0.1], [0.25, 0.1], [-0.25, 0.1]]);
        let (body, radius) = (Body::Polygon(corners), 0.25_f64.hypot(0.1));
        let robot = RobotModel { body, radius, ..model("roomba600").unwrap().clone() };
        let door = [[1.9, 0.0, 2.1, 0.85], [1.9, 1.15, 2.1, 2.0]];
        let plan = Sketch::open(4.0, 2.0, 0.05).fill(&door).start(1.0, 1.0, 0.0).finish("", "");
        let floor = ReachableFloor::new(&plan, &robot, None).unwrap();
        // Straight on it fits through the door, but what is behind isn't reachable floor.
        let straight = RobotModel { wheels: WheelLayout::Omnidirectional, ..robot.clone() };
        let straight = ReachableFloor::of_path(&plan, &straight, floor.start).unwrap();
        let behind = Point::new(3.0, 1.0);
        assert!(straight.standing.is_set(straight.cell_at(behind)));
        assert!(!floor.floor.is_set(floor.cell_at(behind)));
        // All floor lies under the tool in some place where the disc has room.
        let space = FreeSpace::new(floor.limits(), radius - 1e-4);
        let reach = (floor.tool_radius / floor.resolution) as i32 + 1;
        for (cell, _) in floor.floor.iter().filter(|&(_, &is_floor)| is_floor) {
            let near = (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| Cell::new(cell.x + x, cell.y + y)));
            let mut places = near.filter(|&at| floor.standing.is_set(at)).map(|at| floor.centre(at));
            let is_under = |at: Point| (at - floor.centre(cell)).norm() <= floor.tool_radius + 1e-9;
            assert!(places.any(|at| is_under(at) && space.has_room(at)), "{cell:?}");
        }
    }
}

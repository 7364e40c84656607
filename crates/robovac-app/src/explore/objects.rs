//! Editing of objects: create, find, move, turn, resize.

use robovac_core::{
    floor_plan::{BEAMS, FloorPlan, Object, RADII, Who, encloses, middle},
    geometry::{Point, Pose, Vector, normalize},
    math,
};

/// Shorter drags are clicks, m; a click places an object of the usual size.
const CLICK: f64 = 0.08;
/// Shortest side of a drawn object, m.
const LEAST_SIDE: f64 = 0.05;
/// Height of a low obstacle, m: that of a cable cover, and less than the DVR-1's bumper is above the floor.
const LOW: f64 = 0.015;
/// Radius of a table's leg, m.
const TABLE_LEG: f64 = 0.025;
/// Largest distance from a click to the wall at which a dock or lighthouse is placed, m.
const TO_WALL: f64 = 1.0;
/// Distance that a person placed by a click walks to either side, m, if there is room.
const STROLL: f64 = 1.0;
/// Distance that it keeps from walls, m.
const OFF_WALL: f64 = 0.05;
/// Step of looking for room, m, and the farthest that a mover is moved away from a wall, m.
const STRIDE: f64 = 0.02;
const ASIDE: f64 = 0.5;

/// Kinds of objects that can be placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaceableKind {
    /// A box that stands on the floor.
    Furniture,
    /// A low obstacle, which passes under some bumpers.
    LowObstacle,
    /// Four legs.
    Table,
    /// A drop-off.
    Stairs,
    /// A carpet.
    Carpet,
    /// A spot of dirt.
    Dirt,
    /// A dock.
    Dock,
    /// A virtual wall.
    VirtualWall,
    /// A person who walks to and fro.
    Person,
    /// A pet.
    Pet,
}

impl PlaceableKind {
    /// All kinds with their names on the page's buttons.
    pub const ALL: [(Self, &'static str); 10] = [
        (Self::Furniture, "furniture"),
        (Self::LowObstacle, "low_obstacle"),
        (Self::Table, "table"),
        (Self::Stairs, "stairs"),
        (Self::Carpet, "carpet"),
        (Self::Dirt, "dirt"),
        (Self::Dock, "dock"),
        (Self::VirtualWall, "virtual_wall"),
        (Self::Person, "person"),
        (Self::Pet, "pet"),
    ];

    /// The kind of that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(kind, _)| kind)
    }

    /// Its name.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// The objects placed by a drag from one point to another in `plan`; a click places an object of the usual size.
    pub fn drawn(self, plan: &FloorPlan, from: Point, to: Point) -> Vec<Object> {
        let is_click = (to - from).norm() < CLICK;
        let usual =
            |width: f64, depth: f64| if is_click { rect_around(plan, from, width, depth) } else { rect(from, to) };
        let objects = match self {
            Self::Furniture => vec![Object::Furniture { outline: usual(0.8, 0.4) }],
            Self::LowObstacle => vec![Object::LowObstacle { outline: usual(0.9, 0.06), height: LOW }],
            Self::Stairs => vec![Object::DropOff { outline: usual(0.9, 1.0) }],
            Self::Carpet => vec![Object::Carpet { outline: usual(1.6, 1.1) }],
            Self::Table => {
                let corners = usual(1.2, 0.8);
                let centre = middle(&corners);
                let leg = |corner: &Point| {
                    let inwards = |edge: f64, centre: f64| edge + TABLE_LEG * (centre - edge).signum();
                    let at = Point::new(inwards(corner.x, centre.x), inwards(corner.y, centre.y));
                    Object::Leg { at, radius: TABLE_LEG }
                };
                corners.iter().map(leg).collect()
            }
            Self::Dirt => {
                let radius = if is_click { 0.25 } else { (to - from).norm() };
                vec![Object::Dirt { at: from, radius: limited(radius, RADII) }]
            }
            Self::Dock => {
                let pose = if is_click { against_wall(plan, from) } else { looking(from, to) };
                vec![Object::Dock { pose }]
            }
            Self::VirtualWall => {
                let (pose, length) =
                    if is_click { (against_wall(plan, from), 2.0) } else { (looking(from, to), (to - from).norm()) };
                vec![Object::VirtualWall { pose, length: limited(length, BEAMS) }]
            }
            Self::Person | Self::Pet => {
                let who = if self == Self::Person { Who::Person } else { Who::Pet };
                let path = if is_click { stroll(plan, who, from) } else { vec![from, to] };
                vec![Object::Mover { who, path }]
            }
        };
        objects.iter().map(|object| tidy(plan, object)).collect()
    }
}

/// The object moved by a displacement, kept inside the room.
pub fn moved(plan: &FloorPlan, object: &Object, by: Vector) -> Object {
    tidy(plan, &mapped(object, &|p| p + by))
}

/// The object turned counter-clockwise about its middle; round ones stay as they are.
pub fn turned(plan: &FloorPlan, object: &Object, radians: f64) -> Object {
    let centre = middle(&points(object));
    let (sin, cos) = (math::sin(radians), math::cos(radians));
    let turn = |p: Point| {
        let v = p - centre;
        centre + Vector::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y)
    };
    let mut object = mapped(object, &turn);
    if let Object::Dock { pose } | Object::VirtualWall { pose, .. } = &mut object {
        pose.heading = normalize(pose.heading + radians);
    }
    tidy(plan, &object)
}

/// The object larger or smaller by a factor; docks come in one size.
pub fn scaled(plan: &FloorPlan, object: &Object, factor: f64) -> Object {
    let centre = middle(&points(object));
    let mut object = mapped(object, &|p| centre + (p - centre) * factor);
    match &mut object {
        Object::Leg { radius, .. } | Object::Dirt { radius, .. } => *radius = limited(*radius * factor, RADII),
        Object::VirtualWall { length, .. } => *length = limited(*length * factor, BEAMS),
        _ => {}
    }
    tidy(plan, &object)
}

/// Points by which an object can be reshaped or turned.
pub fn handles(object: &Object) -> Vec<Point> {
    match object {
        Object::Leg { at, radius } | Object::Dirt { at, radius } => vec![at + Vector::new(*radius, 0.0)],
        Object::Dock { pose } => vec![pose.to_world(Point::new(0.4, 0.0))],
        Object::VirtualWall { pose, length } => vec![pose.to_world(Point::new(*length, 0.0))],
        outlined => points(outlined),
    }
}

/// The object with one of its handles dragged to a point. Corners of rectangles keep it one.
pub fn reshaped(plan: &FloorPlan, object: &Object, handle: usize, to: Point) -> Object {
    let to = inside(plan, to);
    let mut object = object.clone();
    match &mut object {
        Object::Leg { at, radius } | Object::Dirt { at, radius } => *radius = limited((to - *at).norm(), RADII),
        Object::Dock { pose } => *pose = looking(pose.position(), to),
        Object::VirtualWall { pose, length } => {
            *length = limited((to - pose.position()).norm(), BEAMS);
            *pose = looking(pose.position(), to);
        }
        Object::Furniture { outline }
        | Object::LowObstacle { outline, .. }
        | Object::DropOff { outline }
        | Object::Carpet { outline } => match (is_rectangle(outline), outline.as_slice()) {
            (true, &[a, b, c, d]) => {
                let corners = [a, b, c, d];
                let at = |offset: usize| corners[(handle + offset) % 4];
                let fixed = at(2);
                let (one, other) = ((at(3) - fixed).normalize(), (at(1) - fixed).normalize());
                let along = |side: Vector| side * (to - fixed).dot(&side).max(LEAST_SIDE);
                let mut set = |offset: usize, point| outline[(handle + offset) % 4] = point;
                set(0, fixed + along(one) + along(other));
                set(1, fixed + along(other));
                set(3, fixed + along(one));
            }
            _ => move_point(outline, handle, to),
        },
        Object::Mover { path, .. } => move_point(path, handle, to),
    }
    tidy(plan, &object)
}

/// The object within `reach` metres of a point: small before large, standing before lying.
pub fn object_at(objects: &[Object], at: Point, reach: f64) -> Option<usize> {
    let hit = |object: &Object| {
        let near = |point: Point, radius: f64| (point - at).norm() < radius.max(reach);
        match object {
            Object::Leg { at, radius } => near(*at, *radius).then_some(0),
            Object::Dock { pose } => near(pose.to_world(Point::new(0.08, 0.0)), 0.16).then_some(0),
            Object::VirtualWall { pose, .. } => near(pose.position(), 0.1).then_some(0),
            Object::Mover { path, .. } => path.first().is_some_and(|&start| near(start, 0.15)).then_some(0),
            Object::Furniture { outline } | Object::LowObstacle { outline, .. } => encloses(outline, at).then_some(1),
            Object::Dirt { at, radius } => near(*at, *radius).then_some(2),
            Object::DropOff { outline } => encloses(outline, at).then_some(3),
            Object::Carpet { outline } => encloses(outline, at).then_some(4),
        }
    };
    let ranks = objects.iter().enumerate().filter_map(|(index, object)| Some((hit(object)?, index)));
    ranks.min_by_key(|&(rank, index)| (rank, usize::MAX - index)).map(|(_, index)| index)
}

/// Objects in words, e.g. "2 legs, a dock"; empty if there are none.
pub fn in_words(objects: &[Object]) -> String {
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for object in objects {
        match counts.iter_mut().find(|(name, _)| *name == object.name()) {
            Some((_, count)) => *count += 1,
            None => counts.push((object.name(), 1)),
        }
    }
    let words = counts.into_iter().map(|(name, count)| match name {
        _ if count > 1 => format!("{count} x {name}"),
        "furniture" | "stairs" | "dirt" => name.to_owned(),
        _ => format!("a {name}"),
    });
    words.collect::<Vec<_>>().join(", ")
}

/// Its corners, or its position.
fn points(object: &Object) -> Vec<Point> {
    match object {
        Object::Furniture { outline }
        | Object::LowObstacle { outline, .. }
        | Object::DropOff { outline }
        | Object::Carpet { outline } => outline.clone(),
        Object::Mover { path, .. } => path.clone(),
        Object::Leg { at, .. } | Object::Dirt { at, .. } => vec![*at],
        Object::Dock { pose } | Object::VirtualWall { pose, .. } => vec![pose.position()],
    }
}

fn mapped(object: &Object, map: &dyn Fn(Point) -> Point) -> Object {
    let mut object = object.clone();
    match &mut object {
        Object::Furniture { outline: points }
        | Object::LowObstacle { outline: points, .. }
        | Object::DropOff { outline: points }
        | Object::Carpet { outline: points }
        | Object::Mover { path: points, .. } => points.iter_mut().for_each(|p| *p = map(*p)),
        Object::Leg { at, .. } | Object::Dirt { at, .. } => *at = map(*at),
        Object::Dock { pose } | Object::VirtualWall { pose, .. } => {
            let at = map(pose.position());
            (pose.x, pose.y) = (at.x, at.y);
        }
    }
    object
}

/// Rounded to millimetres and tenths of a degree, so that files are readable, and shifted into the room if it sticks
/// out.
fn tidy(plan: &FloorPlan, object: &Object) -> Object {
    let all = points(object);
    let Some(&first) = all.first() else { return object.clone() };
    let (low, high) = all.iter().fold((first, first), |(low, high), p| (low.inf(p), high.sup(p)));
    let shift = |low: f64, high: f64, size: f64| (size - high).min(0.0).max(-low);
    let by = Vector::new(shift(low.x, high.x, plan.width_m()), shift(low.y, high.y, plan.height_m()));
    let mut object = mapped(object, &|p| (p + by).map(|c| round(c, 1000.0)));
    match &mut object {
        Object::Leg { radius: length, .. } | Object::Dirt { radius: length, .. } => *length = round(*length, 1000.0),
        Object::VirtualWall { pose, length } => {
            *length = round(*length, 1000.0);
            pose.heading = round(pose.heading.to_degrees(), 10.0).to_radians();
        }
        Object::Dock { pose } => pose.heading = round(pose.heading.to_degrees(), 10.0).to_radians(),
        _ => {}
    }
    object
}

fn round(value: f64, parts: f64) -> f64 {
    (value * parts).round() / parts
}

fn limited(value: f64, [low, high]: [f64; 2]) -> f64 {
    value.max(low).min(high)
}

fn inside(plan: &FloorPlan, point: Point) -> Point {
    Point::new(point.x.min(plan.width_m()).max(0.0), point.y.min(plan.height_m()).max(0.0))
}

fn move_point(points: &mut [Point], index: usize, to: Point) {
    if let Some(point) = points.get_mut(index) {
        *point = to;
    }
}

/// Corners of the axis-aligned rectangle between two points, counter-clockwise.
fn rect(a: Point, b: Point) -> Vec<Point> {
    let (low, high) = (a.inf(&b), a.sup(&b));
    let high = Point::new(high.x.max(low.x + LEAST_SIDE), high.y.max(low.y + LEAST_SIDE));
    vec![low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)]
}

fn rect_around(plan: &FloorPlan, centre: Point, width: f64, depth: f64) -> Vec<Point> {
    let half = Vector::new(width.min(plan.width_m()), depth.min(plan.height_m())) / 2.0;
    rect(centre - half, centre + half)
}

/// Whether the corners form a rectangle, to the millimetres to which corners are rounded.
fn is_rectangle(outline: &[Point]) -> bool {
    let &[a, b, c, d] = outline else { return false };
    let (side, other) = (b - a, d - a);
    let is_right = side.dot(&other).abs() < 0.002 * (side.norm() + other.norm());
    is_right && (b - a + (d - c)).norm() < 0.004 && side.norm() > 0.0 && other.norm() > 0.0
}

fn looking(from: Point, to: Point) -> Pose {
    let aim = to - from;
    Pose::new(from.x, from.y, if aim.norm() > 0.0 { math::atan2(aim.y, aim.x) } else { 0.0 })
}

fn is_floor(plan: &FloorPlan, point: Point) -> bool {
    plan.occupancy.get(plan.cell_at(point)).is_some_and(|o| o.is_free())
}

/// Length of free floor from a point in a direction, m, at most `most`.
fn way(plan: &FloorPlan, from: Point, direction: Vector, most: f64) -> f64 {
    let step = (0.25 * plan.resolution).min(0.02);
    let steps = (most / step) as u32;
    (1..=steps)
        .find(|&i| !is_floor(plan, from + direction * (f64::from(i) * step)))
        .map_or(most, |i| f64::from(i) * step)
}

/// The pose at the wall nearest to a point, facing away from it; the point itself if no wall is near.
fn against_wall(plan: &FloorPlan, at: Point) -> Pose {
    let looks = (0..16).map(|i| math::TAU * f64::from(i) / 16.0);
    let ways = looks.map(|heading| {
        let towards = Vector::new(-math::cos(heading), -math::sin(heading));
        (way(plan, at, towards, TO_WALL), at + towards * way(plan, at, towards, TO_WALL), heading)
    });
    match ways.min_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((distance, back, heading)) if distance < TO_WALL => Pose::new(back.x, back.y, heading),
        _ => Pose::new(at.x, at.y, 0.0),
    }
}

/// A way back and forth near a point, horizontal or vertical, wherever there is more room; the mover keeps off walls.
fn stroll(plan: &FloorPlan, who: Who, at: Point) -> Vec<Point> {
    let radius = who.radius() + OFF_WALL;
    let fits = |centre: Point| {
        let edge = (0..16).map(|i| math::TAU * f64::from(i) / 16.0);
        let mut all = edge.map(|angle| centre + Vector::new(math::cos(angle), math::sin(angle)) * radius);
        is_floor(plan, centre) && all.all(|point| is_floor(plan, point))
    };
    let at = nearest(at, fits).unwrap_or(at);
    let far = |direction: Vector| {
        let steps = (STROLL / STRIDE) as u32;
        let free = (1..=steps).take_while(|&i| fits(at + direction * (f64::from(i) * STRIDE)));
        at + direction * (free.count() as f64 * STRIDE)
    };
    let ways = [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)].map(|side| [far(-side), far(side)]);
    let longest = ways.into_iter().max_by(|a, b| (a[1] - a[0]).norm().total_cmp(&(b[1] - b[0]).norm()));
    longest.filter(|[a, b]| (b - a).norm() > 0.1).map_or_else(|| vec![at], Vec::from)
}

/// The point nearest to `at` that `fits`, at most [`ASIDE`] away.
fn nearest(at: Point, fits: impl Fn(Point) -> bool) -> Option<Point> {
    (0..=(ASIDE / STRIDE) as u32).find_map(|ring| {
        let distance = f64::from(ring) * STRIDE;
        let looks = (0..32).map(|i| math::TAU * f64::from(i) / 32.0);
        looks.map(|angle| at + Vector::new(math::cos(angle), math::sin(angle)) * distance).find(|&point| fits(point))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::{Cell, Grid, Occupancy};

    #[test]
    fn person_beside_a_wall_gets_a_way_that_fits() {
        // 4 m by 3 m with a wall of one cell around it.
        let mut occupancy = Grid::filled(80, 60, Occupancy::Free);
        for y in 0..60 {
            for x in 0..80 {
                if x == 0 || y == 0 || x == 79 || y == 59 {
                    occupancy[Cell::new(x, y)] = Occupancy::Occupied;
                }
            }
        }
        let origin = Pose::new(0.0, 0.0, 0.0);
        let (name, note) = (String::new(), String::new());
        let plan = FloorPlan { name, note, resolution: 0.05, occupancy, objects: Vec::new(), start: None, origin };
        for at in [Point::new(0.06, 1.5), Point::new(2.0, 2.94), Point::new(3.94, 0.06), Point::new(2.0, 1.5)] {
            for (kind, who) in [(PlaceableKind::Person, Who::Person), (PlaceableKind::Pet, Who::Pet)] {
                let objects = kind.drawn(&plan, at, at);
                let [Object::Mover { path, .. }] = objects.as_slice() else { panic!("{objects:?}") };
                assert!(path.len() == 2 && (path[1] - path[0]).norm() > 0.9, "{at}: {path:?}");
                let off = |p: &Point| (p.x - 0.05).min(3.95 - p.x).min(p.y - 0.05).min(2.95 - p.y);
                assert!(path.iter().all(|p| off(p) >= who.radius()), "{at}: {path:?}");
            }
        }
    }
}

//! Validation of rooms: for imported files and for every edit on the canvas.

use super::{FloorPlan, Object, crossing, encloses, has_area};
use crate::geometry::{Point, Pose};

/// Most objects in a room.
pub const MAX_OBJECTS: usize = 500;
/// Most corners of one outline, and most points of one path.
pub const MAX_CORNERS: usize = 200;
/// Thinnest and thickest leg and smallest and largest spot of dirt, by radius, m.
pub const RADII: [f64; 2] = [0.005, 5.0];
/// Shortest and longest beam of a virtual wall, m.
pub const BEAMS: [f64; 2] = [0.1, 20.0];
/// Least and greatest height of a low obstacle, m.
const HEIGHTS: [f64; 2] = [0.001, 0.1];
/// Distance in front of the back of a dock or lighthouse where there must be floor, m: about its middle.
const FRONT: f64 = 0.05;
/// Points this close to the border lie inside, m; allows for rounding in files.
const BORDER: f64 = 1e-6;

/// Reasons why an object can't be placed: the cause, and the remedy.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlacementFault {
    /// A number is out of range.
    #[error("{value} is out of range; use {unit} from {low} to {high}")]
    Range {
        /// The number found.
        value: f64,
        /// Smallest allowed number.
        low: f64,
        /// Largest allowed number.
        high: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// Too many elements.
    #[error("there are {found} {what}, but at most {most} are allowed; remove some")]
    TooMany {
        /// The given number.
        found: usize,
        /// The largest number.
        most: usize,
        /// Their name.
        what: &'static str,
    },
    /// Too few corners or points.
    #[error("there are {found} {what}, but at least {least} are needed; add the missing ones")]
    TooFew {
        /// The given number.
        found: usize,
        /// The smallest number.
        least: usize,
        /// Their name.
        what: &'static str,
    },
    /// An outline crosses or touches itself.
    #[error(
        "the outline crosses itself: the edge from corner {first} meets the one from corner {second}; list the corners \
         in order around the outline"
    )]
    Crossing {
        /// Corner at which one edge begins, counted from 0.
        first: usize,
        /// Corner at which the other begins.
        second: usize,
    },
    /// An outline without area.
    #[error("the outline encloses no floor; move its corners apart")]
    NoArea,
    /// A point outside the room.
    #[error(
        "the {what} at ({x:.3} m, {y:.3} m) lies outside the room, which is {width:.2} m x {height:.2} m; move it inside"
    )]
    Outside {
        /// The name of the point.
        what: &'static str,
        /// x of the point, m.
        x: f64,
        /// y of the point, m.
        y: f64,
        /// Width of the room, m.
        width: f64,
        /// Height of the room, m.
        height: f64,
    },
    /// An object that needs floor stands in a wall or another object.
    #[error("the {what} at ({x:.3} m, {y:.3} m) lies in {place}; move it to free floor")]
    NoFloor {
        /// Name of the object.
        what: &'static str,
        /// x of the point, m.
        x: f64,
        /// y of the point, m.
        y: f64,
        /// What is there instead of floor.
        place: &'static str,
    },
    /// A dock or lighthouse without floor in front of it.
    #[error("the {what} at ({x:.3} m, {y:.3} m) faces {place}; put its back to a wall so that it faces the room")]
    NothingBefore {
        /// Name of the object.
        what: &'static str,
        /// x of the point, m.
        x: f64,
        /// y of the point, m.
        y: f64,
        /// What is there instead of floor.
        place: &'static str,
    },
    /// A mover's path crosses a wall.
    #[error("the path crosses a wall at ({x:.2} m, {y:.2} m); add points to lead it around")]
    PathInWall {
        /// x of the crossing, m.
        x: f64,
        /// y of the crossing, m.
        y: f64,
    },
}

/// A fault with its path in a scenario's JSON.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacementRefusal {
    /// The value, e.g. `objects[3].leg.radius`.
    pub path: String,
    /// The fault.
    pub fault: PlacementFault,
}

impl FloorPlan {
    /// Checks the objects, and that a robot can be put down at `start` (only its centre is checked).
    pub fn check_objects(&self, start: Option<Pose>) -> Result<(), PlacementRefusal> {
        let refuse = |path: String, fault| Err(PlacementRefusal { path, fault });
        let found = self.objects.len();
        if found > MAX_OBJECTS {
            return refuse("objects".to_owned(), PlacementFault::TooMany { found, most: MAX_OBJECTS, what: "objects" });
        }
        for (index, object) in self.objects.iter().enumerate() {
            if let Err((key, fault)) = self.check(object) {
                return refuse(format!("objects[{index}].{}{key}", object.key()), fault);
            }
        }
        match start.map(|start| self.check_start(start.position())) {
            Some(Err(fault)) => refuse("start".to_owned(), fault),
            _ => Ok(()),
        }
    }

    /// The key of the invalid value in `object`, with a dot before it, and the fault.
    fn check(&self, object: &Object) -> Result<(), (String, PlacementFault)> {
        match object {
            Object::Furniture { outline }
            | Object::LowObstacle { outline, .. }
            | Object::DropOff { outline }
            | Object::Carpet { outline } => {
                if let Object::LowObstacle { height, .. } = object {
                    in_range(".height", *height, HEIGHTS, "metres")?;
                }
                self.check_points(".outline", outline, 3, "corners")?;
                if let Some((first, second)) = crossing(outline) {
                    return Err((".outline".to_owned(), PlacementFault::Crossing { first, second }));
                }
                if has_area(outline) { Ok(()) } else { Err((".outline".to_owned(), PlacementFault::NoArea)) }
            }
            Object::Leg { at, radius } | Object::Dirt { at, radius } => {
                in_range(".radius", *radius, RADII, "metres")?;
                self.check_inside(*at, object.key()).map_err(|fault| (".at".to_owned(), fault))
            }
            Object::Dock { pose } => self.check_device(pose, "dock"),
            Object::VirtualWall { pose, length } => {
                in_range(".length", *length, BEAMS, "metres")?;
                self.check_device(pose, "virtual wall")
            }
            Object::Mover { path, .. } => {
                self.check_points(".path", path, 1, "points")?;
                for (index, pair) in path.windows(2).enumerate() {
                    self.check_way(pair[0], pair[1]).map_err(|fault| (format!(".path[{}]", index + 1), fault))?;
                }
                self.check_way(path[0], path[0]).map_err(|fault| (".path[0]".to_owned(), fault))
            }
        }
    }

    fn check_points(
        &self,
        key: &str,
        points: &[Point],
        least: usize,
        what: &'static str,
    ) -> Result<(), (String, PlacementFault)> {
        let found = points.len();
        if found < least {
            return Err((key.to_owned(), PlacementFault::TooFew { found, least, what }));
        }
        if found > MAX_CORNERS {
            return Err((key.to_owned(), PlacementFault::TooMany { found, most: MAX_CORNERS, what }));
        }
        for (index, &point) in points.iter().enumerate() {
            self.check_inside(point, "point").map_err(|fault| (format!("{key}[{index}]"), fault))?;
        }
        Ok(())
    }

    fn check_inside(&self, point: Point, what: &'static str) -> Result<(), PlacementFault> {
        let (Point { coords, .. }, width, height) = (point, self.width_m(), self.height_m());
        let (x, y) = (coords.x, coords.y);
        // In this form it also refuses NaN, for which every comparison is false.
        if (-BORDER..=width + BORDER).contains(&x) && (-BORDER..=height + BORDER).contains(&y) {
            Ok(())
        } else {
            Err(PlacementFault::Outside { what, x, y, width, height })
        }
    }

    fn check_start(&self, point: Point) -> Result<(), PlacementFault> {
        self.check_inside(point, "start")?;
        let no_floor = |place| PlacementFault::NoFloor { what: "start", x: point.x, y: point.y, place };
        self.place_without_floor(point).map_or(Ok(()), |place| Err(no_floor(place)))
    }

    /// Docks and lighthouses can have their backs to a wall, but must face floor.
    fn check_device(&self, pose: &Pose, what: &'static str) -> Result<(), (String, PlacementFault)> {
        let nothing_before = |place| PlacementFault::NothingBefore { what, x: pose.x, y: pose.y, place };
        let before = self.place_without_floor(pose.to_world(Point::new(FRONT, 0.0)));
        let checked =
            self.check_inside(pose.position(), what).and(before.map_or(Ok(()), |place| Err(nothing_before(place))));
        checked.map_err(|fault| (String::new(), fault))
    }

    /// The obstacle at a point; `None` if there is floor.
    fn place_without_floor(&self, point: Point) -> Option<&'static str> {
        if !self.occupancy.get(self.cell_at(point)).is_some_and(|o| o.is_free()) {
            return Some("a wall or unknown floor");
        }
        self.objects.iter().find_map(|object| match object {
            Object::Furniture { outline } => encloses(outline, point).then_some("furniture"),
            Object::DropOff { outline } => encloses(outline, point).then_some("a drop-off"),
            Object::Leg { at, radius } => ((at - point).norm() < *radius).then_some("a leg"),
            _ => None,
        })
    }

    /// Whether the way from `a` to `b` is free of walls.
    fn check_way(&self, a: Point, b: Point) -> Result<(), PlacementFault> {
        let steps = ((b - a).norm() / (0.5 * self.resolution)).ceil().max(1.0) as u32;
        for i in 0..=steps {
            let point = a + (b - a) * (f64::from(i) / f64::from(steps));
            // The last row and column go up to the border.
            let inside = Point::new(point.x.min(self.width_m() - BORDER), point.y.min(self.height_m() - BORDER));
            if !self.occupancy.get(self.cell_at(inside)).is_some_and(|o| o.is_free()) {
                return Err(PlacementFault::PathInWall { x: point.x, y: point.y });
            }
        }
        Ok(())
    }
}

fn in_range(key: &str, value: f64, [low, high]: [f64; 2], unit: &'static str) -> Result<(), (String, PlacementFault)> {
    let is_in = (low..=high).contains(&value);
    if is_in { Ok(()) } else { Err((key.to_owned(), PlacementFault::Range { value, low, high, unit })) }
}

//! Input and result of tracing a room from a drawing.

use super::{model::Role, trace::OUTER_DOOR};
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::{Point, Pose, Vector},
    math::{cos, sin},
};

/// The part of a drawing to be traced, in drawing units.
#[derive(Debug, Clone, PartialEq)]
pub enum DrawingRegion {
    /// The floor of the building that walls enclose, with openings to the outside closed, without a garden or a page round
    /// it. All of it, if they enclose hardly any.
    Indoors {
        /// Widest opening to the outside that is closed, m; those as wide as a gap that is closed are in any case.
        outer: f64,
    },
    /// All of it, with a start indoors. Openings by which a robot would get out of the building are closed.
    Whole {
        /// Widest opening to the outside that is closed, m; 0 for none.
        outer: f64,
    },
    /// An axis-aligned rectangle.
    Rectangle {
        /// Lower left corner.
        low: Point,
        /// Upper right corner.
        high: Point,
    },
    /// A simple polygon.
    Polygon(Vec<Point>),
    /// The room around this point: everything reachable without crossing a wall.
    Room(Point),
}

impl DrawingRegion {
    /// All of it, with openings to the outside closed that are as wide as outer doors.
    pub const WHOLE: Self = Self::Whole { outer: OUTER_DOOR };
}

/// Parameters of tracing a room from a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Tracing {
    /// The role of every layer, in their order.
    pub roles: Vec<Role>,
    /// Metres per drawing unit.
    pub metre: f64,
    /// Widest gap between ends of wall strokes that is closed, m; 0 for none.
    pub gap: f64,
    /// Side of the room's cells, m.
    pub resolution: f64,
    /// The part to be traced.
    pub region: DrawingRegion,
}

/// A room traced from a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Traced {
    /// The room.
    pub plan: FloorPlan,
    /// Position of the room's lower-left corner in the drawing, in drawing units: a point of the room is
    /// `corner + point / metre` in the drawing.
    pub corner: Vector,
    /// Angle by which the drawing was turned around its origin before it was traced, rad, counter-clockwise. `corner` is
    /// in the turned drawing.
    pub turn: f64,
    /// Metres per drawing unit.
    pub metre: f64,
    /// Gaps that were closed: both ends, m, in the room.
    pub gaps: Vec<[Point; 2]>,
    /// Floor that is left out indoors, m²: a garden within its wall, a page within its frame.
    pub around_m2: f64,
    /// An opening in the walls round the floor indoors, wider than those that are closed.
    pub leak: Option<OutsideLeak>,
    /// A building with little of the floor within the outermost walls indoors.
    pub free_standing: Option<FreeStandingBuilding>,
    /// Whether a robot gets out of the building that it starts in, where what is outside is floor, too. Then the building
    /// stands free within walls, and may be a block of rooms; or openings were to be left open.
    pub goes_out: bool,
    /// Whether walls enclose hardly any floor indoors, so that all of the drawing counts.
    pub is_open: bool,
}

/// A building that stands free within walls, with less than a quarter of the floor: a house in its garden, or a block of rooms
/// in a hall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeStandingBuilding {
    /// Its floor, m².
    pub floor_m2: f64,
    /// Whether it is taken for a house, so that its floor alone counts. Otherwise all of it does, and the start is in it.
    pub is_taken: bool,
}

/// An opening through which the outside reaches floor that walls enclose otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutsideLeak {
    /// Its middle, in the turned drawing.
    pub at: Point,
    /// Its width, m, rounded up to 5 cm.
    pub width: f64,
    /// The floor that it opens, m².
    pub floor_m2: f64,
    /// Whether the floor is indoors once openings up to this width are closed.
    pub closes: bool,
    /// Whether it leads to what may be a garden within its wall, which is floor, too, as long as the opening isn't closed.
    pub to_garden: bool,
}

impl Traced {
    /// A map as it is: its lower-left corner is the origin of the drawing, whose unit is `metre` m.
    pub fn of_map(plan: FloorPlan, metre: f64) -> Self {
        let (corner, gaps) = (Vector::zeros(), Vec::new());
        Self {
            plan,
            corner,
            turn: 0.0,
            metre,
            gaps,
            around_m2: 0.0,
            leak: None,
            free_standing: None,
            goes_out: false,
            is_open: false,
        }
    }

    /// The room as it is if the drawing was turned by `turn` around its origin before it was traced.
    pub fn turned(mut self, turn: f64) -> Self {
        self.turn = turn;
        if turn != 0.0 {
            let low = self.to_drawing(Point::origin()) * self.metre;
            self.plan.origin = Pose::new(low.x, low.y, -turn);
        }
        self
    }

    /// A point of the room, m, as a point of the drawing as it was before it was turned.
    pub fn to_drawing(&self, point: Point) -> Point {
        let at = self.corner + point.coords / self.metre;
        let (sin, cos) = (sin(-self.turn), cos(-self.turn));
        if self.turn == 0.0 { Point::from(at) } else { Point::new(at.x * cos - at.y * sin, at.x * sin + at.y * cos) }
    }
}

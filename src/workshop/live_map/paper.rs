//! Background of the live map: the room, or a blank sheet that grows.

use robovac_app::explore::Session;
use robovac_core::{
    coverage::ReachableFloor,
    floor_plan::FloorPlan,
    geometry::{Point, Pose, Vector},
    grid::{Grid, Occupancy},
    robot::RobotModel,
};

/// Side of the first blank sheet, m: a room.
const SHEET: f64 = 6.0;
/// Distance from the edge at which a larger sheet is taken, m, and the extension of each side, m.
const EDGE: f64 = 0.6;
/// Largest side of a sheet, m; beyond it the robot leaves the paper.
const MOST: f64 = 60.0;
/// Side of a cell of blank paper, m.
const CELL: f64 = 0.05;

/// The background of a robot.
pub(super) struct Paper {
    /// The walls, if any.
    pub plan: FloorPlan,
    /// The reachable floor; all of blank paper.
    pub floor: Option<ReachableFloor>,
    /// Position of the room's origin on the paper.
    pub shift: Vector,
    /// Whether it is a room.
    pub is_known: bool,
}

impl Paper {
    /// The room of `session` if it is `known`, or else a blank sheet.
    pub fn new(session: &Session, robot: &RobotModel, known: bool) -> Self {
        if known {
            let floor = session.prepared().map(|prepared| (*prepared.floor).clone());
            return Self { plan: (**session.plan()).clone(), floor, shift: Vector::zeros(), is_known: true };
        }
        Self::blank(Point::new(-0.5 * SHEET, -0.5 * SHEET), SHEET, SHEET, robot)
    }

    fn blank(low: Point, width: f64, height: f64, robot: &RobotModel) -> Self {
        let cells = |length: f64| (length / CELL).ceil().max(1.0) as usize;
        let plan = FloorPlan {
            name: "Unknown room".into(),
            note: String::new(),
            resolution: CELL,
            occupancy: Grid::filled(cells(width), cells(height), Occupancy::Free),
            objects: Vec::new(),
            start: None,
            origin: Pose::new(0.0, 0.0, 0.0),
        };
        let floor = ReachableFloor::new(&plan, robot, None).ok();
        Self { plan, floor, shift: Vector::new(-low.x, -low.y), is_known: false }
    }

    /// Start of robots: on blank paper at their present place.
    pub fn start(&self) -> Option<Pose> {
        if self.is_known { self.floor.as_ref().map(|floor| floor.start) } else { Some(Pose::new(0.0, 0.0, 0.0)) }
    }

    /// Whether a robot at that place of the room needs a larger sheet.
    pub fn is_too_small_for(&self, place: Point) -> bool {
        let at = place + self.shift;
        let (width, height) = (self.plan.width_m(), self.plan.height_m());
        let is_near = at.x < EDGE || at.y < EDGE || at.x > width - EDGE || at.y > height - EDGE;
        !self.is_known && is_near && width.max(height) < MOST
    }

    /// A sheet that is half as large again on the sides where that place is near the edge.
    pub fn larger(&self, place: Point, robot: &RobotModel) -> Self {
        let (width, height) = (self.plan.width_m(), self.plan.height_m());
        let at = place + self.shift;
        let more = |at: f64, size: f64| {
            let step = (0.5 * size).max(EDGE);
            // At least as much as needed, as it can have gone far since the last call.
            let below = if at < EDGE { step.max(EDGE - at + step).min(MOST) } else { 0.0 };
            let above = if at > size - EDGE { step.max(at - size + EDGE + step).min(MOST) } else { 0.0 };
            (below, above)
        };
        let ((left, right), (down, up)) = (more(at.x, width), more(at.y, height));
        let low = Point::new(-self.shift.x - left, -self.shift.y - down);
        Self::blank(low, width + left + right, height + down + up, robot)
    }
}

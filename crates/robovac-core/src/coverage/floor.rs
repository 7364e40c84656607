//! Where a robot can stand, and which floor it can reach from there.

use super::{
    FloorError, fits, shapes,
    stamp::{DiscStamp, PolygonStamp, spread},
    walls::Walls,
};
use crate::{
    floor_plan::FloorPlan,
    geometry::{Point, Pose, Vector},
    grid::{Cell, Direction, Grid, largest_part, reachable},
    math,
    rng::Rng,
    robot::{Body, RobotModel, Tool, WheelLayout},
};
use rand::RngExt;

/// Largest side of fine cells, m: a tool of 17 cm is then resolved to about a centimetre, whatever lanes it drives;
/// with cells of 5 cm it would be 15 or 20 cm wide.
const FINE_CELL: f64 = 0.025;
/// Most cells of a fine grid; larger rooms are refined less.
const MAX_FINE_CELLS: usize = 4_000_000;

/// The standing places and the floor that a robot can reach from its start.
///
/// The robot is taken to be the smallest circle around its origin that holds its body: where that fits, it can turn on
/// the spot. So a body that isn't round can reach more places than these, but never fewer.
///
/// Objects of the plan count as well. Standing places keep the body off furniture, legs and drop-offs, as if those filled
/// every fine cell that they touch, within a cell of being exact. Floor is every fine cell whose centre lies in none of
/// them (for a robot that fills a cell: that none of them touches).
#[derive(Debug, Clone)]
pub struct ReachableFloor {
    /// Metres per fine cell: the plan's resolution or a whole fraction of it; for a robot that fills a cell, that cell.
    pub resolution: f64,
    /// The walls and furniture as obstacles to the robot's body.
    pub walls: Walls,
    /// The same with drop-offs, and with beams of virtual walls if the robot detects them; these don't block a body
    /// physically. `None` if there are none.
    edges: Option<Box<Walls>>,
    /// Fine cells in whose centre the robot can stand, connected with the start by ways that leave room to steer.
    pub standing: Grid<bool>,
    /// Fine cells that the tool can sweep.
    pub floor: Grid<bool>,
    /// Number of cells of `floor`, at least 1.
    pub floor_cells: usize,
    /// Number of free fine cells that the tool can't sweep from the start: slivers and closed-off floor.
    pub left_out_cells: usize,
    /// Number of fine cells in whose centre the robot could stand, but which it can't reach.
    pub closed_off_cells: usize,
    /// Where the robot starts.
    pub start: Pose,
    /// Radius of the tool's disc, m; if the whole body is the tool, of the largest disc around the origin in it.
    pub tool_radius: f64,
    /// Where the tool is.
    pub tool: Tool,
    /// The outline of the body, which matters if it is the tool.
    pub body: Body,
    /// Whether the robot turns to where it drives; otherwise it keeps its heading.
    pub turns: bool,
    /// Whether it is that of a path planned elsewhere: see [`ReachableFloor::of_path`].
    pub is_for_path: bool,
}

impl ReachableFloor {
    /// Computes the floor for `robot` in `plan` from `start`, or from the plan's own start, or from the first place
    /// (from the lower left) in the largest connected part of the room.
    pub fn new(plan: &FloorPlan, robot: &RobotModel, start: Option<Pose>) -> Result<Self, FloorError> {
        let Laid { resolution, walls, edges } = Laid::of(plan, robot, robot.fills_cell)?;
        let limits = edges.as_deref().unwrap_or(&walls);
        let passing = robot.radius + steering_margin(robot.radius) - 1e-5;
        let free = limits.clearance.map(|&c| f64::from(c) >= passing);
        let too_narrow = FloorError::TooNarrow { diameter: 2.0 * robot.radius };
        let start = match start.or(plan.start) {
            Some(pose) => check_start(plan, &free, limits, pose)?,
            None => default_start(&free, resolution).ok_or(too_narrow)?,
        };
        let start = if robot.fills_cell { in_centre(start, resolution) } else { start };
        let passable = reachable(&free, Cell::at(start.position(), resolution));
        let closed_off_cells = free.count() - passable.count();
        let standing = up_to_walls(limits, passable);
        let covered = covered(limits, robot.fills_cell);
        let floor = sweepable(&standing, &covered, robot, start.heading, resolution);
        Ok(Self::found(robot, Laid { resolution, walls, edges }, start, [standing, floor, covered], closed_off_cells))
    }

    /// The floor for a path that was planned elsewhere and begins at `start`, where the robot stands exactly. It can
    /// stand wherever its body fits at that heading if it moves in every direction, else wherever the circle fits in
    /// which it turns. Such a path can touch, so no room to steer is asked for.
    pub fn of_path(plan: &FloorPlan, robot: &RobotModel, start: Pose) -> Result<Self, FloorError> {
        let laid = Laid::of(plan, robot, false)?;
        let Laid { resolution, ref walls, ref edges } = laid;
        let limits = edges.as_deref().unwrap_or(walls);
        let covered = covered(limits, false);
        let fits = match robot.body {
            Body::Polygon(corners) if !turns(robot) => fits::for_polygon(limits, &covered, &corners, start.heading),
            _ => fits::for_disc(limits, robot.radius),
        };
        let too_narrow = FloorError::TooNarrow { diameter: 2.0 * robot.radius };
        let from = nearest(&fits, resolution, start.position(), |_| true).ok_or(too_narrow)?;
        let standing = reachable(&fits, Cell::at(from, resolution));
        let closed_off_cells = fits.count() - standing.count();
        let floor = sweepable(&standing, &covered, robot, start.heading, resolution);
        let found = Self::found(robot, laid, start, [standing, floor, covered], closed_off_cells);
        Ok(Self { is_for_path: true, ..found })
    }

    fn found(
        robot: &RobotModel,
        Laid { resolution, walls, edges }: Laid,
        start: Pose,
        [standing, floor, covered]: [Grid<bool>; 3],
        closed_off_cells: usize,
    ) -> Self {
        let floor_cells = floor.count();
        Self {
            left_out_cells: (covered.len() - covered.count()).saturating_sub(floor_cells),
            resolution,
            walls,
            edges,
            standing,
            floor,
            floor_cells,
            closed_off_cells,
            start,
            tool_radius: 0.5 * robot.tool_width,
            tool: robot.tool,
            body: robot.body,
            turns: turns(robot),
            is_for_path: false,
        }
    }

    /// The place for a robot that is put down at `pose`: there if it fits, or else the nearest place that it can reach
    /// from the start. `is_free` excludes places that are taken.
    pub fn place_for(&self, pose: Pose, is_free: impl Fn(Point) -> bool) -> Pose {
        let point = pose.position();
        let limits = self.limits();
        if self.standing.is_set(self.cell_at(point)) && limits.has_room(point, limits.body_radius) && is_free(point) {
            return pose;
        }
        let place = nearest(&self.standing, self.resolution, point, is_free).unwrap_or(self.start.position());
        Pose::new(place.x, place.y, pose.heading)
    }

    /// A random place and heading among all where the robot can stand.
    pub fn anywhere(&self, rng: &mut Rng) -> Option<Pose> {
        let places = self.standing.count();
        let chosen = (places > 0).then(|| rng.random_range(0..places))?;
        let (cell, _) = self.standing.iter().filter(|(_, stands)| **stands).nth(chosen)?;
        let place = self.standing_place(cell);
        Some(Pose::new(place.x, place.y, rng.random_range(-math::PI..math::PI)))
    }

    /// The limits for a careful robot's body: walls, furniture, drop-offs, and virtual walls that it detects.
    #[inline]
    pub fn limits(&self) -> &Walls {
        self.edges.as_deref().unwrap_or(&self.walls)
    }

    /// The fine cell that holds a point; may lie outside.
    #[inline]
    pub fn cell_at(&self, point: Point) -> Cell {
        Cell::at(point, self.resolution)
    }

    /// Centre of a fine cell in metres.
    #[inline]
    pub fn centre(&self, cell: Cell) -> Point {
        cell.centre(self.resolution)
    }

    /// Reachable floor in m².
    pub fn area(&self) -> f64 {
        self.floor_cells as f64 * self.resolution * self.resolution
    }

    /// Free floor that the tool can't reach from the start, m².
    pub fn left_out_area(&self) -> f64 {
        self.left_out_cells as f64 * self.resolution * self.resolution
    }

    /// Area of places where the robot could stand, but which it can't reach from the start, m².
    pub fn closed_off_area(&self) -> f64 {
        self.closed_off_cells as f64 * self.resolution * self.resolution
    }

    /// Whether the robot can drive from `from` straight to `to` over places that it can reach, without touching a wall.
    pub fn is_straight_free(&self, from: Point, to: Point) -> bool {
        let steps = ((to - from).norm() / (0.5 * self.resolution)).ceil().max(1.0);
        let limits = self.limits();
        let room = limits.body_radius + 0.4 * steering_margin(limits.body_radius);
        (0..=steps as u32).all(|i| {
            let point = from + (to - from) * (f64::from(i) / steps);
            self.standing.is_set(self.cell_at(point)) && limits.has_room(point, room)
        })
    }

    /// Centre of a standing fine cell, moved off the walls beside it by the margin that steering needs.
    pub fn standing_place(&self, cell: Cell) -> Point {
        off_walls(self.limits(), &self.standing, cell)
    }
}

/// A room's obstacles.
struct Laid {
    resolution: f64,
    walls: Walls,
    edges: Option<Box<Walls>>,
}

impl Laid {
    fn of(plan: &FloorPlan, robot: &RobotModel, fills_cell: bool) -> Result<Self, FloorError> {
        if !plan.occupancy.values().iter().any(|o| o.is_free()) {
            return Err(FloorError::NoFreeCell);
        }
        let (blocked, resolution) = if fills_cell {
            (resample(plan, robot.tool_width), robot.tool_width)
        } else {
            let resolution = fine_resolution(plan);
            (resample(plan, resolution), resolution)
        };
        let obstacles = shapes::obstacles_for(plan, robot);
        let walls = Walls::new(blocked.clone(), obstacles.clone(), resolution, robot.radius);
        let mut barred = shapes::drop_offs(plan);
        if robot.sensors.infrared {
            barred.extend(shapes::beams(plan, &walls));
        }
        let edges = (!barred.is_empty()).then(|| {
            let shapes = obstacles.into_iter().chain(barred).collect();
            Box::new(Walls::new(blocked, shapes, resolution, robot.radius))
        });
        Ok(Self { resolution, walls, edges })
    }
}

/// Whether a robot turns to where it drives.
fn turns(robot: &RobotModel) -> bool {
    robot.wheels == WheelLayout::Differential
}

/// Metres per fine cell of `plan`: its own resolution or a whole fraction of it. Planning cells can't be smaller.
pub fn fine_resolution(plan: &FloorPlan) -> f64 {
    plan.resolution / refinement(plan) as f64
}

/// Room that a robot needs beside its body to pass, m: steering isn't exact, so narrower gaps are closed to it. It can
/// still move up to a wall.
pub(super) fn steering_margin(body_radius: f64) -> f64 {
    (0.1 * body_radius).min(0.01)
}

/// Adds the cells at the walls, two deep for the corners, in which the robot has half the margin to steer when it keeps
/// off the wall: so gaps that are too tight stay closed.
fn up_to_walls(walls: &Walls, passable: Grid<bool>) -> Grid<bool> {
    let fits = walls.clearance.map(|&c| f64::from(c) >= walls.body_radius - 1e-5);
    let room = walls.body_radius + 0.5 * steering_margin(walls.body_radius);
    let mut standing = passable;
    for _ in 0..2 {
        let is_next = |cell: Cell| fits.is_set(cell) && !standing.is_set(cell);
        let at_edge = standing.iter().filter(|&(_, &stands)| stands).flat_map(|(cell, _)| cell.neighbours());
        let wider: Vec<Cell> =
            at_edge.filter(|&c| is_next(c) && walls.has_room(off_walls(walls, &fits, c), room)).collect();
        for cell in wider {
            standing[cell] = true;
        }
    }
    standing
}

/// Centre of a cell of `standing`, moved away from neighbours outside it by the margin that steering needs.
fn off_walls(walls: &Walls, standing: &Grid<bool>, cell: Cell) -> Point {
    let place = cell.centre(walls.resolution);
    let margin = steering_margin(walls.body_radius);
    if f64::from(walls.clearance[cell]) >= walls.body_radius + margin {
        return place;
    }
    let stands = |direction| f64::from(u8::from(standing.is_set(cell.step(direction))));
    let away = |plus, minus| margin * (stands(plus) - stands(minus));
    place + Vector::new(away(Direction::Right, Direction::Left), away(Direction::Up, Direction::Down))
}

/// Fine cells per map cell, in each direction: enough to resolve the tool, within the memory limit.
fn refinement(plan: &FloorPlan) -> usize {
    let wanted = (plan.resolution / FINE_CELL - 1e-9).ceil().max(1.0) as usize;
    let affordable = ((MAX_FINE_CELLS / plan.occupancy.len().max(1)) as f64).sqrt() as usize;
    wanted.min(affordable.max(1))
}

/// The obstacles on a grid with cells of `resolution` metres: a cell is blocked if any map cell under it is, or if
/// there is none.
fn resample(plan: &FloorPlan, resolution: f64) -> Grid<bool> {
    let map = plan.blocked();
    let ratio = resolution / plan.resolution;
    if (ratio - 1.0).abs() < 1e-9 {
        return map;
    }
    let cells = |n: usize| ((n as f64 / ratio - 1e-6).ceil() as usize).max(1);
    let (width, height) = (cells(map.width()), cells(map.height()));
    // Map columns or rows under cell `i`; an overlap by rounding doesn't count.
    let under = |i: usize| {
        let low = (i as f64 * ratio + 1e-6).floor() as i32;
        let high = ((i + 1) as f64 * ratio - 1e-6).floor() as i32;
        low..=high
    };
    let mut grid = Grid::filled(width, height, false);
    for y in 0..height {
        for x in 0..width {
            let is_free = under(y).all(|row| under(x).all(|column| map.get(Cell::new(column, row)) == Some(&false)));
            grid[Cell::new(x as i32, y as i32)] = !is_free;
        }
    }
    grid
}

/// The start itself, or the nearest place where the robot fits if it stands too close to a wall.
fn check_start(plan: &FloorPlan, free: &Grid<bool>, walls: &Walls, pose: Pose) -> Result<Pose, FloorError> {
    let (x, y) = (pose.x, pose.y);
    let Some(occupancy) = plan.occupancy.get(plan.cell_at(pose.position())) else {
        return Err(FloorError::StartOutside { x, y, width: plan.width_m(), height: plan.height_m() });
    };
    if free.is_set(Cell::at(pose.position(), walls.resolution)) {
        // A free cell guarantees room around its centre, not everywhere in it.
        let has_room = walls.has_room(pose.position(), walls.body_radius);
        return Ok(if has_room { pose } else { in_centre(pose, walls.resolution) });
    }
    let place = nearest(free, walls.resolution, pose.position(), |_| true);
    let place = place.ok_or(FloorError::TooNarrow { diameter: 2.0 * walls.body_radius })?;
    if occupancy.is_free() && !walls.shapes().iter().any(|shape| shape.contains(pose.position())) {
        Ok(Pose::new(place.x, place.y, pose.heading))
    } else {
        Err(FloorError::StartInWall { x, y, free_x: place.x, free_y: place.y })
    }
}

/// The same heading in the middle of the cell.
fn in_centre(pose: Pose, resolution: f64) -> Pose {
    let middle = Cell::at(pose.position(), resolution).centre(resolution);
    Pose::new(middle.x, middle.y, pose.heading)
}

/// Centre of the cell of `free` that is nearest to `point` and for which `is_free` holds.
fn nearest(free: &Grid<bool>, resolution: f64, point: Point, is_free: impl Fn(Point) -> bool) -> Option<Point> {
    free.iter()
        .filter(|&(_, &f)| f)
        .map(|(cell, _)| cell.centre(resolution))
        .filter(|&centre| is_free(centre))
        .min_by(|a, b| (a - point).norm_squared().total_cmp(&(b - point).norm_squared()))
}

/// The first standing place, from the lower left, of the largest connected part; heading 0.
fn default_start(free: &Grid<bool>, resolution: f64) -> Option<Pose> {
    let point = largest_part(free)?.centre(resolution);
    Some(Pose::new(point.x, point.y, 0.0))
}

/// Fine cells that aren't floor: walls, and those whose centre lies in a shape or, if `is_strict`, those that a shape
/// touches.
fn covered(walls: &Walls, is_strict: bool) -> Grid<bool> {
    if is_strict {
        return walls.clearance.map(|&c| c == 0.0);
    }
    let mut covered = walls.squares().clone();
    for (index, is_covered) in covered.values_mut().iter_mut().enumerate() {
        let cell = walls.clearance.cell(index);
        // Cells with enough clearance contain no shape.
        *is_covered |= walls.clearance[cell] == 0.0 && walls.contains(cell.centre(walls.resolution));
    }
    covered
}

/// Cells that the tool sweeps when the robot is anywhere in `standing`, walls left out; at `heading`, if the robot keeps
/// it.
fn sweepable(
    standing: &Grid<bool>,
    blocked: &Grid<bool>,
    robot: &RobotModel,
    heading: f64,
    resolution: f64,
) -> Grid<bool> {
    let mut floor = match (robot.tool, robot.body) {
        (Tool::Body, Body::Polygon(corners)) if !turns(robot) => {
            spread(standing, &PolygonStamp::new(&corners, resolution).around(heading))
        }
        // Turning on the spot, it reaches everything up to its farthest point.
        (Tool::Body, _) => discs(standing, robot.radius / resolution, Vector::zeros()),
        (Tool::Disc([x, y]), _) if turns(robot) => {
            discs(standing, (0.5 * robot.tool_width + math::hypot(x, y)) / resolution, Vector::zeros())
        }
        (Tool::Disc([x, y]), _) => {
            let (sin, cos) = math::sin_cos(heading);
            let shift = Vector::new(cos * x - sin * y, sin * x + cos * y) / resolution;
            discs(standing, 0.5 * robot.tool_width / resolution, shift)
        }
    };
    for (value, &is_blocked) in floor.values_mut().iter_mut().zip(blocked.values()) {
        *value &= !is_blocked;
    }
    floor
}

/// Cells in a disc of `radius` cells, `shift` cells from any cell of `standing`.
///
/// Without a shift, discs around cells at the edge of `standing` are enough: of all its cells, the nearest to a cell
/// outside is one of them.
fn discs(standing: &Grid<bool>, radius: f64, shift: Vector) -> Grid<bool> {
    let stamp = DiscStamp { radius, width: standing.width(), height: standing.height() };
    let is_centred = shift == Vector::zeros();
    let mut floor = if is_centred { standing.clone() } else { standing.map(|_| false) };
    for (cell, &stands) in standing.iter() {
        if stands && !(is_centred && cell.block().all(|c| standing.is_set(c))) {
            stamp.rows(f64::from(cell.x) + 0.5 + shift.x, f64::from(cell.y) + 0.5 + shift.y, |range| {
                floor.values_mut()[range].fill(true);
            });
        }
    }
    floor
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        grid::{Occupancy, from_picture, picture},
        robot::{cell_robot, model},
    };

    fn plan(text: &str, resolution: f64) -> FloorPlan {
        FloorPlan {
            name: "test".into(),
            note: String::new(),
            resolution,
            occupancy: from_picture(text, |c| if c == '#' { Occupancy::Occupied } else { Occupancy::Free }).unwrap(),
            objects: Vec::new(),
            start: None,
            origin: Pose::new(0.0, 0.0, 0.0),
        }
    }

    #[test]
    fn cell_robot_reaches_exactly_the_connected_free_cells() {
        let plan = plan("..#.\n..#.\n...#", 0.2);
        let floor = ReachableFloor::new(&plan, &cell_robot(0.2), None).unwrap();
        assert_eq!(picture(&floor.floor, |&f| if f { 'o' } else { '-' }), "oo--\noo--\nooo-\n");
        assert_eq!(floor.floor_cells, 7);
    }

    #[test]
    fn round_robot_is_not_blamed_for_corners() {
        let plan = plan(&"....................\n".repeat(20), 0.05);
        let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
        // Fine cells of 2.5 cm: centres keep 0.17425 m off the walls (seven cells and a half), the brush reaches 0.085 m
        // further.
        assert!(floor.standing.is_set(Cell::new(7, 7)) && !floor.standing.is_set(Cell::new(6, 20)));
        assert!(floor.floor.is_set(Cell::new(4, 20)) && !floor.floor.is_set(Cell::new(3, 20)));
        assert!(!floor.floor.is_set(Cell::new(0, 0)));
    }

    #[test]
    fn start_in_a_wall_names_a_place_that_works() {
        let plan = plan("....\n.##.\n....", 1.0);
        let error =
            ReachableFloor::new(&plan, model("roomba600").unwrap(), Some(Pose::new(1.5, 1.5, 0.0))).unwrap_err();
        let FloorError::StartInWall { free_x, free_y, .. } = error else { panic!("{error}") };
        assert!(ReachableFloor::new(&plan, model("roomba600").unwrap(), Some(Pose::new(free_x, free_y, 0.0))).is_ok());
    }

    #[test]
    fn start_too_close_to_a_wall_moves_to_the_nearest_place() {
        let plan = plan("....\n....", 1.0);
        let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), Some(Pose::new(0.01, 1.0, 0.5))).unwrap();
        assert!(floor.start.x >= 0.17 && floor.start.x < 0.25 && floor.start.heading == 0.5, "{}", floor.start);
    }

    #[test]
    fn too_narrow_and_empty_maps_are_told_apart() {
        let robot = model("roomba600").unwrap();
        assert_eq!(ReachableFloor::new(&plan("##", 1.0), robot, None).unwrap_err(), FloorError::NoFreeCell);
        let narrow = ReachableFloor::new(&plan("..", 0.1), robot, None).unwrap_err();
        assert!(matches!(narrow, FloorError::TooNarrow { .. }), "{narrow}");
    }
}

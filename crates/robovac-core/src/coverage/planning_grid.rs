//! The planning grid: square cells of any size laid over the floor that a robot can reach.

use super::{PlanningCells, ReachableFloor};
use crate::{
    geometry::{Point, Vector},
    grid::{Cell, Direction, Grid, reachable},
};
use std::collections::VecDeque;

/// Planning cells with a place to stand in each.
///
/// A cell is free if the robot can stand somewhere in it; its **anchor** is the standing place nearest to its centre (a
/// centimetre off the wall beside it), so that paths run along walls that don't lie on the lattice. Two free neighbours
/// are always linked: straight from anchor to anchor, or by a short way round a corner. Where neither exists (a thin
/// wall between two anchors) the cell whose anchor lies farther from its centre is dropped.
#[derive(Debug, Clone)]
pub struct PlanningGrid {
    /// Where the cells lie.
    pub cells: PlanningCells,
    /// Free planning cells, all connected with `start`.
    pub free: Grid<bool>,
    /// The cell of the robot's start.
    pub start: Cell,
    anchors: Grid<Point>,
}

impl PlanningGrid {
    /// Lays cells over `floor`; a number is their side in metres, from the map's lower-left corner.
    pub fn new(floor: &ReachableFloor, cells: impl Into<PlanningCells>) -> Self {
        Self::lay(floor, cells.into())
    }

    fn lay(floor: &ReachableFloor, cells: PlanningCells) -> Self {
        let (standing, cell_size) = (&floor.standing, cells.size);
        let count = |axis: usize, n: usize| cells.along(axis, n as f64 * floor.resolution);
        let (width, height) = (count(0, standing.width()), count(1, standing.height()));
        let planning_cell = |p: Point| {
            let cell = cells.at(p);
            Cell::new(cell.x.clamp(0, width as i32 - 1), cell.y.clamp(0, height as i32 - 1))
        };
        let mut free = Grid::filled(width, height, false);
        for (fine, _) in standing.iter().filter(|&(_, &stands)| stands) {
            free[planning_cell(floor.centre(fine))] = true;
        }
        let targets =
            Targets { free: &free, cells, shift: (2.0 * floor.tool_radius - cell_size).clamp(0.0, 0.5 * cell_size) };
        let mut anchors = Grid::filled(width, height, Point::origin());
        let mut offsets = Grid::filled(width, height, f64::MAX);
        for (fine, _) in standing.iter().filter(|&(_, &stands)| stands) {
            let place = floor.centre(fine);
            let cell = planning_cell(place);
            let offset = (place - targets.of(cell)).norm_squared();
            if offset < offsets[cell] - 1e-12 {
                offsets[cell] = offset;
                anchors[cell] = place;
            }
        }
        for (cell, _) in free.iter().filter(|&(_, &f)| f) {
            anchors[cell] = settle(floor, anchors[cell], targets.of(cell));
        }
        let start = planning_cell(floor.start.position());
        let mut planning_grid = Self { cells, free, start, anchors };
        for index in 0..planning_grid.free.len() {
            let cell = planning_grid.free.cell(index);
            for next in [cell.step(Direction::Right), cell.step(Direction::Up)] {
                if planning_grid.free.is_set(cell)
                    && planning_grid.free.is_set(next)
                    && planning_grid.link(floor, cell, next).is_none()
                {
                    let give_up =
                        if next == start || (cell != start && offsets[cell] > offsets[next]) { cell } else { next };
                    planning_grid.free[give_up] = false;
                }
            }
        }
        planning_grid.free = reachable(&planning_grid.free, start);
        planning_grid
    }

    /// The anchor of a free cell.
    pub fn anchor(&self, cell: Cell) -> Point {
        self.anchors[cell]
    }

    /// The anchors of a walk over free cells: roughly the line that the robot would drive. Other cells are skipped.
    pub fn anchors(&self, walk: &[Cell]) -> Vec<Point> {
        walk.iter().filter(|&&cell| self.free.is_set(cell)).map(|&cell| self.anchors[cell]).collect()
    }

    /// The line that the robot drives to follow a walk over free cells, from the start pose; corners only.
    pub fn polyline(&self, floor: &ReachableFloor, walk: &[Cell]) -> Vec<Point> {
        let mut line = vec![floor.start.position()];
        let Some(&first) = walk.first() else { return line };
        let way_in = way(floor, floor.start.position(), self.anchor(first), f64::MAX);
        for point in way_in.unwrap_or_default() {
            push_corner(&mut line, point);
        }
        for step in walk.windows(2) {
            let link = self.link(floor, step[0], step[1]).unwrap_or_else(|| vec![self.anchor(step[1])]);
            for point in link {
                push_corner(&mut line, point);
            }
        }
        line
    }

    /// Distance along its [`PlanningGrid::polyline`] at which each cell of a walk is reached, m.
    pub fn arrivals(&self, floor: &ReachableFloor, walk: &[Cell]) -> Vec<f64> {
        let Some(&first) = walk.first() else { return Vec::new() };
        let (mut at, mut length) = (floor.start.position(), 0.0);
        let mut drive = |points: Vec<Point>| {
            for point in points {
                length += (point - at).norm();
                at = point;
            }
            length
        };
        let way_in = way(floor, floor.start.position(), self.anchor(first), f64::MAX);
        let mut arrivals = vec![drive(way_in.unwrap_or_default())];
        for step in walk.windows(2) {
            let link = self.link(floor, step[0], step[1]).unwrap_or_else(|| vec![self.anchor(step[1])]);
            arrivals.push(drive(link));
        }
        arrivals
    }

    /// Points to drive through from the anchor of `from` to that of its neighbour `to`, the last one included.
    fn link(&self, floor: &ReachableFloor, from: Cell, to: Cell) -> Option<Vec<Point>> {
        way(floor, self.anchor(from), self.anchor(to), self.cells.size)
    }
}

impl ReachableFloor {
    /// Points to drive through from `from` to `to`, both places where the robot can stand, the last one included; `None`
    /// if there is no way.
    pub fn way(&self, from: Point, to: Point) -> Option<Vec<Point>> {
        way(self, from, to, f64::MAX)
    }
}

/// Straight if possible, else a shortest way over standing cells that keeps within `margin` metres of the box
/// around both ends, pulled tight.
fn way(floor: &ReachableFloor, from: Point, to: Point, margin: f64) -> Option<Vec<Point>> {
    let (start, goal) = (floor.cell_at(from), floor.cell_at(to));
    // Every point between is at most half the distance from one of the ends.
    let room = floor.limits().body_radius + 0.5 * (to - from).norm();
    let is_open = |p: Point| floor.standing.is_set(floor.cell_at(p)) && floor.limits().has_room_around_cell(p, room);
    if start.manhattan(goal) <= 1 || (is_open(from) && is_open(to)) || floor.is_straight_free(from, to) {
        return Some(vec![to]);
    }
    let pad = (margin / floor.resolution).min(1e6) as i32 + 1;
    let low = Cell::new(start.x.min(goal.x) - pad, start.y.min(goal.y) - pad);
    let high = Cell::new(start.x.max(goal.x) + pad, start.y.max(goal.y) + pad);
    let low = Cell::new(low.x.max(0), low.y.max(0));
    let high = Cell::new(high.x.min(floor.standing.width() as i32 - 1), high.y.min(floor.standing.height() as i32 - 1));
    let local = |c: Cell| Cell::new(c.x - low.x, c.y - low.y);
    let mut came_from: Grid<Option<Cell>> =
        Grid::filled((high.x - low.x + 1) as usize, (high.y - low.y + 1) as usize, None);
    let mut queue = VecDeque::from([start]);
    came_from[local(start)] = Some(start);
    while let Some(cell) = queue.pop_front() {
        if cell == goal {
            break;
        }
        for next in cell.neighbours() {
            if floor.standing.is_set(next) && came_from.get(local(next)).is_some_and(Option::is_none) {
                came_from[local(next)] = Some(cell);
                queue.push_back(next);
            }
        }
    }
    let mut cells = vec![goal];
    while let Some(&cell) = cells.last().filter(|&&c| c != start) {
        cells.push(came_from[local(cell)]?);
    }
    cells.reverse();
    let mut way: Vec<Point> = Vec::new();
    let mut at = from;
    for pair in cells.windows(2).skip(1) {
        if !floor.is_straight_free(at, floor.centre(pair[1])) {
            at = floor.standing_place(pair[0]);
            way.push(at);
        }
    }
    way.push(to);
    Some(way)
}

/// Target positions of the anchors: the centre of each cell, or towards the wall where there is no neighbouring cell.
struct Targets<'a> {
    free: &'a Grid<bool>,
    cells: PlanningCells,
    /// Largest shift of a lane beside a wall that leaves no gap to the next lane, m.
    shift: f64,
}

impl Targets<'_> {
    fn of(&self, cell: Cell) -> Point {
        let is_free = |direction| self.free.is_set(cell.step(direction));
        let towards_wall = |plus, minus| match (is_free(plus), is_free(minus)) {
            (false, true) => self.shift,
            (true, false) => -self.shift,
            _ => 0.0,
        };
        self.cells.centre(cell)
            + Vector::new(towards_wall(Direction::Right, Direction::Left), towards_wall(Direction::Up, Direction::Down))
    }
}

/// The target itself if there is room around it, else `place`, the centre of the standing fine cell nearest to it,
/// moved off the walls.
fn settle(floor: &ReachableFloor, place: Point, target: Point) -> Point {
    let has_room = floor.cell_at(target).block().all(|c| floor.standing.is_set(c));
    if has_room { target } else { floor.standing_place(floor.cell_at(place)) }
}

/// Appends a point, replacing the last one if all three lie on one line in this order.
fn push_corner(line: &mut Vec<Point>, point: Point) {
    if let Some(&last) = line.last() {
        if (point - last).norm() < 1e-9 {
            return;
        }
        if let [.., before, _] = line.as_slice() {
            let (a, b): (Vector, Vector) = (last - before, point - last);
            if a.perp(&b).abs() < 1e-9 && a.dot(&b) > 0.0 {
                line.pop();
            }
        }
    }
    line.push(point);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        floor_plan::FloorPlan,
        geometry::Pose,
        grid::{Occupancy, from_picture, picture},
        robot::model,
    };

    fn floor(text: &str, resolution: f64) -> ReachableFloor {
        let plan = FloorPlan {
            name: "test".into(),
            note: String::new(),
            resolution,
            occupancy: from_picture(text, |c| if c == '#' { Occupancy::Occupied } else { Occupancy::Free }).unwrap(),
            objects: Vec::new(),
            start: None,
            origin: Pose::new(0.0, 0.0, 0.0),
        };
        ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap()
    }

    #[test]
    fn every_link_keeps_off_the_walls() {
        let floor = floor(
            "..............\n..............\n......##......\n......##......\n..............\n....##....##..\n..............\n..............",
            0.25,
        );
        for (size, offset) in
            [(0.1, [0.0, 0.0]), (0.15, [0.1, 0.0]), (0.15, [0.0, 0.0]), (0.22, [0.05, 0.2]), (0.35, [0.0, 0.3])]
        {
            let planning_grid = PlanningGrid::new(&floor, PlanningCells { size, offset });
            for (cell, _) in planning_grid.free.iter().filter(|&(_, &f)| f) {
                for next in cell.neighbours().into_iter().filter(|&n| planning_grid.free.is_set(n)) {
                    let mut at = planning_grid.anchor(cell);
                    for point in planning_grid.link(&floor, cell, next).unwrap() {
                        assert!(floor.is_straight_free(at, point), "{cell} to {next} at {size} m, {offset:?}");
                        at = point;
                    }
                }
            }
        }
    }

    #[test]
    fn door_narrower_than_the_lattice_stays_open() {
        // The gap of 0.5 m leaves 0.15 m for the robot's centre; cells of 0.3 m have no centre in it.
        let floor = floor(&format!("{0}{1}{0}", "..........\n".repeat(5), "####..####\n"), 0.25);
        let planning_grid = PlanningGrid::new(&floor, 0.3);
        assert!(planning_grid.free.is_set(Cell::new(4, 1)) && planning_grid.free.is_set(Cell::new(4, 8)), "{}", {
            picture(&planning_grid.free, |&f| if f { '.' } else { '#' })
        });
    }

    #[test]
    fn lanes_in_the_open_are_straight() {
        // Centres of cells of 0.12 m sometimes fall on borders of the fine cells of 0.05 m.
        let floor = floor(&"..........\n".repeat(10), 0.25);
        let planning_grid = PlanningGrid::new(&floor, 0.12);
        for x in 4..16 {
            let anchor = planning_grid.anchor(Cell::new(x, 10));
            assert!((anchor - Point::new((f64::from(x) + 0.5) * 0.12, 10.5 * 0.12)).norm() < 1e-9, "{x}: {anchor}");
        }
    }

    #[test]
    fn cells_begin_where_they_are_told_to() {
        let floor = floor(&"..........\n".repeat(10), 0.25);
        let planning_grid = PlanningGrid::new(&floor, PlanningCells { size: 0.12, offset: [0.04, 0.08] });
        // 2.5 m and what lies outside.
        assert_eq!((planning_grid.free.width(), planning_grid.free.height()), (22, 22));
        let anchor = planning_grid.anchor(Cell::new(8, 10));
        assert!((anchor - Point::new(8.5 * 0.12 - 0.04, 10.5 * 0.12 - 0.08)).norm() < 1e-9, "{anchor}");
        assert_eq!(planning_grid.start, planning_grid.cells.at(floor.start.position()));
    }

    #[test]
    fn polyline_has_corners_only() {
        let floor = floor(&"..........\n".repeat(10), 0.25);
        let planning_grid = PlanningGrid::new(&floor, 0.25);
        let walk: Vec<Cell> = (1..8).map(|x| Cell::new(x, 4)).chain((5..8).map(|y| Cell::new(7, y))).collect();
        let line = planning_grid.polyline(&floor, &walk);
        assert!(line.len() <= 4, "{line:?}");
    }
}

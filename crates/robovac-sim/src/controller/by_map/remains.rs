//! Floor left to clean, by the robot's own map.

use crate::{
    controller::parts::Barred,
    mapping::{CellMark, Mapper, Marks, OccupancyMap, TiledLayer, close_gaps},
};
use coverage_planners::CoverageJob;
use robovac_core::{
    coverage::{PlanningGrid, ReachableFloor},
    floor_plan::FloorPlan,
    geometry::{Point, Pose, Vector},
    grid::{Cell, Direction, Grid, Occupancy, reachable},
    math,
    robot::RobotModel,
};
use std::collections::VecDeque;

/// Margin around the known area, cells of the map.
const MARGIN: i32 = 8;
/// Cells around the robot that aren't occupied are floor, m beyond its radius.
const AROUND: f64 = 0.05;
/// Least difference between the tool and a planning cell, m: the overlap of lanes.
const OVERLAP: f64 = 0.02;

/// Reachable floor on the robot's map, and its uncleaned part. Planning cells consist of whole map cells and don't
/// change as the map grows, so records about them stay valid.
pub(super) struct Remains {
    floor: ReachableFloor,
    planning_grid: PlanningGrid,
    /// Planning cells that are left.
    left: Grid<bool>,
    /// Lower left corner, in the frame of the map: in m, map cells and planning cells.
    corner: Vector,
    low: Cell,
    first: Cell,
    /// Side of the map's cells, m.
    side: f64,
}

/// Criteria for goals.
#[derive(Debug, Clone, Copy)]
pub(super) struct Aim {
    /// How much nearer to an obstacle of the map than its radius the robot can come, m, as maps are blurred and
    /// inaccurate.
    pub slack: f64,
    /// Share of a planning cell that must be left for it to be cleaned. Strips along walls as thin as a map cell, which
    /// vary with its blur, are a third of one of 15 cm.
    pub share: f64,
    /// Fewest planning cells of a part.
    pub cells: usize,
}

/// Parameters for computing the remaining floor.
pub(super) struct Look<'a> {
    /// The robot.
    pub robot: &'a RobotModel,
    /// Criteria for goals.
    pub aim: Aim,
    /// Cells that must not be entered.
    pub barred: &'a Barred,
    /// Planning cells whose attempts are used up.
    pub is_spent: &'a dyn Fn(Cell) -> bool,
}

impl Remains {
    /// The floor that `mapper` has left; `None` if nothing is reachable.
    pub fn new(mapper: &Mapper, look: &Look<'_>) -> Option<Self> {
        let (map, pose) = (mapper.map(), mapper.pose());
        let side = map.resolution();
        let columns = columns(look.robot, side);
        let (plan, low) = plan(map, look, pose, columns)?;
        let corner = Vector::new(f64::from(low.x) * side, f64::from(low.y) * side);
        let narrow = RobotModel { radius: look.robot.radius - look.aim.slack, fills_cell: false, ..look.robot.clone() };
        let at = pose.position() - corner;
        let floor = ReachableFloor::new(&plan, &narrow, Some(Pose::new(at.x, at.y, pose.heading))).ok()?;
        let planning_grid = PlanningGrid::new(&floor, side * f64::from(columns));
        let first = Cell::new(low.x / columns, low.y / columns);
        let mut remains = Self { left: planning_grid.free.clone(), floor, planning_grid, corner, low, first, side };
        remains.leave(mapper.marks(), columns, look);
        Some(remains)
    }

    /// Removes floor that is clean or given up.
    fn leave(&mut self, marks: &Marks, columns: i32, look: &Look<'_>) {
        for index in 0..self.left.len() {
            let cell = self.left.cell(index);
            if !self.left[cell] {
                continue;
            }
            let mut left = 0;
            for (dx, dy) in (0..columns).flat_map(|dy| (0..columns).map(move |dx| (dx, dy))) {
                let inner = Cell::new(cell.x * columns + dx, cell.y * columns + dy);
                if self.floor.floor.is_set(self.floor.cell_at(inner.centre(self.side))) {
                    left += i32::from(!marks.has(self.outer(inner), CellMark::Cleaned));
                }
            }
            let is_left = f64::from(left) >= look.aim.share * f64::from(columns * columns);
            self.left[cell] = is_left && !(look.is_spent)(self.name(cell));
        }
    }

    /// A cell of the plan in the coordinates of the map.
    fn outer(&self, cell: Cell) -> Cell {
        Cell::new(cell.x + self.low.x, cell.y + self.low.y)
    }

    /// The permanent coordinates of a planning cell.
    pub fn name(&self, cell: Cell) -> Cell {
        Cell::new(cell.x + self.first.x, cell.y + self.first.y)
    }

    /// The nearest connected part of the remaining floor with at least `least` planning cells, and the cell to start
    /// in; `None` if there is no reachable one.
    pub fn nearest(&self, least: usize) -> Option<(Grid<bool>, Cell)> {
        let mut rest = self.left.clone();
        loop {
            let (cell, _) = self.search(|cell| rest[cell])?;
            let part = reachable(&rest, cell);
            if part.count() >= least {
                return Some((part, cell));
            }
            for (left, &is_small) in rest.values_mut().iter_mut().zip(part.values()) {
                *left &= !is_small;
            }
        }
    }

    /// The line to near a place, in the frame of the map, if it is reachable.
    pub fn way(&self, to: Point) -> Option<Vec<Point>> {
        let near = self.planning_grid.cells.size;
        let (cell, before) = self.search(|cell| (self.planning_grid.anchor(cell) + self.corner - to).norm() < near)?;
        let mut walk = vec![cell];
        while let Some(next) = walk.last().and_then(|&last| before[last]) {
            walk.push(next);
        }
        walk.reverse();
        Some(self.line(&walk))
    }

    /// The nearest cell with `is_wanted`, by steps, and the predecessor of each cell.
    fn search(&self, is_wanted: impl Fn(Cell) -> bool) -> Option<(Cell, Grid<Option<Cell>>)> {
        let free = &self.planning_grid.free;
        let mut before = free.map(|_| None);
        let mut seen = free.map(|_| false);
        seen[self.planning_grid.start] = true;
        let mut queue = VecDeque::from([self.planning_grid.start]);
        while let Some(cell) = queue.pop_front() {
            if is_wanted(cell) {
                return Some((cell, before));
            }
            for next in cell.neighbours() {
                if free.is_set(next) && !std::mem::replace(&mut seen[next], true) {
                    before[next] = Some(cell);
                    queue.push_back(next);
                }
            }
        }
        None
    }

    /// The job of covering a part from `start` on.
    pub fn job(&self, part: Grid<bool>, start: Cell, robot: &RobotModel) -> CoverageJob {
        let toward = self.planning_grid.anchor(start) - self.floor.start.position();
        let heading = if toward.norm() > self.planning_grid.cells.size {
            math::atan2(toward.y, toward.x)
        } else {
            self.floor.start.heading
        };
        CoverageJob {
            free: part,
            start,
            heading: Direction::nearest(heading),
            step_s: self.planning_grid.cells.size / robot.cruise_speed,
            turn_s: robot.turn_time(math::FRAC_PI_2) + robot.cruise_speed / robot.acceleration,
            place: None,
        }
    }

    /// The line from the robot along a walk over planning cells, in the frame of the map.
    pub fn line(&self, walk: &[Cell]) -> Vec<Point> {
        self.planning_grid.polyline(&self.floor, walk).into_iter().skip(1).map(|at| at + self.corner).collect()
    }

    /// Cells of the map that the tool can reach.
    pub fn reach(&self) -> TiledLayer<bool> {
        let mut reach = TiledLayer::new();
        let [width, height] = [self.floor.floor.width(), self.floor.floor.height()]
            .map(|fine| (fine as f64 * self.floor.resolution / self.side).round() as i32);
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let cell = Cell::new(x, y);
            if self.floor.floor.is_set(self.floor.cell_at(cell.centre(self.side))) {
                reach.update(self.outer(cell), |_| true);
            }
        }
        reach
    }
}

/// The planning cell of a point, in permanent coordinates.
pub(super) fn name_at(point: Point, robot: &RobotModel, side: f64) -> Cell {
    Cell::at(point, side * f64::from(columns(robot, side)))
}

/// Side of a planning cell, cells of the map.
fn columns(robot: &RobotModel, side: f64) -> i32 {
    (((robot.tool_width - OVERLAP) / side + 1e-6) as i32).max(1)
}

/// The map as a floor plan for `look`, and the cell of the map that is its lower left one, a multiple of `columns`; `None` if
/// nothing is known.
///
/// Unknown cells aren't floor, except for gaps within known floor and around the robot at `pose`.
fn plan(map: &OccupancyMap, look: &Look<'_>, pose: Pose, columns: i32) -> Option<(FloorPlan, Cell)> {
    let known = map.to_plan("")?;
    let side = map.resolution();
    let from = Cell::at(known.origin.position() + Vector::new(0.5 * side, 0.5 * side), side);
    let snap = |value: i32| (value - MARGIN).div_euclid(columns) * columns;
    let low = Cell::new(snap(from.x), snap(from.y));
    let size = |from: i32, low: i32, cells: usize| {
        let least = from - low + cells as i32 + MARGIN;
        (least + columns - least.rem_euclid(columns)) as usize
    };
    let (width, height) = (size(from.x, low.x, known.occupancy.width()), size(from.y, low.y, known.occupancy.height()));
    let mut occupancy = Grid::filled(width, height, Occupancy::Unknown);
    let outer = |cell: Cell| Cell::new(cell.x + low.x, cell.y + low.y);
    for (index, value) in occupancy.values_mut().iter_mut().enumerate() {
        let cell = Cell::new((index % width) as i32, (index / width) as i32);
        let inner = Cell::new(cell.x + low.x - from.x, cell.y + low.y - from.y);
        *value = known.occupancy.get(inner).copied().unwrap_or(Occupancy::Unknown);
        let near = (outer(cell).centre(side) - pose.position()).norm() < look.robot.radius + AROUND;
        if *value == Occupancy::Unknown && near {
            *value = Occupancy::Free;
        }
    }
    close_gaps(&mut occupancy, side);
    for index in 0..occupancy.len() {
        let cell = occupancy.cell(index);
        if look.barred.has(outer(cell)) {
            occupancy[cell] = Occupancy::Occupied;
        }
    }
    let origin = Pose::new(f64::from(low.x) * side, f64::from(low.y) * side, 0.0);
    Some((FloorPlan { occupancy, origin, ..known }, low))
}

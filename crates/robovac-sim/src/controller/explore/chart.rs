//! Reachable cells and frontiers of a map.

use crate::{controller::parts::Barred, mapping::OccupancyMap};
use robovac_core::{
    geometry::Point,
    grid::{Cell, Grid, Occupancy, clearance},
};
use std::{
    cmp::Reverse,
    collections::{BinaryHeap, VecDeque},
};

/// Room around the known part, cells.
const MARGIN: i32 = 12;
/// How much nearer to an obstacle of the map than its radius the robot can come, m, as maps are blurred and inaccurate.
pub(super) const SLACK: [f64; 3] = [0.04, 0.08, 0.12];
/// Room beyond that which is worth a detour, m.
const EASY: f64 = 0.08;
/// Cost of a step in cells: straight and diagonal, in thousandths, and how many times as much where there is little room.
const STEP: (u32, u32) = (1000, 1414);
const NARROW: u32 = 3;
/// Cells around the robot that aren't occupied can be driven over, m.
const AROUND: f64 = 0.2;
/// Shortest piece of unknown floor that is worth a visit, cells.
const SHORTEST: usize = 4;
/// Value of a metre of a lane, as a distance, and the number of metres that count.
const WORTH: (f64, f64) = (0.5, 2.0);
/// Known cells that a lane may cross between unknown ones.
const BRIDGE: usize = 6;

/// Known floor, and standing places of the robot.
pub(super) struct Chart {
    /// The cell of the map that is (0, 0) here.
    low: Cell,
    resolution: f64,
    ground: Grid<Occupancy>,
    /// Room around the centre of each cell, m.
    room: Grid<f32>,
    radius: f64,
    /// Least room for the robot's centre, m.
    least: f64,
}

/// The ways from one place to all that are reachable on known floor.
pub(super) struct ReachableWays {
    /// Cost in thousandths of cells; `u32::MAX` if unreachable.
    cost: Grid<u32>,
    before: Grid<Option<Cell>>,
}

/// A line of unknown floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct UnknownLane {
    /// The last known cell before it, which can be reached.
    pub from: Cell,
    /// Its first and its last cell.
    pub entry: Cell,
    pub end: Cell,
    /// Way to it, m.
    pub way: f64,
    /// Its length, m.
    pub length: f64,
}

impl UnknownLane {
    /// Cost of visiting it, m.
    pub fn cost(&self) -> f64 {
        self.way - WORTH.0 * self.length.min(WORTH.1)
    }
}

impl Chart {
    /// The chart of `map` for a robot of `radius` metres at `robot`; `barred` cells count as occupied. The robot can
    /// come `slack` metres nearer to obstacles than its radius.
    pub fn new(map: &OccupancyMap, barred: &Barred, robot: Point, (radius, slack): (f64, f64)) -> Self {
        let here = map.cell_at(robot);
        let (low, high) = map.bounds().unwrap_or((here, here));
        let low = Cell::new(low.x.min(here.x) - MARGIN, low.y.min(here.y) - MARGIN);
        let high = Cell::new(high.x.max(here.x) + MARGIN, high.y.max(here.y) + MARGIN);
        let (width, height) = ((high.x - low.x + 1) as usize, (high.y - low.y + 1) as usize);
        let mut ground = Grid::filled(width, height, Occupancy::Unknown);
        for (index, value) in ground.values_mut().iter_mut().enumerate() {
            let cell = Cell::new(low.x + (index % width) as i32, low.y + (index / width) as i32);
            *value = if barred.has(cell) { Occupancy::Occupied } else { map.occupancy(cell) };
        }
        let blocked = ground.map(|&what| what == Occupancy::Occupied);
        let resolution = map.resolution();
        let limit = ((radius + EASY) / resolution + 1.0) as f32;
        let room = clearance(&blocked, limit).map(|&cells| cells * resolution as f32);
        Self { low, resolution, ground, room, radius, least: radius - slack }
    }

    /// The cell that holds a point.
    pub fn cell_at(&self, point: Point) -> Cell {
        let Cell { x, y } = Cell::at(point, self.resolution);
        Cell::new(x - self.low.x, y - self.low.y)
    }

    /// The centre of a cell, in the map's frame.
    pub fn centre(&self, cell: Cell) -> Point {
        Cell::new(cell.x + self.low.x, cell.y + self.low.y).centre(self.resolution)
    }

    /// Whether the robot can stand on a cell, by the map.
    fn has_room(&self, cell: Cell) -> bool {
        self.room.get(cell).is_some_and(|&room| f64::from(room) > self.least)
    }

    fn is(&self, cell: Cell, what: Occupancy) -> bool {
        self.ground.get(cell) == Some(&what)
    }

    /// The ways from `from` over known floor (Dijkstra 1959).
    pub fn ways(&self, from: Point) -> ReachableWays {
        let start = self.cell_at(from);
        let mut ways = ReachableWays { cost: self.ground.map(|_| u32::MAX), before: self.ground.map(|_| None) };
        if !self.ground.contains(start) {
            return ways;
        }
        let around = (AROUND / self.resolution).ceil() as i32;
        let mut queue = BinaryHeap::new();
        ways.cost[start] = 0;
        queue.push(Reverse((0, start)));
        while let Some(Reverse((cost, cell))) = queue.pop() {
            if cost > ways.cost[cell] {
                continue;
            }
            for next in cell.block() {
                let is_here = (next.x - start.x).abs().max((next.y - start.y).abs()) <= around;
                let is_open = self.is(next, Occupancy::Free) && self.has_room(next)
                    || is_here && !self.is(next, Occupancy::Occupied) && self.ground.contains(next);
                if !is_open || next == cell {
                    continue;
                }
                let step = if next.x == cell.x || next.y == cell.y { STEP.0 } else { STEP.1 };
                let is_narrow = f64::from(self.room[next]) < self.radius + EASY;
                let cost = cost + step * if is_narrow { NARROW } else { 1 };
                if cost < ways.cost[next] {
                    ways.cost[next] = cost;
                    ways.before[next] = Some(cell);
                    queue.push(Reverse((cost, next)));
                }
            }
        }
        ways
    }

    /// Unknown floor that can be entered from known floor, along lines `spacing` cells apart in both directions; `allow` says
    /// which entries count.
    pub fn lanes(&self, ways: &ReachableWays, spacing: i32, allow: impl Fn(Point) -> bool) -> Vec<UnknownLane> {
        let mut lanes = Vec::new();
        for (cell, _) in self.ground.iter() {
            let column = (cell.x + self.low.x).rem_euclid(spacing) == 0;
            let row = (cell.y + self.low.y).rem_euclid(spacing) == 0;
            if !(column || row) || !self.is(cell, Occupancy::Unknown) || !self.has_room(cell) {
                continue;
            }
            let known = cell.neighbours().into_iter().filter(|&c| self.is(c, Occupancy::Free) && ways.reaches(c));
            let Some(from) = known.min_by_key(|&c| (ways.cost[c], c)) else { continue };
            let directions = [(column, 0, 1), (column, 0, -1), (row, 1, 0), (row, -1, 0)];
            let runs = directions.into_iter().filter(|run| run.0).map(|(_, dx, dy)| self.run(cell, dx, dy));
            let Some((end, cells)) = runs.max_by_key(|&(end, cells)| (cells, Reverse(end))) else { continue };
            if cells >= SHORTEST && allow(self.centre(cell)) {
                let way = f64::from(ways.cost[from]) / f64::from(STEP.0) * self.resolution;
                let length = cells as f64 * self.resolution;
                lanes.push(UnknownLane { from, entry: cell, end, way, length });
            }
        }
        lanes
    }

    /// The lane of least cost.
    pub fn nearest(lanes: Vec<UnknownLane>) -> Option<UnknownLane> {
        lanes.into_iter().min_by(|a, b| a.cost().total_cmp(&b.cost()).then(a.entry.cmp(&b.entry)))
    }

    /// The last unknown cell from `cell` on in that direction, and how many there are on the way.
    fn run(&self, cell: Cell, dx: i32, dy: i32) -> (Cell, usize) {
        let (mut end, mut unknown, mut known) = (cell, 0, 0);
        let mut next = cell;
        while self.has_room(next) && known <= BRIDGE {
            if self.is(next, Occupancy::Unknown) {
                (end, known) = (next, 0);
                unknown += 1;
            } else {
                known += 1;
            }
            next = Cell::new(next.x + dx, next.y + dy);
        }
        (end, unknown)
    }

    /// The way to a reachable cell, with few corners where there is room.
    pub fn line(&self, ways: &ReachableWays, to: Cell) -> Vec<Point> {
        let mut cells = VecDeque::from([to]);
        let mut at = to;
        while let Some(before) = ways.before.get(at).copied().flatten() {
            cells.push_front(before);
            at = before;
        }
        let mut line = Vec::new();
        let mut from = 0;
        while from + 1 < cells.len() {
            let sees = |&to: &usize| self.is_open(cells[from], cells[to]);
            let to = (from + 2..cells.len()).take_while(sees).last().unwrap_or(from + 1);
            line.push(self.centre(cells[to]));
            from = to;
        }
        line
    }

    /// Whether the robot can go straight from one cell to another over known floor.
    fn is_open(&self, from: Cell, to: Cell) -> bool {
        let (a, b) = (self.centre(from), self.centre(to));
        let steps = ((b - a).norm() / (0.5 * self.resolution)).ceil().max(1.0);
        (0..=steps as u32).all(|i| {
            let cell = self.cell_at(a + (b - a) * (f64::from(i) / steps));
            self.is(cell, Occupancy::Free) && f64::from(self.room[cell]) > self.radius
        })
    }
}

impl ReachableWays {
    /// Whether a cell can be reached.
    pub fn reaches(&self, cell: Cell) -> bool {
        self.cost.get(cell).is_some_and(|&cost| cost < u32::MAX)
    }

    /// Cost of the way to a cell, in cells, if it can be reached.
    pub fn cost(&self, cell: Cell) -> Option<f64> {
        self.cost.get(cell).filter(|&&cost| cost < u32::MAX).map(|&cost| f64::from(cost) / f64::from(STEP.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::geometry::Pose;

    /// A map from a picture: `#` occupied, `.` free, anything else unknown; 5 cm cells, lower left at the origin.
    fn map(picture: &str) -> OccupancyMap {
        let mut map = OccupancyMap::new(0.05);
        for (y, line) in picture.lines().rev().enumerate() {
            for (x, sign) in line.chars().enumerate() {
                let odds = match sign {
                    '#' => 3.0,
                    '.' => -3.0,
                    _ => continue,
                };
                map.add(Cell::new(x as i32, y as i32), odds);
            }
        }
        map
    }

    fn chart(picture: &str, radius: f64) -> Chart {
        Chart::new(&map(picture), &Barred::new(0.05), Point::new(0.1, 0.1), (radius, 0.03))
    }

    #[test]
    fn ways_lead_around_walls_and_lines_have_few_corners() {
        let floor = "................\n".repeat(6);
        let chart = chart(&format!("{floor}############....\n{floor}"), 0.02);
        let ways = chart.ways(Point::new(0.425, 0.225));
        let to = chart.cell_at(Point::new(0.425, 0.425));
        assert!(ways.cost(to).is_some_and(|cost| cost > 8.0));
        let line = chart.line(&ways, to);
        assert!((2..=6).contains(&line.len()), "{line:?}");
        assert_eq!(line.last(), Some(&chart.centre(to)));
        assert!(line.iter().any(|corner| corner.x > 0.6));
    }

    #[test]
    fn unknown_floor_is_a_lane_if_the_robot_fits_and_can_get_there() {
        // Unknown floor to the right, and a slot that is too narrow on the left.
        let row = "#      #..........\n";
        let picture = format!("{}{}", "###################\n", row.repeat(9));
        let lanes = |radius| {
            let chart = chart(&picture, radius);
            let ways = chart.ways(Point::new(0.65, 0.2));
            chart.lanes(&ways, 3, |_| true).into_iter().map(|lane| chart.centre(lane.entry)).collect::<Vec<_>>()
        };
        let found = lanes(0.04);
        assert!(found.iter().any(|p| p.x > 0.9), "{found:?}");
        assert!(found.iter().all(|p| p.x > 0.4), "behind the wall: {found:?}");
    }

    #[test]
    fn what_is_barred_is_no_way() {
        let picture = "..........\n..........\n..........\n..........";
        let mut barred = Barred::new(0.05);
        for y in -10..10 {
            barred.met(Pose::new(0.27, 0.04 * f64::from(y), 0.0), -0.03, 0.0);
        }
        let chart = Chart::new(&map(picture), &barred, Point::new(0.1, 0.1), (0.03, 0.01));
        let ways = chart.ways(Point::new(0.1, 0.1));
        assert!(ways.reaches(chart.cell_at(Point::new(0.1, 0.17))));
        assert!(!ways.reaches(chart.cell_at(Point::new(0.42, 0.1))));
    }
}

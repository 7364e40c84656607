//! Correlative search: the poses of a window, or of a whole map, from which the points of a scan lie on obstacles.
//!
//! A grid has a value for each cell that falls with the distance to the nearest obstacle, and coarser grids the largest
//! value of a square of cells. The sum of those over a scan's points bounds the sums for all poses of the square, so that
//! the best poses are found without trying all (Olson 2009; Hess, Kohler, Rapp & Andor 2016, section V.B).

use robovac_core::{
    geometry::{Point, Pose, Vector, difference},
    grid::{Cell, Grid},
    math,
};
use std::collections::BinaryHeap;

/// Levels above the finest: the coarsest has squares of 32 cells.
const LEVELS: usize = 5;
/// Padding at the lower and left border, for squares that begin outside.
const PAD: i32 = (1 << LEVELS) - 1;
/// Distance, in cells, at which the value of an obstacle has fallen to exp(-1/2), and at which it ends.
const BLUR: f64 = 1.2;
const REACH: i32 = 3;
/// Poses nearer to a better one than this don't count, m and rad.
const APART: (f64, f64) = (0.3, 0.35);
/// Most nodes that a search opens.
const PATIENCE: usize = 60_000;
/// Largest side of a grid, cells.
const MOST: i32 = 4000;

/// A grid of obstacles with its coarser levels.
#[derive(Debug, Clone)]
pub(in crate::mapping) struct CorrelationGrid {
    low: Cell,
    side: f64,
    levels: Vec<Grid<u8>>,
}

/// Poses to search.
#[derive(Debug, Clone, Copy)]
pub(in crate::mapping) enum SearchWindow {
    /// Around a pose, m and rad.
    Around(Pose, [f64; 2]),
    /// All over the grid.
    Everywhere,
}

/// A pose that was found, and the mean value of the scan's points there, from 0 to 1.
#[derive(Debug, Clone, Copy)]
pub(in crate::mapping) struct Match {
    pub pose: Pose,
    pub score: f64,
}

/// Offsets from `x` and `y`, in cells, to the next 2^`level`, at a heading; in the order of their bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Node {
    bound: u32,
    level: u8,
    heading: u16,
    x: i32,
    y: i32,
}

impl CorrelationGrid {
    /// The grid of obstacles at `points`, with cells of `side` metres; `None` without points.
    pub fn new(points: &[Point], side: f64) -> Option<Self> {
        let cells: Vec<Cell> = points.iter().map(|&point| Cell::at(point, side)).collect();
        let of = |of: fn(&Cell) -> i32| Some((cells.iter().map(of).min()?, cells.iter().map(of).max()?));
        let ((left, right), (bottom, top)) = (of(|cell| cell.x)?, of(|cell| cell.y)?);
        let low = Cell::new(left - REACH - PAD, bottom - REACH - PAD);
        let [width, height] = [right - low.x, top - low.y].map(|size| (size + REACH + 1).min(MOST) as usize);
        let mut finest = Grid::filled(width, height, 0_u8);
        for &point in points {
            let middle = Cell::at(point, side);
            for dy in -REACH..=REACH {
                for dx in -REACH..=REACH {
                    let cell = Cell::new(middle.x + dx, middle.y + dy);
                    let off = (cell.centre(side) - point) / (side * BLUR);
                    let value = (255.0 * math::exp(-0.5 * off.norm_squared())) as u8;
                    let cell = Cell::new(cell.x - low.x, cell.y - low.y);
                    if finest.contains(cell) && finest[cell] < value {
                        finest[cell] = value;
                    }
                }
            }
        }
        let mut levels = vec![finest];
        for level in 0..LEVELS {
            let coarser = coarser(&levels[level], 1 << level);
            levels.push(coarser);
        }
        Some(Self { low, side, levels })
    }

    /// Value of a place, between the middles of cells interpolated: 1 on an obstacle, and 0 from a few cells away.
    pub fn value(&self, at: Point) -> f64 {
        let (x, y) = (at.x / self.side - 0.5, at.y / self.side - 0.5);
        let cell = Cell::new(math::floor(x), math::floor(y));
        let (u, v) = (x - f64::from(cell.x), y - f64::from(cell.y));
        let value = |dx: i32, dy: i32| {
            let cell = Cell::new(cell.x + dx - self.low.x, cell.y + dy - self.low.y);
            self.levels[0].get(cell).map_or(0.0, |&value| f64::from(value))
        };
        let low = value(0, 0) * (1.0 - u) + value(1, 0) * u;
        let high = value(0, 1) * (1.0 - u) + value(1, 1) * u;
        (low * (1.0 - v) + high * v) / 255.0
    }

    /// The best poses of the window for the points of a scan in the robot's frame, best first: at most `count`, whose
    /// scores are at least `least` and that share of the best, and which the robot can have.
    pub fn search(
        &self,
        points: &[Point],
        window: SearchWindow,
        (count, least, share): (usize, f64, f64),
        can_be: impl Fn(Point) -> bool,
    ) -> Vec<Match> {
        let far = points.iter().map(|point| point.coords.norm()).fold(self.side, f64::max);
        let finest = self.side / far.min(3.0);
        let grid = &self.levels[0];
        let (base, turn, range) = match window {
            SearchWindow::Around(pose, [reach, turn]) => {
                let cells = math::ceil(reach / self.side);
                (pose, turn, [-cells, cells, -cells, cells])
            }
            SearchWindow::Everywhere => {
                let corner = Cell::new(self.low.x + PAD, self.low.y + PAD).centre(self.side);
                let size = [grid.width(), grid.height()].map(|size| size as i32 - PAD);
                (Pose::new(corner.x, corner.y, 0.0), math::PI, [0, size[0] - 1, 0, size[1] - 1])
            }
        };
        let half = math::ceil(turn / finest).clamp(1, 2000);
        let step = turn / f64::from(half);
        // A full turn ends where it began.
        let last = if turn < math::PI { half } else { half - 1 };
        let headings: Vec<f64> = (-half..=last).map(|i| base.heading + step * f64::from(i)).collect();
        let turned: Vec<Vec<[i32; 2]>> = headings
            .iter()
            .map(|&heading| {
                let (sin, cos) = math::sin_cos(heading);
                let cell = |point: &Point| {
                    let arm = Vector::new(cos * point.x - sin * point.y, sin * point.x + cos * point.y);
                    let cell = Cell::at(base.position() + arm, self.side);
                    [cell.x - self.low.x, cell.y - self.low.y]
                };
                points.iter().map(cell).collect()
            })
            .collect();
        let bound = |level: u8, heading: u16, x: i32, y: i32| -> u32 {
            let grid = &self.levels[usize::from(level)];
            let (width, height, values) = (grid.width() as i32, grid.height() as i32, grid.values());
            let value = |&[i, j]: &[i32; 2]| {
                let (i, j) = (i + x, j + y);
                if i < 0 || j < 0 || i >= width || j >= height {
                    0
                } else {
                    u32::from(values[(j * width + i) as usize])
                }
            };
            turned[usize::from(heading)].iter().map(value).sum()
        };
        let full = 255.0 * points.len().max(1) as f64;
        let least = (least * full) as u32;
        let extent = (range[1] - range[0]).max(range[3] - range[2]) + 1;
        let top = (0..LEVELS as u8).find(|&level| (2 << level) > extent / 2).unwrap_or(LEVELS as u8);
        let mut queue = BinaryHeap::new();
        let side = 1 << top;
        for heading in 0..headings.len() as u16 {
            for y in (range[2]..=range[3]).step_by(side) {
                for x in (range[0]..=range[1]).step_by(side) {
                    let bound = bound(top, heading, x, y);
                    if bound >= least {
                        queue.push(Node { bound, level: top, heading, x, y });
                    }
                }
            }
        }
        let mut found: Vec<Match> = Vec::new();
        for _ in 0..PATIENCE {
            let Some(node) = queue.pop() else { break };
            let score = f64::from(node.bound) / full;
            if found.first().is_some_and(|best| score < share * best.score) {
                break;
            }
            if node.level == 0 {
                let pose = Pose::new(
                    base.x + f64::from(node.x) * self.side,
                    base.y + f64::from(node.y) * self.side,
                    headings[usize::from(node.heading)],
                );
                let is_same = |other: &Match| {
                    (other.pose.position() - pose.position()).norm() < APART.0
                        && difference(other.pose.heading, pose.heading).abs() < APART.1
                };
                if can_be(pose.position()) && !found.iter().any(is_same) {
                    found.push(Match { pose, score });
                    if found.len() >= count {
                        break;
                    }
                }
                continue;
            }
            let (level, half) = (node.level - 1, 1 << (node.level - 1));
            for (dx, dy) in [(0, 0), (half, 0), (0, half), (half, half)] {
                let (x, y) = (node.x + dx, node.y + dy);
                if x > range[1] || y > range[3] {
                    continue;
                }
                let bound = bound(level, node.heading, x, y);
                if bound >= least {
                    queue.push(Node { bound, level, heading: node.heading, x, y });
                }
            }
        }
        found
    }
}

/// The largest value of each cell and those `step` cells to the right and above.
fn coarser(grid: &Grid<u8>, step: usize) -> Grid<u8> {
    let (width, height, values) = (grid.width(), grid.height(), grid.values());
    let mut coarser = grid.clone();
    for y in 0..height {
        for x in 0..width {
            let value = |x: usize, y: usize| if x < width && y < height { values[y * width + x] } else { 0 };
            let most = value(x, y).max(value(x + step, y)).max(value(x, y + step)).max(value(x + step, y + step));
            coarser.values_mut()[y * width + x] = most;
        }
    }
    coarser
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Outline of a room of 4 m x 3 m with a niche, every 5 cm.
    fn room() -> Vec<Point> {
        let mut points = Vec::new();
        for i in 0..80 {
            let way = 0.05 * f64::from(i);
            points.extend([Point::new(way, 0.0), Point::new(way, if i < 30 { 3.0 } else { 2.5 })]);
            if i < 60 {
                points.push(Point::new(0.0, way));
            }
            if i < 50 {
                points.push(Point::new(4.0, way));
            }
        }
        points
    }

    fn seen_from(pose: Pose) -> Vec<Point> {
        let (sin, cos) = math::sin_cos(pose.heading);
        let local = |point: &Point| {
            let off = point - pose.position();
            Point::new(cos * off.x + sin * off.y, cos * off.y - sin * off.x)
        };
        room().iter().step_by(3).map(local).collect()
    }

    #[test]
    fn it_finds_the_pose_in_a_window_and_in_the_whole_room() {
        let grid = CorrelationGrid::new(&room(), 0.05).unwrap();
        let truth = Pose::new(1.3, 1.1, 2.4);
        let scan = seen_from(truth);
        let near = Pose::new(1.5, 0.9, 2.3);
        for window in [SearchWindow::Around(near, [0.4, 0.3]), SearchWindow::Everywhere] {
            let found = grid.search(&scan, window, (3, 0.3, 0.5), |_| true);
            let best = found[0];
            assert!((best.pose.position() - truth.position()).norm() < 0.06, "{best:?}");
            assert!(difference(best.pose.heading, truth.heading).abs() < 0.04, "{best:?}");
            assert!(best.score > 0.7 && found[1..].iter().all(|other| other.score < best.score));
        }
    }

    #[test]
    fn it_is_as_good_as_trying_all() {
        let grid = CorrelationGrid::new(&room(), 0.1).unwrap();
        let scan = seen_from(Pose::new(2.6, 1.2, -0.7));
        let found =
            grid.search(&scan, SearchWindow::Around(Pose::new(2.5, 1.3, -0.6), [0.5, 0.3]), (1, 0.0, 0.0), |_| true);
        let fine = &grid.levels[0];
        let mut best = 0.0_f64;
        let half = math::ceil(0.3 / (0.1 / 3.0));
        for turn in -half..=half {
            for y in -5..=5 {
                for x in -5..=5 {
                    let pose = Pose::new(2.5, 1.3, -0.6 + 0.3 * f64::from(turn) / f64::from(half));
                    let value = |point: &Point| {
                        let at = Cell::at(pose.to_world(*point), 0.1);
                        f64::from(
                            fine.get(Cell::new(at.x + x - grid.low.x, at.y + y - grid.low.y)).copied().unwrap_or(0),
                        )
                    };
                    best = best.max(scan.iter().map(value).sum::<f64>() / (255.0 * scan.len() as f64));
                }
            }
        }
        assert!((found[0].score - best).abs() < 1e-9, "{} of {best}", found[0].score);
    }

    #[test]
    fn nowhere_to_be_is_no_match() {
        let grid = CorrelationGrid::new(&room(), 0.05).unwrap();
        let scan = seen_from(Pose::new(1.0, 1.0, 0.0));
        assert!(grid.search(&scan, SearchWindow::Everywhere, (3, 0.3, 0.5), |_| false).is_empty());
        assert!(CorrelationGrid::new(&[], 0.05).is_none());
    }
}

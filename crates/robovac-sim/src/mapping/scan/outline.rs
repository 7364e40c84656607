//! The outline of a map's obstacles, as points with normals.
//!
//! Cells make stairs of a wall that stands askew. A scanner sees such a wall as a line, and so does this module: the normal of a side
//! of a cell is that of the line through the sides before and behind it, on the way along the outline.

use super::{
    ScanPoint,
    points::{Line, REACH},
};
use crate::mapping::OccupancyMap;
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Cell, Grid, Occupancy, opened, reachable_from_any},
    math,
};

/// Fewest cells on either side that a line is fitted through.
const LEAST_REACH: f64 = 3.0;
/// Standard deviation of a line through a wall's cells, as a share of a cell.
const ROUGH: f64 = 0.15;
/// Least cosine between a side's own normal and that of its wall.
const LEAST_COSINE: f64 = 0.05;

/// Walls of measured plans can be hollow: a stroke on either side, and what looks like floor between them, into which no scanner
/// sees. Floor is at least so many cells wide.
const SLOT: usize = 2;
/// And it is connected with a place that is so wide, m.
const ROOM: f64 = 0.3;
/// Into a slot that begins at the floor, a scanner sees so many cells deep.
const DEPTH: usize = 3;
/// What tells on which side of a cell's border a point is, m.
const HAIR: f64 = 1e-6;

/// Steps to the neighbours of a cell.
const SIDES: [(i32, i32); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

/// A side of an occupied cell that faces a free one.
#[derive(Debug, Clone, Copy, PartialEq)]
struct OutlineSide {
    cell: Cell,
    facing: (i32, i32),
}

impl OutlineSide {
    fn middle(self, map: &OccupancyMap) -> Point {
        map.centre(self.cell) + vector(self.facing) * (0.5 * map.resolution())
    }

    /// The next side of the outline, and the way behind it.
    fn next(self, map: &OccupancyMap, along: (i32, i32)) -> Option<(Self, (i32, i32))> {
        let Self { cell, facing } = self;
        let before = shifted(cell, facing);
        let (beside, ahead) = (shifted(cell, along), shifted(before, along));
        let side = |cell, facing| Self { cell, facing };
        let (next, along) = match (map.occupancy(beside), map.occupancy(ahead)) {
            (_, Occupancy::Occupied) => (side(ahead, opposite(along)), facing),
            (Occupancy::Occupied, Occupancy::Free) => (side(beside, facing), along),
            (Occupancy::Free, Occupancy::Free) => (side(cell, along), opposite(facing)),
            // The rest is unknown.
            _ => return None,
        };
        Some((next, along))
    }

    /// The middles of the sides that follow within `reach`, m.
    fn following(self, map: &OccupancyMap, along: (i32, i32), reach: f64) -> Vec<Point> {
        let from = self.middle(map);
        let mut middles = Vec::new();
        let (mut at, mut along) = (self, along);
        while let Some((next, way)) = at.next(map, along) {
            let middle = next.middle(map);
            if next == self || (middle - from).norm_squared() > reach * reach {
                break;
            }
            middles.push(middle);
            (at, along) = (next, way);
        }
        middles
    }

    /// The normal of the line through the sides around this one; its own where they don't lie on a line.
    fn normal(self, map: &OccupancyMap) -> Vector {
        let own = vector(self.facing);
        let reach = REACH.max(LEAST_REACH * map.resolution());
        let left = (-self.facing.1, self.facing.0);
        let [left, right] = [left, opposite(left)].map(|along| self.following(map, along, reach));
        let middle = self.middle(map);
        let line = |points: [&[Point]; 2]| {
            let line = Line::through(points.into_iter().flatten().copied().chain([middle]))?;
            line.is_straight(ROUGH * map.resolution()).then_some(line)
        };
        // Beside a corner, the sides up to it still lie on a line.
        let line = line([&left, &right]).or_else(|| match (line([&left, &[]]), line([&right, &[]])) {
            (Some(left), Some(right)) => Some(if left.error() <= right.error() { left } else { right }),
            (left, right) => left.or(right),
        });
        let normal = line.map_or(own, |line| {
            let (sin, cos) = math::sin_cos(line.direction);
            Vector::new(-sin, cos)
        });
        let cosine = normal.dot(&own);
        if cosine.abs() < LEAST_COSINE { own } else { normal * cosine.signum() }
    }
}

fn vector((x, y): (i32, i32)) -> Vector {
    Vector::new(f64::from(x), f64::from(y))
}

fn shifted(cell: Cell, (x, y): (i32, i32)) -> Cell {
    Cell::new(cell.x + x, cell.y + y)
}

fn opposite((x, y): (i32, i32)) -> (i32, i32) {
    (-x, -y)
}

/// The floor of a map, as a grid whose lower left cell is `low`.
fn floor(map: &OccupancyMap, low: Cell, high: Cell) -> Grid<bool> {
    let mut free = Grid::filled((high.x - low.x + 1) as usize, (high.y - low.y + 1) as usize, false);
    for (cell, _) in map.iter().filter(|&(cell, _)| map.occupancy(cell) == Occupancy::Free) {
        free[shifted(cell, (-low.x, -low.y))] = true;
    }
    let open = opened(&free, SLOT);
    let room = (ROOM / map.resolution()).ceil().max(1.0) as usize;
    let mut floor = reachable_from_any(&open, &opened(&open, room));
    for _ in 0..DEPTH {
        let is_next =
            |&cell: &Cell| free[cell] && !floor[cell] && SIDES.iter().any(|&step| floor.is_set(shifted(cell, step)));
        let next: Vec<Cell> = free.iter().map(|(cell, _)| cell).filter(is_next).collect();
        for cell in next {
            floor[cell] = true;
        }
    }
    floor
}

/// Points on the outline of a map's obstacles: the middles of sides that face the floor.
pub(in crate::mapping) fn outline(map: &OccupancyMap) -> Vec<ScanPoint> {
    let Some((low, high)) = map.bounds() else { return Vec::new() };
    let floor = floor(map, low, high);
    let mut points = Vec::new();
    for (cell, _) in map.iter().filter(|&(cell, _)| map.occupancy(cell) == Occupancy::Occupied) {
        for facing in SIDES {
            if floor.is_set(shifted(shifted(cell, facing), (-low.x, -low.y))) {
                let side = OutlineSide { cell, facing };
                let deviation = 0.5 * map.resolution();
                // A hair in front, so that those of the two sides of a thin wall aren't taken for one place.
                let at = side.middle(map) + vector(facing) * HAIR;
                points.push(ScanPoint { at, normal: Some(side.normal(map)), deviation });
            }
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::{super::SurfaceMap, *};
    use robovac_core::{
        floor_plan::{Rect, Sketch},
        geometry::Pose,
    };

    #[test]
    fn stairs_of_a_wall_that_stands_askew_have_its_normal() {
        for degrees in [0.0_f64, 12.0, 30.0, 44.0, 71.0, 100.0, 200.0, 333.0] {
            let (sin, cos) = math::sin_cos(degrees.to_radians());
            let normal = Vector::new(-sin, cos);
            let corner = |along: f64, off: f64| (2.0 + cos * along - sin * off, 2.0 + sin * along + cos * off);
            let wall = [corner(-4.0, 0.0), corner(-4.0, -4.0), corner(4.0, -4.0), corner(4.0, 0.0)];
            let sketch = Sketch::open(4.0, 4.0, 0.05).polygon(&wall);
            let map = OccupancyMap::of(&sketch.finish("", ""));
            let inner = outline(&map).into_iter().filter(|point| (point.at - Point::new(2.0, 2.0)).norm() < 1.0);
            let off: Vec<f64> = inner.map(|point| point.normal.unwrap().dot(&normal)).collect();
            assert!(off.len() > 30, "{degrees}");
            assert!(off.iter().all(|&cosine| cosine > 0.98), "{degrees}: {off:?}");
        }
    }

    /// A room of 3 m x 2 m with more walls and openings in them.
    fn room(walls: &[Rect], openings: &[Rect]) -> Vec<ScanPoint> {
        outline(&OccupancyMap::of(&Sketch::open(3.0, 2.0, 0.05).fill(walls).carve(openings).finish("", "")))
    }

    fn inside(points: &[ScanPoint], [left, bottom, right, top]: Rect) -> usize {
        let is_inside = |point: &&ScanPoint| (left..right).contains(&point.at.x) && (bottom..top).contains(&point.at.y);
        points.iter().filter(is_inside).count()
    }

    #[test]
    fn what_is_in_a_hollow_wall_is_no_outline() {
        // Hollows of one cell, which is open to the room at its end, and of four cells.
        for hollow in [[1.05, 0.0, 1.1, 1.5], [1.05, 0.1, 1.25, 1.4]] {
            let wall = [1.0, 0.0, hollow[2] + 0.05, 1.5];
            let points = room(&[wall], &[hollow]);
            let [left, right] = [wall[0], wall[2]].map(|x| inside(&points, [x - 0.01, 0.0, x + 0.01, 1.5]));
            assert_eq!((left, right), (30, 30), "the sides of the wall");
            assert_eq!(inside(&points, [1.02, 0.0, wall[2] - 0.02, 1.34]), 0, "{hollow:?}");
        }
    }

    #[test]
    fn a_slot_that_is_not_deep_is_outline() {
        let points = room(&[[1.0, 0.0, 1.5, 1.0]], &[[1.2, 0.85, 1.25, 1.0]]);
        assert_eq!(inside(&points, [1.19, 0.84, 1.26, 0.99]), 7);
    }

    #[test]
    fn a_wall_of_one_cell_has_two_surfaces() {
        let points = room(&[[1.0, 0.0, 1.05, 1.5]], &[]);
        let surfaces = SurfaceMap::new(std::iter::once((Pose::new(0.0, 0.0, 0.0), &*points))).places();
        let beside = |x: f64| surfaces.iter().filter(|at| (at.x - x).abs() < 0.01 && at.y < 1.3).count();
        assert!(beside(1.0) > 20 && beside(1.05) > 20, "{} and {}", beside(1.0), beside(1.05));
    }
}

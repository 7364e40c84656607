//! Distance field: from each point of a map to the nearest obstacle.

use crate::mapping::OccupancyMap;
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Cell, Grid, Occupancy, clearance},
};

/// Largest distance of the field, m: beyond the range of a light bumper from the middle of a robot.
const FAR: f64 = 0.6;
/// Cells around the map, so that walls at its border have a free side.
const MARGIN: i32 = 2;
/// Largest depth inside obstacles, cells.
const DEEP: f32 = 2.0;
/// Distance to an obstacle at which a beam ends, m.
const TOUCH: f64 = 0.004;

/// Distance to the nearest occupied cell, m, as a continuous function of the place; negative inside.
#[derive(Debug, Clone)]
pub struct DistanceField {
    /// The map's cell that is the grid's lower left.
    low: Cell,
    resolution: f64,
    distance: Grid<f32>,
    /// Whether a cell is known to be free.
    free: Grid<bool>,
}

impl DistanceField {
    /// The field of a map; `None` without occupied cells. Unknown cells count as open.
    pub fn new(map: &OccupancyMap) -> Option<Self> {
        let (low, high) = map.bounds()?;
        let low = Cell::new(low.x - MARGIN, low.y - MARGIN);
        let size = [high.x - low.x + 1 + MARGIN, high.y - low.y + 1 + MARGIN].map(|n| n as usize);
        let mut blocked = Grid::filled(size[0], size[1], false);
        let mut free = blocked.clone();
        let mut count = 0;
        for (cell, _) in map.iter() {
            let index = blocked.index(Cell::new(cell.x - low.x, cell.y - low.y));
            match map.occupancy(cell) {
                Occupancy::Occupied => {
                    blocked.values_mut()[index] = true;
                    count += 1;
                }
                Occupancy::Free => free.values_mut()[index] = true,
                Occupancy::Unknown => {}
            }
        }
        let resolution = map.resolution();
        let limit = (FAR / resolution) as f32;
        // Negative inside obstacles, so that the interpolated value is 0 at their surface rather than in the middle of
        // their cells.
        let (outside, inside) = (clearance(&blocked, limit), clearance(&blocked.map(|&b| !b), DEEP));
        let metres = |(_, &out): (Cell, &f32), (_, &deep): (Cell, &f32)| (out - deep) * resolution as f32;
        let values = outside.iter().zip(inside.iter()).map(|(out, deep)| metres(out, deep)).collect();
        let distance = Grid::from_rows(size[0], values)?;
        (count > 0).then_some(Self { low, resolution, distance, free })
    }

    /// Distance from a point to the nearest obstacle, m, at most 0.6, negative inside of one; between the middles of cells, interpolated.
    #[inline]
    pub fn distance(&self, at: Point) -> f64 {
        let (x, y) = (at.x / self.resolution - 0.5, at.y / self.resolution - 0.5);
        let cell = Cell::new(robovac_core::math::floor(x), robovac_core::math::floor(y));
        let (u, v) = (x - f64::from(cell.x), y - f64::from(cell.y));
        let (i, j) = (cell.x - self.low.x, cell.y - self.low.y);
        if i < 0 || j < 0 {
            return 0.0;
        }
        let (width, index) = (self.distance.width(), j as usize * self.distance.width() + i as usize);
        let values = self.distance.values();
        if i as usize + 1 >= width || index + width + 1 >= values.len() {
            return 0.0;
        }
        let value = |index: usize| f64::from(values[index]);
        let low = value(index) * (1.0 - u) + value(index + 1) * u;
        let high = value(index + width) * (1.0 - u) + value(index + width + 1) * u;
        low * (1.0 - v) + high * v
    }

    /// Gradient of the distance, of any length; zero far from everything.
    #[inline]
    pub fn away(&self, at: Point) -> Vector {
        let step = 0.6 * self.resolution;
        let along = |d: Vector| self.distance(at + d) - self.distance(at - d);
        Vector::new(along(Vector::new(step, 0.0)), along(Vector::new(0.0, step)))
    }

    /// Length of a beam from `from` in a direction of unit length, m; `None` if it hits nothing within `range`.
    #[inline]
    pub fn ray(&self, from: Point, direction: Vector, range: f64) -> Option<f64> {
        let mut gone = 0.0;
        while gone < range {
            let room = self.distance(from + direction * gone);
            if room < TOUCH {
                return Some(gone);
            }
            // The interpolated distance can be a little too large.
            gone += (0.9 * room).max(TOUCH);
        }
        None
    }

    /// Centres of known free cells at least that far from everything, m.
    pub fn places(&self, least: f64) -> Vec<Point> {
        let cells = self.free.iter().filter(|(_, is_free)| **is_free);
        let cells = cells.map(|(cell, _)| Cell::new(cell.x + self.low.x, cell.y + self.low.y).centre(self.resolution));
        cells.filter(|&at| self.distance(at) >= least).collect()
    }

    /// Side of its cells, m.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::floor_plan::{FloorPlan, SourceFile, load};

    fn plan(picture: &str) -> FloorPlan {
        let file = SourceFile { name: "a.txt".to_owned(), bytes: picture.as_bytes().to_vec() };
        let mut plan = load(&[file]).unwrap();
        plan.resolution = 0.1;
        plan
    }

    #[test]
    fn distances_rays_and_normals_of_a_corridor() {
        let picture = "##########\n#........#\n#........#\n#........#\n#........#\n##########";
        let field = DistanceField::new(&OccupancyMap::of(&plan(picture))).unwrap();
        // The floor is from 0.1 to 0.5 m upwards. On the ridge in its middle, interpolation cuts the top off.
        let middle = Point::new(0.45, 0.2);
        assert!((field.distance(middle) - 0.1).abs() < 0.02, "{}", field.distance(middle));
        let down = field.ray(Point::new(0.45, 0.28), Vector::new(0.0, -1.0), 0.3).unwrap();
        assert!((down - 0.18).abs() < 0.02, "{down}");
        assert_eq!(field.ray(Point::new(0.45, 0.3), Vector::new(0.0, -1.0), 0.1), None);
        let away = field.away(Point::new(0.45, 0.16));
        assert!(away.y > 0.0 && away.x.abs() < 1e-6);
        assert_eq!(field.places(0.14).len(), 2 * 6);
        assert_eq!(field.distance(Point::new(-9.0, 1.0)), 0.0);
    }
}

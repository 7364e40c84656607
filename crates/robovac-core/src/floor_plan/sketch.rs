//! Draws floor plans from rectangles, discs and polygons in metres.

use super::{FloorPlan, Object};
use crate::{
    geometry::{Point, Pose},
    grid::{Cell, Grid, Occupancy},
};

/// Left, bottom, right and top edge, m from the lower-left corner of the plan.
pub type Rect = [f64; 4];

/// Radius of a chair's or table's leg, m: on usual grids just the cell that it stands in.
const LEG: f64 = 0.02;
/// Distance of a recessed dock's back behind the surface, m: the whole back, 2 cm deep, is inside, and a robot that touches
/// the surface touches the contacts.
const RECESS: f64 = 0.025;

/// A floor plan under construction. Parts outside the plan are clipped.
///
/// ```
/// use robovac_core::{floor_plan::Sketch, grid::picture};
/// let plan = Sketch::open(1.0, 0.6, 0.2).fill(&[[0.0, 0.0, 0.4, 0.2]]).disc(0.7, 0.5, 0.05).finish("Shed", "");
/// assert_eq!(picture(&plan.blocked(), |&b| if b { '#' } else { '.' }), "...#.\n.....\n##...\n");
/// ```
#[derive(Debug, Clone)]
pub struct Sketch {
    resolution: f64,
    occupancy: Grid<Occupancy>,
    objects: Vec<Object>,
    start: Option<Pose>,
}

impl Sketch {
    /// Free floor of `width` x `height` metres in cells of `resolution` metres, at least one cell.
    pub fn open(width: f64, height: f64, resolution: f64) -> Self {
        Self::filled(width, height, resolution, Occupancy::Free)
    }

    /// Solid wall, to carve rooms out of.
    pub fn solid(width: f64, height: f64, resolution: f64) -> Self {
        Self::filled(width, height, resolution, Occupancy::Occupied)
    }

    fn filled(width: f64, height: f64, resolution: f64, value: Occupancy) -> Self {
        let cells = |length: f64| ((length / resolution).round() as usize).max(1);
        let occupancy = Grid::filled(cells(width), cells(height), value);
        Self { resolution, occupancy, objects: Vec::new(), start: None }
    }

    /// Walls or solid furniture.
    pub fn fill(self, rects: &[Rect]) -> Self {
        rects.iter().fold(self, |sketch, rect| sketch.paint_rect(rect, Occupancy::Occupied))
    }

    /// Free floor: rooms, and doors in walls.
    pub fn carve(self, rects: &[Rect]) -> Self {
        rects.iter().fold(self, |sketch, rect| sketch.paint_rect(rect, Occupancy::Free))
    }

    /// Solid squares of `side` metres where `free` isn't set, from the lower-left corner on.
    pub fn blocks(self, free: &Grid<bool>, side: f64) -> Self {
        free.iter().filter(|&(_, &free)| !free).fold(self, |sketch, (cell, _)| {
            let (x, y) = (f64::from(cell.x) * side, f64::from(cell.y) * side);
            sketch.paint_rect(&[x, y, x + side, y + side], Occupancy::Occupied)
        })
    }

    /// Repeats a drawing: `draw` is called with each position, from `first` on in (number, distance in m) columns and
    /// rows.
    pub fn repeat(
        self,
        first: (f64, f64),
        (columns, dx): (u32, f64),
        (rows, dy): (u32, f64),
        draw: fn(Self, f64, f64) -> Self,
    ) -> Self {
        (0..columns * rows).fold(self, |sketch, i| {
            let (column, row) = (f64::from(i % columns), f64::from(i / columns));
            draw(sketch, first.0 + column * dx, first.1 + row * dy)
        })
    }

    /// A round obstacle around (`x`, `y`), at least the cell of its centre.
    pub fn disc(mut self, x: f64, y: f64, radius: f64) -> Self {
        self.paint(Cell::at(Point::new(x, y), self.resolution), Occupancy::Occupied);
        self.paint_where(|px, py| (px - x) * (px - x) + (py - y) * (py - y) <= radius * radius);
        self
    }

    /// An obstacle with these corners; where its edges cross, every other part is left out (even-odd rule).
    pub fn polygon(mut self, corners: &[(f64, f64)]) -> Self {
        let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
        self.paint_where(|x, y| {
            let crosses = |&(a, b): &(&(f64, f64), &(f64, f64))| {
                (a.1 > y) != (b.1 > y) && x < a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0)
            };
            edges().filter(crosses).count() % 2 == 1
        });
        self
    }

    /// Four thin legs in the corners of a chair or table.
    pub fn legs(self, rects: &[Rect]) -> Self {
        rects.iter().fold(self, |sketch, &[left, bottom, right, top]| {
            [(left, bottom), (right, bottom), (left, top), (right, top)].into_iter().fold(sketch, |sketch, (x, y)| {
                let towards = |edge: f64, other: f64| edge + LEG.copysign(other - edge);
                let (x, y) = (towards(x, f64::midpoint(left, right)), towards(y, f64::midpoint(bottom, top)));
                sketch.disc(x, y, LEG)
            })
        })
    }

    /// A dock recessed in a wall or in furniture, whose surface is at (`x`, `y`), facing `heading_deg`: it takes no floor.
    pub fn recessed_dock(mut self, x: f64, y: f64, heading_deg: f64) -> Self {
        let surface = Pose::new(x, y, heading_deg.to_radians());
        let back = surface.to_world(Point::new(-RECESS, 0.0));
        self.objects.push(Object::Dock { pose: Pose::new(back.x, back.y, surface.heading) });
        self
    }

    /// Start of the robot; heading in degrees, counter-clockwise from the right.
    pub fn start(mut self, x: f64, y: f64, heading_deg: f64) -> Self {
        self.start = Some(Pose::new(x, y, heading_deg.to_radians()));
        self
    }

    /// The plan as drawn.
    pub fn finish(self, name: &str, note: &str) -> FloorPlan {
        FloorPlan {
            name: name.to_owned(),
            note: note.to_owned(),
            resolution: self.resolution,
            occupancy: self.occupancy,
            objects: self.objects,
            start: self.start,
            origin: Pose::new(0.0, 0.0, 0.0),
        }
    }

    /// Edges go to the nearest grid line; a rectangle thinner than a cell still gets one.
    fn paint_rect(mut self, &[left, bottom, right, top]: &Rect, value: Occupancy) -> Self {
        let line = |metres: f64| (metres / self.resolution).round() as i32;
        let columns = line(left)..line(right).max(line(left) + 1);
        let rows = line(bottom)..line(top).max(line(bottom) + 1);
        for y in rows {
            for x in columns.clone() {
                self.paint(Cell::new(x, y), value);
            }
        }
        self
    }

    /// Makes an obstacle of all cells whose centre lies `inside`.
    fn paint_where(&mut self, inside: impl Fn(f64, f64) -> bool) {
        let centre = |index: i32| (f64::from(index) + 0.5) * self.resolution;
        let hits: Vec<Cell> =
            self.occupancy.iter().map(|(c, _)| c).filter(|c| inside(centre(c.x), centre(c.y))).collect();
        for cell in hits {
            self.paint(cell, Occupancy::Occupied);
        }
    }

    fn paint(&mut self, cell: Cell, value: Occupancy) {
        if self.occupancy.contains(cell) {
            self.occupancy[cell] = value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::picture;

    fn draw(sketch: Sketch) -> String {
        picture(&sketch.finish("", "").blocked(), |&b| if b { '#' } else { '.' })
    }

    #[test]
    fn edges_snap_to_grid_lines_despite_rounding_errors() {
        // 0.15 / 0.05 is a little less than 3.
        assert_eq!(draw(Sketch::open(0.4, 0.1, 0.05).fill(&[[0.15, 0.0, 0.3, 0.1]])), "...###..\n...###..\n");
    }

    #[test]
    fn thin_and_protruding_things_are_still_drawn() {
        assert_eq!(draw(Sketch::open(0.4, 0.2, 0.1).fill(&[[0.1, -1.0, 0.11, 9.0]])), ".#..\n.#..\n");
        assert_eq!(draw(Sketch::open(0.4, 0.2, 0.1).disc(9.0, 9.0, 0.1)), "....\n....\n");
    }

    #[test]
    fn legs_stand_inside_the_corners() {
        assert_eq!(draw(Sketch::open(0.5, 0.4, 0.1).legs(&[[0.1, 0.1, 0.4, 0.4]])), ".#.#.\n.....\n.#.#.\n.....\n");
    }

    #[test]
    fn polygon_fills_its_inside() {
        let triangle = [(0.0, 0.0), (0.4, 0.0), (0.0, 0.4)];
        assert_eq!(draw(Sketch::open(0.4, 0.4, 0.1).polygon(&triangle)), "....\n#...\n##..\n###.\n");
    }
}

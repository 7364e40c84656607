//! Ray casting: the first obstacle on a beam.

use super::Walls;
use crate::{
    geometry::{Point, Shape, Vector, edges},
    grid::Cell,
};

/// The end of a ray.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayHit {
    /// Distance from where the ray began, m; 0 if that is inside.
    pub distance: f64,
    /// Cosine of the angle between the ray and the surface's normal, 0 for a ray that grazes it to 1.
    pub cosine: f64,
    /// The surface.
    pub surface: Surface,
}

/// Kinds of surfaces that reflect light.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surface {
    /// A wall of the plan's grid.
    Wall,
    /// An object that stands in the room.
    Object,
    /// A mover's foot.
    Mover,
}

impl Walls {
    /// The first obstacle on a ray from `from` in the direction of the unit vector `direction` within `reach` metres;
    /// exact, like [`Walls::nearest`].
    ///
    /// It goes from cell to cell (Amanatides & Woo 1987), and in the open from one side of the largest free square
    /// around a cell to the other. In the first cell that an object touches, all objects that can be in the way are
    /// tested.
    pub fn ray(&self, from: Point, direction: Vector, reach: f64) -> Option<RayHit> {
        let size = self.resolution;
        let mut walk = RayWalk::new(from, direction, size);
        let mut reach = reach;
        // The nearest object, once there may be one.
        let mut object = None;
        let mut has_looked = false;
        while walk.travelled * size < reach {
            let moves = self.moves_from(walk.cell);
            if moves == 0 {
                let travelled = walk.travelled * size;
                if self.squares().get(walk.cell) != Some(&false) {
                    return Some(RayHit { distance: travelled, cosine: walk.cosine, surface: Surface::Wall });
                }
                if !has_looked {
                    has_looked = true;
                    object = self.first_object(from, direction, travelled, reach);
                    reach = object.map_or(reach, |hit: RayHit| hit.distance);
                }
            }
            walk.leave_square(moves.max(1));
        }
        object
    }

    /// The first object on a ray between `near` and `far` metres from its origin.
    fn first_object(&self, from: Point, direction: Vector, near: f64, far: f64) -> Option<RayHit> {
        let ends = [from + direction * near, from + direction * far];
        let mut first: Option<RayHit> = None;
        self.shapes_in_box(ends[0].inf(&ends[1]), ends[0].sup(&ends[1]), |shape| {
            let hit = match shape {
                Shape::Disc { centre, radius } => RayHit::on_disc(*centre - from, *radius, direction, Surface::Object),
                Shape::Convex(corners) => RayHit::on_convex(corners, from, direction),
            };
            if let Some(hit) = hit.filter(|hit| hit.distance < first.map_or(far, |first| first.distance)) {
                first = Some(hit);
            }
        });
        first
    }
}

impl RayHit {
    /// The hit of a ray in `direction` on a disc whose centre is `centre` away from the ray's origin.
    pub fn on_disc(centre: Vector, radius: f64, direction: Vector, surface: Surface) -> Option<Self> {
        let along = centre.dot(&direction);
        let outside = centre.norm_squared() - radius * radius;
        if outside <= 0.0 {
            return Some(Self { distance: 0.0, cosine: 1.0, surface });
        }
        let under_root = along * along - outside;
        if along <= 0.0 || under_root <= 0.0 {
            return None;
        }
        let half_chord = under_root.sqrt();
        // Half the chord over the radius is the cosine at which the ray enters.
        Some(Self { distance: along - half_chord, cosine: half_chord / radius, surface })
    }

    /// The hit of a ray on a convex polygon with counter-clockwise corners (Cyrus & Beck 1978).
    fn on_convex(corners: &[Point], from: Point, direction: Vector) -> Option<Self> {
        let (mut enter, mut leave, mut cosine) = (0.0, f64::INFINITY, 1.0);
        for (a, b) in edges(corners) {
            let along = b - a;
            // Positive outside, and where the ray goes outward.
            let (height, climb) = (-along.perp(&(from - a)), -along.perp(&direction));
            if climb < 0.0 {
                let distance = -height / climb;
                if distance > enter {
                    (enter, cosine) = (distance, -climb / along.norm());
                }
            } else if climb > 0.0 {
                leave = (-height / climb).min(leave);
            } else if height > 0.0 {
                return None;
            }
        }
        (enter < leave).then_some(Self { distance: enter, cosine, surface: Surface::Object })
    }
}

/// A ray traversing cells. Lengths are in cells.
struct RayWalk {
    from: Point,
    direction: Vector,
    /// Length of the ray for a step along each axis; infinite for an axis perpendicular to it.
    stride: Vector,
    cell: Cell,
    /// Distance at which the ray entered the cell.
    travelled: f64,
    /// Cosine of the angle at which it crossed the cell's edge.
    cosine: f64,
}

impl RayWalk {
    #[inline]
    fn new(from: Point, direction: Vector, size: f64) -> Self {
        let (from, stride) = (from / size, Vector::new(1.0 / direction.x, 1.0 / direction.y));
        Self { from, direction, stride, cell: Cell::at(from, 1.0), travelled: 0.0, cosine: 1.0 }
    }

    /// Moves on to the first cell outside the square of cells less than `moves` king's moves away, which is free but
    /// for its centre.
    #[inline]
    fn leave_square(&mut self, moves: i32) {
        let Self { from, direction, stride, cell, .. } = *self;
        // The first column and row beyond the square, and where the ray crosses into them.
        let (column, in_x) = beyond(cell.x, moves, from.x, direction.x, stride.x);
        let (row, in_y) = beyond(cell.y, moves, from.y, direction.y, stride.y);
        // The cells of a ray are in order along both axes, despite rounding.
        if in_x < in_y {
            self.travelled = in_x.max(self.travelled);
            self.cosine = direction.x.abs();
            self.cell = Cell::new(column, onward(cell.y, from.y + direction.y * in_x, direction.y));
        } else {
            self.travelled = in_y.max(self.travelled);
            self.cosine = direction.y.abs();
            self.cell = Cell::new(onward(cell.x, from.x + direction.x * in_y, direction.x), row);
        }
    }
}

/// The first column (or row) that is `moves` away from column `cell`, and the distance at which a ray crosses into it, along
/// one axis.
#[inline]
fn beyond(cell: i32, moves: i32, from: f64, direction: f64, stride: f64) -> (i32, f64) {
    if direction > 0.0 {
        (cell + moves, (f64::from(cell + moves) - from) * stride)
    } else if direction < 0.0 {
        (cell - moves, (f64::from(cell - moves + 1) - from) * stride)
    } else {
        (cell, f64::INFINITY)
    }
}

/// The column (or row) at `place`, which lies inside the grid, or `cell` if it isn't before that.
#[inline]
fn onward(cell: i32, place: f64, direction: f64) -> i32 {
    if direction > 0.0 { cell.max(place as i32) } else { cell.min(place as i32) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{grid::Grid, math};
    use proptest::prelude::*;

    const SIZE: f64 = 0.05;

    fn walls(squares: Grid<bool>, shapes: Vec<Shape>) -> Walls {
        Walls::new(squares, shapes, SIZE, 0.15)
    }

    #[test]
    fn the_outside_is_wall() {
        let walls = walls(Grid::filled(20, 20, false), Vec::new());
        let hit = walls.ray(Point::new(0.3, 0.4), Vector::new(1.0, 0.0), 5.0).unwrap();
        assert!((hit.distance - 0.7).abs() < 1e-12 && hit.cosine == 1.0, "{hit:?}");
        let slanted = walls.ray(Point::new(0.5, 0.5), Vector::new(0.6, -0.8), 5.0).unwrap();
        assert!((slanted.distance - 0.625).abs() < 1e-12 && (slanted.cosine - 0.8).abs() < 1e-12, "{slanted:?}");
        assert_eq!(walls.ray(Point::new(0.3, 0.4), Vector::new(1.0, 0.0), 0.69), None);
    }

    #[test]
    fn a_leg_is_met_at_its_bark() {
        let leg = Shape::Disc { centre: Point::new(0.71, 0.52), radius: 0.02 };
        let walls = walls(Grid::filled(20, 20, false), vec![leg]);
        let hit = walls.ray(Point::new(0.2, 0.52), Vector::new(1.0, 0.0), 5.0).unwrap();
        assert!((hit.distance - 0.49).abs() < 1e-12 && hit.surface == Surface::Object, "{hit:?}");
        // Past it, through the cells that it touches.
        let past = walls.ray(Point::new(0.2, 0.545), Vector::new(1.0, 0.0), 5.0).unwrap();
        assert!((past.distance - 0.8).abs() < 1e-12 && past.surface == Surface::Wall, "{past:?}");
    }

    /// First entry into the square of a cell.
    fn enter_square(cell: Cell, from: Point, direction: Vector) -> f64 {
        let (mut enter, mut leave) = (0.0_f64, f64::INFINITY);
        for (low, from, d) in [(cell.x, from.x, direction.x), (cell.y, from.y, direction.y)] {
            let ends = [(f64::from(low) * SIZE - from) / d, (f64::from(low + 1) * SIZE - from) / d];
            enter = enter.max(ends[0].min(ends[1]));
            leave = leave.min(ends[0].max(ends[1]));
        }
        if enter <= leave { enter } else { f64::INFINITY }
    }

    proptest! {
        /// Against the first entry into any square, and a walk in small steps until a shape holds the point.
        #[test]
        fn agrees_with_everything_tried_in_turn(
            bits in proptest::collection::vec(proptest::bool::weighted(0.03), 23 * 17),
            x in 0.0_f64..1.15, y in 0.0_f64..0.85, angle in 0.0..math::TAU, reach in 0.05_f64..1.5,
            a in (0.1_f64..1.0, 0.1_f64..0.7), b in (0.1_f64..1.0, 0.1_f64..0.7), radius in 0.002_f64..0.1,
        ) {
            let squares = Grid::from_rows(23, bits).unwrap();
            let (from, direction) = (Point::new(x, y), Vector::new(math::cos(angle), math::sin(angle)));
            let corner = Point::new(a.0, a.1);
            let triangle = vec![corner, corner + Vector::new(0.3, 0.1), corner + Vector::new(0.1, 0.2)];
            let shapes = vec![Shape::Convex(triangle), Shape::Disc { centre: Point::new(b.0, b.1), radius }];
            let mut nearest = f64::INFINITY;
            for cell in (-1..=17).flat_map(|row| (-1..=23).map(move |column| Cell::new(column, row))) {
                if squares.get(cell) != Some(&false) {
                    nearest = nearest.min(enter_square(cell, from, direction));
                }
            }
            let step = 1e-4;
            let in_shape = (0..15_000).map(|i| f64::from(i) * step).find(|&t| {
                shapes.iter().any(|shape| shape.contains(from + direction * t))
            });
            nearest = nearest.min(in_shape.unwrap_or(f64::INFINITY));
            let found = walls(squares, shapes).ray(from, direction, 2.0).map_or(f64::INFINITY, |h| h.distance);
            // A grazed corner may be stepped over.
            let is_near = found == nearest || (found - nearest).abs() < 2.0 * step;
            let is_grazed = found < nearest;
            prop_assert!(is_near || is_grazed, "{} {}", found, nearest);
            let within = walls(Grid::filled(23, 17, false), Vec::new()).ray(from, direction, reach);
            prop_assert!(within.is_none_or(|hit| hit.distance < reach));
        }
    }
}

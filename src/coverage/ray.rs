//! Rays: what a beam that leaves a robot meets first.

use super::Walls;
use crate::{
    geometry::{Point, Vector},
    grid::Cell,
};

/// Room, in cells, from which a ray jumps instead of going from cell to cell.
const WORTH_JUMPING: f64 = 1.5;

/// What a ray met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Distance from where the ray began, m; 0 if that is in a wall.
    pub distance: f64,
    /// Cosine of the angle between the ray and the surface's normal, 0 for a ray that grazes it to 1.
    pub cosine: f64,
}

impl Walls {
    /// What a ray from `from` in the direction of the unit vector `direction` meets within `reach` metres: exact, as
    /// [`Walls::nearest`] is.
    ///
    /// In the open it jumps as far as nothing can be in the way (sphere tracing, Hart 1996); near walls it goes from
    /// cell to cell (Amanatides & Woo 1987).
    pub fn ray(&self, from: Point, direction: Vector, reach: f64) -> Option<Hit> {
        let size = self.resolution;
        let mut walk = Walk::new(from, direction, size);
        loop {
            let clearance = self.clearance.get(walk.cell).map_or(0.0, |&c| f64::from(c));
            if clearance <= 0.0 {
                if self.squares().get(walk.cell).copied().unwrap_or(true) {
                    return Some(Hit { distance: walk.travelled, cosine: walk.cosine });
                }
                if let Some(hit) = self.shape_in_cell(&walk) {
                    return (hit.distance < reach).then_some(hit);
                }
            }
            let room = clearance - 0.7072 * size;
            if room > WORTH_JUMPING * size {
                walk.jump(walk.travelled + room);
            } else {
                walk.step();
            }
            if walk.travelled >= reach {
                return None;
            }
        }
    }

    /// The nearest shape that a ray enters in the cell that it has come to.
    fn shape_in_cell(&self, walk: &Walk) -> Option<Hit> {
        let leaves = walk.next[0].min(walk.next[1]) + 1e-9;
        let low = Point::new(f64::from(walk.cell.x), f64::from(walk.cell.y)) * self.resolution;
        let mut nearest: Option<Hit> = None;
        self.shapes_in_box(low, low + Vector::new(self.resolution, self.resolution), |shape| {
            let entry = shape.entry(walk.from, walk.direction).filter(|&(distance, _)| distance <= leaves);
            let Some((distance, cosine)) = entry else { return };
            if nearest.is_none_or(|hit| distance < hit.distance) {
                nearest = Some(Hit { distance, cosine });
            }
        });
        nearest
    }

    /// Whether no wall is in the way from one point to the other. What is nearer than `slack` metres to the second doesn't
    /// count: so things that lean on a wall are seen.
    pub fn is_in_sight(&self, from: Point, to: Point, slack: f64) -> bool {
        let way = to - from;
        let distance = way.norm();
        distance <= slack || self.ray(from, way / distance, distance - slack).is_none()
    }
}

/// A ray on its way from cell to cell.
struct Walk {
    from: Point,
    direction: Vector,
    size: f64,
    cell: Cell,
    /// Distance at which the ray entered the cell, m.
    travelled: f64,
    /// Cosine of the angle at which it crossed the cell's edge.
    cosine: f64,
    /// Distances at which it crosses the next column and row, m.
    next: [f64; 2],
}

impl Walk {
    fn new(from: Point, direction: Vector, size: f64) -> Self {
        let mut walk =
            Self { from, direction, size, cell: Cell::new(0, 0), travelled: 0.0, cosine: 1.0, next: [0.0; 2] };
        walk.jump(0.0);
        walk
    }

    /// On to the point at `distance`, over cells that are known to be free.
    #[inline]
    fn jump(&mut self, distance: f64) {
        self.travelled = distance;
        self.cell = Cell::at(self.from + self.direction * distance, self.size);
        self.next = [
            crossing(self.cell.x, self.from.x, self.direction.x, self.size),
            crossing(self.cell.y, self.from.y, self.direction.y, self.size),
        ];
    }

    /// Into the next cell.
    #[inline]
    fn step(&mut self) {
        let (x, y) = (self.direction.x, self.direction.y);
        if self.next[0] < self.next[1] {
            self.travelled = self.next[0].max(self.travelled);
            self.cosine = x.abs();
            self.cell.x += if x > 0.0 { 1 } else { -1 };
            self.next[0] += self.size / x.abs();
        } else {
            self.travelled = self.next[1].max(self.travelled);
            self.cosine = y.abs();
            self.cell.y += if y > 0.0 { 1 } else { -1 };
            self.next[1] += self.size / y.abs();
        }
    }
}

/// Distance at which a ray leaves column (or row) `cell`, along one axis.
#[inline]
fn crossing(cell: i32, from: f64, direction: f64, size: f64) -> f64 {
    if direction == 0.0 {
        return f64::INFINITY;
    }
    let edge = f64::from(cell + i32::from(direction > 0.0)) * size;
    (edge - from) / direction
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{geometry::Shape, grid::Grid, math};
    use proptest::prelude::*;

    fn walls(blocked: &Grid<bool>) -> Walls {
        Walls::new(blocked.clone(), Vec::new(), 0.05, 0.15)
    }

    #[test]
    fn the_outside_is_wall() {
        let walls = walls(&Grid::filled(20, 20, false));
        let hit = walls.ray(Point::new(0.3, 0.4), Vector::new(1.0, 0.0), 5.0).unwrap();
        assert!((hit.distance - 0.7).abs() < 1e-12 && hit.cosine == 1.0, "{hit:?}");
        let slanted = walls.ray(Point::new(0.5, 0.5), Vector::new(0.6, -0.8), 5.0).unwrap();
        assert!((slanted.distance - 0.625).abs() < 1e-12 && (slanted.cosine - 0.8).abs() < 1e-12, "{slanted:?}");
        assert_eq!(walls.ray(Point::new(0.3, 0.4), Vector::new(1.0, 0.0), 0.69), None);
    }

    #[test]
    fn legs_and_furniture_are_met_where_they_are() {
        let leg = Shape::Disc { centre: Point::new(0.61, 0.4), radius: 0.01 };
        let triangle = [[0.3, 0.7], [0.9, 0.7], [0.3, 0.95]].map(|[x, y]| Point::new(x, y)).to_vec();
        let walls = Walls::new(Grid::filled(20, 20, false), vec![leg, Shape::Convex(triangle)], 0.05, 0.15);
        let ahead = |y: f64| walls.ray(Point::new(0.1, y), Vector::new(1.0, 0.0), 5.0).unwrap().distance;
        assert!((ahead(0.4) - 0.5).abs() < 1e-12 && (ahead(0.415) - 0.9).abs() < 1e-12);
        let down = walls.ray(Point::new(0.6, 0.99), Vector::new(0.0, -1.0), 5.0).unwrap();
        // The slanted side is at y = 0.825 there, and turned by atan(0.25 / 0.6).
        assert!((down.distance - 0.165).abs() < 1e-9 && (down.cosine - 0.6 / 0.65).abs() < 1e-9, "{down:?}");
        assert_eq!(walls.ray(Point::new(0.1, 0.4), Vector::new(1.0, 0.0), 0.49), None);
    }

    #[test]
    fn what_leans_on_a_wall_is_in_sight() {
        let walls = walls(&Grid::filled(20, 20, false));
        let (from, to) = (Point::new(0.5, 0.5), Point::new(1.01, 0.5));
        assert!(walls.is_in_sight(from, to, 0.03) && !walls.is_in_sight(from, to, 0.0));
    }

    proptest! {
        /// Against the closest entry into any blocked square.
        #[test]
        fn agrees_with_all_squares_tried_in_turn(
            bits in proptest::collection::vec(proptest::bool::weighted(0.05), 23 * 17),
            x in 0.0_f64..1.15, y in 0.0_f64..0.85, angle in 0.0..math::TAU, reach in 0.05_f64..1.5,
        ) {
            let blocked = Grid::from_rows(23, bits).unwrap();
            let (from, direction) = (Point::new(x, y), Vector::new(math::cos(angle), math::sin(angle)));
            let mut nearest = f64::INFINITY;
            for row in -1..=17 {
                for column in -1..=23 {
                    if blocked.get(Cell::new(column, row)) != Some(&false) {
                        let (mut enter, mut leave) = (0.0_f64, f64::INFINITY);
                        for (low, from, d) in [(column, x, direction.x), (row, y, direction.y)] {
                            let ends = [(f64::from(low) * 0.05 - from) / d, (f64::from(low + 1) * 0.05 - from) / d];
                            enter = enter.max(ends[0].min(ends[1]));
                            leave = leave.min(ends[0].max(ends[1]));
                        }
                        if enter <= leave {
                            nearest = nearest.min(enter);
                        }
                    }
                }
            }
            let distance = walls(&blocked).ray(from, direction, reach).map_or(f64::INFINITY, |h| h.distance);
            let expected = if nearest < reach { nearest } else { f64::INFINITY };
            prop_assert!(distance == expected || (distance - expected).abs() < 1e-9, "{} {}", distance, expected);
        }
    }
}

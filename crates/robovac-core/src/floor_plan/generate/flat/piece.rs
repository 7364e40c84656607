//! A piece of furniture and how it stands.

use super::{
    CELL,
    area::{Area, Side},
};
use crate::{
    floor_plan::Object,
    geometry::{Point, Pose},
    math,
};

/// Furniture in a frame of its own: u along its back, from the left as it looks into the room, v away from its back.
#[derive(Debug, Clone, Default)]
pub(super) struct Piece {
    /// Width and depth of the floor that it claims, cells.
    pub size: (i32, i32),
    /// Depth of the floor before it that stays clear of other furniture, cells.
    pub front: i32,
    pub parts: Vec<FurniturePart>,
}

/// A part of a piece.
#[derive(Debug, Clone)]
pub(super) enum FurniturePart {
    /// What stands flush on the floor: left, near, right and far edge, cells.
    Solid([i32; 4]),
    /// A leg or anything else that is round: its centre and radius, m.
    Round([f64; 2], f64),
    /// What stands at an angle or is thinner than a cell: its corners, m.
    Slab(Vec<[f64; 2]>),
    /// A rug, cells.
    Rug([i32; 4]),
    /// The robot's dock, the middle of its back, m.
    Dock([f64; 2]),
}

/// Where a piece stands: the floor that it claims, and the wall that its back is at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stand {
    pub area: Area,
    pub back: Side,
}

impl Piece {
    pub fn new(width: i32, depth: i32) -> Self {
        Self { size: (width, depth), ..Self::default() }
    }

    /// A block that takes all its floor.
    pub fn block(width: i32, depth: i32) -> Self {
        Self::new(width, depth).solid([0, 0, width, depth])
    }

    pub fn front(mut self, front: i32) -> Self {
        self.front = front;
        self
    }

    pub fn solid(mut self, edges: [i32; 4]) -> Self {
        self.parts.push(FurniturePart::Solid(edges));
        self
    }

    pub fn rug(mut self, edges: [i32; 4]) -> Self {
        self.parts.push(FurniturePart::Rug(edges));
        self
    }

    pub fn round(mut self, u: f64, v: f64, radius: f64) -> Self {
        self.parts.push(FurniturePart::Round([u, v], radius));
        self
    }

    /// Four legs of that radius in the corners of a rectangle of cells.
    pub fn legs(self, edges: [i32; 4], radius: f64) -> Self {
        let inset = radius + 0.02;
        let [left, near, right, far] = edges.map(|cells| f64::from(cells) * CELL);
        let corners = [(left + inset, near + inset), (right - inset, near + inset)];
        let corners = corners.into_iter().chain([(left + inset, far - inset), (right - inset, far - inset)]);
        corners.fold(self, |piece, (u, v)| piece.round(u, v, radius))
    }

    /// The legs of a chair `side` metres wide around a point, turned by `angle`.
    pub fn chair(self, (u, v): (f64, f64), side: f64, angle: f64) -> Self {
        turned_square(side - 0.04, angle).into_iter().fold(self, |piece, [du, dv]| piece.round(u + du, v + dv, 0.016))
    }

    /// A square of `side` metres around a point, turned by `angle`.
    pub fn turned(mut self, (u, v): (f64, f64), side: f64, angle: f64) -> Self {
        self.parts.push(FurniturePart::Slab(turned_square(side, angle).map(|[du, dv]| [u + du, v + dv]).to_vec()));
        self
    }
}

fn turned_square(side: f64, angle: f64) -> [[f64; 2]; 4] {
    let (sin, cos) = math::sin_cos(angle);
    let half = 0.5 * side;
    [[-half, -half], [half, -half], [half, half], [-half, half]].map(|[u, v]| [u * cos - v * sin, u * sin + v * cos])
}

impl Stand {
    /// The floor before it.
    pub fn front(&self, depth: i32) -> Area {
        let Area { left, bottom, right, top } = self.area;
        match self.back {
            Side::Bottom => Area::new(left, top, right, top + depth),
            Side::Top => Area::new(left, bottom - depth, right, bottom),
            Side::Left => Area::new(right, bottom, right + depth, top),
            Side::Right => Area::new(left - depth, bottom, left, top),
        }
    }

    /// A rectangle of the piece on the plan.
    pub fn area(&self, [left, near, right, far]: [i32; 4]) -> Area {
        let all = self.area;
        match self.back {
            Side::Bottom => Area::new(all.left + left, all.bottom + near, all.left + right, all.bottom + far),
            Side::Top => Area::new(all.right - right, all.top - far, all.right - left, all.top - near),
            Side::Left => Area::new(all.left + near, all.top - right, all.left + far, all.top - left),
            Side::Right => Area::new(all.right - far, all.bottom + left, all.right - near, all.bottom + right),
        }
    }

    /// A point of the piece on the plan, m.
    pub fn point(&self, [u, v]: [f64; 2]) -> Point {
        let [left, bottom, right, top] = self.area.metres();
        match self.back {
            Side::Bottom => Point::new(left + u, bottom + v),
            Side::Top => Point::new(right - u, top - v),
            Side::Left => Point::new(left + v, top - u),
            Side::Right => Point::new(right - v, bottom + u),
        }
    }

    /// A place on the plan that looks into the room.
    pub fn pose(&self, at: [f64; 2]) -> Pose {
        let Point { coords, .. } = self.point(at);
        let heading = match self.back {
            Side::Bottom => math::FRAC_PI_2,
            Side::Top => -math::FRAC_PI_2,
            Side::Left => 0.0,
            Side::Right => math::PI,
        };
        Pose::new(coords.x, coords.y, heading)
    }

    /// The object that a part is, unless it is drawn into the cells.
    pub fn object(&self, part: &FurniturePart) -> Option<Object> {
        let corners = |area: Area| {
            let [left, bottom, right, top] = area.metres();
            [(left, bottom), (right, bottom), (right, top), (left, top)].map(|(x, y)| Point::new(x, y)).to_vec()
        };
        match part {
            FurniturePart::Solid(_) => None,
            &FurniturePart::Round(at, radius) => Some(Object::Leg { at: self.point(at), radius }),
            FurniturePart::Slab(outline) => {
                Some(Object::Furniture { outline: outline.iter().map(|&at| self.point(at)).collect() })
            }
            &FurniturePart::Rug(edges) => Some(Object::Carpet { outline: corners(self.area(edges)) }),
            &FurniturePart::Dock(at) => Some(Object::Dock { pose: self.pose(at) }),
        }
    }

    /// The cells that a part takes; at least all those that it touches.
    pub fn taken(&self, part: &FurniturePart) -> Option<Area> {
        let around = |points: &[Point], margin: f64| {
            let cell = |metres: f64| math::floor(metres / CELL);
            let low = points.iter().fold(points[0], |low, point| low.inf(point));
            let high = points.iter().fold(points[0], |high, point| high.sup(point));
            Area::new(cell(low.x - margin), cell(low.y - margin), cell(high.x + margin) + 1, cell(high.y + margin) + 1)
        };
        match part {
            &FurniturePart::Solid(edges) => Some(self.area(edges)),
            &FurniturePart::Round(at, radius) => Some(around(&[self.point(at)], radius)),
            FurniturePart::Slab(outline) => {
                Some(around(&outline.iter().map(|&at| self.point(at)).collect::<Vec<_>>(), 0.0))
            }
            FurniturePart::Rug(_) => None,
            &FurniturePart::Dock([u, v]) => {
                Some(around(&[self.point([u - 0.08, v]), self.point([u + 0.08, v + 0.02])], 0.0))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_piece_turns_with_its_wall() {
        let piece = Piece::new(10, 4).solid([0, 0, 4, 2]).round(0.1, 0.05, 0.02);
        for (back, area) in [
            (Side::Bottom, Area::new(20, 30, 30, 34)),
            (Side::Top, Area::new(20, 30, 30, 34)),
            (Side::Left, Area::new(20, 30, 24, 40)),
            (Side::Right, Area::new(20, 30, 24, 40)),
        ] {
            let stand = Stand { area, back };
            let solid = stand.taken(&piece.parts[0]).unwrap();
            let leg = stand.taken(&piece.parts[1]).unwrap();
            assert!(area.holds(&solid) && solid.holds(&leg), "{back:?} {solid:?} {leg:?}");
            // The nearest cells are at its wall, and the front is before it.
            let wall = stand.area([0, 0, 10, 1]);
            assert!(!wall.overlaps(&stand.area([0, 1, 10, 4])));
            assert!(!area.overlaps(&stand.front(5)));
            let ahead = stand.pose([0.2, 0.2]).to_world(Point::new(0.1, 0.0));
            assert!((ahead - stand.point([0.2, 0.3])).norm() < 1e-9);
        }
    }
}

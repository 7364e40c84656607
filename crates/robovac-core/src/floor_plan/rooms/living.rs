//! A living room of objects: a sofa round the corner, a table on thin legs, a carpet, a dock, and a cat.

use super::{RoomInfo, RoomKind};
use crate::{
    floor_plan::{FloorPlan, Object, Rect, Sketch, Who},
    geometry::{Point, Pose},
};

/// Sideboard with the television, and a shelf; built in, so they are walls.
const SOLID: &[Rect] = &[[1.5, 0.0, 3.5, 0.4], [4.8, 1.2, 5.2, 3.0]];
/// Sofa with a chaise longue and a slanted corner.
const SOFA: &[(f64, f64)] = &[(1.0, 3.3), (3.9, 3.3), (3.9, 4.2), (0.4, 4.2), (0.15, 3.95), (0.15, 2.2), (1.0, 2.2)];
/// An armchair, turned to the television.
const ARMCHAIR: &[(f64, f64)] = &[(4.0, 1.05), (4.55, 1.6), (4.0, 2.15), (3.45, 1.6)];
/// Legs of the coffee table.
const LEGS: &[(f64, f64)] = &[(1.65, 1.7), (2.75, 1.7), (2.75, 2.4), (1.65, 2.4)];
/// Carpet under it.
const CARPET: &[(f64, f64)] = &[(1.2, 1.2), (3.3, 1.2), (3.3, 2.9), (1.2, 2.9)];
/// The cat's way.
const CAT: &[(f64, f64)] = &[(0.55, 1.8), (1.3, 0.95), (3.0, 0.9), (3.2, 2.6), (4.4, 3.6)];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "living",
    title: "Living room with a cat",
    note: "Good for sensors: thin legs, slanted furniture, a carpet, a dock, and a cat in the way.",
    kind: RoomKind::Cluttered,
    is_benchmark: false,
    build: || {
        let leg = |&(x, y): &(f64, f64)| Object::Leg { at: Point::new(x, y), radius: 0.015 };
        let mut objects = vec![
            Object::Carpet { outline: points(CARPET) },
            Object::Furniture { outline: points(SOFA) },
            Object::Furniture { outline: points(ARMCHAIR) },
            Object::Dirt { at: Point::new(2.3, 0.75), radius: 0.3 },
            Object::Dock { pose: Pose::new(0.0, 1.0, 0.0) },
            Object::Mover { who: Who::Pet, path: points(CAT) },
        ];
        objects.extend(LEGS.iter().map(leg));
        let plan = Sketch::open(5.2, 4.2, 0.05).fill(SOLID).start(0.6, 1.0, 0.0).finish(ROOM.title, ROOM.note);
        FloorPlan { objects, ..plan }
    },
};

pub(super) fn points(corners: &[(f64, f64)]) -> Vec<Point> {
    corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
}

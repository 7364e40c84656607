//! A landing with stairs down and a runner.

use super::{RoomInfo, RoomKind, living::points};
use crate::{
    floor_plan::{FloorPlan, Object, Rect, Sketch},
    geometry::{Point, Pose},
};

/// Landing, and the room that it leads to.
const FLOOR: &[Rect] = &[[0.1, 0.1, 4.9, 2.1], [0.1, 2.2, 2.9, 4.4]];
/// Its door.
const DOOR: &[Rect] = &[[0.6, 2.1, 1.5, 2.2]];
/// Stairs along the wall.
const STAIRS: &[(f64, f64)] = &[(2.6, 0.1), (4.9, 0.1), (4.9, 1.1), (2.6, 1.1)];
/// A runner before them.
const RUNNER: &[(f64, f64)] = &[(1.4, 1.25), (4.7, 1.25), (4.7, 1.95), (1.4, 1.95)];
/// A chest in the room.
const CHEST: &[(f64, f64)] = &[(1.9, 3.9), (2.9, 3.9), (2.9, 4.4), (1.9, 4.4)];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "stairs",
    title: "Landing with stairs",
    note: "Good for cliff sensors: the floor ends at stairs leading down, and a virtual wall blocks a door.",
    kind: RoomKind::Cluttered,
    is_benchmark: false,
    build: || {
        let objects = vec![
            Object::Carpet { outline: points(RUNNER) },
            Object::DropOff { outline: points(STAIRS) },
            Object::Furniture { outline: points(CHEST) },
            Object::Dirt { at: Point::new(0.8, 3.8), radius: 0.35 },
            Object::Dock { pose: Pose::new(0.1, 0.6, 0.0) },
            Object::VirtualWall { pose: Pose::new(1.5, 2.32, 180f64.to_radians()), length: 1.0 },
        ];
        let plan = Sketch::solid(5.0, 4.5, 0.05).carve(FLOOR).carve(DOOR);
        FloorPlan { objects, ..plan.start(0.7, 0.6, 0.0).finish(ROOM.title, ROOM.note) }
    },
};

//! A bedroom.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Double bed, wardrobe, chest of drawers with the dock under it, two bedside tables.
const SOLID: &[Rect] =
    &[[1.1, 2.0, 2.9, 4.0], [0.0, 0.0, 0.6, 2.0], [3.6, 0.6, 4.0, 2.0], [0.6, 3.5, 1.0, 4.0], [3.0, 3.5, 3.4, 4.0]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "bedroom",
    title: "Bedroom",
    note: "Good for dead ends: the narrow passages on both sides of the bed end at the wall.",
    kind: RoomKind::Cluttered,
    is_benchmark: true,
    build: || {
        Sketch::open(4.0, 4.0, 0.05)
            .fill(SOLID)
            .legs(&[[1.6, 0.1, 2.1, 0.6]])
            .recessed_dock(3.6, 1.3, 180.0)
            .start(0.9, 0.3, 90.0)
            .finish(ROOM.title, ROOM.note)
    },
};

//! A warehouse.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Office and charging place in a corner.
const SOLID: &[Rect] = &[[24.0, 15.0, 24.2, 20.0], [24.2, 15.0, 27.6, 15.2]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "warehouse",
    title: "Warehouse",
    note: "Good for aisles: twelve shelves of nine metres with long straight lanes in between.",
    kind: RoomKind::Large,
    is_benchmark: true,
    build: || {
        let shelves = |sketch: Sketch, x, y| sketch.fill(&[[x, y, x + 9.0, y + 1.2]]);
        Sketch::open(30.0, 20.0, 0.1)
            .fill(SOLID)
            .repeat((1.6, 1.6), (2, 11.0), (6, 3.0), shelves)
            .start(0.3, 0.3, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

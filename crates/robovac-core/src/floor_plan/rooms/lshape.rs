//! A room with a corner cut out.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::Sketch;

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "lshape",
    title: "L-shaped room",
    note: "Good for seeing how a room is decomposed: one inner corner, no furniture.",
    kind: RoomKind::Simple,
    is_benchmark: true,
    build: || {
        Sketch::open(6.0, 5.0, 0.1).fill(&[[3.2, 2.4, 6.0, 5.0]]).start(0.3, 0.3, 0.0).finish(ROOM.title, ROOM.note)
    },
};

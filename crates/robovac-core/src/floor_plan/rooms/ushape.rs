//! Two wings and what joins them.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::Sketch;

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "ushape",
    title: "U-shaped room",
    note: "Good for sweeping across a gap: the lanes of both wings line up but aren't connected.",
    kind: RoomKind::Simple,
    is_benchmark: true,
    build: || {
        Sketch::open(7.0, 5.0, 0.1).fill(&[[2.4, 1.8, 4.8, 5.0]]).start(0.3, 4.7, -90.0).finish(ROOM.title, ROOM.note)
    },
};

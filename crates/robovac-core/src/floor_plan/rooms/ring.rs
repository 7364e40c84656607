//! A corridor round a core of stairs and lifts.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::Sketch;

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "ring",
    title: "Ring corridor",
    note: "Good for one large loop: both directions meet, so the planner must cut it somewhere.",
    kind: RoomKind::Corridor,
    is_benchmark: true,
    build: || {
        Sketch::open(9.0, 7.0, 0.1).fill(&[[1.6, 1.6, 7.4, 5.4]]).start(0.3, 0.3, 0.0).finish(ROOM.title, ROOM.note)
    },
};

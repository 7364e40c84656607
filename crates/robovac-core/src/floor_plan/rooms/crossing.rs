//! Corridors that cross.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::Sketch;

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "crossing",
    title: "Crossing corridors",
    note: "Good for crossings: six corridors cross nine times, so the lanes of one cross those of others.",
    kind: RoomKind::Corridor,
    is_benchmark: true,
    build: || {
        Sketch::open(10.2, 8.2, 0.1)
            .repeat((1.4, 1.4), (2, 4.0), (2, 3.0), |sketch, x, y| sketch.fill(&[[x, y, x + 3.0, y + 2.0]]))
            .start(0.3, 0.3, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

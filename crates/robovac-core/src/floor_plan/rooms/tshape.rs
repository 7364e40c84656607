//! Two bars that meet.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::Sketch;

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "tshape",
    title: "T-shaped room",
    note: "Good for the choice of lane direction: bar and stem need perpendicular lanes.",
    kind: RoomKind::Simple,
    is_benchmark: true,
    build: || {
        Sketch::open(6.0, 5.0, 0.1)
            .fill(&[[0.0, 0.0, 2.2, 3.0], [3.8, 0.0, 6.0, 3.0]])
            .start(0.3, 4.7, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

//! Boxes everywhere, one of them with the dock under it.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Sketch, generate::random_clutter};

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "clutter",
    title: "Store with boxes",
    note: "Good for worst-case clutter: boxes fill a random quarter of the half-metre squares.",
    kind: RoomKind::Cluttered,
    is_benchmark: true,
    build: || {
        Sketch::open(8.0, 6.0, 0.1)
            .blocks(&random_clutter(16, 12, 0.25, 3), 0.5)
            .recessed_dock(5.0, 2.75, 0.0)
            .start(0.3, 0.3, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

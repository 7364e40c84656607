//! A market hall with stalls at random.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Sketch, generate::random_hall};

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "market",
    title: "Market hall",
    note: "Good for random obstacles: stalls of all sizes, as in the hall used to time planners.",
    kind: RoomKind::Large,
    is_benchmark: true,
    build: || {
        Sketch::open(24.0, 24.0, 0.1)
            .blocks(&random_hall(48, 48, 4), 0.5)
            .start(0.3, 0.3, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

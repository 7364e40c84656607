//! An empty rectangle.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::Sketch;

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "empty",
    title: "Empty room",
    note: "Good for seeing a pure pattern: 5 m x 4 m without obstacles.",
    kind: RoomKind::Simple,
    is_benchmark: true,
    build: || Sketch::open(5.0, 4.0, 0.05).start(0.25, 3.75, 0.0).finish(ROOM.title, ROOM.note),
};

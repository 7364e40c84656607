//! A hall on pillars.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::Sketch;

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "pillars",
    title: "Hall of pillars",
    note: "Good for very large maps: 400 x 400 cells, with pillars that break lanes without dividing the floor.",
    kind: RoomKind::Large,
    is_benchmark: true,
    build: || {
        let pillar = |sketch: Sketch, x, y| sketch.fill(&[[x, y, x + 0.6, y + 0.6]]);
        Sketch::open(40.0, 40.0, 0.1)
            .repeat((3.7, 3.7), (7, 5.3), (7, 5.3), pillar)
            .start(0.3, 0.3, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

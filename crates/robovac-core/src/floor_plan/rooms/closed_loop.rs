//! A closed loop, the subject of Image 7.1 of 004. The image is lost, the room is ours: a robot that only turns away from
//! what is ahead goes round in the room in the middle and passes both doors, 70 cm wide; one that follows walls goes
//! through them.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// The room in the middle, and the ones on its left and right.
const ROOMS: &[Rect] = &[[1.2, 0.2, 3.8, 2.6], [0.1, 0.6, 1.1, 2.2], [3.9, 0.6, 5.1, 2.2]];
const DOORS: &[Rect] = &[[1.1, 1.05, 1.2, 1.75], [3.8, 1.05, 3.9, 1.75]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "closed_loop",
    title: "Closed loop",
    note: "Good for robots without memory: one that only avoids obstacles circles in the middle for ever.",
    kind: RoomKind::Simple,
    is_benchmark: false,
    build: || {
        // The heading is at random, so that nothing depends on its being square.
        Sketch::solid(5.2, 2.8, 0.05).carve(ROOMS).carve(DOORS).start(2.5, 1.4, 17.0).finish(ROOM.title, ROOM.note)
    },
};

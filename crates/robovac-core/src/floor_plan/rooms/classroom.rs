//! A classroom.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// The teacher's platform, and cupboards at the back.
const SOLID: &[Rect] = &[[3.0, 6.6, 6.0, 7.2], [0.4, 0.0, 3.6, 0.4]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "classroom",
    title: "Classroom",
    note: "Good for rows of thin legs: twelve desks with two chairs each, and aisles in between.",
    kind: RoomKind::Office,
    is_benchmark: true,
    build: || {
        let desks = |sketch: Sketch, x, y| {
            sketch.legs(&[
                [x, y, x + 1.3, y + 0.5],
                [x + 0.1, y - 0.5, x + 0.5, y - 0.1],
                [x + 0.8, y - 0.5, x + 1.2, y - 0.1],
            ])
        };
        Sketch::open(9.0, 7.2, 0.1)
            .fill(SOLID)
            .repeat((1.0, 1.6), (4, 2.0), (3, 1.5), desks)
            .start(0.4, 6.8, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

//! A hospital ward.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Corridor, and the passage at its end.
const CORRIDOR: &[Rect] = &[[0.0, 5.0, 16.0, 7.2]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "ward",
    title: "Hospital ward",
    note: "Good for similar rooms: eight of them off one corridor, with two beds on legs in each.",
    kind: RoomKind::Office,
    is_benchmark: true,
    build: || {
        let rooms = |sketch: Sketch, x, y| {
            let door = if y > 5.0 { y - 0.2 } else { y + 4.8 };
            let sketch = sketch.carve(&[[x, y, x + 3.8, y + 4.8], [x + 1.4, door, x + 2.6, door + 0.2]]);
            sketch.legs(&[[x + 0.2, y + 1.4, x + 1.1, y + 3.4], [x + 2.7, y + 1.4, x + 3.6, y + 3.4]])
        };
        Sketch::solid(16.0, 12.2, 0.1)
            .carve(CORRIDOR)
            .repeat((0.0, 0.0), (4, 4.0), (2, 7.4), rooms)
            .start(0.4, 6.0, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

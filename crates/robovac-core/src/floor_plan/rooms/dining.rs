//! A dining room: a long table, its chairs, and not much else.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Sideboard with the dock under it, and cabinet.
const SOLID: &[Rect] = &[[1.0, 4.6, 3.4, 5.0], [5.6, 1.6, 6.0, 3.4]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "dining",
    title: "Dining room",
    note: "Good for thin legs: a table and ten chairs have forty-four of them.",
    kind: RoomKind::Cluttered,
    is_benchmark: true,
    build: || {
        let sketch = Sketch::open(6.0, 5.0, 0.05).fill(SOLID).legs(&[[1.0, 2.0, 5.0, 3.0]]);
        let chairs = |sketch: Sketch, x, y| sketch.legs(&[[x, y, x + 0.45, y + 0.45]]);
        sketch
            .repeat((1.25, 1.55), (4, 1.0), (2, 1.45), chairs)
            .legs(&[[0.6, 2.3, 1.05, 2.75], [4.95, 2.3, 5.4, 2.75]])
            .recessed_dock(2.2, 4.6, -90.0)
            .start(0.3, 0.3, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

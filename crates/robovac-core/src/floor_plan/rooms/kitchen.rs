//! A kitchen with an island.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Worktops round a corner with the dock in their plinth, fridge, island, bench by the window.
const SOLID: &[Rect] =
    &[[0.0, 3.2, 4.2, 3.8], [0.0, 0.8, 0.6, 3.2], [4.4, 3.1, 5.0, 3.8], [1.6, 1.5, 3.2, 2.3], [4.6, 0.0, 5.0, 1.6]];
/// Bar stools at the island, table by the bench.
const LEGS: &[Rect] = &[[1.8, 1.0, 2.2, 1.4], [2.6, 1.0, 3.0, 1.4], [3.7, 0.2, 4.5, 1.4]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "kitchen",
    title: "Kitchen with an island",
    note: "Good for a loop: the passage around the island is narrow, with stools and table legs in it.",
    kind: RoomKind::Cluttered,
    is_benchmark: true,
    build: || {
        let sketch = Sketch::open(5.0, 3.8, 0.05).fill(SOLID).legs(LEGS).recessed_dock(3.75, 3.2, -90.0);
        sketch.start(0.3, 0.3, 0.0).finish(ROOM.title, ROOM.note)
    },
};

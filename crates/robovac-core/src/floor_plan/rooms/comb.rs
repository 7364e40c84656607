//! Alcoves side by side.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Dividing walls from above and below; the alcoves between them differ in width and depth.
const WALLS: &[Rect] = &[
    [0.9, 2.6, 1.0, 5.0],
    [1.8, 3.0, 1.9, 5.0],
    [3.1, 2.6, 3.2, 5.0],
    [4.0, 3.4, 4.1, 5.0],
    [5.3, 2.6, 5.4, 5.0],
    [6.2, 3.0, 6.3, 5.0],
    [1.2, 0.0, 1.4, 1.4],
    [2.4, 0.0, 2.6, 1.8],
    [3.6, 0.0, 3.8, 1.4],
    [4.8, 0.0, 5.0, 1.8],
    [6.0, 0.0, 6.2, 1.4],
];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "comb",
    title: "Comb of alcoves",
    note: "Good for lane direction: many alcoves off one aisle, where sweeping the wrong way costs turns.",
    kind: RoomKind::Maze,
    is_benchmark: true,
    build: || Sketch::open(7.2, 5.0, 0.1).fill(WALLS).start(0.3, 2.2, 0.0).finish(ROOM.title, ROOM.note),
};

//! A corridor that winds inwards.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Side of the square, m: seven lanes of 0.8 m with walls of 0.1 m between them.
const SIDE: f64 = 6.2;

/// Walls from the outer end of the corridor to the inner one.
const WALLS: &[Rect] = &[
    [0.0, 0.8, 5.4, 0.9],
    [5.3, 0.8, 5.4, 5.4],
    [0.8, 5.3, 5.4, 5.4],
    [0.8, 1.7, 0.9, 5.4],
    [0.8, 1.7, 4.5, 1.8],
    [4.4, 1.7, 4.5, 4.5],
    [1.7, 4.4, 4.5, 4.5],
    [1.7, 2.6, 1.8, 4.5],
    [1.7, 2.6, 3.6, 2.7],
    [3.5, 2.6, 3.6, 3.6],
    [2.6, 3.5, 3.6, 3.6],
];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "spiral",
    title: "Spiral corridor",
    note: "Good for one long path without branches: every detour must be driven back.",
    kind: RoomKind::Maze,
    is_benchmark: true,
    build: || Sketch::open(SIDE, SIDE, 0.1).fill(WALLS).start(0.3, 0.3, 0.0).finish(ROOM.title, ROOM.note),
};

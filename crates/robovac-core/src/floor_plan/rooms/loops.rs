//! A maze with loops.

use super::{RoomInfo, RoomKind, maze::carved};
use crate::grid::Cell;

/// Walls that are missing: pairs of passages, column and row.
const MISSING: &[[i32; 4]] = &[
    [0, 0, 1, 0],
    [2, 1, 2, 2],
    [4, 0, 5, 0],
    [5, 3, 6, 3],
    [7, 1, 7, 2],
    [8, 5, 9, 5],
    [3, 5, 3, 6],
    [1, 3, 2, 3],
    [9, 2, 9, 3],
    [4, 4, 4, 5],
    [6, 5, 7, 5],
    [0, 4, 1, 4],
];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "loops",
    title: "Maze with loops",
    note: "Good for choices: few dead ends, but many loops.",
    kind: RoomKind::Maze,
    is_benchmark: true,
    build: || {
        let missing: Vec<_> = MISSING.iter().map(|&[a, b, c, d]| (Cell::new(a, b), Cell::new(c, d))).collect();
        carved(21, &missing).finish(ROOM.title, ROOM.note)
    },
};

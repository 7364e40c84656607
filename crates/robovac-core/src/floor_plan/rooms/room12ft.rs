//! A furnished room of twelve by twelve feet, the size of the arena of 002, Fig. 18; the furniture is ours.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Two inches in metres, so that twelve feet are 72 cells.
const CELL: f64 = 0.0508;
/// Twelve feet in metres.
const SIDE: f64 = 72.0 * CELL;

/// Bed with the dock under it, wardrobe, chest of drawers.
const SOLID: &[Rect] = &[[1.72, 0.0, SIDE, 1.02], [0.0, 2.24, 0.61, SIDE], [3.25, 2.03, SIDE, 2.9]];
/// Desk and chair.
const LEGS: &[Rect] = &[[1.37, 2.95, 2.59, SIDE], [1.73, 2.54, 2.18, 2.95]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "room12ft",
    title: "Furnished room, 12 ft x 12 ft",
    note: "Good for random walks: as large as the arena in which the DVR-1's behaviours were timed.",
    kind: RoomKind::Cluttered,
    is_benchmark: true,
    build: || {
        Sketch::open(SIDE, SIDE, CELL)
            .fill(SOLID)
            .legs(LEGS)
            .disc(0.3, 0.3, 0.18)
            .recessed_dock(2.6, 20.0 * CELL, 90.0)
            .start(0.3, 1.4, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

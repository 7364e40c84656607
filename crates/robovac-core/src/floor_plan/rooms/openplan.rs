//! An open-plan office.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Meeting boxes in two corners, their doors left open, and the copier.
const SOLID: &[Rect] = &[
    [11.0, 9.0, 11.2, 12.0],
    [12.0, 9.0, 16.0, 9.2],
    [4.8, 9.0, 5.0, 12.0],
    [0.0, 9.0, 3.6, 9.2],
    [7.0, 11.4, 9.0, 12.0],
];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "openplan",
    title: "Open-plan office",
    note: "Good for regular islands: eighteen double desks on thin legs.",
    kind: RoomKind::Office,
    is_benchmark: true,
    build: || {
        let desks = |sketch: Sketch, x, y| {
            sketch
                .fill(&[[x, y + 0.7, x + 1.6, y + 0.8]])
                .legs(&[[x, y, x + 1.6, y + 0.7], [x, y + 0.8, x + 1.6, y + 1.5]])
        };
        Sketch::open(16.0, 12.0, 0.1)
            .fill(SOLID)
            .repeat((1.2, 0.8), (6, 2.4), (3, 2.7), desks)
            .start(0.3, 0.3, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

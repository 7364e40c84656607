//! A floor of a hotel.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// The corridor with its bend, the lift's lobby, the linen room.
const WAYS: &[Rect] = &[[0.0, 3.4, 20.0, 5.0], [18.4, 0.0, 20.0, 3.4], [8.0, 5.0, 12.0, 6.6], [0.0, 0.0, 1.6, 3.4]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "hotel",
    title: "Hotel corridor",
    note: "Good for long narrow floors: twenty metres of corridor with door niches on both sides.",
    kind: RoomKind::Corridor,
    is_benchmark: true,
    build: || {
        let niches = |sketch: Sketch, x, y| sketch.carve(&[[x, y, x + 1.0, y + 0.4]]);
        Sketch::solid(20.0, 6.6, 0.1)
            .carve(WAYS)
            .repeat((2.6, 3.0), (6, 2.6), (1, 0.0), niches)
            .repeat((1.0, 5.0), (3, 2.2), (1, 0.0), niches)
            .repeat((13.0, 5.0), (3, 2.2), (1, 0.0), niches)
            .start(0.4, 4.2, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

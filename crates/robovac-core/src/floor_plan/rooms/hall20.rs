//! A hall with seven obstacles, as large and as full as the example of 001; the layout is ours.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// A counter, an L-shaped booth (two pieces) and a long stage.
const SOLID: &[Rect] =
    &[[3.0, 14.6, 7.4, 16.0], [12.6, 13.2, 14.0, 17.4], [14.0, 13.2, 17.2, 14.6], [8.2, 0.0, 12.6, 2.2]];

/// A crate that stands askew.
const CRATE: &[(f64, f64)] = &[(4.6, 3.2), (6.8, 5.0), (5.2, 7.0), (3.0, 5.2)];
/// A display in the shape of a wedge.
const WEDGE: &[(f64, f64)] = &[(14.0, 5.0), (17.6, 5.8), (15.2, 9.0)];
/// A kiosk with eight corners.
const KIOSK: &[(f64, f64)] =
    &[(9.2, 8.6), (10.6, 8.6), (11.6, 9.6), (11.6, 11.0), (10.6, 12.0), (9.2, 12.0), (8.2, 11.0), (8.2, 9.6)];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "hall20",
    title: "Hall with seven obstacles",
    note: "Good for long lanes broken by obstacles of all shapes: 20 m x 20 m, planned in 4 s in the paper.",
    kind: RoomKind::Large,
    is_benchmark: true,
    build: || {
        Sketch::open(20.0, 20.0, 0.1)
            .fill(SOLID)
            .polygon(CRATE)
            .polygon(WEDGE)
            .polygon(KIOSK)
            .disc(3.4, 10.6, 1.1)
            .start(0.3, 19.7, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

//! An attic with walls at odd angles.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::Sketch;

/// What the slanted walls cut off, and a chimney that stands askew.
const CORNERS: &[&[(f64, f64)]] = &[
    &[(0.0, 2.2), (3.0, 5.0), (0.0, 5.0)],
    &[(6.0, 1.6), (6.0, 0.0), (3.6, 0.0)],
    &[(6.0, 3.8), (6.0, 5.0), (4.8, 5.0)],
    &[(2.6, 2.2), (3.2, 1.6), (3.8, 2.2), (3.2, 2.8)],
];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "slanted",
    title: "Attic with slanted walls",
    note: "Good for walls at an angle, which give every lane a different length.",
    kind: RoomKind::Simple,
    is_benchmark: true,
    build: || {
        CORNERS
            .iter()
            .fold(Sketch::open(6.0, 5.0, 0.1), |sketch, corners| sketch.polygon(corners))
            .start(0.3, 0.3, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

//! The preset of the thesis' program (000, Appendix B).

use super::{RoomInfo, RoomKind};
use crate::floor_plan::Sketch;

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "thesis8",
    title: "Thesis preset 8 x 8",
    note: "Good for following every step by hand: the 8 x 8 cells of 20 cm used in the snake thesis.",
    kind: RoomKind::Simple,
    is_benchmark: false,
    build: || {
        Sketch::open(1.6, 1.6, 0.2)
            .fill(&[[0.6, 1.0, 1.0, 1.6], [0.0, 0.0, 0.4, 0.4]])
            .start(0.1, 1.5, 0.0)
            .finish(ROOM.title, ROOM.note)
    },
};

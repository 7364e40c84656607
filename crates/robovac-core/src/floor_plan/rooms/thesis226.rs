//! A room of exactly 226 cells of 20 cm: our own reconstruction of the one of the thesis' Table 2 (000, section 5).
//!
//! The figure is lost. Its size follows from the printed lengths: 45.2 m without a revisit are 226 cells of 20 cm. Of
//! the many ways to place three pieces of furniture, this one was chosen because the snake's result is close to the
//! printed one; the other rows of the table can be compared.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Cupboard with the dock under it, sofa, table: 30 of 256 cells.
const SOLID: &[Rect] = &[[0.0, 1.4, 0.4, 2.6], [2.8, 0.4, 3.2, 1.4], [1.0, 0.6, 1.8, 1.0]];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "thesis226",
    title: "Thesis room, 226 cells of 20 cm",
    note: "Good for the thesis' Table 2: 226 planning cells of 20 cm. The layout is our guess.",
    kind: RoomKind::Cluttered,
    is_benchmark: false,
    build: || {
        let sketch = Sketch::open(3.2, 3.2, 0.2).fill(SOLID).recessed_dock(0.4, 2.1, 0.0);
        sketch.start(0.1, 3.1, 0.0).finish(ROOM.title, ROOM.note)
    },
};

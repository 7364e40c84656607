//! A furnished four-room flat: the opening scene.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Size of the flat with its outer walls of 15 cm, m.
const SIZE: (f64, f64) = (10.6, 8.4);

/// Living room, bedroom, kitchen, hall, bath, study.
const ROOMS: &[Rect] = &[
    [0.15, 0.15, 6.25, 4.75],
    [6.35, 0.15, 10.45, 4.75],
    [0.15, 4.85, 3.65, 8.25],
    [3.75, 4.85, 10.45, 5.95],
    [3.75, 6.05, 6.55, 8.25],
    [6.65, 6.05, 10.45, 8.25],
];

/// Living room to kitchen and to hall, bedroom, kitchen, bath and study to hall; then the niche of the front door.
const DOORS: &[Rect] = &[
    [1.2, 4.75, 2.1, 4.85],
    [4.6, 4.75, 5.5, 4.85],
    [6.9, 4.75, 7.75, 4.85],
    [3.65, 5.0, 3.75, 5.85],
    [4.5, 5.95, 5.3, 6.05],
    [7.4, 5.95, 8.25, 6.05],
    [10.45, 4.95, 10.5, 5.85],
];

// What isn't built in stands 5 cm off the wall, as at home; this separates furniture from walls in pictures.

const LIVING: &[Rect] = &[
    // Sofa with a chaise longue, facing the television's sideboard.
    [1.15, 2.65, 3.45, 3.5],
    [1.15, 1.9, 1.9, 2.65],
    [1.4, 0.2, 3.2, 0.6],
    // Bookcase.
    [0.2, 1.0, 0.55, 2.6],
    // Case of the dock; the robot starts in front of it.
    [3.25, 4.65, 3.45, 4.75],
];
/// Coffee table, dining table and its four chairs.
const LIVING_LEGS: &[Rect] = &[
    [2.25, 1.3, 3.25, 1.9],
    [4.5, 1.4, 5.4, 3.0],
    [4.2, 1.55, 4.65, 2.0],
    [4.2, 2.4, 4.65, 2.85],
    [5.25, 1.55, 5.7, 2.0],
    [5.25, 2.4, 5.7, 2.85],
];

/// Wardrobe, bed, two bedside tables, chest of drawers.
const BEDROOM: &[Rect] = &[
    [6.4, 0.2, 8.8, 0.8],
    [8.35, 1.55, 10.4, 3.2],
    [9.95, 1.05, 10.4, 1.45],
    [9.95, 3.3, 10.4, 3.7],
    [6.4, 1.9, 6.85, 3.3],
];
/// A chair for clothes.
const BEDROOM_LEGS: &[Rect] = &[[9.5, 0.25, 9.95, 0.7]];

/// Worktop round the corner, fridge.
const KITCHEN: &[Rect] = &[[0.15, 6.0, 0.75, 8.25], [0.75, 7.65, 2.9, 8.25], [2.95, 7.55, 3.6, 8.2]];
/// Two chairs at the table with one foot.
const KITCHEN_LEGS: &[Rect] = &[[1.45, 6.2, 1.9, 6.65], [2.75, 6.2, 3.2, 6.65]];

/// Bath tub, washing machine, wash basin, cistern.
const BATH: &[Rect] = &[[4.85, 7.5, 6.55, 8.25], [3.8, 7.6, 4.4, 8.2], [3.75, 6.7, 4.15, 7.3], [6.35, 6.6, 6.55, 7.0]];

/// Bookcase, drawers of the desk and its side, guest sofa.
const STUDY: &[Rect] = &[[6.7, 6.5, 7.0, 8.2], [9.0, 7.5, 9.45, 8.2], [7.8, 7.5, 7.85, 8.2], [9.7, 6.25, 10.4, 7.95]];

/// Shoe rack.
const HALL: &[Rect] = &[[8.6, 5.6, 9.8, 5.9]];

/// Plants, standard lamp, foot of the kitchen table, toilet, foot of the office chair, umbrella stand: x, y, radius.
const ROUND: &[(f64, f64, f64)] = &[
    (0.5, 0.5, 0.2),
    (5.9, 0.5, 0.22),
    (0.85, 3.25, 0.14),
    (2.325, 6.425, 0.2),
    (6.2, 6.8, 0.19),
    (8.425, 7.275, 0.25),
    (10.25, 4.35, 0.15),
    (8.35, 5.85, 0.1),
];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "flat",
    title: "Furnished flat",
    note: "Good for everyday comparisons: four rooms, bath and hall, chair legs, and a loop through three doors.",
    kind: RoomKind::Cluttered,
    is_benchmark: true,
    build: || {
        let furniture = [LIVING, BEDROOM, KITCHEN, BATH, STUDY, HALL];
        let legs = [LIVING_LEGS, BEDROOM_LEGS, KITCHEN_LEGS];
        let mut sketch = Sketch::solid(SIZE.0, SIZE.1, 0.05).carve(ROOMS).carve(DOORS);
        sketch = furniture.into_iter().fold(sketch, Sketch::fill);
        sketch = legs.into_iter().fold(sketch, Sketch::legs);
        sketch = ROUND.iter().fold(sketch, |sketch, &(x, y, radius)| sketch.disc(x, y, radius));
        sketch.recessed_dock(3.35, 4.65, -90.0).start(3.35, 4.4, -90.0).finish(ROOM.title, ROOM.note)
    },
};

//! One floor of an office building.

use super::{RoomInfo, RoomKind};
use crate::floor_plan::{Rect, Sketch};

/// Side of the square floor, m: 200 cells.
const SIDE: f64 = 20.0;

/// Corridors, then rooms from the north-west clockwise.
const ROOMS: &[Rect] = &[
    [0.2, 12.2, 19.8, 14.0],
    [9.2, 0.2, 11.0, 12.2],
    [0.2, 14.2, 4.6, 19.8],
    [4.8, 14.2, 9.2, 19.8],
    [9.4, 14.2, 13.8, 19.8],
    [14.0, 14.2, 19.8, 19.8],
    [15.8, 8.2, 19.8, 12.0],
    [11.2, 8.2, 15.6, 12.0],
    [11.2, 4.2, 19.8, 8.0],
    [11.2, 0.2, 19.8, 4.0],
    [0.2, 0.2, 9.0, 4.4],
    [0.2, 4.6, 9.0, 12.0],
];

/// Doors of 0.9 m, the large rooms have double ones.
const DOORS: &[Rect] = &[
    [3.3, 14.0, 4.2, 14.2],
    [5.2, 14.0, 6.1, 14.2],
    [12.5, 14.0, 13.4, 14.2],
    [14.6, 14.0, 16.2, 14.2],
    [16.4, 12.0, 17.3, 12.2],
    [11.0, 8.8, 11.2, 9.7],
    [11.0, 5.6, 11.2, 6.5],
    [11.0, 1.4, 11.2, 2.3],
    [9.0, 1.6, 9.2, 3.2],
    [9.0, 7.4, 9.2, 9.0],
    [2.0, 12.0, 2.9, 12.2],
];

/// Desks in the offices: x and y of the middle of the rear edge, and the side on which one sits.
const DESKS: &[(f64, f64, DeskSide)] = &[
    // Two single offices and one for two.
    (2.2, 17.6, DeskSide::North),
    (7.0, 17.6, DeskSide::North),
    (11.6, 17.0, DeskSide::North),
    (11.6, 17.0, DeskSide::South),
    // Open-plan office: three islands of four.
    (2.2, 6.9, DeskSide::North),
    (2.2, 6.9, DeskSide::South),
    (3.8, 6.9, DeskSide::North),
    (3.8, 6.9, DeskSide::South),
    (2.2, 9.8, DeskSide::North),
    (2.2, 9.8, DeskSide::South),
    (3.8, 9.8, DeskSide::North),
    (3.8, 9.8, DeskSide::South),
    (6.8, 6.9, DeskSide::North),
    (6.8, 6.9, DeskSide::South),
    // Room for four to the east.
    (13.4, 6.1, DeskSide::North),
    (13.4, 6.1, DeskSide::South),
    (17.2, 6.1, DeskSide::North),
    (17.2, 6.1, DeskSide::South),
];

/// Cupboards, kitchenette, cubicles, lockers, reception, server racks.
const SOLID: &[Rect] = &[
    [0.2, 19.4, 2.6, 19.8],
    [4.8, 19.4, 7.2, 19.8],
    [9.4, 14.6, 9.8, 16.6],
    [13.4, 17.8, 13.8, 19.8],
    // Kitchenette and its bar.
    [11.2, 11.4, 15.0, 12.0],
    [12.6, 9.6, 14.4, 10.2],
    // Wash rooms: partitions of three cubicles and a row of basins.
    [17.0, 8.2, 17.1, 9.6],
    [18.2, 8.2, 18.3, 9.6],
    [19.4, 9.9, 19.8, 11.9],
    [16.2, 8.2, 16.6, 8.7],
    [17.4, 8.2, 17.8, 8.7],
    [18.7, 8.2, 19.1, 8.7],
    // Racks of the laboratory, and its bench.
    [11.8, 3.4, 18.6, 4.0],
    [13.0, 1.2, 18.0, 2.0],
    // Cupboards of the other rooms.
    [19.4, 4.6, 19.8, 7.6],
    [0.2, 5.4, 0.6, 8.6],
    [6.0, 11.6, 8.8, 12.0],
    [0.2, 0.2, 0.6, 2.8],
    // Sofas and printer in the corridor's bay.
    [0.2, 12.6, 0.8, 13.6],
    [18.9, 12.4, 19.8, 13.2],
    // Screen in front of the big meeting room's wall.
    [16.0, 19.6, 18.0, 19.8],
];

/// Meeting tables; chairs stand along both long sides.
const TABLES: &[Rect] = &[[2.2, 1.7, 6.8, 2.9], [16.2, 15.8, 17.6, 18.6]];

/// Plants, pillars, bar stools, sofa table: x, y, radius.
const ROUND: &[(f64, f64, f64)] = &[
    (7.0, 9.8, 0.5),
    (6.1, 10.4, 0.25),
    (7.9, 9.2, 0.25),
    (8.6, 5.0, 0.25),
    (12.9, 9.3, 0.15),
    (13.5, 9.3, 0.15),
    (14.1, 9.3, 0.15),
    (10.1, 0.6, 0.3),
    (19.4, 14.6, 0.25),
    (0.6, 14.6, 0.25),
    (8.8, 14.6, 0.25),
    (8.6, 0.6, 0.25),
];

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "office",
    title: "Office floor",
    note: "Good for large maps: 200 x 200 cells, eleven doors off two corridors, desks to drive under.",
    kind: RoomKind::Office,
    is_benchmark: true,
    build: || {
        let sketch = Sketch::solid(SIDE, SIDE, 0.1).carve(ROOMS).carve(DOORS).fill(SOLID);
        let sketch = DESKS.iter().fold(sketch, |sketch, &(x, y, side)| desk(sketch, x, y, side));
        let sketch = TABLES.iter().fold(sketch, meeting_table);
        let sketch = ROUND.iter().fold(sketch, |sketch, &(x, y, radius)| sketch.disc(x, y, radius));
        sketch.start(10.1, 13.1, 0.0).finish(ROOM.title, ROOM.note)
    },
};

/// The side of a desk on which one sits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum DeskSide {
    North,
    South,
}

/// A desk of 1.6 m x 0.8 m on a drawer unit and a side panel, with a rear panel and a swivel chair.
fn desk(sketch: Sketch, x: f64, y: f64, side: DeskSide) -> Sketch {
    let out = if side == DeskSide::North { 1.0 } else { -1.0 };
    let span = |near: f64, far: f64| if out > 0.0 { (y + near, y + far) } else { (y - far, y - near) };
    let ((rear, rear_end), (bottom, top)) = (span(0.0, 0.1), span(0.0, 0.8));
    sketch
        .fill(&[[x - 0.8, rear, x + 0.8, rear_end], [x - 0.8, bottom, x - 0.4, top], [x + 0.7, bottom, x + 0.8, top]])
        .disc(x + 0.15, y + out * 0.95, 0.25)
}

/// A table on two panels with chairs on four legs every 0.8 m along its long sides.
fn meeting_table(sketch: Sketch, &[left, bottom, right, top]: &Rect) -> Sketch {
    let (length, is_wide) = ((right - left).max(top - bottom), right - left > top - bottom);
    let chairs = (0..(length / 0.8) as u32).flat_map(|i| {
        let from = 0.25 + 0.8 * f64::from(i);
        if is_wide {
            let (near, far) = (left + from, left + from + 0.5);
            [[near, bottom - 0.4, far, bottom + 0.1], [near, top - 0.1, far, top + 0.4]]
        } else {
            let (near, far) = (bottom + from, bottom + from + 0.5);
            [[left - 0.4, near, left + 0.1, far], [right - 0.1, near, right + 0.4, far]]
        }
    });
    let panels = if is_wide {
        [[left + 0.6, bottom + 0.3, left + 0.8, top - 0.3], [right - 0.8, bottom + 0.3, right - 0.6, top - 0.3]]
    } else {
        [[left + 0.3, bottom + 0.6, right - 0.3, bottom + 0.8], [left + 0.3, top - 0.8, right - 0.3, top - 0.6]]
    };
    sketch.fill(&panels).legs(&chairs.collect::<Vec<_>>())
}

//! A room as lines.

use crate::{
    drawing::{Overlay, flatten::ellipse},
    floorplan::{FloorPlan, Object},
    geometry::{Point, Vector},
    grid::{Cell, Direction, Grid},
    math::TAU,
};

/// The outlines of a room's walls, furniture and stairs, in metres from where its map has its origin.
///
/// ```
/// use robovac_playground::{drawing::outlines, floorplan::{SourceFile, load}};
/// let bytes = "; resolution 0.5\n####\n#..#\n####\n".into();
/// let room = load(&[SourceFile { name: "room.txt".into(), bytes }])?;
/// let walls = &outlines(&room)[0];
/// assert_eq!((walls.layer.as_str(), walls.lines.len()), ("WALLS", 1));
/// assert_eq!(walls.lines[0].len(), 5, "four corners and the first once more");
/// # Ok::<(), robovac_playground::floorplan::MapError>(())
/// ```
pub fn outlines(plan: &FloorPlan) -> Vec<Overlay> {
    let place = |line: Vec<Point>| line.into_iter().map(|point| plan.origin.to_world(point)).collect();
    let walls = borders(&plan.occupancy.map(|cell| cell.is_free()), plan.resolution);
    let mut overlays =
        vec![Overlay { layer: "WALLS".to_owned(), colour: 7, lines: walls.into_iter().map(place).collect() }];
    let closed = |outline: &[Point]| outline.iter().chain(outline.first()).copied().collect::<Vec<Point>>();
    let furniture = plan.objects.iter().filter_map(|object| match object {
        Object::Furniture { outline } => Some(closed(outline)),
        Object::Leg { at, radius } => {
            let (x, y) = (Vector::new(*radius, 0.0), Vector::new(0.0, *radius));
            Some(closed(&ellipse(*at, x, y, 0.0, TAU).0))
        }
        _ => None,
    });
    let stairs = plan.objects.iter().filter_map(|object| match object {
        Object::DropOff { outline } => Some(closed(outline)),
        _ => None,
    });
    for (layer, colour, lines) in
        [("FURNITURE", 30, furniture.map(place).collect::<Vec<_>>()), ("STAIRS", 1, stairs.map(place).collect())]
    {
        if !lines.is_empty() {
            overlays.push(Overlay { layer: layer.to_owned(), colour, lines });
        }
    }
    overlays
}

/// Lines around the cells that are set, with those on the left; each ends where it begins.
fn borders(cells: &Grid<bool>, side: f64) -> Vec<Vec<Point>> {
    let (columns, rows) = (cells.width() + 1, cells.height() + 1);
    // The ways on from every corner of cells: a bit a direction.
    let mut ways = Grid::filled(columns, rows, 0_u8);
    let bit = |direction: Direction| 1_u8 << Direction::ALL.iter().position(|&d| d == direction).unwrap_or(0);
    for (cell, _) in cells.iter().filter(|(_, is_set)| **is_set) {
        for (direction, from) in [
            (Direction::ALL[0], cell),
            (Direction::ALL[1], Cell::new(cell.x + 1, cell.y)),
            (Direction::ALL[2], Cell::new(cell.x + 1, cell.y + 1)),
            (Direction::ALL[3], Cell::new(cell.x, cell.y + 1)),
        ] {
            // The neighbour to the right of the way along this side.
            let index = Direction::ALL.iter().position(|&d| d == direction).unwrap_or(0);
            if !cells.is_set(cell.step(Direction::ALL[(index + 3) % 4])) {
                ways[from] |= bit(direction);
            }
        }
    }
    let mut lines = Vec::new();
    for index in 0..ways.len() {
        let start = ways.cell(index);
        while let Some(first) = (0..4).find(|way| ways[start] & (1 << way) != 0) {
            let (mut at, mut way) = (start, first);
            let mut line = Vec::new();
            let point = |cell: Cell| Point::new(f64::from(cell.x) * side, f64::from(cell.y) * side);
            let mut before = None;
            loop {
                ways[at] &= !(1 << way);
                if before != Some(way) {
                    line.push(point(at));
                }
                before = Some(way);
                at = at.step(Direction::ALL[way]);
                if at == start {
                    break;
                }
                // Where two cells touch at a corner, the line stays at its own: left before straight on and right.
                let Some(next) = [1, 0, 3].map(|turn| (way + turn) % 4).into_iter().find(|w| ways[at] & (1 << w) != 0)
                else {
                    break;
                };
                way = next;
            }
            line.push(point(start));
            lines.push(line);
        }
    }
    lines
}

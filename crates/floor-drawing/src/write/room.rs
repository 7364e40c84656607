//! A room as lines.

use crate::{Overlay, flatten::ellipse};
use robovac_core::{
    floor_plan::{FloorPlan, Object},
    geometry::{Point, Vector},
    grid::{self, Cell, Grid},
    math::TAU,
};

/// The outlines of a room's walls, furniture and stairs, in metres from the map's origin.
///
/// ```
/// use floor_drawing::outlines;
/// use robovac_core::floor_plan::{SourceFile, load};
/// let bytes = "; resolution 0.5\n####\n#..#\n####\n".into();
/// let room = load(&[SourceFile { name: "room.txt".into(), bytes }])?;
/// let walls = &outlines(&room)[0];
/// assert_eq!((walls.layer.as_str(), walls.lines.len()), ("WALLS", 1));
/// assert_eq!(walls.lines[0].len(), 5, "four corners and the first once more");
/// # Ok::<(), robovac_core::floor_plan::MapError>(())
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

/// Lines around the set cells, counter-clockwise; each is closed.
fn borders(cells: &Grid<bool>, side: f64) -> Vec<Vec<Point>> {
    let point = |cell: &Cell| Point::new(f64::from(cell.x) * side, f64::from(cell.y) * side);
    // Without a limit: files can't show the cells as an image instead.
    let loops = grid::outlines(cells, usize::MAX).unwrap_or_default();
    loops.iter().map(|corners| corners.iter().chain(corners.first()).map(point).collect()).collect()
}

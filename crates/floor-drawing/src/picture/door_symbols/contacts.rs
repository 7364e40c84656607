//! Places where lines meet walls: the jambs of a door are among them.

use super::strokes::Strokes;
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Cell, Grid},
};

/// The middles of the thin pixels near thick ones, a tile each; without the rough edge of a wall.
pub(super) fn contacts(strokes: &Strokes) -> Vec<Point> {
    let reach = strokes.reach as i32;
    let tile = reach + 1;
    let thin = &strokes.thin;
    let tiles = |length: usize| length / tile as usize + 1;
    let mut sums = Grid::filled(tiles(thin.width()), tiles(thin.height()), (Vector::zeros(), 0_u32, false));
    for (cell, _) in thin.iter().filter(|(_, is_thin)| **is_thin) {
        let moves = strokes.cell_to_thick(cell);
        let (sum, count, is_line) = &mut sums[Cell::new(cell.x / tile, cell.y / tile)];
        if moves <= reach {
            *sum += cell.centre(1.0).coords;
            *count += 1;
        }
        *is_line |= moves > reach;
    }
    // A line leads away from the wall.
    let leads_on = |tile: Cell| {
        let mut around = (-2..=2).flat_map(|dy| (-2..=2).map(move |dx| Cell::new(tile.x + dx, tile.y + dy)));
        around.any(|tile| sums.get(tile).is_some_and(|&(.., is_line)| is_line))
    };
    let places = sums.iter().filter(|&(tile, &(_, count, _))| count > 0 && leads_on(tile));
    places.map(|(_, &(sum, count, _))| Point::from(sum / f64::from(count))).collect()
}

/// Calls `meet` with all pairs whose distance is between `least` and `most`.
pub(super) fn for_pairs(contacts: &[Point], [least, most]: [f64; 2], mut meet: impl FnMut(Point, Point)) {
    let side = most.max(1.0);
    let tile = |at: Point| Cell::at(at, side);
    let mut tiles: std::collections::BTreeMap<Cell, Vec<Point>> = std::collections::BTreeMap::new();
    for &contact in contacts {
        tiles.entry(tile(contact)).or_default().push(contact);
    }
    for &a in contacts {
        for b in tile(a).block().filter_map(|tile| tiles.get(&tile)).flatten() {
            // Each pair once.
            let is_first = (a.x, a.y) < (b.x, b.y);
            if is_first && (least * least..=most * most).contains(&(b - a).norm_squared()) {
                meet(a, *b);
            }
        }
    }
}

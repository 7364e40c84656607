//! Lines outside of the building: dimension lines, the frame and the title block of a sheet, fences. They are no walls.

use super::{
    marks::{PixelMark, erase, marks},
    sheet_frame,
    thickness::{ReducedPicture, erase_reduced, opened, usual_thickness},
};
use robovac_core::{
    geometry::{Point, contains, convex_hull, nearest_on_segment},
    grid::{Cell, Grid},
};
use std::collections::BTreeMap;

/// Least thickness of a wall, as a share of the usual one, and in pixels (ours): lines are drawn with a thin pen.
const THICK: (f64, f64) = (0.6, 3.0);
/// Share of a mark's pixels that is as thick, at least, if it is a wall: windows, doors and furniture can hang on it.
const MOSTLY: f64 = 0.2;
/// A wall is at least so many times as long as thick.
const LONG: f64 = 4.0;
/// Marks with less than this share of the walls' pixels are no building: an arrow, a logo.
const LARGE: f64 = 0.05;
/// Least side of a building, as a share of the picture's.
const BUILDING: f64 = 0.15;
/// Share of a line's pixels that may lie at the building.
const AT_BUILDING: f64 = 0.1;
/// Beside it are its windows: so far from its convex hull, in thicknesses of walls.
const BESIDE: f64 = 0.5;

/// Removes marks that are thin throughout, and lie outside of the convex hull of what is as thick as walls.
pub(super) fn remove(walls: &mut Grid<bool>) {
    let Some(ReducedPicture { by, mut cells, usual }) = ReducedPicture::new(walls) else { return };
    if let Some(frame) = sheet_frame::find(&cells) {
        let mut found = cells.map(|_| false);
        frame.cells.iter().for_each(|&cell| found[cell] = true);
        erase(&mut cells, [&frame]);
        erase_reduced(walls, by, &found);
    }
    let Some(usual) = thickness_of_walls(&cells, usual) else { return };
    let thick = opened(&cells, (THICK.0 * usual).round().max(THICK.1) as u16);
    let (thick, thin): (Vec<PixelMark>, Vec<PixelMark>) = marks(&cells, |_| true).into_iter().partition(|mark| {
        mark.cells.iter().filter(|&&cell| thick[cell]).count() as f64 >= MOSTLY * mark.cells.len() as f64
    });
    let all: usize = thick.iter().map(|mark| mark.cells.len()).sum();
    let is_building = |mark: &&PixelMark| mark.cells.len() as f64 >= LARGE * all as f64 && is_long(mark, usual);
    let building = thick.iter().filter(is_building);
    // The first and the last pixel of each row are enough.
    let mut rows: BTreeMap<i32, [i32; 2]> = BTreeMap::new();
    for cell in building.flat_map(|mark| &mark.cells) {
        let [first, last] = rows.entry(cell.y).or_insert([cell.x; 2]);
        (*first, *last) = ((*first).min(cell.x), (*last).max(cell.x));
    }
    let ends = rows.into_iter().flat_map(|(y, ends)| ends.map(|x| Cell::new(x, y).centre(1.0)));
    let hull = convex_hull(ends.collect());
    let (low, high) = hull.iter().fold((Point::new(f64::MAX, f64::MAX), Point::origin()), |(low, high), corner| {
        (low.inf(corner), high.sup(corner))
    });
    let size = high - low;
    if size.x < BUILDING * cells.width() as f64 || size.y < BUILDING * cells.height() as f64 {
        return;
    }
    let is_at_building = |cell: &&Cell| {
        let at = cell.centre(1.0);
        let next = hull.iter().cycle().skip(1);
        contains(&hull, at)
            || hull.iter().zip(next).any(|(&a, &b)| (nearest_on_segment(a, b, at) - at).norm() <= BESIDE * usual)
    };
    let mut outlying = cells.map(|_| false);
    for PixelMark { cells, .. } in &thin {
        if cells.iter().filter(is_at_building).count() as f64 <= AT_BUILDING * cells.len() as f64 {
            for &cell in cells {
                outlying[cell] = true;
            }
        }
    }
    erase_reduced(walls, by, &outlying);
}

/// Whether a mark is so much longer than walls are thick that it can be one: a desk and a pillar aren't.
fn is_long(mark: &PixelMark, thickness: f64) -> bool {
    f64::from(mark.size().into_iter().max().unwrap_or(0)) >= LONG * thickness
}

/// The usual thickness of what can be walls by its length, pixels, if `usual` is that of all: the desks of a classroom can be more
/// than its walls. `None` if there is hardly any.
fn thickness_of_walls(cells: &Grid<bool>, usual: f64) -> Option<f64> {
    let mut long = cells.clone();
    for PixelMark { cells, .. } in marks(cells, |mark| !is_long(mark, usual)) {
        for cell in cells {
            long[cell] = false;
        }
    }
    usual_thickness(&long)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::drawn::{fill, frame};

    /// A house with walls of 10 pixels, a doorway, and a table drawn thin.
    fn house() -> Grid<bool> {
        let mut walls = Grid::filled(400, 300, false);
        frame(&mut walls, [80, 70, 320, 230], 10);
        fill(&mut walls, [180, 80, 190, 180]);
        (150..180).for_each(|x| (70..80).for_each(|y| walls[Cell::new(x, y)] = false));
        frame(&mut walls, [220, 120, 260, 150], 2);
        walls
    }

    #[test]
    fn dimension_lines_frame_and_title_block_go_and_furniture_stays() {
        let house = house();
        for large in [false, true] {
            let mut walls = house.clone();
            // The frame with its title block, two dimension lines with ticks, and an arrow to the north.
            frame(&mut walls, [5, 5, 395, 295], 3);
            frame(&mut walls, [300, 5, 395, 40], 2);
            fill(&mut walls, [80, 50, 320, 52]);
            fill(&mut walls, [80, 44, 82, 58]);
            fill(&mut walls, [318, 44, 320, 58]);
            fill(&mut walls, [340, 70, 342, 230]);
            let grow = |small: &Grid<bool>| {
                let mut grown = Grid::filled(6 * small.width(), 6 * small.height(), false);
                for index in 0..grown.len() {
                    let cell = grown.cell(index);
                    grown.values_mut()[index] = small[Cell::new(cell.x / 6, cell.y / 6)];
                }
                grown
            };
            let mut walls = if large { grow(&walls) } else { walls };
            remove(&mut walls);
            assert_eq!(walls, if large { grow(&house) } else { house.clone() }, "large: {large}");
        }
    }

    #[test]
    fn the_walls_of_a_room_full_of_desks_stay() {
        for desks in [1, 4, 7] {
            let mut walls = Grid::filled(480, 360, false);
            frame(&mut walls, [40, 40, 440, 320], 8);
            (200..230).for_each(|x| (40..48).for_each(|y| walls[Cell::new(x, y)] = false));
            for (column, row) in (0..desks).flat_map(|column| (0..4).map(move |row| (column, row))) {
                let [left, low] = [70 + 50 * column, 80 + 55 * row];
                fill(&mut walls, [left, low, left + 40, low + 24]);
            }
            let mut kept = walls.clone();
            remove(&mut kept);
            assert_eq!(kept, walls, "{desks} columns of desks");
            // The frame of the sheet goes, whatever is in the room.
            let mut framed = walls.clone();
            frame(&mut framed, [8, 8, 472, 352], 3);
            remove(&mut framed);
            assert_eq!(framed, walls, "{desks} columns of desks, and a frame");
        }
    }

    #[test]
    fn a_plan_in_thin_lines_and_what_is_thick_stay() {
        // Walls drawn as outlines, with a bold line under the title.
        let mut walls = Grid::filled(400, 300, false);
        frame(&mut walls, [80, 70, 320, 230], 2);
        frame(&mut walls, [90, 80, 310, 220], 2);
        fill(&mut walls, [20, 20, 120, 30]);
        let before = walls.clone();
        remove(&mut walls);
        assert_eq!(walls, before);
        // A garden wall as thick as the house's.
        let mut walls = house();
        frame(&mut walls, [20, 20, 380, 280], 9);
        let before = walls.clone();
        remove(&mut walls);
        assert_eq!(walls, before);
    }
}

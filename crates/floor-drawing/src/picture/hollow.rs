//! Walls drawn as two lines, with paper or a light colour between them. What lies between is no floor, and what looks for
//! doors, words and dimension lines has to know how thick walls are.

use super::{
    marks::area,
    thickness::{ReducedPicture, longest_thickness, opened, usual_thickness},
};
use robovac_core::grid::{Cell, Grid, chessboard};

/// What is wider than so many times the usual inside of a wall is floor.
const WIDEST: f64 = 1.5;
/// A strip between two lines is at least so many times as long as wide: a threshold isn't.
const LONG: f64 = 10.0;
/// All strips have at least this share of the lines' area, and extend over this share of the drawing: a shelf doesn't.
const LARGE: f64 = 0.5;
const EXTENT: f64 = 0.5;
/// They are at most this share of the plan: pockets between lines everywhere aren't walls.
const MOST_OF_PLAN: f64 = 0.3;
/// Share of the dark pixels beyond each end of the drawing that may be none of it.
const STRAY: f64 = 0.05;
/// Lines are at most this share of it thick: solid walls aren't.
const LINES: f64 = 0.3;
/// Half of the floor is so far from lines, in widths of strips: rooms beside corridors aren't as wide.
const ROOMS: f64 = 1.0;
/// Difference of shades within the insides of walls; short walls can be told by it if less than this share of the floor has
/// the same.
const ALIKE: u8 = 4;
const OF_FLOOR: f64 = 0.02;

/// A light area that is narrow throughout, between lines.
struct Strip {
    cells: Vec<Cell>,
    is_long: bool,
}

/// Makes the insides of hollow walls dark. With `shades`, those of short walls are found by their colour.
pub(super) fn fill(walls: &mut Grid<bool>, shades: Option<&Grid<u8>>) {
    let inverse = |cells: &Grid<bool>| cells.map(|&is_dark| !is_dark);
    let reduced = ReducedPicture::by(walls, |cells| usual_thickness(&inverse(cells)));
    let Some(ReducedPicture { by, cells, usual }) = reduced else { return };
    // By area what is narrow can be mostly the strip along a dimension line, or rooms.
    let usual_by_length = longest_thickness(&inverse(&cells));
    let found = [Some(usual), usual_by_length].into_iter().flatten().find_map(|usual| HollowWalls::find(&cells, usual));
    let Some(HollowWalls { mut inside, short, floor }) = found else { return };
    if let Some(shades) = shades {
        let shade = |cell: Cell| shades[Cell::new(cell.x * by as i32, cell.y * by as i32)];
        inside.extend(of_their_colour(&inside, short, &floor, shade));
    }
    let inside = marked(&cells, inside.into_iter().flat_map(|strip| strip.cells));
    for index in 0..walls.len() {
        let at = walls.cell(index);
        let at = Cell::new(at.x / by as i32, at.y / by as i32);
        // Beside a line that is thinner than a reduced pixel some light is left.
        let is_inside = inside[at] || by > 1 && cells[at] && at.block().any(|beside| inside.is_set(beside));
        walls.values_mut()[index] |= is_inside;
    }
}

/// Strips that are the insides of walls, short ones that may be, and the floor.
struct HollowWalls {
    inside: Vec<Strip>,
    short: Vec<Strip>,
    floor: Grid<bool>,
}

impl HollowWalls {
    /// Those about as wide as `usual`.
    fn find(cells: &Grid<bool>, usual: f64) -> Option<Self> {
        let light = cells.map(|&is_dark| !is_dark);
        let floor = |usual: f64| opened(&light, (WIDEST * usual).ceil() as u16 + 1);
        // Gaps beside furniture are among what is narrow, but hardly any of them is long.
        let long = strips(cells, &floor(usual)).into_iter().filter(|strip| strip.is_long);
        let usual = usual_thickness(&marked(cells, long.flat_map(|strip| strip.cells)))?;
        let floor = floor(usual);
        let (inside, short): (Vec<Strip>, Vec<Strip>) =
            strips(cells, &floor).into_iter().partition(|strip| strip.is_long);
        are_walls(cells, &inside, &floor, usual).then_some(Self { inside, short, floor })
    }
}

/// Whether strips of this usual width are the insides of walls, not corridors or gaps beside solid walls.
fn are_walls(cells: &Grid<bool>, strips: &[Strip], floor: &Grid<bool>, usual: f64) -> bool {
    let area = strips.iter().map(|strip| strip.cells.len()).sum::<usize>() as f64;
    if area < LARGE * cells.count() as f64 || usual_thickness(cells).is_some_and(|lines| lines > LINES * usual) {
        return false;
    }
    let [low, high] = ends(strips.iter().flat_map(|strip| strip.cells.iter().copied()));
    let share = |own: i32, all: i32| f64::from(own) >= EXTENT * f64::from(all);
    let [across, up] = [extent(set(cells).map(|cell| cell.x)), extent(set(cells).map(|cell| cell.y))];
    if !share(high.x - low.x, across) || !share(high.y - low.y, up) {
        return false;
    }
    if area > MOST_OF_PLAN * f64::from((high.x - low.x) * (high.y - low.y)) {
        return false;
    }
    let depth = chessboard(cells);
    let is_within = |cell: &Cell| (low.x..=high.x).contains(&cell.x) && (low.y..=high.y).contains(&cell.y);
    let depths = set(floor).filter(is_within).map(|cell| depth[cell]);
    median(depths.collect()).is_some_and(|depth| f64::from(depth) >= ROOMS * usual)
}

/// The short strips that have the colour of the long ones, if that isn't a colour of the floor.
fn of_their_colour(
    long: &[Strip],
    mut short: Vec<Strip>,
    floor: &Grid<bool>,
    shade: impl Fn(Cell) -> u8,
) -> Vec<Strip> {
    let colour =
        |strips: &[Strip]| median(strips.iter().flat_map(|strip| &strip.cells).map(|&cell| shade(cell)).collect());
    let Some(walls) = colour(long) else { return Vec::new() };
    let is_alike = |other: u8| other.abs_diff(walls) <= ALIKE;
    let all = set(floor).count();
    let alike = set(floor).filter(|&cell| is_alike(shade(cell))).count();
    if alike as f64 > OF_FLOOR * all as f64 {
        return Vec::new();
    }
    short.retain(|strip| colour(std::slice::from_ref(strip)).is_some_and(is_alike));
    short
}

/// Areas that are neither dark nor floor, and don't reach the picture's edge.
fn strips(walls: &Grid<bool>, floor: &Grid<bool>) -> Vec<Strip> {
    let depth = chessboard(walls);
    let mut seen = walls.clone();
    for (seen, &is_floor) in seen.values_mut().iter_mut().zip(floor.values()) {
        *seen |= is_floor;
    }
    let mut strips = Vec::new();
    for index in 0..walls.len() {
        let cell = walls.cell(index);
        if seen[cell] {
            continue;
        }
        let cells = area(cell, &mut seen);
        // Beyond the edge is no line.
        if cells.iter().any(|cell| cell.neighbours().into_iter().any(|beside| walls.get(beside).is_none())) {
            continue;
        }
        let width = 2.0 * f64::from(cells.iter().map(|&cell| depth[cell]).max().unwrap_or(1));
        let is_long = cells.len() as f64 >= LONG * width * width;
        strips.push(Strip { cells, is_long });
    }
    strips
}

/// A grid like another one, in which these cells are set.
fn marked(like: &Grid<bool>, cells: impl Iterator<Item = Cell>) -> Grid<bool> {
    let mut marked = like.map(|_| false);
    for cell in cells {
        marked[cell] = true;
    }
    marked
}

fn median(mut values: Vec<u8>) -> Option<u8> {
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable(middle).1)
}

/// How far most of these places lie apart: marks of a table under the sheet can be anywhere.
fn extent(places: impl Iterator<Item = i32>) -> i32 {
    let mut places: Vec<i32> = places.collect();
    places.sort_unstable();
    let apart = (STRAY * places.len() as f64) as usize;
    places.len().checked_sub(apart + 1).map_or(0, |last| places[last] - places[apart])
}

/// The lower left and the upper right corner of cells; the origin twice if there are none.
fn ends(cells: impl Iterator<Item = Cell>) -> [Cell; 2] {
    let ends = cells.fold(None, |ends: Option<[Cell; 2]>, cell| {
        let [low, high] = ends.unwrap_or([cell; 2]);
        let low = Cell::new(low.x.min(cell.x), low.y.min(cell.y));
        Some([low, Cell::new(high.x.max(cell.x), high.y.max(cell.y))])
    });
    ends.unwrap_or([Cell::new(0, 0); 2])
}

/// The cells that are set.
fn set(cells: &Grid<bool>) -> impl Iterator<Item = Cell> {
    cells.iter().filter(|(_, is_set)| **is_set).map(|(cell, _)| cell)
}

#[cfg(test)]
mod tests {
    use super::*;

    const INK: u8 = 20;
    const PAPER: u8 = 240;

    /// Paints a rectangle: left, bottom, right, top.
    fn paint(shades: &mut Grid<u8>, [left, bottom, right, top]: [i32; 4], shade: u8) {
        (bottom..top).for_each(|y| (left..right).for_each(|x| shades[Cell::new(x, y)] = shade));
    }

    /// A rectangle with an outline of 2 pixels.
    fn outlined(shades: &mut Grid<u8>, [left, bottom, right, top]: [i32; 4], shade: u8) {
        paint(shades, [left, bottom, right, top], INK);
        paint(shades, [left + 2, bottom + 2, right - 2, top - 2], shade);
    }

    /// Two rooms with walls of 16 pixels in two lines, and a doorway in the partition, which leaves a short piece of wall; `wall`
    /// is the shade between the lines.
    fn house(wall: u8) -> Grid<u8> {
        let mut shades = Grid::filled(500, 400, PAPER);
        outlined(&mut shades, [60, 60, 440, 340], wall);
        outlined(&mut shades, [76, 76, 250, 324], PAPER);
        outlined(&mut shades, [266, 76, 424, 324], PAPER);
        // A line at the end of the short piece, where the partition meets the outer wall.
        outlined(&mut shades, [250, 290, 266, 322], wall);
        paint(&mut shades, [250, 200, 266, 290], PAPER);
        paint(&mut shades, [250, 198, 266, 200], INK);
        paint(&mut shades, [250, 290, 266, 292], INK);
        shades
    }

    fn filled(shades: &Grid<u8>, by_colour: bool) -> Grid<bool> {
        let mut walls = shades.map(|&shade| shade < 128);
        fill(&mut walls, by_colour.then_some(shades));
        walls
    }

    #[test]
    fn walls_in_two_lines_are_filled_and_rooms_are_not() {
        for (wall, by_colour) in [(205, true), (PAPER, true), (PAPER, false)] {
            let walls = filled(&house(wall), by_colour);
            // In an outer wall, in the partition; the rooms, the doorway and the ground around.
            assert!([(68, 200), (250 + 8, 120)].iter().all(|&(x, y)| walls[Cell::new(x, y)]), "{wall}");
            let floor = [(150, 200), (350, 200), (258, 250), (20, 20)];
            assert!(floor.iter().all(|&(x, y)| !walls[Cell::new(x, y)]), "{wall}");
            // A short piece of wall could be a threshold, unless it has another colour.
            assert_eq!(walls[Cell::new(258, 305)], wall != PAPER, "{wall}");
        }
    }

    #[test]
    fn marks_far_from_a_drawing_are_none_of_its_extent() {
        assert_eq!(extent((100..=200).chain([0, 3, 900])), 93);
        assert_eq!((extent(std::iter::empty()), extent([5].into_iter())), (0, 0));
    }

    #[test]
    fn thresholds_stay_open() {
        let mut shades = house(205);
        outlined(&mut shades, [250, 198, 266, 292], PAPER);
        assert!(!filled(&shades, true)[Cell::new(258, 250)]);
    }

    #[test]
    fn shelves_and_corridors_stay() {
        // Solid walls.
        let mut solid = Grid::filled(500, 400, PAPER);
        paint(&mut solid, [60, 60, 440, 340], INK);
        paint(&mut solid, [76, 76, 424, 324], PAPER);
        outlined(&mut solid, [90, 90, 110, 300], PAPER);
        assert_eq!(filled(&solid, true), solid.map(|&shade| shade < 128));
        // A long room of three times the width of walls, whose doors are closed.
        let mut corridor = house(205);
        outlined(&mut corridor, [76, 76, 424, 124], PAPER);
        assert!(!filled(&corridor, true)[Cell::new(200, 100)]);
        // Long corridors between the thin walls of an office, whose doors are closed.
        let mut office = Grid::filled(1000, 600, PAPER);
        for x in (50..950).step_by(100) {
            for y in [50, 190, 330, 470] {
                outlined(&mut office, [x, y, x + 102, y + 92], PAPER);
            }
        }
        assert_eq!(filled(&office, true), office.map(|&shade| shade < 128));
    }

    #[test]
    fn nothing_is_no_drawing() {
        for shade in [INK, PAPER] {
            let all = Grid::filled(30, 20, shade);
            assert_eq!(filled(&all, true), all.map(|&shade| shade < 128));
        }
    }
}

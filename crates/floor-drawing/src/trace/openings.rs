//! Rooms with open doors between walls that have no free ends: walls drawn as outlines.

use robovac_core::{
    geometry::Point,
    grid::{Cell, Grid, chessboard},
    math::ceil,
};
use std::collections::VecDeque;

/// A part of the floor, bounded by walls and openings.
pub(super) struct FloorPart {
    pub cells: Grid<bool>,
    /// Whether it reaches the border.
    pub meets_border: bool,
    /// Its openings, by the centres of their outermost cells.
    pub openings: Vec<[Point; 2]>,
}

/// The free cells around `seeds` that a square wider than `widest` cells can reach, with the corners and niches that it
/// leaves out. This closes openings up to that width, however the walls beside them are drawn.
///
/// A cell that lies nearer to the border than to the next wall counts as wide: the outside is open.
pub(super) fn part(blocked: &Grid<bool>, seeds: impl IntoIterator<Item = Cell>, widest: f64) -> FloorPart {
    part_with(blocked, seeds, widest, usize::MAX)
}

/// The same, with corners and niches of at most `most` cells.
pub(super) fn part_with(
    blocked: &Grid<bool>,
    seeds: impl IntoIterator<Item = Cell>,
    widest: f64,
    most: usize,
) -> FloorPart {
    let moves = chessboard(blocked);
    // A square that is n moves from the next wall is 2 n - 1 cells wide.
    let least = ceil((widest / 2.0).clamp(0.0, 200.0)) + 1;
    let (right, top) = (blocked.width() as i32 - 1, blocked.height() as i32 - 1);
    let from_border = |cell: Cell| cell.x.min(cell.y).min(right - cell.x).min(top - cell.y);
    let is_free = |cell: Cell| blocked.get(cell) == Some(&false);
    let is_wide = |cell: Cell| {
        let moves = moves.get(cell).map_or(0, |&moves| i32::from(moves));
        moves >= least || moves > from_border(cell)
    };
    let mut cells = blocked.map(|_| false);
    let mut core = VecDeque::new();
    for seed in seeds {
        // The square might not fit at the chosen point.
        if let Some(seed) = nearest(blocked, seed, is_wide).filter(|&seed| !cells[seed]) {
            cells[seed] = true;
            core.push_back(seed);
        }
    }
    let mut reached = Vec::new();
    while let Some(cell) = core.pop_front() {
        reached.push(cell);
        for next in cell.neighbours() {
            if is_free(next) && !cells[next] && is_wide(next) {
                cells[next] = true;
                core.push_back(next);
            }
        }
    }
    let meets_border = reached.iter().any(|&cell| from_border(cell) == 0);
    // The squares themselves.
    for _ in 1..least {
        let mut ring = Vec::new();
        for cell in reached {
            for next in cell.block() {
                if is_free(next) && !cells[next] {
                    cells[next] = true;
                    ring.push(next);
                }
            }
        }
        reached = ring;
    }
    niches(blocked, &mut cells, most, |cell| is_wide(cell) || from_border(cell) == 0);
    let openings = openings(blocked, &cells);
    FloorPart { cells, meets_border, openings }
}

/// The nearest cell, in steps over free cells, where the square fits.
fn nearest(blocked: &Grid<bool>, start: Cell, is_wide: impl Fn(Cell) -> bool) -> Option<Cell> {
    let mut seen = blocked.map(|_| false);
    let mut waiting = VecDeque::from([start]);
    while let Some(cell) = waiting.pop_front() {
        if is_wide(cell) {
            return Some(cell);
        }
        for next in cell.neighbours() {
            if blocked.get(next) == Some(&false) && !seen[next] {
                seen[next] = true;
                waiting.push_back(next);
            }
        }
    }
    None
}

/// Adds the rest of the floor beside `cells` from which no place where the square fits can be reached. What is larger
/// than half of them is no niche: the way round a house that is close to a page's frame.
fn niches(blocked: &Grid<bool>, cells: &mut Grid<bool>, most: usize, leads_on: impl Fn(Cell) -> bool) {
    let mut seen = blocked.map(|_| false);
    let most = most.min(cells.count() / 2);
    for index in 0..seen.len() {
        let start = seen.cell(index);
        if blocked[start] || cells[start] || seen[start] {
            continue;
        }
        let (mut part, mut next) = (vec![start], 0);
        seen[start] = true;
        let (mut is_beside, mut is_niche) = (false, true);
        while let Some(&cell) = part.get(next) {
            next += 1;
            is_niche &= !leads_on(cell);
            for neighbour in cell.neighbours().into_iter().filter(|&n| blocked.get(n) == Some(&false)) {
                is_beside |= cells[neighbour];
                if !cells[neighbour] && !seen[neighbour] {
                    seen[neighbour] = true;
                    part.push(neighbour);
                }
            }
        }
        if is_niche && is_beside && part.len() <= most {
            for cell in part {
                cells[cell] = true;
            }
        }
    }
}

/// The lines along which `cells` end without a wall.
pub(super) fn openings(blocked: &Grid<bool>, cells: &Grid<bool>) -> Vec<[Point; 2]> {
    let is_open = |cell: Cell| {
        cells.is_set(cell) && cell.neighbours().into_iter().any(|n| blocked.get(n) == Some(&false) && !cells[n])
    };
    let mut seen = blocked.map(|_| false);
    let mut lines = Vec::new();
    for index in 0..seen.len() {
        let start = seen.cell(index);
        if seen[start] || !is_open(start) {
            continue;
        }
        let (mut line, mut next) = (vec![start], 0);
        seen[start] = true;
        while let Some(&cell) = line.get(next) {
            next += 1;
            for neighbour in cell.block().filter(|&n| is_open(n)) {
                if !seen[neighbour] {
                    seen[neighbour] = true;
                    line.push(neighbour);
                }
            }
        }
        let farthest = |from: Cell| {
            let away = |cell: &Cell| (cell.x - from.x).pow(2) + (cell.y - from.y).pow(2);
            line.iter().copied().max_by_key(away).unwrap_or(from)
        };
        let end = farthest(start);
        lines.push([end, farthest(end)].map(|cell| cell.centre(1.0)));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::{from_picture, picture};

    #[test]
    fn doors_are_closed_and_corners_and_niches_stay() {
        let blocked = from_picture(
            "...............\n\
             .#############.\n\
             .#......#....#.\n\
             .#...........#.\n\
             .#...........#.\n\
             .#......#....#.\n\
             .#......#....#.\n\
             .#......#....#.\n\
             .##.##########.\n\
             .##.##########.\n\
             .#############.\n\
             ...............\n",
            |c| c == '#',
        )
        .unwrap();
        let room = part(&blocked, [Cell::new(4, 6)], 2.0);
        assert!(!room.meets_border);
        assert_eq!(
            picture(&room.cells, |&is_set| if is_set { '#' } else { '.' }).trim(),
            "...............\n...............\n..######.......\n..######.......\n..######.......\n..######.......\n\
             ..######.......\n..######.......\n...#...........\n...#...........\n...............\n..............."
        );
        assert_eq!(room.openings, [[Point::new(7.5, 8.5), Point::new(7.5, 7.5)]]);
    }

    #[test]
    fn a_narrow_way_round_a_house_is_no_niche_of_the_room_with_its_front_door() {
        // A room of 8 x 8 cells with a door of 2, in a frame that leaves 3 cells round it.
        let mut blocked = Grid::filled(22, 22, false);
        for index in 0..blocked.len() {
            let cell = blocked.cell(index);
            let from_frame = (cell.x - 2).min(cell.y - 2).min(19 - cell.x).min(19 - cell.y);
            blocked[cell] = from_frame == 0 || from_frame == 4;
        }
        for y in 7..9 {
            blocked[Cell::new(15, y)] = false;
        }
        let room = part(&blocked, [Cell::new(10, 10)], 3.0);
        assert!((64..=68).contains(&room.cells.count()), "{}", room.cells.count());
        assert_eq!(room.openings.len(), 1);
    }
}

//! Finds the cells that are floor.

use robovac_core::{
    geometry::Point,
    grid::{Cell, Grid, chessboard},
    math::ceil,
};
use std::collections::VecDeque;

/// An enclosed area that is nowhere wider than this is the inside of a wall, m (ours): walls that are drawn as outlines
/// are rarely thicker, and no room is as narrow throughout.
const LEAST_WIDTH: f64 = 0.5;

/// The free cells that can't be reached from the border, without areas too narrow to be floor.
pub(super) fn enclosed(blocked: &Grid<bool>, resolution: f64) -> Grid<bool> {
    let (width, height) = (blocked.width() as i32, blocked.height() as i32);
    let mut outside = blocked.map(|_| false);
    let border = (0..width).flat_map(|x| [Cell::new(x, 0), Cell::new(x, height - 1)]);
    let sides = (0..height).flat_map(|y| [Cell::new(0, y), Cell::new(width - 1, y)]);
    for cell in border.chain(sides) {
        flood(blocked, cell, &mut outside, |_| {});
    }
    let mut inside = blocked.map(|_| false);
    let wide = chessboard(blocked);
    // A square of 2 n - 1 cells lies around a cell that is n moves from the next wall. A single cell can always be the
    // inside of a wall.
    let least = ceil(f64::midpoint(LEAST_WIDTH / resolution, 1.0) - 1e-9).clamp(2, 255) as u8;
    for (cell, &is_outside) in outside.iter() {
        if !is_outside && !inside[cell] && !blocked[cell] && wide[cell] >= least {
            flood(blocked, cell, &mut inside, |_| {});
        }
    }
    inside
}

/// The free cells that are connected with `start`, and whether one of them is on the border.
pub(super) fn room(blocked: &Grid<bool>, start: Cell) -> (Grid<bool>, bool) {
    let mut reached = blocked.map(|_| false);
    let (right, top) = (blocked.width() as i32 - 1, blocked.height() as i32 - 1);
    let mut meets_border = false;
    flood(blocked, start, &mut reached, |cell| {
        meets_border |= cell.x == 0 || cell.y == 0 || cell.x == right || cell.y == top;
    });
    (reached, meets_border)
}

/// Marks all free cells that are connected with `start` and not marked yet, a piece of a row at a time.
fn flood(blocked: &Grid<bool>, start: Cell, marked: &mut Grid<bool>, mut seen: impl FnMut(Cell)) {
    if !blocked.contains(start) {
        return;
    }
    let width = blocked.width();
    let mut stack = vec![(start.x as usize, start.y as usize)];
    while let Some((x, y)) = stack.pop() {
        let row = y * width;
        let walls = &blocked.values()[row..row + width];
        let marks = &mut marked.values_mut()[row..row + width];
        if walls[x] || marks[x] {
            continue;
        }
        // The free cells to either side.
        let open = |x: &usize| !walls[*x] && !marks[*x];
        let first = (0..x).rev().take_while(open).last().unwrap_or(x);
        let end = (x + 1..width).take_while(open).last().unwrap_or(x) + 1;
        marks[first..end].fill(true);
        for x in first..end {
            seen(Cell::new(x as i32, y as i32));
        }
        // The first cell of each free run of the rows beside it.
        let beside = [y.checked_sub(1), (y + 1 < blocked.height()).then_some(y + 1)];
        for y in beside.into_iter().flatten() {
            let row = y * width;
            let (walls, marks) = (&blocked.values()[row..row + width], &marked.values()[row..row + width]);
            let mut was_new = false;
            for x in first..end {
                let is_new = !walls[x] && !marks[x];
                if is_new && !was_new {
                    stack.push((x, y));
                }
                was_new = is_new;
            }
        }
    }
}

/// The likely opening of a room that isn't closed: the middle of the narrowest place of the widest way from `start` to the
/// border, and the width there in cells.
pub(super) fn leak(blocked: &Grid<bool>, start: Cell) -> Option<(Point, f64)> {
    let moves = chessboard(blocked);
    let (right, top) = (blocked.width() as i32 - 1, blocked.height() as i32 - 1);
    let from_border = |cell: Cell| cell.x.min(cell.y).min(right - cell.x).min(top - cell.y);
    // `chessboard` treats the outside as a wall, but here it is open.
    let width = |cell: Cell| {
        let width = moves.get(cell).map_or(0, |&moves| i32::from(moves));
        if width > from_border(cell) { 255 } else { width as usize }
    };
    // Whoever clicks beside a wall means the room before it.
    let mut start = start;
    while let Some(wider) = start.block().filter(|&cell| width(cell) > width(start)).max_by_key(|&c| width(c)) {
        start = wider;
    }
    // Cells to continue from, by the width of the way to them, each with the cell before it.
    let mut waiting: Vec<VecDeque<(Cell, Cell)>> = vec![VecDeque::new(); 256];
    let mut before = blocked.map(|_| None);
    let mut level = width(start);
    waiting[level].push_back((start, start));
    loop {
        let Some((cell, from)) = waiting[level].pop_front() else {
            level = level.checked_sub(1)?;
            continue;
        };
        if before[cell].is_some() {
            continue;
        }
        before[cell] = Some(from);
        if from_border(cell) == 0 {
            let mut way = vec![cell];
            while let Some(from) = before[way[way.len() - 1]].filter(|&from| from != way[way.len() - 1]) {
                way.push(from);
            }
            // Squares of that width begin half of it before the opening. The nearest wall is nearest within it.
            let narrow = way.iter().rev().skip_while(|&&cell| width(cell) > level).take(2 * level + 1);
            let rooms: Vec<_> = narrow.map(|&cell| (cell, nearest_wall(blocked, cell, 2 * level as i32))).collect();
            let least = rooms.iter().map(|room| room.1).min()?;
            let within: Vec<_> = rooms.into_iter().filter(|room| room.1 == least).collect();
            return Some((within[within.len() / 2].0.centre(1.0), 2.0 * level as f64 - 1.0));
        }
        for next in cell.neighbours() {
            if blocked.get(next) == Some(&false) && before[next].is_none() {
                waiting[width(next).min(level)].push_back((next, cell));
            }
        }
    }
}

/// Square of the distance to the nearest cell of wall, cells, if it is within `most`.
fn nearest_wall(blocked: &Grid<bool>, from: Cell, most: i32) -> i32 {
    let offsets = (-most..=most).flat_map(|y| (-most..=most).map(move |x| (x, y)));
    let walls = offsets.filter(|&(x, y)| blocked.get(Cell::new(from.x + x, from.y + y)) == Some(&true));
    walls.map(|(x, y)| x * x + y * y).min().unwrap_or(i32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        floor_plan::generate::random_clutter,
        grid::{from_picture, picture, reachable},
    };

    #[test]
    fn a_flood_marks_what_steps_reach() {
        for seed in 0..20 {
            let free = random_clutter(31, 23, 0.4, seed);
            let blocked = free.map(|&is_free| !is_free);
            for start in [Cell::new(0, 0), Cell::new(15, 11), Cell::new(30, 22), Cell::new(7, 19)] {
                let (reached, meets_border) = room(&blocked, start);
                let expected = if free[start] { reachable(&free, start) } else { free.map(|_| false) };
                assert_eq!(reached, expected, "{seed} {start}");
                let on_border = |cell: Cell| cell.x == 0 || cell.y == 0 || cell.x == 30 || cell.y == 22;
                assert_eq!(meets_border, expected.iter().any(|(cell, &is_set)| is_set && on_border(cell)));
            }
        }
    }

    #[test]
    fn what_the_border_reaches_is_outside() {
        let blocked = from_picture(
            "...........\n\
             .#########.\n\
             .#...#...#.\n\
             .#...#...#.\n\
             .#...#...#.\n\
             .#####.###.\n\
             ...........\n",
            |c| c == '#',
        )
        .unwrap();
        let inside = enclosed(&blocked, 0.2);
        assert_eq!(
            picture(&inside, |&is_set| if is_set { '#' } else { '.' }).trim(),
            "...........\n...........\n..###......\n..###......\n..###......\n...........\n..........."
        );
        // Three cells of 5 cm are the inside of a wall.
        assert_eq!(enclosed(&blocked, 0.05).count(), 0);
    }

    #[test]
    fn the_inside_of_a_hollow_wall_is_no_room_at_coarse_cells() {
        let hollow = from_picture("......\n.####.\n.#..#.\n.#..#.\n.####.\n......\n", |c| c == '#').unwrap();
        for resolution in [0.05, 0.2, 0.25, 0.5] {
            assert_eq!(enclosed(&hollow, resolution).count(), 0, "{resolution}");
        }
    }

    #[test]
    fn a_leak_is_found_at_the_opening() {
        let blocked = from_picture(
            "............\n\
             .##########.\n\
             .#........#.\n\
             .#........#.\n\
             .#..........\n\
             .#........#.\n\
             .##########.\n\
             ............\n",
            |c| c == '#',
        )
        .unwrap();
        let start = Cell::new(4, 4);
        let (_, meets_border) = room(&blocked, start);
        assert!(meets_border);
        assert_eq!(leak(&blocked, start), Some((Point::new(10.5, 3.5), 1.0)));
    }

    #[test]
    fn a_wide_leak_was_found_before_its_opening() {
        // Outside there is little or much of the grid.
        for margin in [2, 20] {
            let (low, high) = (margin, margin + 40);
            let mut blocked = Grid::filled((high + margin) as usize + 1, (high + margin) as usize + 1, false);
            for i in low..=high {
                for cell in [Cell::new(i, high), Cell::new(low, i), Cell::new(high, i)] {
                    blocked[cell] = true;
                }
                blocked[Cell::new(i, low)] = !(low + 14..low + 25).contains(&i);
            }
            let (at, width) = leak(&blocked, Cell::new(low + 4, high - 5)).unwrap();
            let middle = Point::new(f64::from(low) + 19.5, f64::from(low) + 0.5);
            assert!((at - middle).norm() <= 1.0 && width == 11.0, "{at} {width}, not {middle}");
        }
    }
}

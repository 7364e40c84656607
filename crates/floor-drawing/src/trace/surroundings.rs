//! Tells a building from what lies round it within the outermost walls: a garden, or the page within its frame.

use super::{openings, region};
use robovac_core::{
    geometry::Point,
    grid::{Cell, Grid, chessboard},
    math::ceil,
};
use std::collections::VecDeque;

/// Fewest rooms of a building: a column, a kiosk or a lift stands in a hall, too.
const ROOMS: usize = 2;
/// Least share of the floor that is the building's (ours). The core of an office floor is less; on a sheet, within a thin
/// or standard frame, a building can be smaller.
const SHARE: f64 = 0.25;
const SHARE_IN_FRAME: f64 = 0.1;
/// Largest floor that stands at the outermost walls, as a share of the building's: a shed, a title block. Halls have
/// their rooms there.
const ATTACHED: f64 = 0.25;
/// How much of its box a frame fills at least, and how thick its lines are at most beside those of the building.
const RECTANGLE: f64 = 0.95;
const THIN: f64 = 0.6;
/// Longer by shorter side of sheets (ISO 216), with margins a little more or less.
const ASPECT: [f64; 2] = [1.36, 1.48];
/// Walls round walls: a frame of two lines round a garden.
const MOST_LAYERS: usize = 4;
/// No part.
const NONE: u16 = u16::MAX;

/// The floor of a building that stands free within walls, with the openings in its walls that are closed for it.
/// `inside` is the floor that the walls enclose; `None` if nothing there is a building.
pub(super) fn building(
    walls: &Grid<bool>,
    inside: &Grid<bool>,
    door: f64,
    resolution: f64,
) -> Option<(Grid<bool>, Vec<[Point; 2]>)> {
    let mut found: Option<(Grid<bool>, Vec<[Point; 2]>)> = None;
    for _ in 0..MOST_LAYERS {
        let floor = found.as_ref().map_or(inside, |(floor, _)| floor);
        let Some(next) = within(walls, floor, door, resolution) else { break };
        found = Some(next);
    }
    found
}

/// A part of the floor: what is left connected if doors are closed.
#[derive(Clone)]
struct RoomShare {
    /// A cell where a square as wide as a door fits.
    seed: Cell,
    /// Cells.
    area: usize,
    /// Sides of its cells at the outermost walls, and at what stands free within them.
    at_outer: usize,
    at_inner: usize,
}

impl RoomShare {
    /// Whether it stands free of the outermost walls.
    fn is_free(&self) -> bool {
        self.at_outer * 10 <= self.at_inner
    }
}

/// The building within the outermost walls of `floor`.
fn within(walls: &Grid<bool>, floor: &Grid<bool>, door: f64, resolution: f64) -> Option<(Grid<bool>, Vec<[Point; 2]>)> {
    let blocked = floor.map(|&is_floor| !is_floor);
    let (labels, mut parts) = parts(&blocked, door);
    let outer = outer(&labels);
    let part_of = |cell: Cell| labels.get(cell).map(|&label| usize::from(label));
    for (cell, &is_wall) in labels.map(|&label| label == NONE).iter().filter(|(_, is_wall)| **is_wall) {
        for next in cell.neighbours() {
            if let Some(part) = part_of(next).and_then(|label| parts.get_mut(label)) {
                *if outer[cell] { &mut part.at_outer } else { &mut part.at_inner } += usize::from(is_wall);
            }
        }
    }
    let (around, yard) = parts.iter().enumerate().max_by_key(|(_, part)| part.at_outer)?;
    let others = || parts.iter().enumerate().filter(|&(index, _)| index != around).map(|(_, part)| part);
    let area = |is_free: bool| others().filter(|part| part.is_free() == is_free).map(|part| part.area).sum::<usize>();
    let (building, attached) = (area(true), area(false));
    let rooms = others().filter(|part| part.is_free()).count();
    let share = |part: usize, of: usize| part as f64 / of.max(1) as f64;
    if yard.at_outer == 0 || rooms < ROOMS || share(attached, building) > ATTACHED {
        return None;
    }
    let least = if is_frame(walls, &labels, &outer, &parts) { SHARE_IN_FRAME } else { SHARE };
    if share(building, building + attached + yard.area) < least {
        return None;
    }
    let mut shut = blocked;
    // Up to the closed doors of the building.
    let outside = openings::part(&shut, [yard.seed], door);
    for index in 0..shut.len() {
        let cell = shut.cell(index);
        let is_attached = part_of(cell).and_then(|label| parts.get(label)).is_some_and(|part| !part.is_free());
        shut[cell] |= outside.cells[cell] || outer[cell] || is_attached;
    }
    let left = region::enclosed(&shut, resolution);
    // What lies round a building without closed walls flows through it.
    (left.count() * 2 > building).then_some((left, outside.openings))
}

/// The outermost walls, and what is too narrow for a part between them.
fn outer(labels: &Grid<u16>) -> Grid<bool> {
    let mut outer = labels.map(|_| false);
    let mut waiting = vec![Cell::new(0, 0)];
    while let Some(cell) = waiting.pop() {
        if labels.get(cell) == Some(&NONE) && !outer[cell] {
            outer[cell] = true;
            waiting.extend(cell.block());
        }
    }
    outer
}

/// The parts of the floor with openings up to `door` cells closed, and the part of every cell.
fn parts(blocked: &Grid<bool>, door: f64) -> (Grid<u16>, Vec<RoomShare>) {
    let moves = chessboard(blocked);
    // As in `openings::part`.
    let least = ceil((door / 2.0).clamp(0.0, 200.0)) + 1;
    let is_wide = |cell: Cell| moves.get(cell).is_some_and(|&moves| i32::from(moves) >= least);
    let mut labels = blocked.map(|_| NONE);
    let mut parts: Vec<RoomShare> = Vec::new();
    let mut reached = VecDeque::new();
    for index in 0..labels.len() {
        let seed = labels.cell(index);
        if labels[seed] != NONE || !is_wide(seed) || parts.len() >= usize::from(NONE) {
            continue;
        }
        let label = parts.len() as u16;
        parts.push(RoomShare { seed, area: 0, at_outer: 0, at_inner: 0 });
        labels[seed] = label;
        let mut core = vec![seed];
        while let Some(cell) = core.pop() {
            reached.push_back(cell);
            for next in cell.neighbours() {
                if is_wide(next) && labels[next] == NONE {
                    labels[next] = label;
                    core.push(next);
                }
            }
        }
    }
    // What is narrow belongs to the nearest part.
    while let Some(cell) = reached.pop_front() {
        let label = labels[cell];
        parts[usize::from(label)].area += 1;
        for next in cell.neighbours() {
            if blocked.get(next) == Some(&false) && labels[next] == NONE {
                labels[next] = label;
                reached.push_back(next);
            }
        }
    }
    (labels, parts)
}

/// Whether the outermost walls are a rectangle of lines that are thin beside the building's walls, or with the sides of a
/// sheet of paper.
fn is_frame(walls: &Grid<bool>, labels: &Grid<u16>, outer: &Grid<bool>, parts: &[RoomShare]) -> bool {
    let (mut low, mut high) = (Cell::new(i32::MAX, i32::MAX), Cell::new(i32::MIN, i32::MIN));
    let (mut within, mut lines, mut standing) = (0_usize, 0_usize, 0_usize);
    for (cell, &is_outer) in outer.iter() {
        if is_outer {
            lines += usize::from(walls[cell]);
            continue;
        }
        standing += usize::from(labels[cell] == NONE);
        within += 1;
        low = Cell::new(low.x.min(cell.x), low.y.min(cell.y));
        high = Cell::new(high.x.max(cell.x), high.y.max(cell.y));
    }
    let (width, height) = (f64::from(high.x - low.x + 1), f64::from(high.y - low.y + 1));
    let sides = |count: fn(&RoomShare) -> usize| parts.iter().map(count).sum::<usize>().max(1) as f64;
    // What stands free has floor on two sides.
    let [line, wall] =
        [lines as f64 / sides(|part| part.at_outer), 2.0 * standing as f64 / sides(|part| part.at_inner)];
    let aspect = width.max(height) / width.min(height);
    within as f64 >= RECTANGLE * width * height && (line <= THIN * wall || (ASPECT[0]..=ASPECT[1]).contains(&aspect))
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::floor_plan::{self, FloorPlan, generate::random_flat};

    /// m.
    const RESOLUTION: f64 = 0.05;
    const DOOR: f64 = 1.25 / RESOLUTION;

    /// The walls of a plan, `margin` cells from the edges of the grid.
    fn drawn(plan: &FloorPlan, margin: i32) -> Grid<bool> {
        let cells = &plan.occupancy;
        let side = 2 * margin as usize;
        let mut walls = Grid::filled(cells.width() + side, cells.height() + side, false);
        for (cell, state) in cells.iter() {
            // A flat is as wide as its sheet: what isn't free is wall if it is beside floor.
            let is_wall = !state.is_free() && cell.block().any(|near| cells.get(near).is_some_and(|c| c.is_free()));
            walls[Cell::new(cell.x + margin, cell.y + margin)] = is_wall;
        }
        walls
    }

    /// Draws a rectangle of lines `thick` cells wide, `away` from the edges of the grid.
    fn frame(walls: &mut Grid<bool>, away: i32, thick: i32) {
        let (right, top) = (walls.width() as i32 - 1, walls.height() as i32 - 1);
        for index in 0..walls.len() {
            let cell = walls.cell(index);
            let edge = cell.x.min(cell.y).min(right - cell.x).min(top - cell.y);
            walls[cell] |= (away..away + thick).contains(&edge);
        }
    }

    fn found(walls: &Grid<bool>) -> Option<usize> {
        let inside = region::enclosed(walls, RESOLUTION);
        building(walls, &inside, DOOR, RESOLUTION).map(|(floor, _)| floor.count())
    }

    #[test]
    fn a_house_is_found_within_a_garden_wall_and_within_a_frame_of_two_lines() {
        for seed in 0..12 {
            let flat = random_flat(2, 2, seed);
            let floor = region::enclosed(&drawn(&flat, 3), RESOLUTION).count();
            assert_eq!(found(&drawn(&flat, 3)), None, "a flat alone, {seed}");
            // 3 m of garden, 1 m of paper.
            let mut walls = drawn(&flat, 80);
            frame(&mut walls, 20, 3);
            assert_eq!(found(&walls), Some(floor), "garden, {seed}");
            frame(&mut walls, 4, 1);
            frame(&mut walls, 8, 1);
            assert_eq!(found(&walls), Some(floor), "garden in a frame, {seed}");
        }
    }

    #[test]
    fn the_built_in_rooms_have_nothing_round_them() {
        for plan in floor_plan::ROOMS.iter().map(|info| (info.build)()) {
            assert_eq!(found(&drawn(&plan, 3)), None, "{}", plan.name);
        }
    }

    #[test]
    fn the_core_of_an_office_floor_is_no_building() {
        // 24 x 18 m, with a core of two rooms of 4 x 5 m, 9 % of the floor; and twice as large, if only one room.
        for (core, divided) in [([8.0, 5.0], true), ([14.0, 10.0], false)] {
            let mut walls = Grid::filled(520, 400, false);
            frame(&mut walls, 20, 3);
            let half = core.map(|side: f64| (side / 2.0 / RESOLUTION) as i32);
            for index in 0..walls.len() {
                let cell = walls.cell(index);
                let (x, y) = ((cell.x - 260).abs(), (cell.y - 200).abs());
                let is_side = x <= half[0] && y <= half[1] && (x > half[0] - 2 || y > half[1] - 2);
                walls[cell] |= is_side || divided && cell.x == 260 && y <= half[1];
            }
            assert_eq!(found(&walls), None, "{core:?}");
        }
    }
}

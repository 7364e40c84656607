//! Tells a building from what lies round it within the outermost walls: a garden, or the page within its frame.

use super::{
    house::{FreeStanding, Site},
    openings, region,
};
use robovac_core::{
    geometry::Point,
    grid::{Cell, Grid, chessboard, largest_part, reachable},
    math::{ceil, cos, sin},
};
use std::{
    collections::{BTreeMap, VecDeque},
    f64::consts::FRAC_PI_2,
};

/// Fewest rooms of a building, unless a thin frame is round it: a column, a kiosk or a lift stands in a hall, too.
pub(super) const ROOMS: usize = 2;
/// Share of the floor from which on a building is one (ours). The core of an office floor has less; so has a house in a
/// large garden, which is told by what it is like, and a building on a sheet, within a thin or standard frame: a flat of
/// 50 m² at 1:100 is a twelfth of an A4 sheet.
pub(super) const SHARE: f64 = 0.25;
pub(super) const LEAST_SHARE: f64 = 0.05;
/// Largest floor that stands at the outermost walls, as a share of the building's: a shed, a title block. Halls have
/// their rooms there.
pub(super) const ATTACHED: f64 = 0.25;
/// On a sheet, its share of all within the frame: the title block.
const TITLE_BLOCK: f64 = 0.2;
/// How much of its box a frame fills at least, and how thick its lines are at most beside those of the building.
const RECTANGLE: f64 = 0.95;
const THIN: f64 = 0.6;
/// Angles at which that box is looked for: every half a degree.
const ANGLES: u32 = 180;
/// Longer by shorter side of sheets (ISO 216), with margins a little more or less.
const ASPECT: [f64; 2] = [1.36, 1.48];
/// Walls round walls: a frame of two lines round a garden.
pub(super) const MOST_LAYERS: usize = 4;
/// No part.
const NONE: u16 = u16::MAX;

/// A building that stands free within walls.
pub(super) struct Building {
    pub floor: Grid<bool>,
    /// The openings in its walls that are closed for it.
    pub openings: Vec<[Point; 2]>,
    /// What it is if it has little of the floor.
    pub small: Option<FreeStanding>,
}

/// What stands free within walls.
#[derive(Default)]
pub(super) struct Surrounded {
    pub building: Option<Building>,
    /// The floor of what may be a building.
    pub in_doubt: Option<Grid<bool>>,
}

/// What stands free within the walls round `site.floor`; `can_be_small` is whether a house with little of it is looked for.
pub(super) fn building(walls: &Grid<bool>, site: Site<'_>, mut can_be_small: bool) -> Surrounded {
    let mut found = Surrounded::default();
    let (mut outside, _) = region::room(walls, Cell::new(0, 0));
    for _ in 0..MOST_LAYERS {
        let floor = found.building.as_ref().map_or(site.floor, |found| &found.floor);
        let Some((next, is_sheet)) = within(walls, Site { floor, outside: &outside, ..site }, can_be_small) else {
            break;
        };
        // What stands in a house is no other house, but a page can be round a garden.
        can_be_small &= is_sheet;
        if next.small == Some(FreeStanding::InDoubt) {
            found.in_doubt = Some(next.floor);
            break;
        }
        for (cell, &is_floor) in floor.iter() {
            outside[cell] |= is_floor && !next.floor[cell];
        }
        found.building = Some(next);
    }
    found
}

/// A part of the floor: what is left connected if doors are closed.
#[derive(Default)]
pub(super) struct RoomShare {
    /// Cells where a square as wide as a door fits; none in what is narrower throughout.
    pub seeds: Vec<Cell>,
    /// Cells.
    pub area: usize,
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

/// The building within the outermost walls of a place, and whether these are the frame of a sheet.
fn within(walls: &Grid<bool>, site: Site<'_>, can_be_small: bool) -> Option<(Building, bool)> {
    let Site { floor, outside, door, resolution, .. } = site;
    let blocked = floor.map(|&is_floor| !is_floor);
    let (mut labels, mut parts) = parts(&blocked, door);
    let outer = outer(&labels);
    split_ring(&mut labels, &mut parts, &outer, door);
    for (cell, _) in labels.iter().filter(|(_, label)| **label == NONE) {
        for next in cell.neighbours() {
            if let Some(part) = labels.get(next).and_then(|&label| parts.get_mut(usize::from(label))) {
                *if outer[cell] { &mut part.at_outer } else { &mut part.at_inner } += 1;
            }
        }
    }
    let beyond = chessboard(outside);
    let is_near_outside = |cell: Cell| beyond.get(cell).is_some_and(|&moves| f64::from(moves) <= door);
    // No room is as small as a door is wide: a place where it just fits between two others.
    join(&mut labels, &mut parts, &outer, &is_near_outside, |a, b, _| (a.area.min(b.area) as f64) < door * door);
    join(&mut labels, &mut parts, &outer, &is_near_outside, |_, _, between| between == [true, true]);
    let part_of = |cell: Cell| labels.get(cell).map(|&label| usize::from(label));
    let (around, yard) = parts.iter().enumerate().max_by_key(|(_, part)| part.at_outer)?;
    let others = || parts.iter().enumerate().filter(|&(index, _)| index != around).map(|(_, part)| part);
    let rooms = || others().filter(|part| !part.seeds.is_empty());
    let area = |is_free: bool| rooms().filter(|part| part.is_free() == is_free).map(|part| part.area).sum::<usize>();
    let (building, attached) = (area(true), area(false));
    let blocks = rooms().filter(|part| !part.is_free()).count();
    let rooms = rooms().filter(|part| part.is_free()).count();
    let share = |part: usize, of: usize| part as f64 / of.max(1) as f64;
    let all = building + attached + yard.area;
    if yard.at_outer == 0 || rooms == 0 {
        return None;
    }
    let frame = frame(walls, &labels, &outer, &parts);
    let is_sheet = frame.is_some() && rooms >= ROOMS;
    let has_title_block = is_sheet && blocks == 1 && share(attached, all) <= TITLE_BLOCK;
    let is_small = !is_sheet && share(building, all) < SHARE;
    let least = if is_sheet || can_be_small { LEAST_SHARE } else { SHARE };
    let is_alone = rooms < ROOMS && frame != Some(PageFrame::Thin);
    if is_alone || share(attached, building) > ATTACHED && !has_title_block || share(building, all) < least {
        return None;
    }
    let mut shut = blocked.clone();
    // Up to the closed doors of the building.
    let outside = openings::part(&shut, yard.seeds.iter().copied(), door);
    for index in 0..shut.len() {
        let cell = shut.cell(index);
        let label = part_of(cell);
        let is_attached = label.and_then(|label| parts.get(label)).is_some_and(|part| !part.is_free());
        // Between a frame and a house close to it there is no place as wide as a door.
        let is_ring = yard.seeds.is_empty() && label == Some(around);
        shut[cell] |= outside.cells[cell] || outer[cell] || is_attached || is_ring;
    }
    let left = region::enclosed(&shut, resolution);
    let openings = if yard.seeds.is_empty() { openings::openings(&blocked, &left) } else { outside.openings };
    // What lies round a building without closed walls flows through it.
    if left.count() * 2 <= building {
        return None;
    }
    let small = is_small.then(|| site.kind(&left));
    (small != Some(FreeStanding::Block)).then_some((Building { floor: left, openings, small }, is_sheet))
}

/// Removes floor that no wall connects with the building, if it is little: a shed, a tree, a pond.
pub(super) fn remove_outbuildings(floor: &mut Grid<bool>, walls: &Grid<bool>) {
    let Some(start) = largest_part(floor) else { return };
    let mut all = floor.clone();
    for (cell, &is_wall) in all.values_mut().iter_mut().zip(walls.values()) {
        *cell |= is_wall;
    }
    let building = reachable(&all, start);
    let others = floor.iter().filter(|&(cell, &is_floor)| is_floor && !building[cell]).count();
    if others as f64 <= ATTACHED * (floor.count() - others) as f64 {
        for (cell, &is_building) in floor.values_mut().iter_mut().zip(building.values()) {
            *cell &= is_building;
        }
    }
}

/// Makes a part of its own of the ring between the outermost walls and a building close to them, where it is narrower than
/// a door throughout: through a front door it would belong to the room behind that.
fn split_ring(labels: &mut Grid<u16>, parts: &mut Vec<RoomShare>, outer: &Grid<bool>, door: f64) {
    let blocked = labels.map(|&label| label == NONE);
    let moves = chessboard(&blocked);
    let least = least_moves(door);
    // The squares that are as wide as a door.
    let mut near = blocked.map(|_| false);
    let mut edge: Vec<Cell> =
        moves.iter().filter(|&(_, &moves)| i32::from(moves) >= least).map(|(cell, _)| cell).collect();
    for &cell in &edge {
        near[cell] = true;
    }
    for _ in 1..least {
        let mut next = Vec::new();
        for cell in edge.into_iter().flat_map(Cell::block) {
            if blocked.get(cell) == Some(&false) && !near[cell] {
                near[cell] = true;
                next.push(cell);
            }
        }
        edge = next;
    }
    let sides = |cell: Cell| cell.neighbours().into_iter().filter(|&next| outer.is_set(next)).count();
    let (mut seen, mut all) = (near.clone(), 0);
    let mut ring: (Vec<Cell>, usize) = (Vec::new(), 0);
    for (start, _) in labels.iter().filter(|(_, label)| **label != NONE) {
        all += sides(start);
        if seen[start] {
            continue;
        }
        seen[start] = true;
        let (mut cells, mut next, mut at_outer) = (vec![start], 0, 0);
        while let Some(&cell) = cells.get(next) {
            next += 1;
            at_outer += sides(cell);
            for beside in cell.neighbours().into_iter().filter(|&beside| blocked.get(beside) == Some(&false)) {
                if !seen[beside] {
                    seen[beside] = true;
                    cells.push(beside);
                }
            }
        }
        if at_outer > ring.1 {
            ring = (cells, at_outer);
        }
    }
    // Most of the way round.
    if ring.1 == 0 || 2 * ring.1 < all || parts.len() >= usize::from(NONE) {
        return;
    }
    let label = parts.len() as u16;
    for &cell in &ring.0 {
        parts[usize::from(labels[cell])].area -= 1;
        labels[cell] = label;
    }
    parts.push(RoomShare { area: ring.0.len(), ..RoomShare::default() });
}

/// Moves from the next wall of the middle of a square that is wider than a door: as in [`openings::part`].
fn least_moves(door: f64) -> i32 {
    ceil((door / 2.0).clamp(0.0, 200.0)) + 1
}

/// Joins parts at the outermost walls, by what is between them where they meet: whether something that stands free, and
/// whether an outermost wall with the outside beyond it. Both are where a building's corner is closer than a door's width to
/// the outermost walls; doors between rooms are beside partitions.
fn join(
    labels: &mut Grid<u16>,
    parts: &mut [RoomShare],
    outer: &Grid<bool>,
    is_near_outside: &impl Fn(Cell) -> bool,
    are_one: impl Fn(&RoomShare, &RoomShare, [bool; 2]) -> bool,
) {
    // A room reaches the outermost walls through its front door, too.
    let is_round =
        |label: u16| parts.get(usize::from(label)).is_some_and(|part| 2 * part.at_outer >= part.at_inner.max(1));
    let mut meetings: BTreeMap<[u16; 2], [bool; 2]> = BTreeMap::new();
    for (cell, &label) in labels.iter().filter(|(_, label)| is_round(**label)) {
        for next in cell.neighbours() {
            let Some(&other) = labels.get(next).filter(|&&other| other != label && is_round(other)) else { continue };
            let [at_inner, at_outer] = meetings.entry([label.min(other), label.max(other)]).or_default();
            for beside in cell.block().chain(next.block()).filter(|&beside| labels.get(beside) == Some(&NONE)) {
                *at_inner |= !outer[beside];
                *at_outer |= outer[beside] && is_near_outside(beside);
            }
        }
    }
    let mut joined: Vec<u16> = (0..parts.len() as u16).collect();
    let are_one =
        |[a, b]: [u16; 2], between: [bool; 2]| are_one(&parts[usize::from(a)], &parts[usize::from(b)], between);
    for (pair, _) in meetings.iter().filter(|&(&pair, &between)| are_one(pair, between)) {
        let [to, from] = pair.map(|label| joined[usize::from(label)]);
        joined.iter_mut().filter(|label| **label == from).for_each(|label| *label = to);
    }
    for index in 0..parts.len() {
        let to = usize::from(joined[index]);
        if to != index {
            let part = std::mem::take(&mut parts[index]);
            parts[to].area += part.area;
            parts[to].at_outer += part.at_outer;
            parts[to].at_inner += part.at_inner;
            parts[to].seeds.extend(part.seeds);
        }
    }
    for label in labels.values_mut().iter_mut().filter(|label| **label != NONE) {
        *label = joined[usize::from(*label)];
    }
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
pub(super) fn parts(blocked: &Grid<bool>, door: f64) -> (Grid<u16>, Vec<RoomShare>) {
    let moves = chessboard(blocked);
    let least = least_moves(door);
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
        parts.push(RoomShare { seeds: vec![seed], area: 0, at_outer: 0, at_inner: 0 });
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
    // What is nowhere as wide, and has no way to what is.
    for index in 0..labels.len() {
        let cell = labels.cell(index);
        if blocked[cell] || labels[cell] != NONE || parts.len() >= usize::from(NONE) {
            continue;
        }
        let label = parts.len() as u16;
        let mut part = RoomShare::default();
        labels[cell] = label;
        let mut waiting = vec![cell];
        while let Some(cell) = waiting.pop() {
            part.area += 1;
            for next in cell.neighbours() {
                if blocked.get(next) == Some(&false) && labels[next] == NONE {
                    labels[next] = label;
                    waiting.push(next);
                }
            }
        }
        parts.push(part);
    }
    (labels, parts)
}

/// A rectangle of walls, at any angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum PageFrame {
    /// Of lines that are thin beside the building's walls.
    Thin,
    /// With the sides of a sheet of paper.
    Sheet,
}

/// The frame that the outermost walls are.
fn frame(walls: &Grid<bool>, labels: &Grid<u16>, outer: &Grid<bool>, parts: &[RoomShare]) -> Option<PageFrame> {
    let (mut within, mut lines, mut standing) = (0_usize, 0_usize, 0_usize);
    // The first and the last cell of each row.
    let mut ends: Vec<[Point; 2]> = Vec::new();
    let mut row = i32::MIN;
    for (cell, &is_outer) in outer.iter() {
        if is_outer {
            lines += usize::from(walls[cell]);
            continue;
        }
        standing += usize::from(labels[cell] == NONE);
        within += 1;
        match ends.last_mut().filter(|_| row == cell.y) {
            Some([_, last]) => *last = cell.centre(1.0),
            None => ends.push([cell.centre(1.0); 2]),
        }
        row = cell.y;
    }
    // The smallest box around it.
    let box_at = |angle: f64| {
        let (sin, cos) = (sin(angle), cos(angle));
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for at in ends.as_flattened() {
            for (axis, value) in [at.x * cos + at.y * sin, at.y * cos - at.x * sin].into_iter().enumerate() {
                low[axis] = low[axis].min(value);
                high[axis] = high[axis].max(value);
            }
        }
        // Half a cell beyond the centres.
        [high[0] - low[0] + 1.0, high[1] - low[1] + 1.0]
    };
    let boxes = (0..ANGLES).map(|index| box_at(FRAC_PI_2 * f64::from(index) / f64::from(ANGLES)));
    let [width, height] = boxes.min_by(|a, b| (a[0] * a[1]).total_cmp(&(b[0] * b[1])))?;
    let sides = |count: fn(&RoomShare) -> usize| parts.iter().map(count).sum::<usize>().max(1) as f64;
    // What stands free has floor on two sides.
    let [line, wall] =
        [lines as f64 / sides(|part| part.at_outer), 2.0 * standing as f64 / sides(|part| part.at_inner)];
    let aspect = width.max(height) / width.min(height);
    let is_sheet = (ASPECT[0]..=ASPECT[1]).contains(&aspect);
    let kind = if line <= THIN * wall { Some(PageFrame::Thin) } else { is_sheet.then_some(PageFrame::Sheet) };
    kind.filter(|_| within as f64 >= RECTANGLE * width * height)
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
    fn draw_frame(walls: &mut Grid<bool>, away: i32, thick: i32) {
        let (right, top) = (walls.width() as i32 - 1, walls.height() as i32 - 1);
        for index in 0..walls.len() {
            let cell = walls.cell(index);
            let edge = cell.x.min(cell.y).min(right - cell.x).min(top - cell.y);
            walls[cell] |= (away..away + thick).contains(&edge);
        }
    }

    fn found(walls: &Grid<bool>) -> Option<usize> {
        let inside = region::enclosed(walls, RESOLUTION);
        let outside = region::room(walls, Cell::new(0, 0)).0;
        let site = Site { floor: &inside, outside: &outside, door: DOOR, resolution: RESOLUTION, has_garden: false };
        building(walls, site, true).building.map(|building| building.floor.count())
    }

    #[test]
    fn a_house_is_found_within_a_garden_wall_and_within_a_frame_of_two_lines() {
        for seed in 0..12 {
            let flat = random_flat(2, 2, seed);
            let floor = region::enclosed(&drawn(&flat, 3), RESOLUTION).count();
            assert_eq!(found(&drawn(&flat, 3)), None, "a flat alone, {seed}");
            // 3 m of garden, 1 m of paper.
            let mut walls = drawn(&flat, 80);
            draw_frame(&mut walls, 20, 3);
            assert_eq!(found(&walls), Some(floor), "garden, {seed}");
            draw_frame(&mut walls, 4, 1);
            draw_frame(&mut walls, 8, 1);
            assert_eq!(found(&walls), Some(floor), "garden in a frame, {seed}");
        }
    }

    /// The walls turned around the middle of a larger grid, by degrees.
    fn turned(walls: &Grid<bool>, degrees: f64) -> Grid<bool> {
        let (width, height) = (walls.width() as f64, walls.height() as f64);
        let side = width.hypot(height).ceil() as usize + 4;
        let (sin, cos) = (sin(-degrees.to_radians()), cos(-degrees.to_radians()));
        let mut turned = Grid::filled(side, side, false);
        for index in 0..turned.len() {
            let at = turned.cell(index).centre(1.0).coords.add_scalar(-0.5 * side as f64);
            // As a picture becomes cells: a cell with something of a wall is wall.
            turned.values_mut()[index] = [-0.3, 0.3].into_iter().any(|dx| {
                [-0.3, 0.3].into_iter().any(|dy| {
                    let (x, y) = (at.x + dx, at.y + dy);
                    let from = [x * cos - y * sin + 0.5 * width, x * sin + y * cos + 0.5 * height];
                    walls.is_set(Cell::new(from[0].floor() as i32, from[1].floor() as i32))
                })
            });
        }
        turned
    }

    #[test]
    fn a_house_is_found_whatever_the_turn_of_the_house_and_of_the_frame_though_a_corner_is_close_to_it() {
        for seed in 0..2 {
            // 1.5 m round the house, less than a door at the corners of one that is turned within its frame.
            let house = drawn(&random_flat(2, 2, seed), 8);
            for degrees in [0.0, 7.0, 20.0, 45.0] {
                let alone = turned(&house, degrees);
                let floor = region::enclosed(&alone, RESOLUTION).count();
                let (mut low, mut high) = (Cell::new(i32::MAX, i32::MAX), Cell::new(0, 0));
                for (cell, _) in alone.iter().filter(|(_, is_wall)| **is_wall) {
                    (low, high) = (
                        Cell::new(low.x.min(cell.x), low.y.min(cell.y)),
                        Cell::new(high.x.max(cell.x), high.y.max(cell.y)),
                    );
                }
                for gap in [12, 30] {
                    // A page, `gap` cells from the house where it is nearest.
                    let margin = gap + 6;
                    let (width, height) = (high.x - low.x + 1 + 2 * margin, high.y - low.y + 1 + 2 * margin);
                    let mut page = Grid::filled(width as usize, height as usize, false);
                    for (cell, _) in alone.iter().filter(|(_, is_wall)| **is_wall) {
                        page[Cell::new(cell.x - low.x + margin, cell.y - low.y + margin)] = true;
                    }
                    draw_frame(&mut page, 5, 1);
                    assert_eq!(
                        found(&page),
                        Some(floor),
                        "seed {seed}, house at {degrees}°, {gap} cells from the frame"
                    );
                    let askew = turned(&page, -degrees);
                    let share = found(&askew).unwrap_or(0) as f64 / floor as f64;
                    assert!((share - 1.0).abs() < 0.05, "seed {seed}, frame at {degrees}°, {gap} cells: {share}");
                }
            }
        }
    }

    #[test]
    fn a_room_stays_the_building_s_though_its_open_front_door_leads_to_a_ring_narrower_than_a_door() {
        for (seed, gap) in [(0, 10), (1, 16), (2, 20)] {
            let mut walls = drawn(&random_flat(2, 2, seed), gap + 6);
            let floor = region::enclosed(&walls, RESOLUTION).count();
            draw_frame(&mut walls, 5, 1);
            assert_eq!(found(&walls), Some(floor), "closed, seed {seed}");
            // 0.9 m, at the first place of the left wall with a room behind it that is wider than a door.
            let middle = walls.height() as i32 / 2;
            let x = (0..gap + 12).rfind(|&x| walls.is_set(Cell::new(x, middle))).unwrap();
            let is_room = |y: i32| (-6..24).all(|up| (1..30).all(|right| !walls[Cell::new(x + right, y + up)]));
            let from = (gap + 12..walls.height() as i32 - gap - 36).find(|&y| is_room(y)).unwrap();
            for y in from..from + 18 {
                (gap + 4..=x).for_each(|x| walls[Cell::new(x, y)] = false);
            }
            let share = found(&walls).unwrap_or(0) as f64 / floor as f64;
            assert!((0.98..1.02).contains(&share), "seed {seed}, {gap} cells from the frame: {share}");
        }
    }

    #[test]
    fn the_built_in_rooms_have_nothing_round_them() {
        for plan in floor_plan::ROOMS.iter().map(|info| (info.build)()) {
            assert_eq!(found(&drawn(&plan, 3)), None, "{}", plan.name);
        }
    }

    #[test]
    fn rooms_round_a_core_are_no_garden_though_their_doors_are_beside_it() {
        // 12 x 9 m round a core of 6 x 4 m with two rooms; four partitions leave doors of 0.9 m at its corners.
        let mut walls = Grid::filled(280, 220, false);
        draw_frame(&mut walls, 20, 3);
        for index in 0..walls.len() {
            let cell = walls.cell(index);
            let (x, y) = (cell.x - 140, cell.y - 110);
            let is_core = x.abs() <= 60 && y.abs() <= 40 && (x.abs() > 57 || y.abs() > 37) || x == 0 && y.abs() <= 40;
            let is_partition = (x.abs() >= 78 && (y - x.signum() * 39).abs() <= 1)
                || (y.abs() >= 58 && (x + y.signum() * 59).abs() <= 1);
            walls[cell] |= is_core || is_partition && x.abs() < 120 && y.abs() < 90;
        }
        assert_eq!(found(&walls), None);
    }

    #[test]
    fn the_core_of_an_office_floor_is_no_building() {
        // 24 x 18 m, with a core of two rooms of 4 x 5 m, 9 % of the floor; and twice as large, if only one room.
        for (core, divided) in [([8.0, 5.0], true), ([14.0, 10.0], false)] {
            let mut walls = Grid::filled(520, 400, false);
            draw_frame(&mut walls, 20, 3);
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

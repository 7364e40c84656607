//! A building that stands free within the outermost walls, closed as if these weren't there: a garden can be narrower than
//! a terrace door.

use super::{
    behind::{OpenRoom, open_rooms},
    house::{FreeStanding, Site},
    openings, region,
    surroundings::{ATTACHED, LEAST_SHARE, MOST_LAYERS, ROOMS, SHARE, parts},
};
use robovac_core::grid::{Cell, Grid};

/// Widths of terrace doors that are closed, m (ours): they are up to 3 m wide, and cells are added to that. The narrower ones
/// first, so that a recess before a door is no part of the room behind it.
const TERRACE_DOORS: [f64; 3] = [1.8, 2.5, 3.2];
/// Least share of a building that is enclosed without them.
const CLOSED: f64 = 0.5;
/// Least share of the floor that may be a building's, whatever it is like: the core of an office floor with a wide opening
/// may be as large.
const IN_DOUBT: f64 = 0.5 * SHARE;
/// Share of the floor that is all of it: what stands free is the inner line of the walls round it then.
const ALL: f64 = 0.98;

/// A building in its garden.
pub(super) struct FreeBuilding {
    pub floor: Grid<bool>,
    /// Its rooms behind openings wider than outer doors.
    pub behind: Vec<OpenRoom>,
    /// Whether it has little of the floor.
    pub is_small: bool,
    /// Whether it may as well be the core of a hall.
    is_in_doubt: bool,
}

impl FreeBuilding {
    /// Whether it is no core of a hall, if openings up to `gap` cells are to be closed: all of its openings tell a building from
    /// its garden.
    pub fn is_decided(&self, gap: f64) -> bool {
        !self.is_in_doubt || self.behind.iter().filter_map(OpenRoom::widest).all(|(_, width)| width <= gap)
    }
}

/// The building that stands free within the walls of a place, with its openings up to `gap` cells closed, and its terrace
/// doors, unless openings as narrow as an outer door stay open.
pub(super) fn building(walls: &Grid<bool>, site: Site<'_>, gap: f64) -> Option<FreeBuilding> {
    let Site { floor: inside, door, resolution, .. } = site;
    let mut found: Option<FreeBuilding> = None;
    let (mut standing, mut outside) = (walls.clone(), site.outside.clone());
    for _ in 0..MOST_LAYERS {
        let all = found.as_ref().map_or(inside, |found| &found.floor);
        standing = free_standing(&standing, &outside);
        let all_cells = all.count().max(1) as f64;
        let Some(mut next) = closed(&standing, [gap, door], resolution, CLOSED * LEAST_SHARE * all_cells) else {
            break;
        };
        let share = next.floor.count() as f64 / all_cells;
        if found.is_none() && next.behind.is_empty() && share >= ALL {
            outside = beyond(&standing, &next.floor);
            continue;
        }
        // What stands in a house is no other house: only the outermost one can be small.
        let can_be_small = !next.behind.is_empty() && found.is_none();
        next.is_small = share < SHARE;
        if next.is_small && !can_be_small || share < LEAST_SHARE || !has_rooms_in_a_garden(&next, all, door) {
            break;
        }
        let kind = next.is_small.then(|| site.kind(&next.floor));
        if kind == Some(FreeStanding::Block) && share < IN_DOUBT {
            break;
        }
        next.is_in_doubt = kind.is_some_and(|kind| kind != FreeStanding::House)
            || found.as_ref().is_some_and(|found| found.is_in_doubt);
        next.is_small |= found.as_ref().is_some_and(|found| found.is_small);
        outside = beyond(&standing, &next.floor);
        found = Some(next);
    }
    found
}

/// The walls without those that touch the outside, and all that is connected with these.
fn free_standing(walls: &Grid<bool>, outside: &Grid<bool>) -> Grid<bool> {
    let mut standing = walls.clone();
    let mut waiting: Vec<Cell> = outside.iter().filter(|(_, is_outside)| **is_outside).map(|(cell, _)| cell).collect();
    while let Some(cell) = waiting.pop() {
        for beside in cell.block() {
            if standing.is_set(beside) {
                standing[beside] = false;
                waiting.push(beside);
            }
        }
    }
    standing
}

/// Cells of the box around the walls: they enclose no more.
fn box_cells(walls: &Grid<bool>) -> f64 {
    let (mut low, mut high) = (Cell::new(i32::MAX, i32::MAX), Cell::new(0, 0));
    for (cell, _) in walls.iter().filter(|(_, is_wall)| **is_wall) {
        low = Cell::new(low.x.min(cell.x), low.y.min(cell.y));
        high = Cell::new(high.x.max(cell.x), high.y.max(cell.y));
    }
    if low.x > high.x { 0.0 } else { f64::from(high.x - low.x + 1) * f64::from(high.y - low.y + 1) }
}

/// What is neither wall nor floor.
fn beyond(walls: &Grid<bool>, floor: &Grid<bool>) -> Grid<bool> {
    without(&walls.map(|is_wall| !is_wall), floor)
}

/// The cells that aren't `removed`.
fn without(cells: &Grid<bool>, removed: &Grid<bool>) -> Grid<bool> {
    let mut rest = cells.clone();
    for (cell, &is_removed) in rest.values_mut().iter_mut().zip(removed.values()) {
        *cell &= !is_removed;
    }
    rest
}

/// Whether a building has rooms, is mostly closed, and has hardly anything but a garden round it; `all` is the floor of both.
fn has_rooms_in_a_garden(building: &FreeBuilding, all: &Grid<bool>, door: f64) -> bool {
    let rooms = |floor: &Grid<bool>| {
        let (_, parts) = parts(&floor.map(|is_floor| !is_floor), door);
        parts.into_iter().filter(|part| !part.seeds.is_empty()).map(|part| part.area)
    };
    let area = building.floor.count() as f64;
    let behind: usize = building.behind.iter().map(|room| room.cells.len()).sum();
    if rooms(&building.floor).count() < ROOMS || area - (behind as f64) < CLOSED * area {
        return false;
    }
    let mut around: Vec<usize> = rooms(&without(all, &building.floor)).collect();
    around.sort_unstable();
    let _garden = around.pop();
    around.iter().sum::<usize>() as f64 <= ATTACHED * area
}

/// What walls enclose with openings closed; `None` if that is less than so many cells without terrace doors.
fn closed(walls: &Grid<bool>, [gap, door]: [f64; 2], resolution: f64, least: f64) -> Option<FreeBuilding> {
    if box_cells(walls) < least {
        return None;
    }
    let with = |gap: f64| {
        let mut shut = openings::part_with(walls, [Cell::new(0, 0)], gap, 0).cells;
        for (cell, &is_wall) in shut.values_mut().iter_mut().zip(walls.values()) {
            *cell |= is_wall;
        }
        region::enclosed(&shut, resolution)
    };
    let mut floor = with(door);
    if (floor.count() as f64) < least {
        return None;
    }
    let mut behind = Vec::new();
    let terraces = TERRACE_DOORS.map(|width| width / resolution).into_iter().chain([gap]);
    let mut widest = door;
    for width in terraces.filter(|_| gap >= door) {
        if width <= widest {
            continue;
        }
        widest = width;
        let wide = with(width);
        let rooms = open_rooms(walls, &wide, without(&wide, &floor));
        for room in rooms.into_iter().filter(OpenRoom::is_walled) {
            for &cell in &room.cells {
                floor[cell] = true;
            }
            behind.push(room);
        }
    }
    Some(FreeBuilding { floor, behind, is_small: false, is_in_doubt: false })
}

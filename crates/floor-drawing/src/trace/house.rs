//! Tells a small house in a large garden from a block of rooms in a hall.

use super::surroundings::parts;
use robovac_core::grid::{Cell, Grid};
use std::collections::{BTreeSet, VecDeque};

/// Fewest rooms of a house that are connected by doors of their own, the share of its floor that they have at least, and
/// its least floor, m² (ours). Rooms of a hall have their doors to the hall.
const ROOMS: usize = 3;
const CONNECTED: f64 = 0.7;
const FLOOR: f64 = 25.0;
/// How much thinner its walls can be than those round all, cells: lines cover one cell or two.
const THINNER: u32 = 1;

/// What a building that stands free is, if it has little of the floor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FreeStanding {
    /// A house in its garden.
    House,
    /// A house or a block.
    InDoubt,
    /// A block of rooms, a core, a kiosk.
    Block,
}

/// What is known of a place that walls enclose.
#[derive(Debug, Clone, Copy)]
pub(super) struct Site<'a> {
    /// All of its floor, and what is beyond its walls.
    pub floor: &'a Grid<bool>,
    pub outside: &'a Grid<bool>,
    /// Width of an outer door, cells.
    pub door: f64,
    /// Side of a cell, m.
    pub resolution: f64,
    /// Whether a layer is named after a garden or a fence.
    pub has_garden: bool,
}

impl Site<'_> {
    /// What a building with this floor is.
    pub fn kind(&self, building: &Grid<bool>) -> FreeStanding {
        if building.count() as f64 * self.resolution * self.resolution < FLOOR {
            return FreeStanding::Block;
        }
        let yard = without(self.floor, building);
        let is_thin = || {
            let walls = without(&self.floor.map(|is_floor| !is_floor), building);
            let of = |from: &Grid<bool>| thickness(&walls, &without(from, &yard), &yard);
            // A hall's walls are thicker than its partitions, a house's thicker than those of its garden.
            matches!([of(building), of(self.outside)], [Some(own), Some(outer)] if own + THINNER < outer)
        };
        let is_connected = self.is_connected(building);
        if self.has_garden || is_connected && !is_thin() {
            FreeStanding::House
        } else if is_connected || touch(building, &yard) && !is_thin() {
            FreeStanding::InDoubt
        } else {
            FreeStanding::Block
        }
    }

    /// Whether most of a building is rooms with doors between them.
    fn is_connected(&self, building: &Grid<bool>) -> bool {
        let (labels, parts) = parts(&building.map(|is_floor| !is_floor), self.door);
        let part_of = |cell: Cell| labels.get(cell).map(|&label| usize::from(label)).filter(|&part| part < parts.len());
        let mut doors = BTreeSet::new();
        for (cell, _) in building.iter().filter(|(_, is_floor)| **is_floor) {
            for next in cell.neighbours() {
                if let (Some(a), Some(b)) = (part_of(cell), part_of(next))
                    && a != b
                {
                    doors.insert([a, b]);
                }
            }
        }
        let mut seen = vec![false; parts.len()];
        (0..parts.len()).any(|first| {
            let (mut rooms, mut area, mut waiting) = (0, 0, vec![first]);
            while let Some(part) = waiting.pop() {
                if std::mem::replace(&mut seen[part], true) {
                    continue;
                }
                rooms += usize::from(!parts[part].seeds.is_empty());
                area += parts[part].area;
                waiting.extend(doors.range([part, 0]..[part + 1, 0]).map(|&[_, other]| other));
            }
            rooms >= ROOMS && area as f64 >= CONNECTED * building.count() as f64
        })
    }
}

/// Whether a layer's name is that of a garden or what is round it, in English, German, French, Spanish or Italian.
pub(super) fn names_garden(layer: &str) -> bool {
    const WORDS: [&str; 11] =
        ["garden", "garten", "fence", "zaun", "einfriedung", "hedge", "hecke", "lawn", "rasen", "jardin", "giardino"];
    let name = layer.to_lowercase();
    name.split(|c: char| !c.is_alphabetic()).any(|part| WORDS.iter().any(|word| part.starts_with(word)))
}

/// The cells that aren't `removed`.
fn without(cells: &Grid<bool>, removed: &Grid<bool>) -> Grid<bool> {
    let mut rest = cells.clone();
    for (cell, &is_removed) in rest.values_mut().iter_mut().zip(removed.values()) {
        *cell &= !is_removed;
    }
    rest
}

/// Whether there is a way between them.
fn touch(a: &Grid<bool>, b: &Grid<bool>) -> bool {
    a.iter().any(|(cell, &is_its)| is_its && cell.neighbours().into_iter().any(|next| b.is_set(next)))
}

/// Usual thickness of the walls between `from` and `to`, cells: the median where they are seen from `to`.
fn thickness(walls: &Grid<bool>, from: &Grid<bool>, to: &Grid<bool>) -> Option<u32> {
    let mut away = walls.map(|_| u32::MAX);
    let mut waiting = VecDeque::new();
    for (cell, _) in from.iter().filter(|(_, is_its)| **is_its) {
        away[cell] = 0;
        waiting.push_back(cell);
    }
    let mut found = Vec::new();
    while let Some(cell) = waiting.pop_front() {
        if away[cell] > 0 && cell.neighbours().into_iter().any(|next| to.is_set(next)) {
            found.push(away[cell]);
        }
        for next in cell.block() {
            if walls.is_set(next) && !from[next] && away[next] == u32::MAX {
                away[next] = away[cell] + 1;
                waiting.push_back(next);
            }
        }
    }
    found.sort_unstable();
    found.get(found.len() / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gardens_are_known_by_the_names_of_their_layers() {
        for name in ["GARDEN", "A-Gartenmauer", "L_FENCE_2", "Zaun", "jardin"] {
            assert!(names_garden(name), "{name}");
        }
        for name in ["WALLS", "Kindergarten", "defence", ""] {
            assert!(!names_garden(name), "{name}");
        }
    }
}

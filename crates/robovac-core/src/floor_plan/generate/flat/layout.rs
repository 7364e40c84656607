//! Rooms and doors of a flat.

use super::{
    CELL, FlatSpec,
    area::{Area, Side},
    passable::MOST_BITS,
};
use crate::rng::Rng;
use rand::RngExt;

/// Thickness of walls between rooms and around the flat, cells.
const WALL: i32 = 2;
const OUTER: i32 = 3;
/// Widths of doors, cells: 0.7 to 0.9 m.
const DOORS: std::ops::RangeInclusive<i32> = 14..=18;
/// Widths of openings without a door, cells.
const OPENINGS: std::ops::RangeInclusive<i32> = 20..=34;
/// Distance of a door from the corner of a room, cells.
const JAMB: i32 = 2;
/// Flats below this area have one room, m².
const STUDIO: f64 = 44.0;
/// How often a plan is drawn before the plainest one is taken; of those of the rarest size, one in 300 has rooms of common
/// sizes.
const DRAWS: u32 = 10_000;

/// What a room is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum RoomUse {
    /// Living room.
    Living,
    /// Living room with kitchen and dining table, in the middle of the flat.
    OpenPlan,
    /// The one room of a small flat.
    Studio,
    Kitchen,
    Bedroom,
    Child,
    Study,
    Bath,
    Storage,
    /// Corridor, or the room behind the front door.
    Hall,
}

impl RoomUse {
    /// Number of uses.
    #[cfg(test)]
    pub const COUNT: usize = 10;

    /// Usual area, m², and least width, cells.
    fn usual(self) -> (f64, i32) {
        match self {
            Self::Living | Self::OpenPlan | Self::Studio => (24.0, 64),
            Self::Bedroom => (15.0, 56),
            Self::Child => (12.0, 50),
            Self::Study => (10.0, 46),
            Self::Kitchen => (10.0, 42),
            Self::Bath => (6.0, 34),
            Self::Storage => (4.0, 26),
            Self::Hall => (5.0, 26),
        }
    }

    /// Longest side for each unit of the shorter one.
    fn slimmest(self) -> f64 {
        if matches!(self, Self::Bath | Self::Storage | Self::Hall) { 3.0 } else { 2.2 }
    }

    fn fits(self, area: &Area) -> bool {
        let (short, long) = (area.width().min(area.height()), area.width().max(area.height()));
        (self.usual().1..=MOST_BITS).contains(&short) && f64::from(long) <= self.slimmest() * f64::from(short)
    }
}

/// A room.
#[derive(Debug, Clone)]
pub(super) struct FlatRoom {
    pub area: Area,
    pub purpose: RoomUse,
}

/// A gap in the wall between two rooms.
#[derive(Debug, Clone)]
pub(super) struct Doorway {
    /// The cells of the wall that it takes.
    pub gap: Area,
    /// The rooms that it joins, by number.
    pub rooms: [usize; 2],
    /// Whether it is wider than a door.
    pub is_wide: bool,
}

/// A flat without furniture.
#[derive(Debug, Clone)]
pub(super) struct FlatLayout {
    /// Columns and rows with the outer walls.
    pub width: i32,
    pub height: i32,
    pub rooms: Vec<FlatRoom>,
    pub doors: Vec<Doorway>,
}

impl FlatLayout {
    pub fn new(spec: &FlatSpec, rng: &mut Rng) -> Self {
        let [low, high] = spec.area_m2;
        let area = if low < high { rng.random_range(low..high) } else { low };
        let kind = rng.random_range(0..100);
        let found = (0..DRAWS).find_map(|_| match area {
            ..STUDIO => studio(area, rng),
            _ if kind < 60 => corridor(area, rng),
            _ => open_plan(area, rng),
        });
        let drawn = found.unwrap_or_else(|| single(area));
        drawn.mirrored(rng)
    }

    /// Area between the outer walls, m².
    pub fn area_m2(&self) -> f64 {
        f64::from((self.width - 2 * OUTER) * (self.height - 2 * OUTER)) * CELL * CELL
    }

    /// In one of the eight ways in which a plan can lie.
    fn mirrored(mut self, rng: &mut Rng) -> Self {
        if rng.random_bool(0.5) {
            let width = self.width;
            self.each(|area| area.flipped(width));
        }
        if rng.random_bool(0.5) {
            self.each(Area::transposed);
            std::mem::swap(&mut self.width, &mut self.height);
        }
        if rng.random_bool(0.5) {
            let width = self.width;
            self.each(|area| area.flipped(width));
        }
        self
    }

    fn each(&mut self, change: impl Fn(&Area) -> Area) {
        self.rooms.iter_mut().for_each(|room| room.area = change(&room.area));
        self.doors.iter_mut().for_each(|door| door.gap = change(&door.gap));
    }

    fn empty(inner: (i32, i32)) -> Self {
        Self { width: inner.0 + 2 * OUTER, height: inner.1 + 2 * OUTER, rooms: Vec::new(), doors: Vec::new() }
    }

    fn add(&mut self, purpose: RoomUse, area: Area) -> usize {
        self.rooms.push(FlatRoom { area, purpose });
        self.rooms.len() - 1
    }

    /// A door between two rooms side by side, often near a corner; `None` if they have too little wall in common.
    fn join(&mut self, one: usize, other: usize, is_wide: bool, rng: &mut Rng) -> Option<()> {
        let (a, b) = (self.rooms[one].area, self.rooms[other].area);
        let upright = a.right + WALL == b.left || b.right + WALL == a.left;
        let level = a.top + WALL == b.bottom || b.top + WALL == a.bottom;
        let (from, to) = if upright {
            (a.bottom.max(b.bottom), a.top.min(b.top))
        } else {
            (a.left.max(b.left), a.right.min(b.right))
        };
        let wanted = if is_wide { rng.random_range(OPENINGS) } else { rng.random_range(DOORS) };
        let width = if is_wide { wanted.min(to - from - 2 * JAMB) } else { wanted };
        let room = to - from - width - 2 * JAMB;
        if upright == level || room < 0 || width < *DOORS.start() {
            return None;
        }
        let near = room.min(rng.random_range(0..4));
        let off = match rng.random_range(0..10) {
            0..3 => near,
            3..6 => room - near,
            _ => rng.random_range(0..=room),
        };
        let (start, end) = (from + JAMB + off, from + JAMB + off + width);
        let gap = if upright {
            Area::new(a.right.min(b.right), start, a.left.max(b.left), end)
        } else {
            Area::new(start, a.top.min(b.top), end, a.bottom.max(b.bottom))
        };
        self.doors.push(Doorway { gap, rooms: [one, other], is_wide: width > *DOORS.end() });
        Some(())
    }

    fn checked(self) -> Option<Self> {
        let fits = self.rooms.iter().all(|room| match room.purpose {
            RoomUse::Hall => room.area.width().min(room.area.height()) >= 20,
            purpose => purpose.fits(&room.area),
        });
        fits.then_some(self)
    }
}

impl Doorway {
    /// The wall of a room of that area in which it is.
    pub fn side(&self, room: &Area) -> Side {
        match self.gap {
            gap if gap.right == room.left => Side::Left,
            gap if gap.left == room.right => Side::Right,
            gap if gap.top == room.bottom => Side::Bottom,
            _ => Side::Top,
        }
    }

    /// The floor `depth` cells deep behind it, in a room of that area.
    pub fn inside(&self, room: &Area, depth: i32) -> Area {
        let Area { left, bottom, right, top } = self.gap;
        match self.side(room) {
            Side::Left => Area::new(right, bottom, right + depth, top),
            Side::Right => Area::new(left - depth, bottom, left, top),
            Side::Bottom => Area::new(left, top, right, top + depth),
            Side::Top => Area::new(left, bottom - depth, right, bottom),
        }
    }
}

fn cells(metres: f64) -> i32 {
    (metres / CELL).round() as i32
}

/// Width of an area, cells, that is so high.
fn across(area: f64, height: i32) -> i32 {
    (area / (f64::from(height) * CELL * CELL)).round() as i32
}

/// One room, bath and hall or kitchen at its side.
fn studio(area: f64, rng: &mut Rng) -> Option<FlatLayout> {
    let height = rng.random_range(96..150);
    let width = across(area, height);
    let strip = rng.random_range(36..50);
    let bath = rng.random_range(34..52);
    let mut flat = FlatLayout::empty((width, height));
    let (left, bottom) = (OUTER, OUTER);
    let (right, top) = (left + width, bottom + height);
    let split = bottom + strip;
    let main = flat.add(RoomUse::Studio, Area::new(left, split + WALL, right, top));
    let wet = flat.add(RoomUse::Bath, Area::new(left, bottom, left + bath, split));
    let rest = Area::new(left + bath + WALL, bottom, right, split);
    let purpose = if rest.width() >= 42 && rng.random_bool(0.6) { RoomUse::Kitchen } else { RoomUse::Hall };
    let hall = flat.add(purpose, rest);
    flat.join(main, hall, true, rng)?;
    let entry = if rng.random_bool(0.5) { hall } else { main };
    flat.join(wet, entry, false, rng)?;
    flat.checked()
}

/// Rooms on both sides of a corridor.
fn corridor(area: f64, rng: &mut Rng) -> Option<FlatLayout> {
    let depths = [rng.random_range(52..100), rng.random_range(52..100)];
    let hall = rng.random_range(22..34);
    let height = depths[0] + depths[1] + hall + 2 * WALL;
    let width = across(area, height);
    let mut rows = [Vec::new(), Vec::new()];
    for purpose in programme(area, false, rng) {
        rows[usize::from(rng.random_bool(0.5))].push(purpose);
    }
    if rows.iter().any(Vec::is_empty) {
        return None;
    }
    let mut flat = FlatLayout::empty((width, height));
    let (left, right) = (OUTER, OUTER + width);
    let bottoms = [OUTER, OUTER + depths[0] + hall + 2 * WALL];
    let way = (OUTER + depths[0] + WALL, OUTER + depths[0] + WALL + hall);
    // A long corridor can have a closet at its end.
    let closet = if width > 150 && rng.random_bool(0.4) { rng.random_range(26..40) } else { 0 };
    let end = if closet > 0 { right - closet - WALL } else { right };
    let hall = flat.add(RoomUse::Hall, Area::new(left, way.0, end, way.1));
    if closet > 0 {
        let closet = flat.add(RoomUse::Storage, Area::new(right - closet, way.0, right, way.1));
        flat.join(closet, hall, false, rng)?;
    }
    for ((row, depth), bottom) in rows.iter().zip(depths).zip(bottoms) {
        let widths = split(width, row, rng)?;
        let (mut at, mut last) = (left, None);
        for (&purpose, wide) in row.iter().zip(widths) {
            let room = flat.add(purpose, Area::new(at, bottom, at + wide, bottom + depth));
            flat.join(room, hall, false, rng)?;
            if let Some(last) = last.replace(room) {
                also_join(&mut flat, last, room, rng);
            }
            at += wide + WALL;
        }
    }
    flat.checked()
}

/// A living room with a kitchen, as deep as the flat, and rooms at one or both of its sides.
fn open_plan(area: f64, rng: &mut Rng) -> Option<FlatLayout> {
    let height = rng.random_range(90..200);
    let width = across(area, height);
    let living = rng.random_range(70..=MOST_BITS);
    let sides = if area > 65.0 && rng.random_bool(0.7) { 2 } else { 1 };
    let rest = width - living - sides * WALL;
    let first = if sides == 2 { rest * rng.random_range(40..60) / 100 } else { rest };
    let columns = [first, rest - first];
    let mut homes = [Vec::new(), Vec::new()];
    for purpose in programme(area, true, rng) {
        homes[if sides == 2 { usize::from(rng.random_bool(0.5)) } else { 0 }].push(purpose);
    }
    if homes[..sides as usize].iter().any(Vec::is_empty) {
        return None;
    }
    let mut flat = FlatLayout::empty((width, height));
    let edge = if sides == 2 { OUTER + columns[0] + WALL } else { OUTER };
    let middle = flat.add(RoomUse::OpenPlan, Area::new(edge, OUTER, edge + living, OUTER + height));
    let lefts = if sides == 2 { [OUTER, edge + living + WALL] } else { [edge + living + WALL, 0] };
    for ((home, wide), left) in homes.iter().zip(columns).zip(lefts).take(sides as usize) {
        let (mut at, mut last) = (OUTER, None);
        for (&purpose, high) in home.iter().zip(split(height, home, rng)?) {
            let room = flat.add(purpose, Area::new(left, at, left + wide, at + high));
            flat.join(room, middle, purpose == RoomUse::Hall, rng)?;
            if let Some(last) = last.replace(room) {
                also_join(&mut flat, last, room, rng);
            }
            at += high + WALL;
        }
    }
    flat.checked()
}

/// The rooms besides the corridor or the open living room, in random order.
fn programme(area: f64, is_open: bool, rng: &mut Rng) -> Vec<RoomUse> {
    use RoomUse::{Bath, Bedroom, Child, Hall, Kitchen, Living, Storage, Study};
    let mut rooms = vec![Bedroom, Bath];
    if is_open {
        rooms.push(Hall);
    } else {
        rooms.extend([Living, Kitchen]);
    }
    for (from, choice) in
        [(55.0, [Child, Study, Bedroom]), (78.0, [Study, Child, Storage]), (98.0, [Child, Bath, Bath])]
    {
        if area > from + rng.random_range(-6.0..6.0) {
            rooms.push(choice[rng.random_range(0..choice.len())]);
        }
    }
    for last in (1..rooms.len()).rev() {
        rooms.swap(last, rng.random_range(0..=last));
    }
    rooms
}

/// Splits a length among rooms by their usual area, give or take a quarter; walls between them are taken off.
fn split(length: i32, rooms: &[RoomUse], rng: &mut Rng) -> Option<Vec<i32>> {
    let walls = WALL * (rooms.len() as i32 - 1);
    let shares: Vec<f64> = rooms.iter().map(|room| room.usual().0.sqrt() * rng.random_range(0.75..1.25)).collect();
    let sum: f64 = shares.iter().sum();
    let mut lengths: Vec<i32> = shares.iter().map(|share| (f64::from(length - walls) * share / sum) as i32).collect();
    *lengths.last_mut()? += length - walls - lengths.iter().sum::<i32>();
    Some(lengths)
}

/// A second door between neighbours, now and then: homes have loops.
fn also_join(flat: &mut FlatLayout, one: usize, other: usize, rng: &mut Rng) {
    use RoomUse::{Bath, Bedroom, Child, Kitchen, Living, Study};
    let mut pair = [flat.rooms[one].purpose, flat.rooms[other].purpose];
    pair.sort_by_key(|&purpose| purpose as usize);
    let (chance, is_wide) = match pair {
        [Living, Kitchen] => (0.6, rng.random_bool(0.5)),
        [Living, Bedroom | Study] | [Bedroom, Child | Bath] => (0.3, false),
        _ => (0.0, false),
    };
    if rng.random_bool(chance) {
        // Too short a wall has none.
        let _ = flat.join(one, other, is_wide, rng);
    }
}

/// One room without walls inside, as large as a room can be, beside its bath.
fn single(area: f64) -> FlatLayout {
    let strip = cells(2.0);
    let height = cells((area.sqrt() * 0.9).min(6.0)) + strip + WALL;
    let width = across(area, height);
    let mut flat = FlatLayout::empty((width, height));
    let split = OUTER + strip;
    let main = flat.add(RoomUse::Studio, Area::new(OUTER, split + WALL, OUTER + width, OUTER + height));
    let bath = flat.add(RoomUse::Bath, Area::new(OUTER, OUTER, OUTER + cells(2.2), split));
    let hall = flat.add(RoomUse::Hall, Area::new(OUTER + cells(2.2) + WALL, OUTER, OUTER + width, split));
    for (room, width) in [(bath, 16), (hall, 24)] {
        let left = flat.rooms[room].area.left + JAMB;
        let gap = Area::new(left, split, left + width, split + WALL);
        flat.doors.push(Doorway { gap, rooms: [main, room], is_wide: width > *DOORS.end() });
    }
    flat
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::seeded;

    #[test]
    fn plans_are_found_at_every_size() {
        for tenth in 250..=1200 {
            let area = f64::from(tenth) / 10.0;
            let spec = FlatSpec { area_m2: [area, area], ..FlatSpec::default() };
            let flat = FlatLayout::new(&spec, &mut seeded(tenth as u64, 0));
            let studio = flat.rooms.iter().any(|room| room.purpose == RoomUse::Studio);
            assert_eq!(studio, area < STUDIO, "{area}");
            assert!((flat.area_m2() / area - 1.0).abs() < 0.02, "{area}");
        }
    }

    #[test]
    fn the_plainest_plan_exists_at_every_size() {
        for area in 25..=120 {
            let flat = single(f64::from(area));
            assert!((flat.area_m2() / f64::from(area) - 1.0).abs() < 0.02);
            assert!(flat.rooms.iter().all(|room| room.area.width().min(room.area.height()) <= MOST_BITS));
        }
    }

    #[test]
    fn doors_lie_in_walls_between_their_rooms() {
        for seed in 0..300 {
            let flat = FlatLayout::new(&FlatSpec::default(), &mut seeded(seed, 0));
            let mut reached = vec![false; flat.rooms.len()];
            reached[0] = true;
            for _ in &flat.rooms {
                for door in &flat.doors {
                    let [one, other] = door.rooms;
                    (reached[one], reached[other]) = (reached[one] | reached[other], reached[one] | reached[other]);
                }
            }
            assert!(reached.iter().all(|&reached| reached), "{seed}");
            for door in &flat.doors {
                assert!(flat.rooms.iter().all(|room| !room.area.overlaps(&door.gap)), "{seed}");
                for room in door.rooms {
                    let area = flat.rooms[room].area;
                    assert!(area.holds(&door.inside(&area, 10)), "{seed} {door:?}");
                }
            }
        }
    }
}

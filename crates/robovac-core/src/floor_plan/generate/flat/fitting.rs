//! One room being furnished.

use super::{
    area::{Area, Side},
    layout::Doorway,
    passable::Mask,
    piece::{FurniturePart, Piece, Stand},
};
use crate::{floor_plan::Object, rng::Rng};
use rand::RngExt;

/// Depth of the floor behind doors that stays clear, cells.
const DOOR_CLEAR: i32 = 14;
/// Distance of the place behind a door from which ways begin, cells.
const DOOR_STEP: i32 = 5;
/// How often a place for a piece is looked for.
const TRIES: u32 = 14;
/// Distance from the walls of what stands in the open, cells.
const OPEN: i32 = 10;

/// Kinds of places.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PlaceKind {
    /// Anywhere along a wall.
    Wall,
    /// At a wall, in a corner.
    Corner,
    /// Across the room from the last piece at a wall.
    Facing,
    /// Away from the walls.
    Open,
    /// Anywhere.
    Anywhere,
}

/// A room with the furniture that it has so far.
#[derive(Debug)]
pub(super) struct Fitting {
    room: Area,
    /// Places that have to be reached from each other.
    doors: Vec<(i32, i32)>,
    /// Floor of the pieces, and floor before them and behind doors that stays clear.
    claimed: Vec<Area>,
    clear: Vec<Area>,
    mask: Mask,
    last: Option<Stand>,
    /// What is drawn into the cells.
    pub solids: Vec<Area>,
    pub objects: Vec<Object>,
}

impl Fitting {
    pub fn new<'a>(room: Area, doors: impl Iterator<Item = &'a Doorway>) -> Self {
        let mut fitting = Self {
            room,
            doors: Vec::new(),
            claimed: Vec::new(),
            clear: Vec::new(),
            mask: Mask::new(room),
            last: None,
            solids: Vec::new(),
            objects: Vec::new(),
        };
        for door in doors {
            fitting.clear.push(door.inside(&room, DOOR_CLEAR));
            let Area { left, bottom, right, top } = door.inside(&room, 2 * DOOR_STEP);
            fitting.doors.push((i32::midpoint(left, right), i32::midpoint(bottom, top)));
        }
        fitting
    }

    /// Looks for a place for a piece, anew at every try; returns where it stands.
    pub fn put(&mut self, make: fn(&mut Rng) -> Piece, spot: PlaceKind, rng: &mut Rng) -> Option<Stand> {
        (0..TRIES).find_map(|_| {
            let piece = make(rng);
            let stand = self.choose(&piece, spot, rng)?;
            self.place(&piece, stand).then_some(stand)
        })
    }

    /// The open leaf of a door, 4 cm thick, at one of its ends.
    pub fn hang(&mut self, door: &Doorway, at_end: bool) {
        let side = door.side(&self.room);
        let inside = door.inside(&self.room, door.gap.width().max(door.gap.height()));
        let stand = Stand { area: inside, back: side };
        let [left, bottom, right, top] = inside.metres();
        let (wide, deep) = match side {
            Side::Left | Side::Right => (top - bottom, right - left),
            Side::Bottom | Side::Top => (right - left, top - bottom),
        };
        // In the cells beside the opening.
        let (from, to) = if at_end { (wide + 0.005, wide + 0.045) } else { (-0.045, -0.005) };
        let (near, far) = (0.005, deep - 0.005);
        let leaf = FurniturePart::Slab(vec![[from, near], [to, near], [to, far], [from, far]]);
        let Some(taken) = stand.taken(&leaf) else { return };
        let mut mask = self.mask.clone();
        mask.take(&taken);
        // Another door or the corner of the room can be in the way.
        let is_clear = !self.claimed.iter().chain(&self.clear).any(|other| other.overlaps(&taken));
        if is_clear && self.room.holds(&taken) && mask.is_passable(&self.doors) {
            self.mask = mask;
            self.claimed.push(taken);
            self.objects.extend(stand.object(&leaf));
        }
    }

    /// The dock, at any wall with floor before it; the robot starts `ahead` cells before its back.
    pub fn dock(&mut self, ahead: i32, rng: &mut Rng) -> Option<Stand> {
        let piece = Piece { parts: vec![FurniturePart::Dock([0.25, 0.0])], ..Piece::new(10, 1).front(22) };
        (0..20 * TRIES).find_map(|_| {
            let stand = self.choose(&piece, PlaceKind::Wall, rng)?;
            let Area { left, bottom, right, top } = stand.front(2 * ahead - 2);
            self.doors.push((i32::midpoint(left, right), i32::midpoint(bottom, top)));
            let stands = self.place(&piece, stand);
            if !stands {
                self.doors.pop();
            }
            stands.then_some(stand)
        })
    }

    fn choose(&self, piece: &Piece, spot: PlaceKind, rng: &mut Rng) -> Option<Stand> {
        let (wide, deep) = piece.size;
        let mut back = Side::ALL[rng.random_range(0..4)];
        if spot == PlaceKind::Facing {
            back = self.last?.back.opposite();
        }
        let along = self.room.length(back) - wide;
        let away =
            self.room.length(if matches!(back, Side::Left | Side::Right) { Side::Bottom } else { Side::Left }) - deep;
        if along < 0 || away < 0 {
            return None;
        }
        let in_range = |rng: &mut Rng, low: i32, high: i32| if low < high { rng.random_range(low..=high) } else { low };
        // Not everything is moved right up to the wall.
        let gap = in_range(rng, 0, away.min(1));
        let (u, v) = match spot {
            PlaceKind::Wall => (in_range(rng, 0, along), gap),
            PlaceKind::Corner => (if rng.random_bool(0.5) { 0 } else { along }, 0),
            PlaceKind::Facing => {
                let Area { left, bottom, right, top } = self.last?.area;
                let middle = match back {
                    Side::Bottom => i32::midpoint(left, right) - self.room.left,
                    Side::Top => self.room.right - i32::midpoint(left, right),
                    Side::Left => self.room.top - i32::midpoint(bottom, top),
                    Side::Right => i32::midpoint(bottom, top) - self.room.bottom,
                };
                ((middle - wide / 2 + rng.random_range(-4..=4)).clamp(0, along), gap)
            }
            PlaceKind::Open => (in_range(rng, OPEN, along - OPEN), in_range(rng, OPEN, away - OPEN)),
            PlaceKind::Anywhere => (in_range(rng, 0, along), in_range(rng, 0, away)),
        };
        let room = self.room;
        let area = match back {
            Side::Bottom => Area::new(room.left + u, room.bottom + v, room.left + u + wide, room.bottom + v + deep),
            Side::Top => Area::new(room.right - u - wide, room.top - v - deep, room.right - u, room.top - v),
            Side::Left => Area::new(room.left + v, room.top - u - wide, room.left + v + deep, room.top - u),
            Side::Right => Area::new(room.right - v - deep, room.bottom + u, room.right - v, room.bottom + u + wide),
        };
        room.holds(&area).then_some(Stand { area, back })
    }

    /// Leaves the piece there if the floor is free and the robot still gets about.
    fn place(&mut self, piece: &Piece, stand: Stand) -> bool {
        let front = stand.front(piece.front);
        let lies = piece.parts.iter().all(|part| matches!(part, FurniturePart::Rug(_)));
        let is_free = |area: &Area| !self.claimed.iter().any(|other| other.overlaps(area));
        let is_clear = !self.clear.iter().any(|other| other.overlaps(&stand.area));
        let stands = self.room.holds(&front) && is_clear && is_free(&stand.area) && is_free(&front);
        if !lies && !stands {
            return false;
        }
        let taken: Vec<Area> = piece.parts.iter().filter_map(|part| stand.taken(part)).collect();
        if !taken.iter().all(|cells| self.room.holds(cells)) {
            return false;
        }
        let mut mask = self.mask.clone();
        for cells in &taken {
            mask.take(cells);
        }
        if !mask.is_passable(&self.doors) {
            return false;
        }
        self.mask = mask;
        if !lies {
            self.claimed.push(stand.area);
            self.clear.push(front);
            self.last = Some(stand);
        }
        for part in &piece.parts {
            match part {
                FurniturePart::Solid(edges) => self.solids.push(stand.area(*edges)),
                other => self.objects.extend(stand.object(other)),
            }
        }
        true
    }
}

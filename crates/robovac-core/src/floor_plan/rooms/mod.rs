//! The built-in rooms. To add one, write its file and list it in [`ROOMS`].

mod bedroom;
mod classroom;
mod closed_loop;
mod clutter;
mod comb;
mod crossing;
mod dining;
mod empty;
mod flat;
mod hall20;
mod hotel;
mod kitchen;
mod landing;
mod living;
mod loops;
mod lshape;
mod market;
mod maze;
mod office;
mod openplan;
mod pillars;
mod ring;
mod room12ft;
mod slanted;
mod spiral;
mod thesis226;
mod thesis8;
mod tshape;
mod ushape;
mod ward;
mod warehouse;

use super::FloorPlan;
use serde::Serialize;

/// Entry of the list of rooms.
#[derive(Debug)]
pub struct RoomInfo {
    /// Name in links, files and on the command line.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence on the room's purpose.
    pub note: &'static str,
    /// Its kind of difficulty.
    pub kind: RoomKind,
    /// Whether it belongs to the benchmark set of planners; the rooms of the thesis have too few cells for that.
    pub is_benchmark: bool,
    /// Draws the room; takes a few milliseconds at most.
    pub build: fn() -> FloorPlan,
}

/// Kinds of rooms by their difficulty.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum RoomKind {
    /// A shape without furniture.
    Simple,
    /// A room full of furniture.
    Cluttered,
    /// Similar rooms and desks, side by side.
    Office,
    /// Winding ways, dead ends and loops.
    Maze,
    /// Long and narrow floor.
    Corridor,
    /// Hundreds of square metres.
    Large,
}

impl RoomKind {
    /// All kinds, with their names in links and in menus.
    pub const ALL: [(Self, &'static str, &'static str); 6] = [
        (Self::Simple, "shapes", "Simple shapes"),
        (Self::Cluttered, "furnished", "Furnished rooms"),
        (Self::Office, "offices", "Offices and wards"),
        (Self::Maze, "mazes", "Mazes"),
        (Self::Corridor, "corridors", "Corridors"),
        (Self::Large, "halls", "Large halls"),
    ];
}

/// All rooms, in the order of the menus: furnished ones first, then plain shapes, mazes and corridors, then whole floors and
/// large halls.
pub const ROOMS: &[&RoomInfo] = &[
    &flat::ROOM,
    &room12ft::ROOM,
    &bedroom::ROOM,
    &kitchen::ROOM,
    &dining::ROOM,
    &clutter::ROOM,
    &living::ROOM,
    &landing::ROOM,
    &thesis226::ROOM,
    &empty::ROOM,
    &thesis8::ROOM,
    &closed_loop::ROOM,
    &lshape::ROOM,
    &tshape::ROOM,
    &ushape::ROOM,
    &slanted::ROOM,
    &spiral::ROOM,
    &comb::ROOM,
    &maze::ROOM,
    &loops::ROOM,
    &ring::ROOM,
    &crossing::ROOM,
    &hotel::ROOM,
    &office::ROOM,
    &openplan::ROOM,
    &ward::ROOM,
    &classroom::ROOM,
    &hall20::ROOM,
    &market::ROOM,
    &warehouse::ROOM,
    &pillars::ROOM,
];

/// The room with that id.
pub fn room(id: &str) -> Option<&'static RoomInfo> {
    ROOMS.iter().copied().find(|room| room.id == id)
}

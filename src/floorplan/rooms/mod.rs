//! The rooms that ship. To add one, write its file and list it in [`ROOMS`].

mod comb;
mod empty;
mod flat;
mod hall20;
mod lshape;
mod maze;
mod office;
mod room12ft;
mod spiral;
mod thesis8;

use super::FloorPlan;

/// Entry of the list of rooms.
#[derive(Debug)]
pub struct RoomInfo {
    /// Name in links, files and on the command line.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence: what the room is good for.
    pub note: &'static str,
    /// Draws the room; takes about a millisecond.
    pub build: fn() -> FloorPlan,
}

/// All rooms, in the order of the menus: everyday ones first, then those that are hard in one respect, then large ones.
pub const ROOMS: &[&RoomInfo] = &[
    &flat::ROOM,
    &room12ft::ROOM,
    &empty::ROOM,
    &thesis8::ROOM,
    &lshape::ROOM,
    &spiral::ROOM,
    &comb::ROOM,
    &maze::ROOM,
    &hall20::ROOM,
    &office::ROOM,
];

/// The room with that id.
pub fn room(id: &str) -> Option<&'static RoomInfo> {
    ROOMS.iter().copied().find(|room| room.id == id)
}

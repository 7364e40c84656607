//! The rooms that a comparison may be made in.

use crate::{app::SettingsError, floorplan::ROOMS};

/// A room of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoomChoice {
    /// One that ships, by its id.
    Shipped(&'static str),
    /// The session's, which was drawn, changed or loaded.
    Own,
}

/// Rooms that are compared in together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoomSet {
    /// The session's room.
    This,
    /// All that ship.
    All,
}

impl RoomSet {
    /// All sets, with their ids and names.
    pub fn all() -> impl Iterator<Item = (Self, &'static str, &'static str)> {
        [(Self::This, "this", "This room"), (Self::All, "all", "All rooms")].into_iter()
    }

    /// The set with that id.
    pub fn parse(id: &str) -> Result<Self, SettingsError> {
        Self::all().find(|set| set.1 == id).map(|set| set.0).ok_or_else(|| SettingsError::Unknown {
            kind: "set of rooms",
            id: id.to_owned(),
            known: Self::all().map(|set| set.1).collect::<Vec<_>>().join(", "),
        })
    }

    /// Its id.
    pub fn id(self) -> &'static str {
        Self::all().find(|set| set.0 == self).map_or("", |set| set.1)
    }

    /// Its rooms; `here` is the session's.
    pub fn rooms(self, here: RoomChoice) -> Vec<RoomChoice> {
        match self {
            Self::This => vec![here],
            Self::All => ROOMS.iter().map(|room| RoomChoice::Shipped(room.id)).collect(),
        }
    }
}

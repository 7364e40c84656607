//! The rooms available for a comparison.

use robovac_core::floor_plan::{ROOMS, RoomInfo, RoomKind};
use robovac_sim::experiment::SettingsError;

/// A room of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoomChoice {
    /// A built-in room, by its id.
    Shipped(&'static str),
    /// The session's room, if it was drawn, changed or loaded.
    Own,
}

/// A set of rooms for a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoomSet {
    /// The session's room.
    This,
    /// The built-in rooms of the published results.
    Benchmark,
    /// All built-in rooms.
    All,
    /// All rooms of a kind.
    Kind(RoomKind),
}

impl RoomSet {
    /// All sets, with their ids and names.
    pub fn all() -> impl Iterator<Item = (Self, &'static str, &'static str)> {
        let kinds = RoomKind::ALL.into_iter().map(|(kind, id, title)| (Self::Kind(kind), id, title));
        let mixed = [
            (Self::This, "this", "This room"),
            (Self::Benchmark, "benchmark", "Benchmark set"),
            (Self::All, "all", "All rooms"),
        ];
        mixed.into_iter().chain(kinds)
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
        let takes = |room: &RoomInfo| match self {
            Self::This => false,
            Self::Benchmark => room.is_benchmark,
            Self::All => true,
            Self::Kind(kind) => room.kind == kind,
        };
        match self {
            Self::This => vec![here],
            _ => ROOMS.iter().filter(|room| takes(room)).map(|room| RoomChoice::Shipped(room.id)).collect(),
        }
    }
}

//! Objects in a room: furniture, carpets, docks, movers.

use crate::geometry::{Point, Pose};
use serde::{Deserialize, Serialize};

/// A thing in a room. Lengths in metres from the room's lower-left corner.
#[derive(Debug, Clone, PartialEq)]
pub enum Object {
    /// Furniture that stands on the floor with its whole outline, a simple polygon.
    Furniture {
        /// Corners, in either direction.
        outline: Vec<Point>,
    },
    /// A round leg, thin or thick.
    Leg {
        /// Centre.
        at: Point,
        /// Radius, m.
        radius: f64,
    },
    /// Floor that ends: stairs down. A robot whose wheel gets there falls.
    DropOff {
        /// Corners of where there is no floor.
        outline: Vec<Point>,
    },
    /// Carpet: wheels slip more.
    Carpet {
        /// Corners.
        outline: Vec<Point>,
    },
    /// A spot of dirt, beyond the dust that is everywhere.
    Dirt {
        /// Centre.
        at: Point,
        /// Radius, m.
        radius: f64,
    },
    /// A dock: it stands with its back to the wall and looks along its heading, from where robots come.
    Dock {
        /// Middle of its back, and the way it looks.
        pose: Pose,
    },
    /// A virtual wall: a beam that robots with infrared receivers don't cross.
    VirtualWall {
        /// Where its lighthouse stands, and the way its beam goes.
        pose: Pose,
        /// Length of the beam, m.
        length: f64,
    },
    /// A person or pet that walks back and forth along a line.
    Mover {
        /// Who.
        who: Who,
        /// Corners of the line; at least one.
        path: Vec<Point>,
    },
}

/// Who moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Who {
    /// A person: a disc of 15 cm radius around the feet (ours), walking at 0.6 m/s. Older people walk at 0.61 m/s on
    /// average at home (Kaye et al., One walk a year to 1000 within a year, Gait & Posture 35, 2012).
    Person,
    /// A pet: a disc of 12 cm radius, at 0.4 m/s, that stops where it likes, every 4 s on average and for up to 6 s (ours).
    Pet,
}

impl Who {
    /// Radius of the disc that stands for it, m.
    pub fn radius(self) -> f64 {
        match self {
            Self::Person => 0.15,
            Self::Pet => 0.12,
        }
    }

    /// How fast it walks, m/s.
    pub fn speed(self) -> f64 {
        match self {
            Self::Person => 0.6,
            Self::Pet => 0.4,
        }
    }
}

impl Object {
    /// What kind of thing it is, as scenario files call it.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Furniture { .. } => "furniture",
            Self::Leg { .. } => "leg",
            Self::DropOff { .. } => "drop_off",
            Self::Carpet { .. } => "carpet",
            Self::Dirt { .. } => "dirt",
            Self::Dock { .. } => "dock",
            Self::VirtualWall { .. } => "virtual_wall",
            Self::Mover { .. } => "mover",
        }
    }

    /// Its name for users.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Furniture { .. } => "furniture",
            Self::Leg { .. } => "leg",
            Self::DropOff { .. } => "stairs",
            Self::Carpet { .. } => "carpet",
            Self::Dirt { .. } => "dirt",
            Self::Dock { .. } => "dock",
            Self::VirtualWall { .. } => "virtual wall",
            Self::Mover { who: Who::Person, .. } => "person",
            Self::Mover { who: Who::Pet, .. } => "pet",
        }
    }
}

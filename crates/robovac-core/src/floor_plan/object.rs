//! Objects in a room: furniture, carpets, docks, movers.

use crate::geometry::{Point, Pose};
use serde::{Deserialize, Serialize};

/// An object in a room. Lengths in metres from the room's lower-left corner.
#[derive(Debug, Clone, PartialEq)]
pub enum Object {
    /// Furniture that occupies its whole outline, a simple polygon.
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
    /// A low obstacle, such as a cable cover or a threshold. It passes under bumpers that are higher above the floor; other
    /// robots bump into it.
    LowObstacle {
        /// Corners of its outline, a simple polygon.
        outline: Vec<Point>,
        /// Height, m.
        height: f64,
    },
    /// A drop-off: stairs down. A robot whose wheel passes its edge falls.
    DropOff {
        /// Corners of the area without floor.
        outline: Vec<Point>,
    },
    /// Carpet: wheels slip more.
    Carpet {
        /// Corners.
        outline: Vec<Point>,
    },
    /// A spot of dirt, in addition to the dust that is everywhere.
    Dirt {
        /// Centre.
        at: Point,
        /// Radius, m.
        radius: f64,
    },
    /// A dock: its back is at the wall and it faces along its heading, where robots come from.
    Dock {
        /// Middle of its back, and its heading.
        pose: Pose,
    },
    /// A virtual wall: a beam that robots with infrared receivers don't cross.
    VirtualWall {
        /// Position of its lighthouse, and direction of its beam.
        pose: Pose,
        /// Length of the beam, m.
        length: f64,
    },
    /// A person or pet that walks back and forth along a line.
    Mover {
        /// Kind of the mover.
        who: Who,
        /// Corners of the line; at least one.
        path: Vec<Point>,
    },
}

/// Kinds of movers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Who {
    /// A person: a disc of 15 cm radius around the feet (ours), walking at 0.6 m/s. Older people walk at 0.61 m/s on
    /// average at home (Kaye et al., One walk a year to 1000 within a year, Gait & Posture 35, 2012).
    Person,
    /// A pet: a disc of 12 cm radius, at 0.4 m/s, that stops at random, every 4 s on average and for up to 6 s (ours).
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

    /// Its walking speed, m/s.
    pub fn speed(self) -> f64 {
        match self {
            Self::Person => 0.6,
            Self::Pet => 0.4,
        }
    }
}

impl Object {
    /// Its key in scenario files.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Furniture { .. } => "furniture",
            Self::Leg { .. } => "leg",
            Self::LowObstacle { .. } => "low_obstacle",
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
            Self::LowObstacle { .. } => "low obstacle",
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

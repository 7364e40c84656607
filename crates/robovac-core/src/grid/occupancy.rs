//! Occupancy of a cell.

/// State of a map cell, with the values of a ROS `OccupancyGrid`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(i8)]
pub enum Occupancy {
    /// Never seen; nothing drives there.
    Unknown = -1,
    /// Floor.
    Free = 0,
    /// Wall or furniture.
    Occupied = 100,
}

impl Occupancy {
    /// Whether a robot can be there.
    #[inline]
    pub fn is_free(self) -> bool {
        self == Self::Free
    }
}

//! Rectangles of whole cells.

use super::CELL;

/// Left, bottom, right and top edge, in cells; right and top are the first that aren't in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Area {
    pub left: i32,
    pub bottom: i32,
    pub right: i32,
    pub top: i32,
}

/// A wall of a room.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Bottom,
    Right,
    Top,
}

impl Side {
    pub const ALL: [Self; 4] = [Self::Left, Self::Bottom, Self::Right, Self::Top];

    /// The wall across the room.
    pub fn opposite(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
            Self::Bottom => Self::Top,
            Self::Top => Self::Bottom,
        }
    }
}

impl Area {
    pub const fn new(left: i32, bottom: i32, right: i32, top: i32) -> Self {
        Self { left, bottom, right, top }
    }

    pub fn width(&self) -> i32 {
        self.right - self.left
    }

    pub fn height(&self) -> i32 {
        self.top - self.bottom
    }

    /// Length of that wall, cells.
    pub fn length(&self, side: Side) -> i32 {
        match side {
            Side::Left | Side::Right => self.height(),
            Side::Bottom | Side::Top => self.width(),
        }
    }

    /// Whether they have a cell in common.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right && other.left < self.right && self.bottom < other.top && other.bottom < self.top
    }

    /// Whether all of `other` lies in it.
    pub fn holds(&self, other: &Self) -> bool {
        self.left <= other.left && other.right <= self.right && self.bottom <= other.bottom && other.top <= self.top
    }

    /// Mirrored at the diagonal: x and y change places.
    pub fn transposed(&self) -> Self {
        Self::new(self.bottom, self.left, self.top, self.right)
    }

    /// Mirrored left to right in a plan of that width.
    pub fn flipped(&self, width: i32) -> Self {
        Self::new(width - self.right, self.bottom, width - self.left, self.top)
    }

    /// Left, bottom, right and top edge, m.
    pub fn metres(&self) -> [f64; 4] {
        [self.left, self.bottom, self.right, self.top].map(|cells| f64::from(cells) * CELL)
    }
}

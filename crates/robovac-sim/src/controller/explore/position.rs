//! The thesis' helper classes (004, section 7.1).

/// The side of the robot on which something is: the thesis' `PositionEnum` (LEFT -1, NONE 0, RIGHT 1) and `Position`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Position {
    Left,
    #[default]
    None,
    Right,
}

/// The side to rotate to, and how often that was commanded: the thesis' `Rotation`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Rotation {
    /// The side.
    pub position: Position,
    /// Number of commands; phase 3 of the end of an edge counts other things with it.
    pub counter: u32,
}

impl Position {
    /// `switch`: changes to the other side; none stays none.
    pub fn switched(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::None => Self::None,
            Self::Right => Self::Left,
        }
    }

    /// Whether it is on the left.
    pub fn is_left(self) -> bool {
        self == Self::Left
    }

    /// Whether it is nowhere.
    pub fn is_none(self) -> bool {
        self == Self::None
    }
}

impl Rotation {
    /// `set_position`, which resets the counter.
    ///
    /// `Rotation.switch` is printed too, as `super().switch(self)`, which fails in Python for an extra argument;
    /// nothing calls it, and it isn't included.
    pub fn set_position(&mut self, position: Position) {
        *self = Self { position, counter: 0 };
    }
}

//! The thesis' helper classes (004, section 7.1).

/// On which side of the robot something is: the thesis' `PositionEnum` (LEFT -1, NONE 0, RIGHT 1) and `Position`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Position {
    Left,
    #[default]
    None,
    Right,
}

/// To which side the robot is to rotate, and how often it was told to: the thesis' `Rotation`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Rotation {
    /// The side.
    pub position: Position,
    /// How often it was told to; phase 3 of the end of an edge counts other things with it.
    pub counter: u32,
}

impl Position {
    /// `switch`: over to the other side; nowhere stays nowhere.
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
    /// `Rotation.switch` is printed too, as `super().switch(self)`, which Python refuses for an argument too many; nothing
    /// calls it, and it isn't here.
    pub fn set_position(&mut self, position: Position) {
        *self = Self { position, counter: 0 };
    }
}

//! Cells of a grid and the four directions between them.

use crate::{
    geometry::Point,
    math::{self, FRAC_PI_2},
};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Column and row of a cell; (0, 0) is the lower-left one. Can lie outside the grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Cell {
    /// Column, counted to the right.
    pub x: i32,
    /// Row, counted upwards.
    pub y: i32,
}

impl Cell {
    /// The cell in column `x` and row `y`.
    #[inline]
    pub const fn new(x: i32, y: i32) -> Self {
        Self { x, y }
    }

    /// The cell that holds a point, in a grid of cells of `side` metres; the origin is the lower-left corner of (0, 0).
    #[inline]
    pub fn at(point: Point, side: f64) -> Self {
        Self::new(math::floor(point.x / side), math::floor(point.y / side))
    }

    /// The centre of the cell in metres if its sides are `side` metres: an inverse of [`Cell::at`].
    #[inline]
    pub fn centre(self, side: f64) -> Point {
        Point::new((f64::from(self.x) + 0.5) * side, (f64::from(self.y) + 0.5) * side)
    }

    /// The neighbour one step away.
    #[inline]
    pub fn step(self, direction: Direction) -> Self {
        let (dx, dy) = direction.offset();
        Self::new(self.x + dx, self.y + dy)
    }

    /// The four neighbours, counter-clockwise from the right.
    #[inline]
    pub fn neighbours(self) -> [Self; 4] {
        Direction::ALL.map(|d| self.step(d))
    }

    /// The cell with its eight neighbours, row by row from the lower left.
    #[inline]
    pub fn block(self) -> impl Iterator<Item = Self> {
        (-1..=1).flat_map(move |dy| (-1..=1).map(move |dx| Self::new(self.x + dx, self.y + dy)))
    }

    /// The direction that leads to `next` in one step; `None` unless they are 4-neighbours.
    #[inline]
    pub fn direction_to(self, next: Self) -> Option<Direction> {
        match (next.x.wrapping_sub(self.x), next.y.wrapping_sub(self.y)) {
            (1, 0) => Some(Direction::Right),
            (0, 1) => Some(Direction::Up),
            (-1, 0) => Some(Direction::Left),
            (0, -1) => Some(Direction::Down),
            _ => None,
        }
    }

    /// Number of steps to `other` without obstacles.
    #[inline]
    pub fn manhattan(self, other: Self) -> u32 {
        self.x.abs_diff(other.x) + self.y.abs_diff(other.y)
    }
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", self.x, self.y)
    }
}

impl Serialize for Cell {
    /// Written as `[x, y]`.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        [self.x, self.y].serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Cell {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        <[i32; 2]>::deserialize(deserializer).map(|[x, y]| Self { x, y })
    }
}

/// One of the four directions of a grid, numbered counter-clockwise from the right.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// +x, heading 0.
    Right,
    /// +y, heading 90°.
    Up,
    /// -x, heading 180°.
    Left,
    /// -y, heading -90°.
    Down,
}

impl Direction {
    /// All four, counter-clockwise from the right.
    pub const ALL: [Self; 4] = [Self::Right, Self::Up, Self::Left, Self::Down];

    /// The direction nearest to a heading in radians; halfway goes counter-clockwise.
    pub fn nearest(heading: f64) -> Self {
        let quarter = (heading / FRAC_PI_2 + 0.5).floor().rem_euclid(4.0);
        Self::ALL[quarter as usize % 4]
    }

    /// Heading in radians: 0, π/2, π or -π/2.
    pub fn heading(self) -> f64 {
        match self {
            Self::Right => 0.0,
            Self::Up => FRAC_PI_2,
            Self::Left => 2.0 * FRAC_PI_2,
            Self::Down => -FRAC_PI_2,
        }
    }

    /// Change of column and row by one step.
    #[inline]
    pub const fn offset(self) -> (i32, i32) {
        match self {
            Self::Right => (1, 0),
            Self::Up => (0, 1),
            Self::Left => (-1, 0),
            Self::Down => (0, -1),
        }
    }

    /// A quarter turn counter-clockwise.
    #[inline]
    pub const fn left(self) -> Self {
        Self::ALL[(self as usize + 1) % 4]
    }

    /// A quarter turn clockwise.
    #[inline]
    pub const fn right(self) -> Self {
        Self::ALL[(self as usize + 3) % 4]
    }

    /// The way back.
    #[inline]
    pub const fn opposite(self) -> Self {
        Self::ALL[(self as usize + 2) % 4]
    }

    /// Whether it runs along x.
    #[inline]
    pub const fn is_horizontal(self) -> bool {
        matches!(self, Self::Right | Self::Left)
    }

    /// Quarter turns needed to look in direction `to`: 0, 1, or 2 for a reversal.
    #[inline]
    pub const fn quarter_turns(self, to: Self) -> u32 {
        let turned = (to as u32 + 4 - self as u32) % 4;
        if turned == 3 { 1 } else { turned }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_inverts_heading() {
        for d in Direction::ALL {
            assert_eq!(Direction::nearest(d.heading()), d);
            assert_eq!(Direction::nearest(d.heading() + 0.7), d);
            assert_eq!(Direction::nearest(d.heading() - 0.7 - 4.0 * core::f64::consts::PI), d);
        }
    }

    #[test]
    fn turning() {
        let up = Direction::Up;
        assert_eq!((up.left(), up.right(), up.opposite()), (Direction::Left, Direction::Right, Direction::Down));
        assert_eq!(up.quarter_turns(Direction::Down), 2);
        assert_eq!(Direction::Right.quarter_turns(Direction::Down), 1);
        assert_eq!(Cell::new(1, 1).direction_to(Cell::new(1, 0)), Some(Direction::Down));
        assert_eq!(Cell::new(1, 1).direction_to(Cell::new(2, 2)), None);
    }
}

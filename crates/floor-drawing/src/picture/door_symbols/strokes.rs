//! Thin and thick strokes of a picture: lines and walls.

use super::super::{marks, thickness::opened};
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Cell, Grid, chessboard},
    math::floor,
};

/// How far from the line between the jambs the next wall is at least, as a share of its length: a corner bath has a wall
/// along this line.
const CLEAR: f64 = 0.12;

/// The strokes of a picture.
pub(super) struct Strokes {
    /// Pixels of lines.
    pub thin: Grid<bool>,
    /// Moves to the next pixel of a line, and of a wall.
    to_thin: Grid<u8>,
    to_thick: Grid<u8>,
    /// How far from walls lines end that meet them, pixels.
    pub reach: f64,
    /// How far from walls thin pixels are their corners at most, pixels: walls can be turned.
    pub corner: i32,
}

impl Strokes {
    /// What is narrower than `side` pixels is thin; walls are `usual` pixels thick.
    pub fn new(walls: &Grid<bool>, side: u16, usual: f64) -> Self {
        let mut thick = opened(walls, side);
        // Where lines cross they are no wall, nor where they run together.
        let blots = marks::marks(&thick, |mark| f64::from(mark.size()[0].max(mark.size()[1])) < usual);
        marks::erase(&mut thick, &blots);
        let mut thin = walls.clone();
        thin.values_mut().iter_mut().zip(thick.values()).for_each(|(thin, &is_thick)| *thin &= !is_thick);
        Self {
            to_thin: chessboard(&thin),
            to_thick: chessboard(&thick),
            thin,
            reach: f64::from(side / 2 + 2),
            corner: i32::from(side / 4),
        }
    }

    /// Moves from a point to the next line.
    pub fn to_thin(&self, at: Point) -> i32 {
        moves(&self.to_thin, pixel(at))
    }

    /// Moves from a point to the next wall.
    pub fn to_thick(&self, at: Point) -> i32 {
        moves(&self.to_thick, pixel(at))
    }

    /// Moves from a pixel to the next wall.
    pub fn cell_to_thick(&self, cell: Cell) -> i32 {
        moves(&self.to_thick, cell)
    }

    /// Whether something is drawn at a point.
    pub fn is_dark(&self, at: Point) -> bool {
        self.to_thin(at).min(self.to_thick(at)) == 0
    }

    /// Whether walls go on beyond the two jambs of a doorway, and none is near the middle of the line between them.
    pub fn is_doorway(&self, a: Point, b: Point) -> bool {
        let clear = (CLEAR * (b - a).norm()).min(250.0);
        let beyond = (b - a).normalize() * self.reach;
        [0.5, 0.3, 0.7, 0.4, 0.6].into_iter().all(|share| f64::from(self.to_thick(a + (b - a) * share)) > clear)
            && f64::from(self.to_thick(a - beyond).max(self.to_thick(b + beyond))) <= self.reach
    }

    /// Whether there is floor to the right, or to the left, of the way between two jambs: a round table in a corner has none
    /// behind it.
    pub fn is_floor(&self, a: Point, b: Point, is_left: bool) -> bool {
        let way = b - a;
        let side = Vector::new(-way.y, way.x) * if is_left { 0.5 } else { -0.5 };
        f64::from(self.to_thick(a + way * 0.5 + side)) > (CLEAR * way.norm()).min(250.0)
    }
}

/// The pixel at a point.
pub(super) fn pixel(at: Point) -> Cell {
    Cell::new(floor(at.x), floor(at.y))
}

fn moves(moves: &Grid<u8>, cell: Cell) -> i32 {
    moves.get(cell).map_or(i32::from(u8::MAX), |&moves| i32::from(moves))
}

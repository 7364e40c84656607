//! Floor behind openings in walls: rooms, not recesses.

use super::openings;
use robovac_core::{
    geometry::Point,
    grid::{Cell, Grid},
    math::floor,
};

/// How many times wider than its opening the floor behind it is at least, along the opening (ours): a court or a porch is
/// as wide as its opening.
const WIDER: f64 = 1.2;

/// A connected piece of floor behind openings.
pub(super) struct OpenRoom {
    pub cells: Vec<Cell>,
    /// The lines along which it ends without a wall, the widest first.
    pub openings: Vec<[Point; 2]>,
}

impl OpenRoom {
    /// Its widest opening, and how wide that is, cells.
    pub fn widest(&self) -> Option<([Point; 2], f64)> {
        self.openings.first().map(|&line| (line, width(&line)))
    }

    /// Whether its openings are no longer than half of what is round it: what is between columns is no room.
    pub fn is_walled(&self) -> bool {
        let (mut low, mut high) = (Point::new(f64::MAX, f64::MAX), Point::new(f64::MIN, f64::MIN));
        for at in self.cells.iter().map(|cell| cell.centre(1.0)) {
            (low, high) = (low.inf(&at), high.sup(&at));
        }
        self.openings.iter().map(width).sum::<f64>() <= (high - low).sum()
    }
}

/// The connected pieces of `rest` with openings in the border of the floor `inside` that are narrower than the piece.
pub(super) fn open_rooms(walls: &Grid<bool>, inside: &Grid<bool>, mut rest: Grid<bool>) -> Vec<OpenRoom> {
    let lines = openings::openings(walls, inside);
    let mut pieces = rest.map(|_| 0_u32);
    let mut rooms = Vec::new();
    for index in 0..rest.len() {
        let cells = taken(&mut rest, index);
        for &cell in &cells {
            pieces[cell] = index as u32 + 1;
        }
        let is_its = |[a, _]: &[Point; 2]| pieces.get(Cell::new(floor(a.x), floor(a.y))) == Some(&(index as u32 + 1));
        let mut openings: Vec<[Point; 2]> =
            if cells.is_empty() { Vec::new() } else { lines.iter().copied().filter(is_its).collect() };
        openings.sort_by(|a, b| width(b).total_cmp(&width(a)));
        let room = OpenRoom { cells, openings };
        let Some((widest, width)) = room.widest() else { continue };
        let along = (widest[1] - widest[0]).try_normalize(0.0).unwrap_or_default();
        let places = room.cells.iter().map(|cell| cell.centre(1.0).coords.dot(&along));
        let (low, high) = places.fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at), high.max(at)));
        if high - low + 1.0 >= WIDER * width && room.cells.len() as f64 >= width * width {
            rooms.push(room);
        }
    }
    rooms
}

/// Length of a line between the centres of its outermost cells, with these, cells.
fn width([a, b]: &[Point; 2]) -> f64 {
    (b - a).norm() + 1.0
}

/// Takes the connected cells around one out of `rest`.
fn taken(rest: &mut Grid<bool>, index: usize) -> Vec<Cell> {
    let start = rest.cell(index);
    let (mut piece, mut next) = (Vec::new(), 0);
    if rest[start] {
        rest[start] = false;
        piece.push(start);
    }
    while let Some(&cell) = piece.get(next) {
        next += 1;
        for beside in cell.neighbours() {
            if rest.is_set(beside) {
                rest[beside] = false;
                piece.push(beside);
            }
        }
    }
    piece
}

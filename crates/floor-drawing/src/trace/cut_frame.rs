//! The frame of a page that a picture's edge cuts: it has openings there, which lead to no room.

use super::EnclosedFloor;
use crate::Picture;
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Cell, Grid},
};

/// A picture without what its edge cuts round the floor, if there is such; `side` is that of a cell, pixels. What the floor
/// is beside is a wall of the building.
pub(super) fn without(picture: &Picture, floor: &EnclosedFloor, side: f64) -> Option<Picture> {
    let mut blocked = picture.blocked.clone();
    let cut: Vec<Cell> = cut_marks(&picture.blocked)
        .into_iter()
        .filter(|mark| !is_beside(mark, picture, floor, side))
        .flatten()
        .collect();
    let places = floor.inside.iter().filter(|(_, is_floor)| **is_floor);
    let places = places.map(|(cell, _)| picture.pixel(floor.frame.point(cell.centre(1.0))));
    let [low, high] = bounds(cut.iter().map(|cell| cell.centre(1.0)))?;
    let [floor_low, floor_high] = bounds(places)?;
    let is_round = (floor_low - low).min() > 0.0 && (high - floor_high).min() > 0.0;
    for cell in cut {
        blocked[cell] = false;
    }
    is_round.then(|| Picture { blocked, ..picture.clone() })
}

/// The connected dark pixels at the edge of a picture.
fn cut_marks(blocked: &Grid<bool>) -> Vec<Vec<Cell>> {
    let mut rest = blocked.clone();
    let [right, top] = [blocked.width(), blocked.height()].map(|side| side as i32 - 1);
    let is_edge = |cell: Cell| cell.x.min(cell.y).min(right - cell.x).min(top - cell.y) == 0;
    let mut marks = Vec::new();
    for index in 0..rest.len() {
        let start = rest.cell(index);
        if !rest[start] || !is_edge(start) {
            continue;
        }
        rest[start] = false;
        let (mut mark, mut next) = (vec![start], 0);
        while let Some(&cell) = mark.get(next) {
            next += 1;
            for beside in cell.block() {
                if rest.is_set(beside) {
                    rest[beside] = false;
                    mark.push(beside);
                }
            }
        }
        marks.push(mark);
    }
    marks
}

/// Whether the floor is beside one of the pixels.
fn is_beside(mark: &[Cell], picture: &Picture, floor: &EnclosedFloor, side: f64) -> bool {
    mark.iter().any(|cell| {
        let at = picture.place(cell.centre(1.0));
        let around = Cell::new(0, 0).block().map(|step| Vector::new(f64::from(step.x), f64::from(step.y)));
        around.into_iter().any(|step| floor.has(at + step * (1.5 * side)))
    })
}

fn bounds(points: impl IntoIterator<Item = Point>) -> Option<[Point; 2]> {
    super::BoundingBox::of(points).map(|bounds| [bounds.low, bounds.high])
}

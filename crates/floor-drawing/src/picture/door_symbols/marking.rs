//! Marks the lines of a door that was found.

use super::strokes::{Strokes, pixel};
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Cell, Grid},
    math::ceil,
};

/// Half the thickness of a leaf that is drawn as a rectangle, as a share of its length.
const LEAF: f64 = 0.07;
/// Deepest threshold, as a share of the doorway; and how far beyond the jambs the wall is looked for.
const DEEPEST: f64 = 0.4;
const INTO_JAMB: f64 = 0.08;

/// How far from where they are looked for lines of a leaf or doorway with that width are, pixels.
pub(super) fn beside_lines(width: f64) -> f64 {
    (LEAF * width).max(2.0)
}

/// Marks the lines of the threshold between two jambs, as deep as the wall beside them.
pub(super) fn mark_threshold(strokes: &Strokes, [a, b]: [Point; 2], is_left: bool, found: &mut Grid<bool>) {
    let width = (b - a).norm();
    let along = (b - a) / width;
    let back = Vector::new(along.y, -along.x) * if is_left { 1.0 } else { -1.0 };
    let most = ceil(DEEPEST * width);
    let depth = |jamb: Point, out: Vector| {
        let from = jamb + out * (INTO_JAMB * width);
        let is_wall = |step: i32| strokes.to_thick(from + back * f64::from(step)) <= 1;
        // The line meets the corner of the wall, or about there.
        let inside = (0..most).take_while(|&step| f64::from(step) < INTO_JAMB * width || is_wall(step));
        inside.count() as f64
    };
    let depth = depth(a, -along).min(depth(b, along));
    let beside = beside_lines(width);
    mark_around(strokes, found, a, width + depth + beside, |by| {
        (-beside..=width + beside).contains(&by.dot(&along))
            && (-beside - 1.0..=depth + beside).contains(&by.dot(&back))
    });
}

/// Marks the lines around `middle` whose places from there are meant.
pub(super) fn mark_around(
    strokes: &Strokes,
    found: &mut Grid<bool>,
    middle: Point,
    far: f64,
    is_meant: impl Fn(Vector) -> bool,
) {
    let (centre, far) = (pixel(middle), ceil(far) + 1);
    for y in centre.y - far..=centre.y + far {
        for x in centre.x - far..=centre.x + far {
            let cell = Cell::new(x, y);
            let is_line = strokes.thin.is_set(cell) && strokes.cell_to_thick(cell) > strokes.corner;
            if is_line && is_meant(cell.centre(1.0) - middle) {
                found[cell] = true;
            }
        }
    }
}

//! The dominant direction of walls, so that askew plans can be straightened.

use crate::{Drawing, Role};
use robovac_core::{
    geometry::Point,
    grid::{Cell, Grid},
    math::{atan2, cos, sin},
};
use std::f64::consts::FRAC_PI_2;

/// Bins of a quarter turn: a quarter of a degree each.
const BINS: usize = 360;
/// Least share of the walls' length within a degree of the dominant direction.
const LEAST_SHARE: f64 = 0.35;
/// Most pixels that are looked at in a picture.
const MOST_PIXELS: usize = 20_000;
/// Least ratio of the best to the mean score of a picture.
const LEAST_RATIO: f64 = 1.25;
/// Pixels around one of an edge that tell the direction of the edge there, and how much it can differ from the walls'.
const NEAR: i32 = 6;
const NEARLY: f64 = 5.0;

/// Most places of a stroke's side that are looked at.
const MOST_PLACES: i32 = 16;

/// Angle by which most walls of a drawing are askew, rad, above -45° to 45°, counter-clockwise; `None` if they have no
/// common direction. Strokes count by their length, as far as it `is_meant`.
///
/// ```
/// use floor_drawing::{Role, dominant_direction, read};
/// use robovac_core::floor_plan::SourceFile;
/// let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="320" height="220">
///     <path d="M50 50 L249 70 L239 169 L40 149 Z" fill="none" stroke="black"/></svg>"#;
/// let drawing = read(&SourceFile { name: "room.svg".into(), bytes: svg.into() })?;
/// let askew = dominant_direction(&drawing, &[Role::Wall], |_| true).unwrap();
/// assert!((askew.to_degrees() + 5.75).abs() < 0.1);
/// # Ok::<(), floor_drawing::DrawingError>(())
/// ```
pub fn dominant_direction(drawing: &Drawing, roles: &[Role], is_meant: impl Fn(Point) -> bool) -> Option<f64> {
    let is_wall = |layer: u32| roles.get(layer as usize) == Some(&Role::Wall);
    let mut lengths = vec![0.0; BINS];
    let mut sides = Vec::new();
    for stroke in drawing.strokes.iter().filter(|stroke| is_wall(stroke.layer)) {
        let corners = drawing.corners(stroke);
        let closing = stroke.is_closed.then(|| corners.last().copied().zip(corners.first().copied())).flatten();
        for (a, b) in corners.windows(2).map(|pair| (pair[0], pair[1])).chain(closing) {
            let side = b - a;
            let place = |index: i32| a + side * ((f64::from(index) + 0.5) / f64::from(MOST_PLACES));
            let meant = (0..MOST_PLACES).filter(|&index| is_meant(place(index))).count();
            let length = side.norm() * meant as f64 / f64::from(MOST_PLACES);
            if length > 0.0 {
                let angle = atan2(side.y, side.x).rem_euclid(FRAC_PI_2);
                lengths[(angle / FRAC_PI_2 * BINS as f64) as usize % BINS] += length;
                sides.push((angle, length));
            }
        }
    }
    let total: f64 = lengths.iter().sum();
    let around = |bin: usize| (BINS - 2..=BINS + 2).map(|by| lengths[(bin + by) % BINS]).sum::<f64>();
    let best = (0..BINS).max_by(|&a, &b| around(a).total_cmp(&around(b)))?;
    let centre = (best as f64 + 0.5) / BINS as f64 * FRAC_PI_2;
    // Their mean, on the circle of a quarter turn.
    let (mut x, mut y, mut weight) = (0.0, 0.0, 0.0);
    for (angle, length) in sides {
        let by = wrapped(angle - centre);
        if by.abs() <= 1.0_f64.to_radians() {
            x += length * cos(4.0 * by);
            y += length * sin(4.0 * by);
            weight += length;
        }
    }
    (total > 0.0 && weight >= LEAST_SHARE * total).then(|| wrapped(centre + atan2(y, x) / 4.0))
}

/// Angle by which the walls of a picture are askew, likewise: that at which their edges fall onto the fewest rows and
/// columns (the projection profiles of Postl 1986), if enough of them run that way: the arc of a door has such an angle, too.
/// `is_meant` is asked about the pixels beside walls.
pub fn picture_direction(walls: &Grid<bool>, is_meant: impl Fn(Cell) -> bool) -> Option<f64> {
    let is_beside = |next: Cell| walls.get(next) == Some(&false) && is_meant(next);
    let is_edge = |cell: Cell| walls[cell] && cell.neighbours().into_iter().any(is_beside);
    let edges: Vec<Cell> = walls.iter().map(|(cell, _)| cell).filter(|&cell| is_edge(cell)).collect();
    let mut at_edge = walls.map(|_| false);
    for &cell in &edges {
        at_edge[cell] = true;
    }
    let step = edges.len().div_ceil(MOST_PIXELS).max(1);
    // Not every nth in a row of pixels: that beats with their raster.
    let edges: Vec<Cell> =
        edges.into_iter().enumerate().filter(|(index, _)| index * 7919 % step == 0).map(|(_, cell)| cell).collect();
    if edges.len() < 40 {
        return None;
    }
    let size = walls.width() + walls.height();
    let mut counts = vec![0_u32; 2 * size + 2];
    let mut score = |angle: f64| {
        let (sin, cos) = (sin(-angle), cos(-angle));
        let mut sum = 0.0;
        for axis in 0..2 {
            counts.fill(0);
            for cell in &edges {
                let (x, y) = (f64::from(cell.x), f64::from(cell.y));
                let at = if axis == 0 { x * cos - y * sin } else { x * sin + y * cos };
                let index = (at + size as f64).max(0.0) as usize;
                counts[index.min(2 * size)] += 1;
            }
            sum += counts.iter().map(|&count| f64::from(count) * f64::from(count)).sum::<f64>();
        }
        sum
    };
    let degrees = |tenths: i32| (f64::from(tenths) / 10.0).to_radians();
    let coarse: Vec<(i32, f64)> = (-89..=90).map(|half| (5 * half, score(degrees(5 * half)))).collect();
    let &(best, _) = coarse.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let mean = coarse.iter().map(|(_, score)| score).sum::<f64>() / coarse.len() as f64;
    let fine = (best - 6..=best + 6).map(|tenths| (tenths, score(degrees(tenths))));
    let (found, most) = fine.max_by(|a, b| a.1.total_cmp(&b.1))?;
    if most < LEAST_RATIO * mean {
        return None;
    }
    let found = wrapped(degrees(found));
    let is_along = |&&cell: &&Cell| {
        direction_at(&at_edge, cell).is_some_and(|angle| wrapped(angle - found).abs() <= NEARLY.to_radians())
    };
    (edges.iter().filter(is_along).count() as f64 >= LEAST_SHARE * edges.len() as f64).then_some(found)
}

/// Direction of the edge at one of its pixels: that in which those around it spread most.
fn direction_at(at_edge: &Grid<bool>, cell: Cell) -> Option<f64> {
    let (mut count, mut sums, mut squares) = (0.0, [0.0; 2], [0.0; 3]);
    for dy in -NEAR..=NEAR {
        for dx in -NEAR..=NEAR {
            if at_edge.is_set(Cell::new(cell.x + dx, cell.y + dy)) {
                let (x, y) = (f64::from(dx), f64::from(dy));
                count += 1.0;
                sums = [sums[0] + x, sums[1] + y];
                squares = [squares[0] + x * x, squares[1] + x * y, squares[2] + y * y];
            }
        }
    }
    let [x, y] = sums.map(|sum| sum / count);
    let [xx, xy, yy] = [squares[0] / count - x * x, squares[1] / count - x * y, squares[2] / count - y * y];
    (count > 1.0).then(|| 0.5 * atan2(2.0 * xy, xx - yy))
}

/// An angle above -45° to 45° that differs by quarter turns.
fn wrapped(angle: f64) -> f64 {
    let angle = angle.rem_euclid(FRAC_PI_2);
    if angle > FRAC_PI_2 / 2.0 { angle - FRAC_PI_2 } else { angle }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::floor_plan::{SourceFile, generate::random_flat};

    #[test]
    fn the_walls_of_a_turned_flat_say_by_how_much() {
        for (seed, degrees) in [(1, 7.0_f64), (2, -31.0), (3, 0.0), (4, 0.7), (5, 44.5)] {
            let flat = random_flat(2, 2, seed).blocked();
            let (width, height) = (flat.width() as f64 * 3.0, flat.height() as f64 * 3.0);
            let side = (width + height) as usize;
            let (sin, cos) = (sin(-degrees.to_radians()), cos(-degrees.to_radians()));
            let mut picture = Grid::filled(side, side, false);
            for index in 0..picture.len() {
                let at = picture.cell(index).centre(1.0).coords.add_scalar(-0.5 * side as f64);
                let (x, y) = (at.x * cos - at.y * sin + 0.5 * width, at.x * sin + at.y * cos + 0.5 * height);
                let cell = Cell::new((x / 3.0).floor() as i32, (y / 3.0).floor() as i32);
                picture.values_mut()[index] = flat.is_set(cell);
            }
            let found = picture_direction(&picture, |_| true).unwrap().to_degrees();
            assert!((found - degrees).abs() < 0.15, "seed {seed}: {found} for {degrees}");
        }
    }

    #[test]
    fn the_arc_of_a_door_says_none() {
        for case in 0..40 {
            // Shares of their ranges that have nothing to do with each other.
            let any = |step: f64| (f64::from(case) * step).fract();
            let (radius, half, from) = (40.0 + 120.0 * any(0.618), 0.6 + 2.4 * any(0.414), 6.3 * any(0.732));
            // A quarter of a circle, or what a cut leaves of it.
            let length = 1.0 + 0.57 * any(0.236);
            let mut arc = Grid::filled(340, 340, false);
            for index in 0..arc.len() {
                let at = arc.cell(index).centre(1.0).coords.add_scalar(-170.0);
                let along = (atan2(at.y, at.x) - from).rem_euclid(2.0 * std::f64::consts::PI);
                arc.values_mut()[index] = (at.norm() - radius).abs() <= half && along <= length;
            }
            let found = picture_direction(&arc, |_| true);
            assert_eq!(found, None, "{length} rad of {radius} pixels, {half} to either side");
        }
    }

    #[test]
    fn what_has_no_direction_says_none() {
        let mut disc = Grid::filled(200, 200, false);
        for index in 0..disc.len() {
            let from = disc.cell(index).centre(1.0).coords.add_scalar(-100.0).norm();
            disc.values_mut()[index] = (60.0..64.0).contains(&from);
        }
        assert_eq!(picture_direction(&disc, |_| true), None);
        let circle = "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nWALL\n10\n0\n20\n0\n40\n5\n0\nENDSEC\n0\nEOF\n";
        let drawing = crate::read(&SourceFile { name: "round.dxf".into(), bytes: circle.into() }).unwrap();
        assert_eq!(dominant_direction(&drawing, &[Role::Wall], |_| true), None);
    }
}

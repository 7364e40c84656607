//! Closed outlines of things on the floor.

use super::{frame::Frame, raster::Canvas};
use crate::{
    drawing::{Drawing, Role, model::Stroke},
    floorplan::{
        DrawingFlaw, FloorPlan, MAX_CORNERS, MAX_OBJECTS, MAX_SIDE, Object, RADII, crossing, has_area, middle,
    },
    geometry::Point,
    grid::{Cell, Grid, Occupancy},
    math::{ceil, floor},
};

/// Fewest corners of a circle: one every 15°.
const CIRCLE_CORNERS: usize = 24;
/// How far a circle's corners may be from it, as a share of its radius.
const CIRCLE_ERROR: f64 = 1e-3;

/// The strokes that are outlines of solid things.
pub(super) fn solids<'a>(drawing: &'a Drawing, roles: &'a [Role]) -> impl Iterator<Item = &'a Stroke> {
    drawing.strokes.iter().filter(|stroke| stroke.is_closed && roles[stroke.layer as usize] == Role::Obstacle)
}

/// A stroke's corners in cells of the frame.
pub(super) fn in_cells(drawing: &Drawing, stroke: &Stroke, frame: &Frame) -> Vec<Point> {
    drawing.corners(stroke).iter().map(|&corner| frame.cells(corner)).collect()
}

/// Puts the solids that stand on the floor of a room into it: as objects while there may be more of them and each is simple
/// enough, else as cells that aren't floor.
pub(super) fn furnish(
    plan: &mut FloorPlan,
    drawing: &Drawing,
    roles: &[Role],
    frame: &Frame,
) -> Result<(), DrawingFlaw> {
    let free = plan.occupancy.map(|cell| cell.is_free());
    let mut rest = Canvas::new(frame.size);
    for stroke in solids(drawing, roles) {
        let outline = in_cells(drawing, stroke, frame);
        let object = if plan.objects.len() < MAX_OBJECTS { object(&outline, plan) } else { None };
        match object {
            Some(object) if touches(&outline, &free) => plan.objects.push(object),
            Some(_) => {}
            None => rest.fill(&outline)?,
        }
    }
    for (cell, &is_solid) in plan.occupancy.values_mut().iter_mut().zip(rest.cells.values()) {
        if is_solid {
            *cell = Occupancy::Occupied;
        }
    }
    Ok(())
}

/// Whether there is floor under an outline or beside it, looked for along its edges and in its middle. In cells.
pub(super) fn touches(outline: &[Point], free: &Grid<bool>) -> bool {
    let (width, height) = (free.width() as f64, free.height() as f64);
    let near = |point: Point| Cell::new(floor(point.x), floor(point.y)).block().any(|cell| free.is_set(cell));
    let edges = outline.iter().copied().zip(outline.iter().copied().cycle().skip(1));
    let outside = |a: f64, b: f64, size: f64| a.max(b) < -1.0 || a.min(b) > size + 1.0;
    near(middle(outline))
        || edges.filter(|(a, b)| !outside(a.x, b.x, width) && !outside(a.y, b.y, height)).any(|(a, b)| {
            let steps = ceil((b - a).norm()).clamp(1, 4 * MAX_SIDE as i32);
            (0..steps).any(|i| near(a + (b - a) * (f64::from(i) / f64::from(steps))))
        })
}

/// The outline as an object of the room, if it can be one.
fn object(outline: &[Point], plan: &FloorPlan) -> Option<Object> {
    let metres: Vec<Point> = outline.iter().map(|corner| corner * plan.resolution).collect();
    let (width, height) = (plan.width_m(), plan.height_m());
    let is_inside = |point: &Point| (0.0..=width).contains(&point.x) && (0.0..=height).contains(&point.y);
    if let Some((at, radius)) = circle(&metres) {
        let fits = (RADII[0]..=RADII[1]).contains(&radius) && is_inside(&at);
        return fits.then_some(Object::Leg { at, radius });
    }
    let fits =
        metres.len() <= MAX_CORNERS && metres.iter().all(is_inside) && has_area(&metres) && crossing(&metres).is_none();
    fits.then_some(Object::Furniture { outline: metres })
}

/// Centre and radius if the corners lie evenly on a circle.
fn circle(corners: &[Point]) -> Option<(Point, f64)> {
    if corners.len() < CIRCLE_CORNERS {
        return None;
    }
    let sum = corners.iter().fold(nalgebra::Vector2::zeros(), |sum, corner| sum + corner.coords);
    let centre = Point::from(sum / corners.len() as f64);
    let radius = (corners[0] - centre).norm();
    let is_round = corners.iter().all(|corner| ((corner - centre).norm() - radius).abs() <= CIRCLE_ERROR * radius);
    is_round.then_some((centre, radius))
}

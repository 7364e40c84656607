//! Closed outlines of obstacles on the floor.

use super::{
    frame::{BoundingBox, RasterFrame},
    raster::RasterCanvas,
};
use crate::{Drawing, DrawingFlaw, Role, model::Stroke};
use robovac_core::{
    floor_plan::{FloorPlan, MAX_CORNERS, MAX_OBJECTS, MAX_SIDE, Object, RADII, crossing, has_area, middle},
    geometry::Point,
    grid::{Cell, Grid, Occupancy},
    math::{ceil, floor},
};

/// Fewest corners of a circle: one every 15°.
const CIRCLE_CORNERS: usize = 24;
/// Largest distance of a circle's corners from it, as a share of its radius.
const CIRCLE_ERROR: f64 = 1e-3;

/// The strokes that are outlines of solid objects.
pub(super) fn solids<'a>(drawing: &'a Drawing, roles: &'a [Role]) -> impl Iterator<Item = &'a Stroke> {
    drawing.strokes.iter().filter(|stroke| stroke.is_closed && roles[stroke.layer as usize] == Role::Obstacle)
}

/// A stroke's corners in cells of the frame.
pub(super) fn in_cells(drawing: &Drawing, stroke: &Stroke, frame: &RasterFrame) -> Vec<Point> {
    drawing.corners(stroke).iter().map(|&corner| frame.cells(corner)).collect()
}

/// Adds the solids that stand on the floor of a room: as objects up to the room's limits if they are simple enough,
/// otherwise as cells that aren't floor.
pub(super) fn furnish(
    plan: &mut FloorPlan,
    drawing: &Drawing,
    roles: &[Role],
    frame: &RasterFrame,
) -> Result<(), DrawingFlaw> {
    let free = plan.occupancy.map(|cell| cell.is_free());
    let floor = DrawnFloor::new(&free);
    let mut rest = RasterCanvas::new(frame.size);
    for stroke in solids(drawing, roles) {
        let outline = in_cells(drawing, stroke, frame);
        let object = if plan.objects.len() < MAX_OBJECTS { object(&outline, plan) } else { None };
        match object {
            Some(object) if floor.touches(&outline) => plan.objects.push(object),
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

/// The floor of a room, with its bounding box: most of a large drawing lies outside.
pub(super) struct DrawnFloor<'a> {
    free: &'a Grid<bool>,
    bounds: Option<BoundingBox>,
}

impl<'a> DrawnFloor<'a> {
    pub fn new(free: &'a Grid<bool>) -> Self {
        let cells = free.iter().filter(|(_, is_free)| **is_free);
        let corner = |cell: Cell, side: i32| Point::new(f64::from(cell.x + side), f64::from(cell.y + side));
        // Including the neighbouring cells.
        let bounds = BoundingBox::of(cells.flat_map(|(cell, _)| [corner(cell, -1), corner(cell, 2)]));
        Self { free, bounds }
    }

    /// Whether there is floor under an outline or beside it, checked along its edges and in its middle. In cells.
    pub fn touches(&self, outline: &[Point]) -> bool {
        let meets = |points: &[Point]| match (self.bounds, BoundingBox::of(points.iter().copied())) {
            (Some(ours), Some(other)) => {
                let is_apart = |axis: usize| ours.low[axis] > other.high[axis] || other.low[axis] > ours.high[axis];
                !is_apart(0) && !is_apart(1)
            }
            _ => false,
        };
        if !meets(outline) {
            return false;
        }
        let near = |point: Point| {
            let at = Cell::new(floor(point.x), floor(point.y));
            at.block().any(|cell| self.free.is_set(cell))
        };
        let edges = outline.iter().copied().zip(outline.iter().copied().cycle().skip(1));
        near(middle(outline))
            || edges.filter(|&(a, b)| meets(&[a, b])).any(|(a, b)| {
                let steps = ceil((b - a).norm()).clamp(1, 4 * MAX_SIDE as i32);
                (0..steps).any(|i| near(a + (b - a) * (f64::from(i) / f64::from(steps))))
            })
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_beside_the_box_around_the_floor_does_not_touch_it() {
        let mut free = Grid::filled(100, 100, false);
        for x in 40..43 {
            free.values_mut()[40 * 100 + x] = true;
        }
        let square =
            |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)].map(|(x, y)| Point::new(x, y));
        let on = |floor: &Grid<bool>, outline: &[Point]| DrawnFloor::new(floor).touches(outline);
        assert!(on(&free, &square(41.0, 90.0)) && on(&free, &square(37.0, 39.5)) && on(&free, &square(20.0, 62.0)));
        assert!(!on(&free, &square(43.5, 90.0)) && !on(&free, &square(1.0, 38.5)));
        assert!(!on(&Grid::filled(9, 9, false), &square(1.0, 8.0)));
    }
}

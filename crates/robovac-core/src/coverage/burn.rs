//! Furniture converted to walls, for formats with cells only.

use super::obstacles;
use crate::{
    floor_plan::FloorPlan,
    geometry::Point,
    grid::{Cell, Occupancy},
};

/// The room with every cell occupied that a piece of furniture, a leg, a dock or a lighthouse touches; without objects.
pub fn with_objects(plan: &FloorPlan) -> FloorPlan {
    let mut burnt = FloorPlan { objects: Vec::new(), ..plan.clone() };
    let side = plan.resolution;
    for shape in obstacles(plan) {
        let (low, high) = shape.bounds();
        let (first, last) = (plan.cell_at(low), plan.cell_at(high));
        for y in first.y.max(0)..=last.y {
            for x in first.x.max(0)..=last.x {
                let corner = Point::new(f64::from(x) * side, f64::from(y) * side);
                let opposite = Point::new(corner.x + side, corner.y + side);
                let cell = Cell::new(x, y);
                if burnt.occupancy.contains(cell) && shape.overlaps_box(corner, opposite) {
                    burnt.occupancy[cell] = Occupancy::Occupied;
                }
            }
        }
    }
    burnt
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        floor_plan::{Object, room, to_ascii},
        geometry::Point,
    };

    #[test]
    fn a_table_takes_the_cells_that_it_touches() {
        let mut plan = (room("thesis8").unwrap().build)();
        plan.occupancy = crate::grid::Grid::filled(5, 4, Occupancy::Free);
        plan.resolution = 1.0;
        plan.start = None;
        let corner = |x, y| Point::new(x, y);
        plan.objects = vec![
            Object::Furniture { outline: vec![corner(1.0, 1.0), corner(2.5, 1.0), corner(2.5, 2.0), corner(1.0, 2.0)] },
            Object::Leg { at: corner(4.9, 3.9), radius: 0.3 },
        ];
        let text = to_ascii(&with_objects(&plan));
        assert!(text.ends_with("....#\n.....\n.##..\n.....\n"), "{text}");
    }
}

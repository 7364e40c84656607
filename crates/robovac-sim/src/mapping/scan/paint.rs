//! The inverse sensor model of a laser: log-odds updates of cells by a scan.
//!
//! - Floor under the body is certainly free, and cells along a beam are, up to its end.
//! - The cell where a beam ends is occupied; near ends are stronger evidence, as they are more accurate.
//! - A beam without an end is free as far as its neighbours are, as single beams get lost on dark surfaces.

use super::ScanSensor;
use crate::mapping::OccupancyMap;
use robovac_core::{
    geometry::{Point, Pose, Vector},
    grid::Cell,
    math,
    robot::{Body, RobotModel},
};

/// Log odds of a cell under the body, along a beam, and at its end from near and from afar: two beams that end in a cell at any
/// distance make it occupied, as the robot may never look there again.
const UNDER_BODY: f64 = -0.4;
const ALONG: f64 = -0.12;
const END: (f64, f64) = (0.9, 0.45);
/// Distances at which an end counts as near and as far, m.
const NEAR: f64 = 2.0;
const FAR: f64 = 5.0;
/// What is left before the end of a beam: m, and as a share of the distance (two standard deviations).
const BEFORE: (f64, f64) = (0.05, 0.02);
/// Distance behind the surface that is occupied, m: surfaces often lie between two cells.
const BEHIND: f64 = 0.012;
/// Farthest floor that a beam without an end shows, m.
const OPEN: f64 = 4.0;

/// Adds a scan taken at `pose`.
pub(super) fn paint_scan(map: &mut OccupancyMap, pose: Pose, sensor: &ScanSensor, scan: &[f32]) {
    let from = pose.to_world(sensor.place());
    let ahead = pose.direction();
    let beams: Vec<(Vector, f64)> = sensor.beams(scan).collect();
    for (index, &(direction, distance)) in beams.iter().enumerate() {
        let direction =
            Vector::new(ahead.x * direction.x - ahead.y * direction.y, ahead.y * direction.x + ahead.x * direction.y);
        if distance.is_finite() {
            let end = map.cell_at(from + direction * (distance + BEHIND));
            free(map, from, direction, distance - BEFORE.0 - BEFORE.1 * distance, end);
            let share = ((distance - NEAR) / (FAR - NEAR)).clamp(0.0, 1.0);
            map.add(end, END.0 + (END.1 - END.0) * share);
        } else {
            let beside = [index.wrapping_sub(1), index + 1].map(|i| beams.get(i).map_or(0.0, |beam| beam.1));
            let length = beside[0].min(beside[1]).min(OPEN);
            let end = map.cell_at(from + direction * OPEN);
            free(map, from, direction, length - BEFORE.0 - BEFORE.1 * length, end);
        }
    }
}

/// Adds the floor under the body at `pose`.
pub(super) fn paint_body(map: &mut OccupancyMap, pose: Pose, robot: &RobotModel) {
    let size = map.resolution();
    let reach = math::ceil(robot.radius / size);
    let middle = map.cell_at(pose.position());
    let (sin, cos) = math::sin_cos(pose.heading);
    for y in middle.y - reach..=middle.y + reach {
        for x in middle.x - reach..=middle.x + reach {
            let cell = Cell::new(x, y);
            let off = cell.centre(size) - pose.position();
            let local = Point::new(cos * off.x + sin * off.y, cos * off.y - sin * off.x);
            if covers(robot, local) {
                map.add(cell, UNDER_BODY);
            }
        }
    }
}

/// Whether a point in the robot's frame is under its body.
fn covers(robot: &RobotModel, at: Point) -> bool {
    match robot.body {
        Body::Round => at.coords.norm_squared() < robot.radius * robot.radius,
        Body::Polygon(corners) => (0..corners.len()).all(|i| {
            let ([ax, ay], [bx, by]) = (corners[i], corners[(i + 1) % corners.len()]);
            (bx - ax) * (at.y - ay) - (by - ay) * (at.x - ax) > 0.0
        }),
    }
}

/// Marks the cells of the first `length` metres of a beam as free, each once, but not its `end` (Amanatides & Woo 1987).
fn free(map: &mut OccupancyMap, from: Point, direction: Vector, length: f64, end: Cell) {
    if length <= 0.0 {
        return;
    }
    let size = map.resolution();
    let mut cell = map.cell_at(from);
    let axis = |from: f64, direction: f64, cell: i32| {
        let next = if direction > 0.0 { f64::from(cell + 1) } else { f64::from(cell) };
        let way = if direction == 0.0 { f64::INFINITY } else { (next * size - from) / direction };
        (way, size / direction.abs(), if direction > 0.0 { 1 } else { -1 })
    };
    let (mut way_x, step_x, sign_x) = axis(from.x, direction.x, cell.x);
    let (mut way_y, step_y, sign_y) = axis(from.y, direction.y, cell.y);
    loop {
        if cell != end {
            map.add(cell, ALONG);
        }
        if way_x.min(way_y) >= length {
            return;
        }
        if way_x < way_y {
            (cell.x, way_x) = (cell.x + sign_x, way_x + step_x);
        } else {
            (cell.y, way_y) = (cell.y + sign_y, way_y + step_y);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{grid::Occupancy, robot::model};

    #[test]
    fn beams_show_free_floor_and_where_it_ends() {
        let robot = model("cbot").unwrap();
        let sensor = ScanSensor::new(robot.sensors.laser.unwrap());
        // The middle beam looks straight ahead at a wall 1.3 m away, the others into the open, where one is lost.
        let mut scan = vec![f32::INFINITY; 114];
        for (beam, range) in scan.iter_mut().enumerate() {
            *range = if (52..=60).contains(&beam) { 1.3 } else { 2.0 };
        }
        scan[80] = f32::INFINITY;
        let mut map = OccupancyMap::new(0.05);
        let pose = Pose::new(1.0, 2.0, 0.0);
        for _ in 0..10 {
            paint_scan(&mut map, pose, &sensor, &scan);
            paint_body(&mut map, pose, robot);
        }
        let at = |x: f64, y: f64| map.occupancy(map.cell_at(Point::new(x, y)));
        assert_eq!(at(1.15 + 1.31, 2.0), Occupancy::Occupied);
        assert_eq!(at(2.2, 2.0), Occupancy::Free);
        assert_eq!(at(2.6, 2.0), Occupancy::Unknown);
        // Under the body, but not beside it, where the circle around it would be.
        assert_eq!((at(0.85, 2.0), at(0.85, 2.17)), (Occupancy::Free, Occupancy::Unknown));
    }
}

//! The inverse sensor model: log-odds updates of cells by a reading.
//!
//! - Floor under the body is certainly free.
//! - A beam is free up to the echo, or within its certain range.
//! - The source of an echo or a contact is occupied: the cell a centimetre behind the surface, as surfaces often lie
//!   between two cells. Nearer echoes are stronger evidence.
//!
//! The strengths are ours: three or four observations settle a cell, and errors are removed once the body has been
//! there.

use super::{
    OccupancyMap,
    observation::{Observation, SensorModel},
};
use robovac_core::{
    geometry::{Point, Pose, Vector},
    grid::Cell,
    math,
};

/// Log odds of floor under the body, and along a beam.
const UNDER_BODY: f64 = -0.4;
const ALONG_BEAM: f64 = -0.12;
/// Log odds of a contact, and of an echo from directly ahead.
const TOUCHED: f64 = 1.2;
const ECHO: f64 = 0.45;
/// Farthest echo that makes a cell occupied, m from the body's edge.
const FAR: f64 = 0.1;
/// Distance behind the surface, m.
const BEHIND: f64 = 0.012;
/// Uncertainty of direction above which a contact says little about a cell, rad.
const VAGUE: f64 = 0.35;
/// Margin of the floor under a body with nothing but a bumper, m.
const WIPES: f64 = 0.015;

/// Adds a reading taken at `pose`.
pub(super) fn paint(map: &mut OccupancyMap, pose: Pose, seen: &Observation, sensors: &SensorModel) {
    let position = pose.position();
    let size = map.resolution();
    // By contacts alone the pose is known less well, and the body mustn't wipe out the walls that it touches.
    let radius = sensors.inner_radius() - if sensors.is_bumper_alone() { WIPES } else { 0.0 };
    let low = map.cell_at(position - Vector::new(radius, radius));
    let high = map.cell_at(position + Vector::new(radius, radius));
    for y in low.y..=high.y {
        for x in low.x..=high.x {
            let cell = Cell::new(x, y);
            if (cell.centre(size) - position).norm_squared() < radius * radius {
                map.add(cell, UNDER_BODY);
            }
        }
    }
    let ahead = pose.direction();
    let turned = |v: Vector| Vector::new(ahead.x * v.x - ahead.y * v.y, ahead.y * v.x + ahead.x * v.y);
    if sensors.seen() > 0.0 {
        for (beam, echo) in seen.echoes.iter().enumerate() {
            let direction = turned(sensors.direction(beam));
            let free = echo.map_or(sensors.seen(), |echo| (echo.distance - size).min(sensors.seen()));
            ray(map, position + direction * radius, direction, free);
            if let Some(echo) = echo.filter(|echo| echo.distance < FAR) {
                let cell = map.cell_at(position + direction * (radius + echo.distance + BEHIND));
                map.add(cell, ECHO * (1.0 - 0.7 * echo.distance / FAR));
            }
        }
    }
    if let Some(contact) = seen.contact {
        let (sin, cos) = math::sin_cos(contact.direction);
        let radius = sensors.support(contact.direction);
        let cell = map.cell_at(position + turned(Vector::new(cos, sin)) * (radius + BEHIND));
        map.add(cell, if contact.deviation < VAGUE { TOUCHED } else { 0.3 * TOUCHED });
    }
}

/// Adds a point of a wall between contacts, with its normal towards the robot.
pub(super) fn paint_wall(map: &mut OccupancyMap, at: Point, normal: Vector) {
    let cell = map.cell_at(at - normal * BEHIND);
    map.add(cell, TOUCHED);
}

/// Marks the cells along a beam as free, each once.
fn ray(map: &mut OccupancyMap, from: Point, direction: Vector, length: f64) {
    let step = 0.5 * map.resolution();
    let mut last = None;
    for i in 0..=(length / step).max(0.0) as u32 {
        let cell = map.cell_at(from + direction * (step * f64::from(i)));
        if last != Some(cell) && length > 0.0 {
            map.add(cell, ALONG_BEAM);
            last = Some(cell);
        }
    }
}

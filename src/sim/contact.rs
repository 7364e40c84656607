//! A disc against the walls of a floor, exactly.

use crate::{
    coverage::ReachableFloor,
    geometry::{Point, Vector},
    grid::Cell,
};

/// The bumper is pressed where a wall is nearer than this to the body, m: its play before the switch opens.
const BUMPER_PLAY: f64 = 0.001;
/// Pushing a disc out of one wall may push it into the next; two walls meet in a corner, more don't help.
const ROUNDS: usize = 4;

/// Where a disc ends up, and the wall that it touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Centre of the disc, outside all walls, m.
    pub position: Point,
    /// Unit vector from the centre to the nearest wall that it touches.
    pub touch: Option<Vector>,
}

/// Moves a disc of `radius` metres at `position` out of the walls, by the shortest way.
///
/// The tangential part of a motion survives: the robot slides along walls.
#[inline]
pub fn resolve(floor: &ReachableFloor, position: Point, radius: f64) -> Contact {
    let cell = floor.cell_at(position);
    // The field holds the room around the cell's centre, at most 0.71 cells away from here.
    let around = floor.clearance.get(cell).map_or(0.0, |&c| f64::from(c));
    if around > radius + BUMPER_PLAY + 0.7072 * floor.resolution {
        return Contact { position, touch: None };
    }
    resolve_near_walls(floor, position, radius)
}

fn resolve_near_walls(floor: &ReachableFloor, mut position: Point, radius: f64) -> Contact {
    for _ in 0..ROUNDS {
        let Some((wall, distance)) = nearest_wall(floor, position, radius) else { break };
        if distance >= radius {
            break;
        }
        let away = position - wall;
        let normal = if distance > 1e-12 { away / distance } else { Vector::new(1.0, 0.0) };
        position += normal * (radius - distance);
    }
    let touch = nearest_wall(floor, position, radius + BUMPER_PLAY)
        .filter(|&(_, distance)| distance > 1e-12)
        .map(|(wall, distance)| (wall - position) / distance);
    Contact { position, touch }
}

/// The nearest point of a wall within `reach` metres of `position`, and its distance.
fn nearest_wall(floor: &ReachableFloor, position: Point, reach: f64) -> Option<(Point, f64)> {
    let size = floor.resolution;
    let low = floor.cell_at(position - Vector::new(reach, reach));
    let high = floor.cell_at(position + Vector::new(reach, reach));
    let mut best: Option<(Point, f64)> = None;
    for y in low.y..=high.y {
        for x in low.x..=high.x {
            if floor.clearance.get(Cell::new(x, y)).is_some_and(|&c| c > 0.0) {
                continue;
            }
            let (left, bottom) = (f64::from(x) * size, f64::from(y) * size);
            let wall = Point::new(position.x.clamp(left, left + size), position.y.clamp(bottom, bottom + size));
            let distance = (wall - position).norm();
            if distance < reach && best.is_none_or(|(_, nearest)| distance < nearest) {
                best = Some((wall, distance));
            }
        }
    }
    best
}

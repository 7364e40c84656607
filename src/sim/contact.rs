//! A disc against the walls of a floor, exactly.

use crate::{
    coverage::Walls,
    geometry::{Point, Vector},
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
pub fn resolve(walls: &Walls, position: Point, radius: f64) -> Contact {
    if walls.has_room_around_cell(position, radius + BUMPER_PLAY) {
        return Contact { position, touch: None };
    }
    resolve_near_walls(walls, position, radius)
}

fn resolve_near_walls(walls: &Walls, mut position: Point, radius: f64) -> Contact {
    for _ in 0..ROUNDS {
        let Some((wall, distance)) = walls.nearest(position, radius) else { break };
        if distance >= radius {
            break;
        }
        let away = position - wall;
        let normal = if distance > 1e-12 { away / distance } else { Vector::new(1.0, 0.0) };
        position += normal * (radius - distance);
    }
    let touch = walls
        .nearest(position, radius + BUMPER_PLAY)
        .filter(|&(_, distance)| distance > 1e-12)
        .map(|(wall, distance)| (wall - position) / distance);
    Contact { position, touch }
}

//! Ray casting against walls, objects and movers.

use super::Around;
use robovac_core::{
    coverage::{RayHit, Surface},
    geometry::{Point, Vector},
};

/// The nearest hit from `from` along the unit vector `direction` within `reach` metres.
pub(super) fn look(around: Around<'_>, from: Point, direction: Vector, reach: f64) -> Option<RayHit> {
    let mut nearest = around.walls.ray(from, direction, reach);
    for &(centre, radius) in around.life.movers() {
        let reach = nearest.map_or(reach, |hit| hit.distance);
        let hit = RayHit::on_disc(centre - from, radius, direction, Surface::Mover);
        nearest = hit.filter(|hit| hit.distance < reach).or(nearest);
    }
    nearest
}

/// Whether nothing is between two points; obstacles nearer than `slack` metres to the second don't count.
pub(super) fn is_in_sight(around: Around<'_>, from: Point, to: Point, slack: f64) -> bool {
    let way = to - from;
    let distance = way.norm();
    distance <= slack || look(around, from, way / distance, distance - slack).is_none()
}

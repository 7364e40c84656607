//! What a beam meets: walls, and what moves.

use super::Around;
use crate::{
    coverage::Hit,
    geometry::{Point, Vector},
};

/// What sends the light back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Surface {
    /// A wall or furniture.
    Fixed,
    /// Somebody's foot.
    Mover,
}

/// The nearest thing on the way from `from` along the unit vector `direction` within `reach` metres.
pub(super) fn look(around: Around<'_>, from: Point, direction: Vector, reach: f64) -> Option<(Hit, Surface)> {
    let wall = around.walls.ray(from, direction, reach);
    let mut nearest = wall.map(|hit| (hit, Surface::Fixed));
    for &(centre, radius) in around.life.movers() {
        let reach = nearest.map_or(reach, |(hit, _)| hit.distance);
        if let Some(hit) = meet_disc(centre - from, radius, direction).filter(|hit| hit.distance < reach) {
            nearest = Some((hit, Surface::Mover));
        }
    }
    nearest
}

/// Whether nothing is in the way between two points; things nearer than `slack` metres to the second don't count.
pub(super) fn is_in_sight(around: Around<'_>, from: Point, to: Point, slack: f64) -> bool {
    let way = to - from;
    let distance = way.norm();
    distance <= slack || look(around, from, way / distance, distance - slack).is_none()
}

/// Where a ray in `direction` meets a disc whose centre is `centre` away.
fn meet_disc(centre: Vector, radius: f64, direction: Vector) -> Option<Hit> {
    let along = centre.dot(&direction);
    let outside = centre.norm_squared() - radius * radius;
    if outside <= 0.0 {
        return Some(Hit { distance: 0.0, cosine: 1.0 });
    }
    let under_root = along * along - outside;
    if along <= 0.0 || under_root <= 0.0 {
        return None;
    }
    let half_chord = under_root.sqrt();
    // The chord's half over the radius is the cosine at which the ray enters.
    Some(Hit { distance: along - half_chord, cosine: half_chord / radius })
}

//! What only the simulator knows: for critics, teachers and tests.

use super::Episode;
use robovac_core::geometry::{Point, Vector};
use robovac_core::math;

/// Directions in which the distance to the next obstacle is measured.
pub const RAYS: usize = 16;
/// Longest distance, m.
pub const REACH: f64 = 5.0;
/// Number of values.
pub const VALUES: usize = 8 + RAYS;

/// Names of the values before the distances, which go round counter-clockwise from straight ahead, from the body's middle.
pub const NAMES: [&str; 8] =
    ["x_m", "y_m", "cos_heading", "sin_heading", "speed_mps", "turn_rate_radps", "coverage", "time_share"];

/// Writes [`VALUES`] values of `episode` into `out`.
pub fn write(episode: &Episode, out: &mut [f32]) {
    let pose = episode.pose();
    let (sin, cos) = math::sin_cos(pose.heading);
    let (speed, turn_rate) = episode.motion();
    let values = [pose.x, pose.y, cos, sin, speed, turn_rate, episode.coverage(), episode.time_share()];
    let walls = &episode.room().floor.walls;
    let distances = (0..RAYS).map(|ray| {
        let (sin, cos) = math::sin_cos(pose.heading + math::TAU * ray as f64 / RAYS as f64);
        let from = Point::new(pose.x, pose.y);
        walls.ray(from, Vector::new(cos, sin), REACH).map_or(REACH, |hit| hit.distance)
    });
    for (value, out) in values.into_iter().chain(distances).zip(out) {
        *out = value as f32;
    }
}

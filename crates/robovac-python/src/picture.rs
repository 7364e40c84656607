//! A picture of an episode, a pixel for each fine cell.

use robovac_core::{geometry::Point, grid::Cell};
use robovac_sim::learning::Episode;

/// Wall, floor that can't be reached, floor to be swept, swept floor, robot, its nose.
const COLOURS: [[u8; 3]; 6] =
    [[51, 51, 51], [225, 222, 214], [255, 255, 255], [158, 202, 225], [0, 114, 178], [255, 255, 255]];
/// Half the angle of the robot's nose, as a cosine.
const NOSE: f64 = 0.97;

/// Rows, columns and colours, the top row first.
pub fn picture(episode: &Episode, radius_m: f64) -> (usize, usize, Vec<u8>) {
    let floor = &episode.room().floor;
    let (width, height) = (floor.floor.width(), floor.floor.height());
    let (pose, visits) = (episode.pose(), episode.tracker().visits());
    let ahead = pose.direction();
    let mut pixels = Vec::with_capacity(3 * width * height);
    for y in (0..height as i32).rev() {
        for x in 0..width as i32 {
            let cell = Cell::new(x, y);
            let off = floor.centre(cell) - Point::new(pose.x, pose.y);
            let distance = off.norm();
            let colour = if distance < radius_m {
                if distance > 0.3 * radius_m && off.dot(&ahead) > NOSE * distance { 5 } else { 4 }
            } else if visits.get(cell).is_some_and(|&count| count > 0) {
                3
            } else if floor.floor.is_set(cell) {
                2
            } else {
                usize::from(!floor.walls.contains(floor.centre(cell)))
            };
            pixels.extend(COLOURS[colour]);
        }
    }
    (height, width, pixels)
}

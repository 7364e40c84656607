//! A picture of an episode.

use robovac_core::{geometry::Point, grid::Cell};
use robovac_sim::learning::Episode;

/// Side, pixels: the same for all rooms, as a film of several episodes needs it.
pub const SIDE: usize = 480;
/// Wall, floor that can't be reached and what is outside, floor to be swept, swept floor, robot, its nose.
const COLOURS: [[u8; 3]; 6] =
    [[51, 51, 51], [225, 222, 214], [255, 255, 255], [158, 202, 225], [0, 114, 178], [255, 255, 255]];
/// Half the angle of the robot's nose, as a cosine.
const NOSE: f64 = 0.97;

/// The colours of its pixels, row by row from the top. The room fills it.
pub fn picture(episode: &Episode, radius_m: f64) -> Vec<u8> {
    let floor = &episode.room().floor;
    let (width, height) = (floor.floor.width() as i32, floor.floor.height() as i32);
    let (pose, visits) = (episode.pose(), episode.tracker().visits());
    let ahead = pose.direction();
    let cells_a_pixel = f64::from(width.max(height)) / SIDE as f64;
    // From the middle, in cells.
    let from_middle = |pixel: usize| (pixel as f64 + 0.5 - 0.5 * SIDE as f64) * cells_a_pixel;
    let mut pixels = Vec::with_capacity(3 * SIDE * SIDE);
    for row in (0..SIDE).rev() {
        let y = 0.5 * f64::from(height) + from_middle(row);
        for column in 0..SIDE {
            let x = 0.5 * f64::from(width) + from_middle(column);
            let cell = Cell::new(x.floor() as i32, y.floor() as i32);
            let off = Point::new(x, y) * floor.resolution - Point::new(pose.x, pose.y);
            let distance = off.norm();
            let colour = if distance < radius_m {
                if distance > 0.3 * radius_m && off.dot(&ahead) > NOSE * distance { 5 } else { 4 }
            } else if visits.get(cell).is_some_and(|&count| count > 0) {
                3
            } else if floor.floor.is_set(cell) {
                2
            } else if (0..width).contains(&cell.x) && (0..height).contains(&cell.y) {
                usize::from(!floor.walls.contains(floor.centre(cell)))
            } else {
                1
            };
            pixels.extend(COLOURS[colour]);
        }
    }
    pixels
}

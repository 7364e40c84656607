//! The boundary that a laser scanner has seen, against which its map is measured.

use super::{MapTruth, OccupancyMap};
use robovac_core::{
    coverage::Walls,
    geometry::{Pose, Vector},
    grid::{Cell, Occupancy},
    math,
    robot::Laser,
};
use std::collections::BTreeSet;

/// Distance behind the surface of the cell that a beam shows, m: surfaces often lie between two cells.
const BEHIND: f64 = 0.005;

/// Cells of the true boundary in which a beam without errors ended, from the true poses of a run.
#[derive(Debug, Clone, Default)]
pub struct SeenBoundary(BTreeSet<(i32, i32)>);

impl SeenBoundary {
    /// Adds what a scan from `pose` shows, in cells of `resolution` metres.
    pub fn look(&mut self, walls: &Walls, laser: &Laser, pose: Pose, resolution: f64) {
        let from = pose.to_world([laser.at[0], laser.at[1]].into());
        for beam in 0..laser.beams {
            let (sin, cos) = math::sin_cos(pose.heading + laser.first + laser.step * beam as f64);
            let direction = Vector::new(cos, sin);
            let hit = walls.ray(from, direction, laser.range[1]);
            if let Some(hit) = hit.filter(|hit| hit.distance >= laser.range[0]) {
                let cell = Cell::at(from + direction * (hit.distance + BEHIND), resolution);
                self.0.insert((cell.x, cell.y));
            }
        }
    }

    /// Share with an occupied cell of the map within one cell, from 0 to 1; 1 if nothing was seen. As for
    /// [`MapQuality::boundary`](super::MapQuality::boundary), only occupied cells of the truth count.
    pub fn mapped(&self, truth: &MapTruth, map: &OccupancyMap) -> f64 {
        let cells = self.0.iter().map(|&(x, y)| Cell::new(x, y));
        let seen: Vec<Cell> = cells.filter(|&cell| truth.at(cell) == Some(Occupancy::Occupied)).collect();
        let is_mapped = |cell: &&Cell| cell.block().any(|at| map.occupancy(at) == Occupancy::Occupied);
        if seen.is_empty() { 1.0 } else { seen.iter().filter(is_mapped).count() as f64 / seen.len() as f64 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{coverage::ReachableFloor, floor_plan::room, robot::model};

    #[test]
    fn it_is_on_the_true_map_and_not_on_an_empty_or_a_shifted_one() {
        let (plan, robot) = ((room("bedroom").unwrap().build)(), model("cbot").unwrap());
        let floor = ReachableFloor::new(&plan, robot, None).unwrap();
        let mut map = OccupancyMap::new(0.05);
        let truth = MapTruth::of(&floor, map.resolution());
        let cells = (-5..200).flat_map(|y| (-5..200).map(move |x| Cell::new(x, y)));
        for cell in cells.filter(|&cell| truth.at(cell) == Some(Occupancy::Occupied)) {
            map.add(cell, 3.0);
        }
        let mut seen = SeenBoundary::default();
        assert_eq!(seen.mapped(&truth, &map), 1.0);
        for turn in 0..8 {
            let pose = Pose::new(floor.start.x, floor.start.y, f64::from(turn));
            seen.look(&floor.walls, &robot.sensors.laser.unwrap(), pose, map.resolution());
        }
        assert!(seen.mapped(&truth, &map) > 0.99, "{}", seen.mapped(&truth, &map));
        assert_eq!(seen.mapped(&truth, &OccupancyMap::new(map.resolution())), 0.0);
        let mut shifted = OccupancyMap::new(map.resolution());
        for (cell, odds) in map.iter() {
            shifted.add(Cell::new(cell.x + 4, cell.y + 4), odds);
        }
        assert!(seen.mapped(&truth, &shifted) < 0.8, "{}", seen.mapped(&truth, &shifted));
    }
}

//! Docks as landmarks: likelihood of what the infrared receivers see at a pose on a known map with docks.

use super::DistanceField;
use crate::docking::{BEAMS, RECEIVERS, SLACK, front_sees, light_at};
use robovac_core::{
    geometry::{Point, Pose},
    math,
    robot::{RobotModel, SensorReadings},
};
use std::sync::Arc;

/// Bits of a dock's characters that are beams, and of its force field (Open Interface specification); all have the base.
const BASE: u8 = 160;
const FIELD: u8 = 1;
const GREEN: u8 = 4;
const RED: u8 = 8;
/// Likelihood that receivers see nothing within the light of a dock: they miss characters, and people are in the way.
const MISSED: f64 = 0.2;
/// That they see light where the map has none, by reflection or because the map is wrong.
const ODD: f64 = 0.05;
/// Of every beam or side that differs otherwise: edges of beams aren't sharp.
const DIFFERS: f64 = 0.3;

/// Docks on a map, and the place of a robot's receivers.
#[derive(Debug, Clone)]
pub(super) struct Landmarks {
    pub docks: Arc<[Pose]>,
    /// Receivers ahead of the robot's middle, m; `None` for a robot without them.
    receivers: Option<f64>,
}

/// What receivers see of docks: green and red beam on any of them, a beam on the left, and one on the right. The force
/// field doesn't count, as it is reflected from everywhere.
pub(super) type DockLight = [bool; 4];

/// Nothing of it.
pub(super) const DARK: DockLight = [false; 4];

impl Landmarks {
    pub fn new(docks: &[Pose], robot: &RobotModel) -> Self {
        Self { docks: docks.into(), receivers: robot.sensors.infrared.then_some(RECEIVERS * robot.radius) }
    }

    /// What a robot with a reading sees of docks; `None` if it can't see any.
    pub fn seen(&self, sensed: &SensorReadings) -> Option<DockLight> {
        self.receivers.filter(|_| !self.docks.is_empty())?;
        let beams = |character: u8| {
            let is_of_dock = character & !(FIELD | GREEN | RED) == BASE;
            if is_of_dock { character & (GREEN | RED) } else { 0 }
        };
        let [omni, left, right] = [sensed.infrared.omni, sensed.infrared.left, sensed.infrared.right].map(beams);
        let any = omni | left | right;
        Some([any & GREEN != 0, any & RED != 0, left != 0, right != 0])
    }

    /// Whether a place is within reach of a dock's beams for a robot heading anywhere.
    pub fn is_near(&self, place: Point) -> bool {
        let reach = BEAMS + self.receivers.unwrap_or_default();
        self.docks.iter().any(|dock| (place - dock.position()).norm() < reach)
    }

    /// Natural logarithm of the likelihood of seeing `seen` at `pose`, 0 at best.
    pub fn fit(&self, seen: DockLight, field: &DistanceField, pose: Pose) -> f64 {
        let expected = self.expected(field, pose);
        match (seen == DARK, expected == DARK) {
            (true, true) => 0.0,
            (true, false) => math::ln(MISSED),
            (false, true) => math::ln(ODD),
            (false, false) => {
                let differ = seen.iter().zip(expected).filter(|&(seen, expected)| *seen != expected).count();
                differ as f64 * math::ln(DIFFERS)
            }
        }
    }

    /// What it should see at `pose`.
    fn expected(&self, field: &DistanceField, pose: Pose) -> DockLight {
        let mut light = DARK;
        let Some(ahead) = self.receivers else { return light };
        let receiver = pose.to_world(Point::new(ahead, 0.0));
        for &dock in &*self.docks {
            let [_, green, red] = light_at(dock, receiver);
            if !(green || red) {
                continue;
            }
            let way = dock.position() - receiver;
            let distance = way.norm();
            // Walls on a map are a cell off or so.
            let clear = distance - SLACK - field.resolution();
            if clear > 0.0 && field.ray(receiver, way / distance, clear).is_some() {
                continue;
            }
            let [left, right] = front_sees(way, pose.direction());
            light = [light[0] || green, light[1] || red, light[2] || left, light[3] || right];
        }
        light
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mapping::OccupancyMap;
    use robovac_core::{
        floor_plan::Sketch,
        robot::{Infrared, model},
    };

    #[test]
    fn light_is_expected_where_the_dock_sends_it_and_no_wall_is_between() {
        let plan = Sketch::open(4.0, 3.0, 0.05).fill(&[[2.0, 0.0, 2.1, 1.2]]).finish("", "");
        let field = DistanceField::new(&OccupancyMap::of(&plan)).unwrap();
        let robot = model("roomba600").unwrap();
        let marks = Landmarks::new(&[Pose::new(0.0, 1.0, 0.0)], robot);
        let seen = |omni| SensorReadings { infrared: Infrared { omni, left: omni, right: omni }, ..Default::default() };
        let both = marks.seen(&seen(172)).unwrap();
        assert_eq!(both, [true; 4]);
        assert_eq!(marks.seen(&seen(162)), Some(DARK), "a virtual wall");
        let fit = |light, x, y, heading| marks.fit(light, &field, Pose::new(x, y, heading));
        assert_eq!(fit(both, 1.2, 1.0, math::PI), 0.0);
        assert!(fit(both, 1.2, 1.4, math::PI) < 0.0, "only one beam is there");
        assert!(fit(both, 1.2, 1.0, 0.0) < 0.0, "it looks away");
        assert_eq!(fit(both, 2.4, 1.0, math::PI), math::ln(ODD), "behind a wall");
        assert_eq!(fit(DARK, 2.4, 1.0, math::PI), 0.0);
        assert_eq!(fit(DARK, 1.2, 1.0, math::PI), math::ln(MISSED));
        let blind = Landmarks::new(&[Pose::new(0.0, 1.0, 0.0)], model("dvr1").unwrap());
        assert_eq!(blind.seen(&seen(172)), None);
    }
}

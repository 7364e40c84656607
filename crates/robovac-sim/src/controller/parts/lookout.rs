//! What a laser scanner sees ahead, so that a robot that follows a route slows down or turns away before a contact.

use robovac_core::{
    geometry::Point,
    math,
    robot::{Body, RobotModel, SensorReadings},
};

/// Room that the body needs on either side, m: about the scanner's error.
const ASIDE: f64 = 0.01;

/// Looks ahead with a robot's scanner.
#[derive(Debug, Clone)]
pub(in crate::controller) struct Lookout {
    /// Place of the scanner, and directions of its beams.
    at: [f64; 2],
    directions: Vec<[f64; 2]>,
    body: Body,
    radius: f64,
}

impl Lookout {
    /// `None` for a robot without a scanner.
    pub(in crate::controller) fn new(robot: &RobotModel) -> Option<Self> {
        let laser = robot.sensors.laser?;
        let direction = |beam: usize| {
            let (sin, cos) = math::sin_cos(laser.first + laser.step * beam as f64);
            [cos, sin]
        };
        let directions = (0..laser.beams).map(direction).collect();
        Some(Self { at: laser.at, directions, body: robot.body, radius: robot.radius })
    }

    /// Distance that the body can drive straight ahead, m; infinite if nothing is in sight there, or without a scan.
    pub(in crate::controller) fn room_ahead(&self, sensed: &SensorReadings) -> f64 {
        let Some(scan) = &sensed.laser else { return f64::INFINITY };
        let point = |(direction, &range): (&[f64; 2], &f32)| {
            let range = f64::from(range);
            Point::new(self.at[0] + range * direction[0], self.at[1] + range * direction[1])
        };
        let points = self.directions.iter().zip(scan.iter()).filter(|(_, range)| range.is_finite()).map(point);
        let room = points.filter_map(|at| Some(at.x - self.front(at.y)?)).filter(|&room| room > -ASIDE);
        room.fold(f64::INFINITY, f64::min)
    }

    /// Where the body ends ahead on a line `aside` metres to its left; `None` beside it.
    fn front(&self, aside: f64) -> Option<f64> {
        match self.body {
            Body::Round => {
                let inner = aside.abs().min(self.radius);
                (aside.abs() < self.radius + ASIDE).then(|| (self.radius * self.radius - inner * inner).sqrt())
            }
            Body::Polygon(corners) => {
                let half = corners.iter().map(|corner| corner[1].abs()).fold(0.0, f64::max);
                let front = corners.iter().map(|corner| corner[0]).fold(0.0, f64::max);
                (aside.abs() < half + ASIDE).then_some(front)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    /// Room ahead of a robot before a wall straight ahead that is that far from its middle.
    fn before_a_wall(id: &str, distance: f64) -> f64 {
        let robot = model(id).unwrap();
        let laser = robot.sensors.laser.unwrap();
        let range = |beam: usize| {
            let cos = math::cos(laser.first + laser.step * beam as f64);
            if cos > 0.01 { ((distance - laser.at[0]) / cos) as f32 } else { f32::INFINITY }
        };
        let sensed = SensorReadings { laser: Some((0..laser.beams).map(range).collect()), ..SensorReadings::default() };
        Lookout::new(robot).unwrap().room_ahead(&sensed)
    }

    #[test]
    fn a_wall_ahead_leaves_the_room_in_front_of_the_body() {
        assert!((before_a_wall("cbot", 1.0) - 0.8).abs() < 1e-6);
        assert!((before_a_wall("roomba600_lidar", 1.0) - (1.0 - 0.174_25)).abs() < 1e-3);
        assert!(Lookout::new(model("roomba600").unwrap()).is_none());
    }

    #[test]
    fn what_stands_beside_the_way_leaves_it_free() {
        let robot = model("cbot").unwrap();
        let laser = robot.sensors.laser.unwrap();
        // Walls 0.15 m to either side.
        let range = |beam: usize| (0.15 / math::sin(laser.first + laser.step * beam as f64).abs().max(0.01)) as f32;
        let sensed = SensorReadings { laser: Some((0..laser.beams).map(range).collect()), ..SensorReadings::default() };
        let lookout = Lookout::new(robot).unwrap();
        assert_eq!(lookout.room_ahead(&sensed), f64::INFINITY);
        assert_eq!(lookout.room_ahead(&SensorReadings::default()), f64::INFINITY);
    }
}

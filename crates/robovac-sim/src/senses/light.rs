//! Light bumper and wall sensor: infrared light reflected by obstacles.
//!
//! The signal as a function of distance is [`robovac_core::robot::LightBumper::light_at`].
//!
//! It is proportional to the cosine of the angle of incidence (Lambert) and to the surface's reflectance: 1 for walls,
//! 0.7 for furniture, 0.6 for movers, in shoes and fur (ours). One ray stands for the beam of about 10 degrees. Without
//! an obstacle, a Roomba's sensors read 2 to 32 (Open Interface facts, section 6).
//!
//! Noise: at "typical" a standard deviation of 3 % and the idle values above; at "harsh" 15 % and idle values up to 160,
//! as in sunlight. The percentages and the threshold are ours.

use super::{Around, BodyFrame, Noisy, sight::look};
use crate::SensorKind;
use robovac_core::{
    coverage::{RayHit, Surface},
    geometry::Point,
    math,
    robot::{LightBumper, MOST_LIGHT, RobotModel, SensorReadings},
};

/// Value without an obstacle and without noise.
const IDLE: f64 = 12.0;
/// Signals above this mean that something is near: a wall ahead at 13 cm.
const THRESHOLD: u16 = 200;

/// The six beams of one robot.
#[derive(Debug, Clone)]
pub(super) struct LightBeams {
    /// Unit vectors, (ahead, left).
    directions: [[f64; 2]; 6],
    /// Distances from the body's origin at which beams start, m: where the body ends.
    starts: [f64; 6],
    /// The largest that they can be, m.
    radius: f64,
    bumper: LightBumper,
}

impl LightBeams {
    /// The beams of `light` on the body of `model`.
    pub fn new(model: &RobotModel, light: LightBumper) -> Self {
        let directions = light.angles.map(|angle| [math::cos(angle), math::sin(angle)]);
        let starts = light.angles.map(|angle| model.body.reach(model.radius, angle));
        Self { directions, starts, radius: model.radius, bumper: light }
    }

    /// Reads all of them.
    pub fn read(
        &self,
        around: Around<'_>,
        frame: &BodyFrame,
        is_lifted: bool,
        noise: &Noisy<'_>,
        sensors: &mut SensorReadings,
    ) {
        let deviation = noise.pick(SensorKind::Light, [0.0, 0.03, 0.15]);
        let idle = noise.pick(SensorKind::Light, [(IDLE, 0.0), (2.0, 31.0), (2.0, 159.0)]);
        let sees_nothing = is_lifted || self.is_all_out_of_reach(around, frame.position);
        for (index, &direction) in self.directions.iter().enumerate() {
            let light = if sees_nothing { 0.0 } else { self.light(around, frame, (direction, self.starts[index])) };
            let mut value = idle.0 + idle.1 * noise.uniform(SensorKind::Light, index);
            if light > 0.0 {
                value += light * (1.0 + deviation * noise.normal(SensorKind::Light, index)).max(0.0);
            }
            let signal = value.min(MOST_LIGHT) as u16;
            sensors.light_signal[index] = signal;
            sensors.light_bumper[index] = signal > THRESHOLD;
        }
        // The wall sensor of this generation is the right end of its light bumper (packet 8), with a quarter of the range.
        sensors.wall = sensors.light_bumper[5];
        sensors.wall_signal = sensors.light_signal[5] / 4;
    }

    /// Whether nothing is within the range of any beam; a quick test.
    fn is_all_out_of_reach(&self, around: Around<'_>, origin: Point) -> bool {
        let reach = self.radius + self.bumper.range;
        let is_near =
            |&(centre, radius): &(Point, f64)| (centre - origin).norm_squared() < (reach + radius) * (reach + radius);
        around.walls.are_far_from(origin, reach) && !around.life.movers().iter().any(is_near)
    }

    /// The light returned to a beam.
    fn light(&self, around: Around<'_>, frame: &BodyFrame, (direction, start): ([f64; 2], f64)) -> f64 {
        let direction = frame.direction(direction);
        let range = self.bumper.range;
        let middle = frame.position + direction * (start + 0.5 * range);
        if around.life.movers().is_empty() && around.walls.are_far_from(middle, 0.5 * range) {
            return 0.0;
        }
        let from = frame.position + direction * start;
        look(around, from, direction, range).map_or(0.0, |hit| self.strength(hit))
    }

    /// Signal of a hit.
    fn strength(&self, hit: RayHit) -> f64 {
        let reflectance = match hit.surface {
            Surface::Wall => 1.0,
            Surface::Object => 0.7,
            Surface::Mover => 0.6,
        };
        self.bumper.light_at(hit.distance, reflectance * hit.cosine)
    }
}

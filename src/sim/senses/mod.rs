//! Sensors: what a robot reports of its surroundings, one kind a file.

mod bumper;

use super::{Life, Noise, World};
use crate::{
    coverage::Walls,
    geometry::{Pose, Vector},
    robot::{Drive, RobotModel, Sensors},
};

/// Everything that can be sensed from outside.
#[derive(Clone, Copy)]
pub struct Around<'a> {
    /// Walls and furniture.
    pub walls: &'a Walls,
    /// What lies on the floor and shines.
    pub world: &'a World,
    /// What moves.
    pub life: &'a Life,
}

/// The body that carries the sensors, after a step.
#[derive(Debug, Clone, Copy)]
pub struct Carrier {
    /// Where it is.
    pub pose: Pose,
    /// Unit vector from its origin to what it touches.
    pub touch: Option<Vector>,
    /// Wheel speeds that were asked for.
    pub wanted: Drive,
    /// Wheel speeds.
    pub speed: Drive,
    /// What the wheels have rolled since the start: left, right, sideways, m.
    pub rolled: [f64; 3],
    /// How far the body really moved in the step, m.
    pub moved: f64,
    /// Whether it hangs in the air.
    pub is_lifted: bool,
    /// Which wheels hang over a drop-off, left and right; both once the robot has fallen.
    pub dropped: [bool; 2],
    /// Dirt that was picked up in the step: as much as lies on so many m² of a spot of dirt.
    pub dirt: f64,
}

/// The sensors of one robot, with what they remember and how they err.
#[derive(Debug, Clone)]
pub struct Senses {
    model: RobotModel,
    sensors: Sensors,
}

impl Senses {
    /// The sensors of `model`; `seed` decides over their noise.
    pub fn new(model: &RobotModel, _noise: Noise, _seed: u64) -> Self {
        Self { model: model.clone(), sensors: Sensors::default() }
    }

    /// The latest reading.
    #[inline]
    pub fn reading(&self) -> &Sensors {
        &self.sensors
    }

    /// Takes a new reading.
    pub fn read(&mut self, _around: Around<'_>, carrier: &Carrier) {
        let Self { model, sensors } = self;
        (sensors.bump_left, sensors.bump_right) = bumper::pressed(model, carrier);
        let counts = |rolled: f64| ((rolled * model.counts_per_metre).floor() as i64) as u16;
        [sensors.left_counts, sensors.right_counts, sensors.lateral_counts] = carrier.rolled.map(counts);
        sensors.wheel_drop_left = carrier.is_lifted || carrier.dropped[0];
        sensors.wheel_drop_right = carrier.is_lifted || carrier.dropped[1];
    }
}

//! Simulated sensors, one kind per file.

mod battery;
mod bumper;
mod cliff;
mod dirt;
mod infrared;
mod laser;
mod light;
mod motors;
mod sight;

use super::{
    Conditions, Life, Noise, NoiseLevel, SensorKind, Touch, World,
    noise::{NoiseDraw, NoiseSource},
};
use battery::BatteryCells;
pub use battery::Supply;
use bumper::Switches;
use cliff::Edges;
use dirt::DirtSensor;
use laser::Scanner;
use light::LightBeams;
use motors::Motors;
use robovac_core::{
    coverage::Walls,
    geometry::{Point, Pose, Vector},
    robot::{DistanceAngleMeter, Drive, RobotModel, SensorReadings},
};

/// The surroundings that sensors can detect.
#[derive(Clone, Copy)]
pub struct Around<'a> {
    /// Walls and furniture.
    pub walls: &'a Walls,
    /// Objects on the floor, and emitters.
    pub world: &'a World,
    /// Movers and dirt.
    pub life: &'a Life,
}

/// The body that carries the sensors, after a step.
#[derive(Debug, Clone, Copy)]
pub struct Carrier {
    /// Its pose.
    pub pose: Pose,
    /// Its contacts.
    pub touch: Touch,
    /// Commanded wheel speeds.
    pub wanted: Drive,
    /// Wheel speeds.
    pub speed: Drive,
    /// Distances rolled by the wheels since the start: left, right, sideways, m.
    pub rolled: [f64; 3],
    /// Actual distance moved in the step, m.
    pub moved: f64,
    /// Whether it is lifted.
    pub is_lifted: bool,
    /// Dropped wheels, left and right; both once the robot has fallen.
    pub dropped: [bool; 2],
    /// Dirt that was picked up in the step: 1 is the dirt on 10 cm² of a spot. A Roomba at 0.3 m/s gets 0.77.
    pub dirt: f64,
}

/// The sensors of one robot, with their memory and errors.
#[derive(Debug, Clone)]
pub struct Senses {
    model: RobotModel,
    noise: Noise,
    /// `None` if no sensor errs.
    source: Option<NoiseSource>,
    switches: Switches,
    edges: Edges,
    light: Option<LightBeams>,
    laser: Option<Scanner>,
    dirt: DirtSensor,
    motors: Motors,
    cells: BatteryCells,
    moved: DistanceAngleMeter,
    sensors: SensorReadings,
}

impl Senses {
    /// The sensors of `model`; `seed` determines their noise.
    pub fn new(model: &RobotModel, conditions: Conditions, seed: u64) -> Self {
        let noise = conditions.noise;
        let cells = BatteryCells::new(model, conditions, seed);
        let mut sensors = SensorReadings::default();
        cells.report(0.0, &mut sensors);
        Self {
            model: model.clone(),
            noise,
            source: (!noise.is_off()).then(|| NoiseSource::new(seed)),
            switches: Switches::default(),
            edges: Edges::new(model, seed),
            light: model.sensors.light_bumper.map(|light| LightBeams::new(model, light)),
            laser: model.sensors.laser.map(|laser| Scanner::new(laser, noise.of(SensorKind::Laser), seed)),
            dirt: DirtSensor::default(),
            motors: Motors::default(),
            cells,
            moved: DistanceAngleMeter::new(model),
            sensors,
        }
    }

    /// Takes the light bumper and the laser off: the costliest to simulate.
    pub fn see_nothing(&mut self) {
        (self.light, self.laser) = (None, None);
    }

    /// The latest reading.
    #[inline]
    pub fn reading(&self) -> &SensorReadings {
        &self.sensors
    }

    /// Whether the battery is empty.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// Sets the battery's power and charging current from outside.
    pub fn supply(&mut self, supply: Supply) {
        self.cells.supply(supply);
    }

    /// Takes a new reading.
    pub fn read(&mut self, around: Around<'_>, carrier: &Carrier) {
        let Self { model, noise, source, switches, edges, light, laser, dirt, motors, cells, sensors, .. } = self;
        let draw = source.as_mut().map(NoiseSource::draw);
        let noise = Noisy { levels: *noise, draw };
        let frame = BodyFrame::new(carrier.pose);
        // Rounded down, like `floor`, which is a function call.
        let counts = |rolled: f64| {
            let counts = rolled * model.counts_per_metre;
            (counts as i64 - i64::from(counts as i64 as f64 > counts)) as u16
        };
        [sensors.left_counts, sensors.right_counts, sensors.lateral_counts] = carrier.rolled.map(counts);
        sensors.moved = self.moved.take(sensors);
        (sensors.bump_left, sensors.bump_right) = switches.pressed(model, carrier, &noise);
        if model.sensors.wheel_drops {
            [sensors.wheel_drop_left, sensors.wheel_drop_right] = carrier.dropped.map(|d| d || carrier.is_lifted);
        }
        let on_dock = !carrier.is_lifted && infrared::is_docked(model, around.world, &frame);
        edges.read(around.world, &frame, !carrier.is_lifted && !on_dock, &noise, sensors);
        if let Some(light) = light {
            light.read(around, &frame, carrier.is_lifted, &noise, sensors);
        }
        if let Some(scan) = laser.as_mut().and_then(|laser| laser.read(around, &frame)) {
            sensors.laser = Some(scan);
        }
        if model.sensors.infrared {
            infrared::read(model, around, &frame, &noise, sensors);
        }
        sensors.dirt = dirt.read(carrier.dirt, &noise);
        motors.read(carrier, sensors);
        cells.step(model, around.world, carrier, on_dock, motors.is_stalled());
        cells.report(noise.normal(SensorKind::Battery, 0), sensors);
    }
}

/// The body's pose in a form for placing sensors.
#[derive(Debug, Clone, Copy)]
struct BodyFrame {
    position: Point,
    /// Unit vector ahead.
    ahead: Vector,
}

impl BodyFrame {
    fn new(pose: Pose) -> Self {
        Self { position: pose.position(), ahead: pose.direction() }
    }

    /// The world direction of (ahead, left).
    #[inline]
    fn direction(&self, [ahead, left]: [f64; 2]) -> Vector {
        let (x, y) = (self.ahead.x, self.ahead.y);
        Vector::new(x * ahead - y * left, y * ahead + x * left)
    }

    /// The world position of (ahead, left) of the body's origin.
    #[inline]
    fn point(&self, place: [f64; 2]) -> Point {
        self.position + self.direction(place)
    }
}

/// Levels of noise, with the random bytes of this step.
struct Noisy<'a> {
    levels: Noise,
    /// `None` if no sensor errs.
    draw: Option<NoiseDraw<'a>>,
}

impl Noisy<'_> {
    /// One of three values, for off, typical and harsh, by the level of `kind`.
    #[inline]
    fn pick<T: Copy>(&self, kind: SensorKind, values: [T; NoiseLevel::ALL.len()]) -> T {
        values[self.levels.of(kind) as usize]
    }

    /// Number `index` of a kind's random numbers, as a normal deviate; 0 if no sensor errs.
    #[inline]
    fn normal(&self, kind: SensorKind, index: usize) -> f64 {
        self.draw.map_or(0.0, |draw| draw.normal(kind, index))
    }

    /// The same as a random number below 1, at least 0; 0 if no sensor errs.
    #[inline]
    fn uniform(&self, kind: SensorKind, index: usize) -> f64 {
        self.draw.map_or(0.0, |draw| f64::from(draw.byte(kind, index)) / 256.0)
    }

    /// True with this probability, by the same number.
    #[inline]
    fn happens(&self, kind: SensorKind, index: usize, probability: f64) -> bool {
        self.draw.is_some_and(|draw| f64::from(draw.byte(kind, index)) < 256.0 * probability)
    }
}

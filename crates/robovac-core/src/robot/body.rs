//! Shape of a robot's body, with the positions of sensors and brushes. SI units in the robot's frame: x ahead, y to
//! the left, angles counter-clockwise from straight ahead; the origin is the middle between the driven wheels.

use super::LightLaw;

/// Outline of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Body {
    /// A circle around the origin whose radius is the model's.
    Round,
    /// A convex polygon, counter-clockwise, m. It holds the origin.
    Polygon(&'static [[f64; 2]]),
}

/// How a robot moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WheelLayout {
    /// Two driven wheels on one axle, and castors.
    Differential,
    /// Moves in every direction without turning.
    Omnidirectional,
}

/// Sensors of a robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorSuite {
    /// Bumper; `None` for a robot without one.
    pub bumper: Option<Bumper>,
    /// Cliff sensors: left, front left, front right, right. [`None`] where there is none; a single front sensor is
    /// listed twice.
    pub cliffs: [Option<[f64; 2]>; 4],
    /// Light bumper and wall sensor.
    pub light_bumper: Option<LightBumper>,
    /// Whether it has infrared receivers for docks and virtual walls.
    pub infrared: bool,
    /// Whether it has wheel drop switches.
    pub wheel_drops: bool,
    /// Laser scanner.
    pub laser: Option<Laser>,
}

/// A bumper around the front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bumper {
    /// Half the angle that it spans, rad.
    pub half_arc: f64,
    /// A contact this far off the middle or less presses both switches, rad.
    pub both_within: f64,
    /// Height of its lower edge above the floor, m: lower obstacles pass under it. 0 where no source gives it.
    pub height: f64,
}

/// Six infrared distance sensors around the front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightBumper {
    /// Directions of the beams, from left to right, rad. They start at the body's edge.
    pub angles: [f64; 6],
    /// Range from the body's edge, m.
    pub range: f64,
    /// How its signal falls with distance.
    pub law: LightLaw,
}

/// A laser scanner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Laser {
    /// Its position.
    pub at: [f64; 2],
    /// Direction of the first beam, rad.
    pub first: f64,
    /// Angle from one beam to the next, rad, counter-clockwise.
    pub step: f64,
    /// Number of beams.
    pub beams: usize,
    /// Nearest and farthest distance that it measures, m.
    pub range: [f64; 2],
    /// Scans per second.
    pub rate_hz: f64,
}

/// A wheel that isn't driven and follows where the robot goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Castor {
    /// Where it touches the floor.
    pub at: [f64; 2],
    /// Its radius, m.
    pub radius: f64,
}

/// A brush that sweeps dirt from beside the body under it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SideBrush {
    /// Its axis.
    pub at: [f64; 2],
    /// Length of its bristles, m.
    pub radius: f64,
}

/// A battery.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Battery {
    /// Capacity when new, mAh.
    pub capacity_mah: f64,
    /// Nominal voltage, V.
    pub voltage: f64,
    /// Current into it while it charges on a dock, mA; 0 for a robot without contacts for one.
    pub charge_ma: f64,
    /// Whether the robot can read its gauge.
    pub has_gauge: bool,
}

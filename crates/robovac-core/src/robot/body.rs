//! Shape of a robot's body, with the positions of sensors and brushes. SI units in the robot's frame: x ahead, y to
//! the left, angles counter-clockwise from straight ahead; the origin is the middle between the driven wheels.

use super::LightLaw;
use crate::math;
use serde::{Deserialize, Serialize};
use std::{fmt, ops::Deref};

/// Most corners of a body.
pub const MAX_CORNERS: usize = 64;

/// Outline of a body.
// Models are constants and are copied seldom: a list on the heap could be neither.
#[expect(clippy::large_enum_variant)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Body {
    /// A circle around the origin whose radius is the model's.
    Round,
    /// A simple polygon, convex or not, counter-clockwise, m. It holds the origin.
    Polygon(Corners),
}

/// Corners of a polygon, at most [`MAX_CORNERS`].
#[derive(Clone, Copy, PartialEq)]
pub struct Corners {
    count: usize,
    at: [[f64; 2]; MAX_CORNERS],
}

/// What cleans the floor under a robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tool {
    /// A disc as wide as the model's tool around this point.
    Disc([f64; 2]),
    /// The whole body: all floor under it is clean, as 001 takes it.
    Body,
}

impl Tool {
    /// A disc around the middle between the wheels.
    pub const CENTRED: Self = Self::Disc([0.0, 0.0]);
}

impl Corners {
    /// These corners; those beyond the limit are left out.
    pub const fn of(corners: &[[f64; 2]]) -> Self {
        let mut at = [[0.0; 2]; MAX_CORNERS];
        let mut count = 0;
        while count < corners.len() && count < MAX_CORNERS {
            at[count] = corners[count];
            count += 1;
        }
        Self { count, at }
    }
}

impl Deref for Corners {
    type Target = [[f64; 2]];

    #[inline]
    fn deref(&self) -> &[[f64; 2]] {
        &self.at[..self.count]
    }
}

impl fmt::Debug for Corners {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&**self, f)
    }
}

impl Body {
    /// Distance from the origin to where the body ends in the direction `angle`, m; `radius` is the model's.
    pub fn reach(&self, radius: f64, angle: f64) -> f64 {
        let Self::Polygon(corners) = self else { return radius };
        let (y, x) = math::sin_cos(angle);
        let next = corners.iter().cycle().skip(1);
        let ends = corners.iter().zip(next).filter_map(|(&[ax, ay], &[bx, by])| {
            // Where the ray meets the side: a + t (b - a), with 0 <= t <= 1.
            let (sx, sy) = (bx - ax, by - ay);
            let across = x * sy - y * sx;
            let t = (y * ax - x * ay) / across;
            let far = (ax * sy - ay * sx) / across;
            (across != 0.0 && (-1e-9..=1.0 + 1e-9).contains(&t) && far > 0.0).then_some(far)
        });
        ends.fold(0.0, f64::max)
    }

    /// Radius of the largest circle around the origin that the body holds, m; `radius` is the model's.
    pub fn inner_radius(&self, radius: f64) -> f64 {
        let Self::Polygon(corners) = self else { return radius };
        let next = corners.iter().cycle().skip(1);
        let off = |(&[ax, ay], &[bx, by]): (&[f64; 2], &[f64; 2])| {
            let (sx, sy) = (bx - ax, by - ay);
            let t = (-(ax * sx + ay * sy) / (sx * sx + sy * sy).max(1e-18)).clamp(0.0, 1.0);
            math::hypot(ax + t * sx, ay + t * sy)
        };
        corners.iter().zip(next).map(off).fold(radius, f64::min)
    }
}

/// How a robot moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum WheelLayout {
    /// Two driven wheels on one axle, and castors.
    Differential,
    /// Moves in every direction without turning.
    Omnidirectional,
}

impl WheelLayout {
    /// Both, with their names in links and files.
    pub const ALL: [(Self, &'static str); 2] =
        [(Self::Differential, "differential"), (Self::Omnidirectional, "omnidirectional")];
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

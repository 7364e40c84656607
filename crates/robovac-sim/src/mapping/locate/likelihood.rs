//! Likelihood of a reading at a pose on a known map.

use super::DistanceField;
use robovac_core::{
    geometry::{Point, Pose, Vector},
    math,
    robot::{LightBumper, RobotModel, SensorReadings},
};

/// Signals below this mean that nothing is near; above the values read in the dark.
const SEEN: u16 = 150;
/// Assumed reflectance of obstacles, between walls and furniture (ours).
const REFLECTANCE: f64 = 0.85;
/// Least cosine of incidence, as normals of cells aren't exact.
const GRAZING: f64 = 0.3;
/// Error of an echo's distance: m, and as a share of it (ours: due to the map's cells, and unknown reflectances).
const ECHO: (f64, f64) = (0.015, 0.1);
/// An obstacle nearer than this must be detected, m.
const MUST_SEE: f64 = 0.08;
/// Error of the body's position at a contact, m.
const TOUCH: f64 = 0.025;
/// Likelihood of readings that don't fit, relative to the best: people, moved chairs, legs thinner than a cell.
const ODD: f64 = 0.08;

/// A reading prepared for comparison with many poses.
#[derive(Debug, Clone)]
pub(super) struct Reading {
    /// Unit vectors and distances from the robot's origin at which beams start, and the distance at which a wall
    /// perpendicular to the beam would return that signal; `None` without an echo.
    beams: Vec<(Vector, Option<f64>)>,
    start: f64,
    light: Option<LightBumper>,
    range: f64,
    body: f64,
    bumped: [bool; 2],
    half_arc: f64,
    both_within: f64,
}

impl Reading {
    /// The reading of `robot`.
    pub fn new(robot: &RobotModel, sensed: &SensorReadings) -> Self {
        let light = robot.sensors.light_bumper;
        let beams = light.map_or_else(Vec::new, |light| {
            let beam = |(angle, &signal): (f64, &u16)| {
                let (sin, cos) = math::sin_cos(angle);
                (
                    Vector::new(cos, sin),
                    (signal >= SEEN).then(|| light.distance_of_light(f64::from(signal), REFLECTANCE)),
                )
            };
            light.angles.into_iter().zip(&sensed.light_signal).map(beam).collect()
        });
        let bumper = robot.sensors.bumper;
        Self {
            beams,
            start: robot.radius,
            light,
            range: light.map_or(0.0, |light| light.range),
            body: robot.radius,
            bumped: [sensed.bump_left, sensed.bump_right],
            half_arc: bumper.map_or(0.0, |b| b.half_arc),
            both_within: bumper.map_or(0.0, |b| b.both_within),
        }
    }

    /// Whether it detects anything.
    pub fn meets_something(&self) -> bool {
        self.bumped != [false; 2] || self.beams.iter().any(|(_, echo)| echo.is_some())
    }

    /// Largest distance of detected obstacles from the body's edge, m.
    pub fn reach(&self) -> f64 {
        if self.bumped == [false; 2] { self.range } else { 2.0 * TOUCH }
    }

    /// Natural logarithm of the likelihood of the reading at `pose`, 0 at best.
    pub fn fit(&self, field: &DistanceField, pose: Pose) -> f64 {
        let position = pose.position();
        let room = field.distance(position) - self.body;
        // The body can't be inside a wall.
        let mut fit = if room < 0.0 { -0.5 * square(room / TOUCH) } else { 0.0 };
        if fit < -12.0 {
            return fit;
        }
        let (sin, cos) = math::sin_cos(pose.heading);
        let turn = |v: Vector| Vector::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos);
        if self.bumped != [false; 2] {
            let touch = math::exp(-0.5 * square(room / TOUCH));
            let likely = touch * if self.is_on_side(field, position, (sin, cos)) { 1.0 } else { 0.2 };
            fit += math::ln(ODD + (1.0 - ODD) * likely);
        }
        if room > self.range {
            let missing = self.beams.iter().filter(|(_, echo)| echo.is_some()).count();
            return fit + missing as f64 * math::ln(ODD);
        }
        for &(direction, echo) in &self.beams {
            let direction = turn(direction);
            let from = position + direction * self.start;
            let expected = field.ray(from, direction, self.range).map(|distance| {
                let away = field.away(from + direction * distance);
                let length = away.norm();
                let cosine = if length > 1e-9 { -away.dot(&direction) / length } else { 1.0 };
                self.light.map_or(distance, |light| light.apparent_distance(distance, cosine.max(GRAZING)))
            });
            fit += match (echo, expected) {
                (Some(echo), Some(expected)) => {
                    let error = ECHO.0 + ECHO.1 * expected;
                    math::ln(ODD + (1.0 - ODD) * math::exp(-0.5 * square((echo - expected) / error)))
                }
                (Some(_), None) => math::ln(ODD),
                (None, Some(expected)) if expected < MUST_SEE => math::ln(2.0 * ODD),
                (None, _) => 0.0,
            };
        }
        fit
    }

    /// Whether the nearest obstacle lies on the pressed side of the bumper.
    fn is_on_side(&self, field: &DistanceField, at: Point, (sin, cos): (f64, f64)) -> bool {
        let away = field.away(at);
        if away.norm_squared() == 0.0 {
            return false;
        }
        let towards = -away;
        let bearing = math::atan2(towards.y * cos - towards.x * sin, towards.x * cos + towards.y * sin);
        let slack = 0.2;
        match self.bumped {
            [true, true] => bearing.abs() < self.both_within + slack,
            [true, false] => (self.both_within - slack..self.half_arc + slack).contains(&bearing),
            [false, true] => (self.both_within - slack..self.half_arc + slack).contains(&-bearing),
            [false, false] => true,
        }
    }
}

fn square(x: f64) -> f64 {
    x * x
}

//! The sensor model: from a reading to observations in the robot's frame.
//!
//! - A *beam* of the light bumper measures a distance, by the law of [`LightBumper::light_at`]. The share of
//!   reflected light isn't known: it depends on reflectances of 0.6 to 1 and the cosine of incidence. So the distance
//!   from the sensor's source is uncertain by a share, which the filter makes smaller once it knows the wall's
//!   direction.
//! - A *contact* touches the body in the direction of the switches: the left half, the right half, or both, which is
//!   within the angle of the model. With a light bumper, a straight wall that touches the body in a certain direction
//!   returns certain amounts of light to the beams beside it; the direction that explains them best is chosen.
//! - *No echo* means that there is no obstacle within range.

use robovac_core::{
    geometry::{Point, Vector, difference, edges, outward},
    math,
    robot::{Body, LightBumper, RobotModel, SensorReadings},
};

/// Beams of a light bumper.
pub const BEAMS: usize = 6;
/// Signal without an obstacle: the middle of a Roomba's 2 to 32 (Open Interface facts, section 6).
pub const IDLE: f64 = 17.0;
/// Least signal above that which counts as an echo (ours: seven times the standard deviation of idle readings).
pub const LEAST: f64 = 65.0;
/// Expected reflectance, and its relative uncertainty (ours: between dark furniture and white walls).
pub const REFLECTANCE: (f64, f64) = (0.92, 0.15);
/// Expected cosine, and its uncertainty, for an unknown direction of the surface (ours).
pub const COSINE: (f64, f64) = (0.88, 0.15);
/// Share of the light that a usual wall sends back.
pub const REFLECTED: f64 = REFLECTANCE.0 * COSINE.0;
/// Distance within which a beam certainly detects obstacles, m: a dark surface at 60 degrees is still an echo there.
const SEEN: f64 = 0.08;
/// Step between tried directions of a contact, rad.
const TRIES: f64 = 0.05;
/// Direction of a contact beyond which a robot that pushes ahead still moves, rad: it slides by the sine of that, and
/// the castor reports motion from three tenths on.
const SLIDES: f64 = 0.3;
/// Least difference of the wheels' distances in a reading that counts as a curve, m, and the direction of the contact
/// with the obstacle inside the curve, as a share of the bumper's half arc (ours, measured: a robot that follows walls
/// moves by 93 % of the distance rolled).
const AROUND: (f64, f64) = (0.0005, 0.85);
/// Angle that a switch spans, as a multiple of the standard deviation within it.
const SWITCHES: f64 = 3.5;
/// How far beyond that a contact may be, as the heading is uncertain, rad.
const ALLOWANCE: f64 = 0.1;
/// Uncertainty of a contact's direction found by light, rad (ours).
const BY_LIGHT: f64 = 0.1;

/// An echo of a beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Echo {
    /// Light above the idle signal.
    pub light: f64,
    /// Distance from the body's edge along the beam, m.
    pub distance: f64,
    /// Its standard deviation, m.
    pub deviation: f64,
}

/// A contact of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactPoint {
    /// Direction from the body's origin, rad.
    pub direction: f64,
    /// Its standard deviation, rad.
    pub deviation: f64,
}

impl ContactPoint {
    /// Whether the switches allow a wall in that direction from the body's origin.
    pub(super) fn allows(&self, direction: f64) -> bool {
        difference(self.direction, direction).abs() < 0.5 * SWITCHES * self.deviation + ALLOWANCE
    }
}

/// The observations of a reading.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Observation {
    /// Echoes of the beams, from left to right.
    pub echoes: [Option<Echo>; BEAMS],
    /// The contact, if any.
    pub contact: Option<ContactPoint>,
}

/// The sensors of one robot.
#[derive(Debug, Clone)]
pub struct SensorModel {
    radius: f64,
    body: Body,
    bumper: Option<[f64; 2]>,
    light: Option<Light>,
    has_laser: bool,
}

#[derive(Debug, Clone)]
struct Light {
    bumper: LightBumper,
    directions: [Vector; BEAMS],
    /// For directions of a contact from -half arc upwards, in steps of [`TRIES`]: square roots of the signals of a
    /// straight wall.
    walls: Vec<[f64; BEAMS]>,
}

impl SensorModel {
    /// The sensors of `robot`.
    pub fn new(robot: &RobotModel) -> Self {
        let bumper = robot.sensors.bumper.map(|bumper| [bumper.half_arc, bumper.both_within]);
        let light = robot.sensors.light_bumper.map(|light| {
            let tries = bumper.map_or(0, |[half_arc, _]| (2.0 * half_arc / TRIES) as usize + 1);
            let first = -bumper.map_or(0.0, |[half_arc, _]| half_arc);
            Light {
                directions: light.angles.map(|angle| Vector::new(math::cos(angle), math::sin(angle))),
                walls: (0..tries).map(|i| touching(&light, robot.radius, first + TRIES * i as f64)).collect(),
                bumper: light,
            }
        });
        Self { radius: robot.radius, body: robot.body, bumper, light, has_laser: robot.sensors.laser.is_some() }
    }

    /// The observations of a reading.
    pub fn observe(&self, sensed: &SensorReadings) -> Observation {
        let mut echoes = [None; BEAMS];
        if self.light.is_some() {
            for (echo, &signal) in echoes.iter_mut().zip(&sensed.light_signal) {
                let light = f64::from(signal) - IDLE;
                *echo = (light > LEAST).then(|| self.echo(light, COSINE.0, COSINE.1)).flatten();
            }
        }
        Observation { echoes, contact: self.contact(sensed, false) }
    }

    /// The contact of a reading; much faster than [`SensorModel::observe`]. `pushes` is whether the wheels roll ahead:
    /// then the castor shows whether the body slides along the obstacle or stands.
    pub fn contact(&self, sensed: &SensorReadings, pushes: bool) -> Option<ContactPoint> {
        let [half_arc, both_within] = self.bumper?;
        let (least, most) = match (sensed.bump_left, sensed.bump_right) {
            (false, false) => return None,
            (true, true) => (-both_within, both_within),
            (true, false) => (both_within, half_arc),
            (false, true) => (-half_arc, -both_within),
        };
        // Directions in which it would stand although it pushes, or slide; a Roomba's castor tells.
        let (least, most) = match (pushes && self.light.is_some(), sensed.stasis) {
            (true, true) if least.abs() < SLIDES && most > 0.0 && least >= 0.0 => (SLIDES.max(least), most),
            (true, true) if most.abs() < SLIDES && least < 0.0 && most <= 0.0 => (least, (-SLIDES).min(most)),
            (true, false) if least >= 0.0 => (least.min(SLIDES), least.min(SLIDES) + 0.05),
            (true, false) if most <= 0.0 => (most.max(-SLIDES) - 0.05, most.max(-SLIDES)),
            _ => (least, most),
        };
        let by_switches = ContactPoint { direction: 0.5 * (least + most), deviation: (most - least) / SWITCHES };
        let Some(light) = &self.light else { return Some(by_switches) };
        let roots = sensed.light_signal.map(|signal| (f64::from(signal) - IDLE).max(0.0).sqrt());
        let brightest = roots.iter().copied().fold(0.0, f64::max);
        // An obstacle too narrow for the beams.
        if brightest < 20.0 {
            return Some(by_switches);
        }
        let misfit = |wall: &[f64; BEAMS]| wall.iter().zip(&roots).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        let direction = |i: usize| TRIES * i as f64 - half_arc;
        // With a margin, as switches bounce.
        let within = |i: usize| {
            let slides = direction(i).abs() > SLIDES;
            (least - 0.15..=most + 0.15).contains(&direction(i)) && (!pushes || slides == sensed.stasis)
        };
        let tries = light.walls.iter().enumerate().filter(|&(i, _)| within(i)).map(|(i, wall)| (i, misfit(wall)));
        let best = tries.min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((best, misfit)) = best else { return Some(by_switches) };
        // With less than nine tenths explained it isn't a straight wall.
        let total: f64 = roots.iter().map(|root| root * root).sum();
        let deviation = if misfit < 0.1 * total { BY_LIGHT } else { 0.3 };
        Some(ContactPoint { direction: direction(best), deviation: deviation.min(by_switches.deviation) })
    }

    /// A contact corrected by the robot's motion, where the right wheel rolls so much more than the left one, m: a
    /// robot that curves around an edge or a leg keeps moving.
    pub(super) fn aside(&self, contact: ContactPoint, curve: f64) -> ContactPoint {
        let half_arc = self.bumper.map_or(0.0, |[half_arc, _]| half_arc);
        let is_around = curve * contact.direction > 0.0 && curve.abs() > AROUND.0;
        if contact.deviation <= BY_LIGHT || contact.direction.abs() < SLIDES || !is_around {
            return contact;
        }
        ContactPoint { direction: (AROUND.1 * half_arc).copysign(contact.direction), ..contact }
    }

    /// The distance of an obstacle that returns so much light at an angle whose cosine is known up to `uncertain`;
    /// `None` without a light bumper.
    pub fn echo(&self, light: f64, cosine: f64, uncertain: f64) -> Option<Echo> {
        let distance = self.light.as_ref()?.bumper.distance_of_light(light, REFLECTANCE.0 * cosine);
        // Light falls with the square of the distance.
        let share = 0.5 * (REFLECTANCE.1 * REFLECTANCE.1 + uncertain * uncertain).sqrt() + 0.02;
        // Idle values have a standard deviation of 9.
        let idle = 0.5 * 9.0 / light.max(9.0);
        Some(Echo { light, distance, deviation: 0.002 + (share + idle) * (distance + 0.017) })
    }

    /// Point on a beam at `distance` metres from the body's edge, in the robot's frame.
    #[inline]
    pub fn along(&self, beam: usize, distance: f64) -> Point {
        self.light.as_ref().map_or(Point::origin(), |light| {
            Point::from(light.directions[beam.min(BEAMS - 1)] * (self.radius + distance))
        })
    }

    /// Unit vector along a beam.
    #[inline]
    pub fn direction(&self, beam: usize) -> Vector {
        self.light.as_ref().map_or(Vector::x(), |light| light.directions[beam.min(BEAMS - 1)])
    }

    /// Distance from the body's edge that is free if a beam has no echo, m; 0 without a light bumper.
    pub fn seen(&self) -> f64 {
        self.light.as_ref().map_or(0.0, |light| SEEN.min(0.5 * light.bumper.range))
    }

    /// Radius of the smallest circle around the body, m.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Radius of the largest circle around the origin within the body, m.
    pub fn inner_radius(&self) -> f64 {
        let Body::Polygon(corners) = self.body else { return self.radius };
        let corners = corners.iter().map(|&[x, y]| Point::new(x, y)).collect::<Vec<_>>();
        edges(&corners).map(|(a, b)| a.coords.dot(&outward(a, b))).fold(self.radius, f64::min)
    }

    /// Distance from the origin to a straight wall in that direction that the body touches, m.
    pub fn support(&self, direction: f64) -> f64 {
        let Body::Polygon(corners) = self.body else { return self.radius };
        let (sin, cos) = math::sin_cos(direction);
        corners.iter().map(|[x, y]| cos * x + sin * y).fold(0.0, f64::max)
    }

    /// Whether contacts of a round body are all that it senses of its surroundings: the middle of such a body is as far from a
    /// wall that it touches, whatever the direction.
    pub fn is_bumper_alone(&self) -> bool {
        self.light.is_none() && self.bumper.is_some() && !self.has_laser && self.body == Body::Round
    }
}

/// Square roots of the signals of a straight wall that touches the body in that direction.
fn touching(light: &LightBumper, radius: f64, direction: f64) -> [f64; BEAMS] {
    light.angles.map(|angle| {
        let cosine = math::cos(angle - direction);
        if cosine < 0.1 {
            return 0.0;
        }
        let distance = radius / cosine - radius;
        if distance >= light.range {
            return 0.0;
        }
        light.light_at(distance, REFLECTANCE.0 * cosine).sqrt()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    fn roomba() -> (&'static RobotModel, SensorModel) {
        let robot = model("roomba600").unwrap();
        (robot, SensorModel::new(robot))
    }

    /// Simulated readings beside a straight wall of that reflectance, `gap` metres from the body at the nearest point,
    /// which lies in that direction.
    fn beside_a_wall(direction: f64, gap: f64, reflectance: f64) -> SensorReadings {
        let (robot, _) = roomba();
        let light = robot.sensors.light_bumper.unwrap();
        let light_signal = light.angles.map(|angle| {
            let cosine = math::cos(angle - direction);
            let distance = (robot.radius + gap) / cosine - robot.radius;
            let is_seen = cosine > 0.0 && distance < light.range;
            let back = if is_seen { light.light_at(distance, reflectance * cosine) } else { 0.0 };
            (back + IDLE) as u16
        });
        SensorReadings { light_signal, ..SensorReadings::default() }
    }

    #[test]
    fn distances_are_those_that_the_simulator_turned_into_light() {
        let (robot, model) = roomba();
        let angles = robot.sensors.light_bumper.unwrap().angles;
        for reflectance in [0.7, 1.0] {
            for gap in [0.01, 0.03, 0.06, 0.09] {
                let seen = model.observe(&beside_a_wall(angles[2], gap, reflectance));
                let echo = seen.echoes[2].unwrap();
                assert!((echo.distance - gap).abs() < 2.5 * echo.deviation, "{gap} m at {reflectance}: {echo:?}");
                // With a known angle, only the reflectance is uncertain.
                let better = model.echo(echo.light, 1.0, 0.05).unwrap();
                assert!(better.deviation < echo.deviation);
                assert!((better.distance - gap).abs() < 0.2 * (gap + 0.017), "{gap} m at {reflectance}: {better:?}");
            }
        }
        assert_eq!(model.observe(&SensorReadings::default()), Observation::default());
    }

    #[test]
    fn light_tells_in_which_direction_a_wall_is_touched() {
        let (_, model) = roomba();
        for degrees in [-80_i32, -60, -35, -15, 0, 10, 30, 50, 75] {
            let direction = f64::from(degrees).to_radians();
            let touching = SensorReadings {
                bump_left: direction >= -0.35,
                bump_right: direction <= 0.35,
                ..beside_a_wall(direction, 0.0005, 1.0)
            };
            let contact = model.contact(&touching, false).unwrap();
            assert!((contact.direction - direction).abs() < 0.12, "{degrees}: {contact:?}");
        }
    }

    #[test]
    fn what_no_beam_sees_is_somewhere_on_the_side_that_is_pressed() {
        let (_, model) = roomba();
        let right = model.contact(&SensorReadings { bump_right: true, ..SensorReadings::default() }, false).unwrap();
        assert!(right.direction < -0.35 && right.deviation > 0.3, "{right:?}");
        let stuck = SensorReadings { bump_left: true, bump_right: true, ..SensorReadings::default() };
        assert!(model.contact(&stuck, true).unwrap().direction.abs() < 0.01);
        assert_eq!(model.contact(&SensorReadings::default(), true), None);
    }
}

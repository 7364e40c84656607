//! An own robot: a shape, a tool, speeds and sensors of the user's choice in place of a model's.

use super::{Body, Corners, RobotModel, SensorSuite, Tool, WheelLayout};
use crate::{
    cspace::{CspaceError, Outline},
    geometry::Point,
    math,
};
use serde::{Deserialize, Serialize};
use std::{fmt, ops::RangeInclusive};

/// Id of the model that an own robot can't be built on: it has the size of a cell, whatever that is.
const SIZED_BY_CELLS: &str = "cell";
/// Widths of a tool, m.
const TOOLS: RangeInclusive<f64> = 0.005..=10.0;
/// Speeds of driving, m/s, and of turning, degrees a second.
const SPEEDS: RangeInclusive<f64> = 0.01..=3.0;
const TURNS: RangeInclusive<f64> = 1.0..=720.0;
/// Sides of planning cells, m.
const CELLS: RangeInclusive<f64> = 0.02..=2.0;

/// What an own robot has in place of its model's; what is missing is the model's.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct OwnRobot {
    /// Radius of a round body, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius: Option<f64>,
    /// Corners of any other body, m: x ahead, y to the left of the middle between the wheels.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub corners: Vec<[f64; 2]>,
    /// Whether it cleans all floor under its body, rather than a strip.
    #[serde(skip_serializing_if = "is_off")]
    pub cleans_all: bool,
    /// Width of the strip that it cleans, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool_width: Option<f64>,
    /// Middle of its tool, m: ahead, to the left.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool_at: Option<[f64; 2]>,
    /// Speed at which it drives paths, m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed_m_s: Option<f64>,
    /// Speed at which it turns on the spot, degrees a second.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turn_deg_s: Option<f64>,
    /// How it moves.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheels: Option<WheelLayout>,
    /// Sensors of its model that it lacks.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub without: Vec<OwnSensor>,
}

/// A kind of sensor that a robot can have or lack.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum OwnSensor {
    /// The bumper.
    Bumper,
    /// All cliff sensors.
    Cliffs,
    /// The light bumper and the wall sensor.
    Light,
    /// The receivers for docks and virtual walls.
    Infrared,
    /// The wheel drop switches.
    WheelDrops,
    /// The laser scanner.
    Laser,
}

/// Reasons why no robot is like that.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OwnRobotFault {
    /// Its body isn't one.
    #[error(transparent)]
    Outline(#[from] CspaceError),
    /// A figure that no robot has.
    #[error("the robot's {name} can't be {value} {unit}; use {from} to {to} {unit}")]
    Figure {
        /// Name of the figure.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Least and greatest value.
        from: f64,
        /// Greatest value.
        to: f64,
        /// Their unit.
        unit: &'static str,
    },
    /// The tool sticks out of the body.
    #[error(
        "the tool (a disc) reaches {tool:.3} m from the robot's centre, but its body only \
         {body:.3} m; make the tool narrower, move it to the centre, or make the body larger"
    )]
    Tool {
        /// Farthest point of the tool from the origin, m.
        tool: f64,
        /// That of the body, m.
        body: f64,
    },
    /// It is built on the robot that fills a cell.
    #[error("your robot can't be based on the grid robot, which is as large as a cell; choose another model")]
    GridRobot,
}

impl OwnSensor {
    /// All kinds, with their names in links.
    pub const ALL: [(Self, &'static str); 6] = [
        (Self::Bumper, "bumper"),
        (Self::Cliffs, "cliffs"),
        (Self::Light, "light"),
        (Self::Infrared, "infrared"),
        (Self::WheelDrops, "wheel_drops"),
        (Self::Laser, "laser"),
    ];

    fn remove(self, suite: &mut SensorSuite) {
        match self {
            Self::Bumper => suite.bumper = None,
            Self::Cliffs => suite.cliffs = [None; 4],
            Self::Light => suite.light_bumper = None,
            Self::Infrared => suite.infrared = false,
            Self::WheelDrops => suite.wheel_drops = false,
            Self::Laser => suite.laser = None,
        }
    }
}

impl OwnRobot {
    /// Checks that a robot built on `model` can be like that.
    pub fn check(&self, model: &RobotModel) -> Result<(), OwnRobotFault> {
        if model.id == SIZED_BY_CELLS {
            return Err(OwnRobotFault::GridRobot);
        }
        let figure = |name, unit, value: Option<f64>, range: RangeInclusive<f64>| match value {
            Some(value) if !range.contains(&value) => {
                Err(OwnRobotFault::Figure { name, value, from: *range.start(), to: *range.end(), unit })
            }
            _ => Ok(()),
        };
        self.outline()?;
        figure("tool width", "m", self.tool_width, TOOLS)?;
        let far = -*TOOLS.end()..=*TOOLS.end();
        figure("tool position", "m", self.tool_at.map(|[x, y]| if far.contains(&x) { y } else { x }), far)?;
        figure("speed", "m/s", self.speed_m_s, SPEEDS)?;
        figure("turn rate", "degrees a second", self.turn_deg_s, TURNS)?;
        let robot = self.of(model);
        if let Tool::Disc([x, y]) = robot.tool {
            let tool = math::hypot(x, y) + 0.5 * robot.tool_width;
            // The tools of models end at the circle.
            if tool > robot.radius + 1e-6 && (robot.tool_width, robot.tool) != (model.tool_width, model.tool) {
                return Err(OwnRobotFault::Tool { tool, body: robot.radius });
            }
        }
        Ok(())
    }

    /// Its body; `None` for the model's.
    fn outline(&self) -> Result<Option<Outline>, CspaceError> {
        Ok(match self.radius {
            Some(radius) => Some(Outline::circle(radius)?),
            None if self.corners.is_empty() => None,
            None => Some(Outline::checked(self.corners.iter().map(|&[x, y]| Point::new(x, y)).collect())?),
        })
    }

    /// The robot, built on `model`: sensors sit where its body's edge is, wheels as far apart as its width allows.
    #[must_use]
    pub fn of(&self, model: &RobotModel) -> RobotModel {
        let mut robot = RobotModel {
            title: "Own robot",
            summary: "A model with your shape, tool, speeds and sensors",
            wheels: self.wheels.unwrap_or(model.wheels),
            ..model.clone()
        };
        match self.outline() {
            Ok(Some(Outline::Circle { radius })) => (robot.body, robot.radius) = (Body::Round, radius),
            Ok(Some(outline @ Outline::Polygon(_))) => {
                let Outline::Polygon(corners) = &outline else { return robot };
                let corners: Vec<[f64; 2]> = corners.iter().map(|corner| corner.coords.into()).collect();
                robot.radius = corners.iter().map(|[x, y]| math::hypot(*x, *y)).fold(0.0, f64::max);
                robot.body = Body::Polygon(Corners::of(&corners));
            }
            _ => {}
        }
        let has_body = robot.body != model.body || robot.radius != model.radius;
        if has_body {
            fit(&mut robot, model);
        }
        self.equip(&mut robot);
        if (robot.tool_width, robot.tool) != (model.tool_width, model.tool) {
            (robot.castors, robot.side_brushes) = (&[], &[]);
            let cell = model.default_cell / model.tool_width * robot.tool_width;
            robot.default_cell = ((100.0 * cell).round() / 100.0).clamp(*CELLS.start(), *CELLS.end());
        }
        for sensor in &self.without {
            sensor.remove(&mut robot.sensors);
        }
        robot
    }

    /// Gives it its tool and its speeds.
    fn equip(&self, robot: &mut RobotModel) {
        let inner = robot.body.inner_radius(robot.radius);
        if self.cleans_all {
            robot.tool = if robot.body == Body::Round { Tool::CENTRED } else { Tool::Body };
            robot.tool_width = 2.0 * inner;
        } else {
            if let Some(at) = self.tool_at {
                robot.tool = Tool::Disc(at);
            }
            robot.tool_width = self.tool_width.unwrap_or(robot.tool_width);
        }
        if let Some(speed) = self.speed_m_s {
            robot.cruise_speed = speed;
        }
        if let Some(turn) = self.turn_deg_s {
            robot.turn_wheel_speed = 0.5 * turn.to_radians() * robot.wheel_base;
        }
        robot.max_wheel_speed = robot.max_wheel_speed.max(robot.cruise_speed).max(robot.turn_wheel_speed);
    }

    /// The own robot of a link: the inverse of its [`Display`](fmt::Display).
    pub fn parse(text: &str) -> Option<Self> {
        let mut own = Self::default();
        for part in text.split(',').filter(|part| !part.is_empty()) {
            let (key, value) = part.split_once(':')?;
            let number = || value.parse::<f64>().ok();
            let pairs = || -> Option<Vec<[f64; 2]>> {
                let numbers = value.split('_').map(|number| number.parse().ok()).collect::<Option<Vec<f64>>>()?;
                let (pairs, []) = numbers.as_chunks::<2>() else { return None };
                Some(pairs.to_vec())
            };
            match key {
                "radius" => own.radius = Some(number()?),
                "corners" => own.corners = pairs()?,
                "tool" if value == "body" => own.cleans_all = true,
                "tool" => own.tool_width = Some(number()?),
                "at" => own.tool_at = Some(*pairs()?.first()?),
                "speed" => own.speed_m_s = Some(number()?),
                "turn" => own.turn_deg_s = Some(number()?),
                "wheels" => own.wheels = Some(WheelLayout::ALL.into_iter().find(|(_, name)| *name == value)?.0),
                "without" => {
                    let kind = |name| Some(OwnSensor::ALL.into_iter().find(|(_, known)| *known == name)?.0);
                    own.without = value.split('-').map(kind).collect::<Option<_>>()?;
                }
                _ => return None,
            }
        }
        Some(own)
    }
}

/// Sets wheels and sensors of `model` into the new body of `robot`.
fn fit(robot: &mut RobotModel, model: &RobotModel) {
    let (body, inner) = (robot.body, robot.body.inner_radius(robot.radius));
    let share = inner / model.body.inner_radius(model.radius);
    robot.wheel_base *= share;
    robot.turn_wheel_speed *= share;
    robot.wheel_radius = robot.wheel_radius.min(0.4 * inner);
    robot.tool_width = robot.tool_width.min(2.0 * inner);
    (robot.castors, robot.side_brushes) = (&[], &[]);
    let radius = robot.radius;
    let moved = |[x, y]: [f64; 2]| {
        let angle = math::atan2(y, x);
        let share = body.reach(radius, angle) / model.body.reach(model.radius, angle);
        [x * share, y * share]
    };
    robot.sensors.cliffs = model.sensors.cliffs.map(|cliff| cliff.map(moved));
    if let Some(laser) = &mut robot.sensors.laser {
        laser.at = moved(laser.at);
    }
}

fn is_off(on: &bool) -> bool {
    !on
}

/// As in links: `corners:0.2_-0.1_0.2_0.1_-0.2_0,tool:body,speed:0.25`.
impl fmt::Display for OwnRobot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts = Vec::new();
        let mut say = |key: &str, value: String| parts.push(format!("{key}:{value}"));
        let joined = |numbers: &[f64]| numbers.iter().map(f64::to_string).collect::<Vec<_>>().join("_");
        if let Some(radius) = self.radius {
            say("radius", radius.to_string());
        }
        if !self.corners.is_empty() {
            say("corners", joined(self.corners.as_flattened()));
        }
        if self.cleans_all {
            say("tool", "body".to_owned());
        }
        for (key, value) in [("tool", self.tool_width), ("speed", self.speed_m_s), ("turn", self.turn_deg_s)] {
            if let Some(value) = value {
                say(key, value.to_string());
            }
        }
        if let Some(at) = self.tool_at {
            say("at", joined(&at));
        }
        if let Some((_, name)) = WheelLayout::ALL.into_iter().find(|(kind, _)| Some(*kind) == self.wheels) {
            say("wheels", name.to_owned());
        }
        if !self.without.is_empty() {
            let named = OwnSensor::ALL.into_iter().filter(|(kind, _)| self.without.contains(kind));
            say("without", named.map(|(_, name)| name).collect::<Vec<_>>().join("-"));
        }
        f.write_str(&parts.join(","))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::{MODELS, model};

    fn wedge() -> OwnRobot {
        OwnRobot {
            corners: vec![[0.2, -0.1], [0.2, 0.1], [-0.2, 0.05], [-0.2, -0.05]],
            tool_width: Some(0.1),
            tool_at: Some([0.1, 0.0]),
            speed_m_s: Some(0.25),
            turn_deg_s: Some(90.0),
            wheels: Some(WheelLayout::Omnidirectional),
            without: vec![OwnSensor::Light, OwnSensor::WheelDrops],
            ..OwnRobot::default()
        }
    }

    #[test]
    fn a_link_holds_all_of_it() {
        let text = wedge().to_string();
        assert_eq!(
            text,
            "corners:0.2_-0.1_0.2_0.1_-0.2_0.05_-0.2_-0.05,tool:0.1,speed:0.25,turn:90,at:0.1_0,\
             wheels:omnidirectional,without:light-wheel_drops"
        );
        let round = OwnRobot { radius: Some(0.1), cleans_all: true, ..OwnRobot::default() };
        for own in [wedge(), OwnRobot::default(), round] {
            assert_eq!(OwnRobot::parse(&own.to_string()), Some(own));
        }
        for text in ["radius", "radius:x", "corners:1_2_3", "size:1", "without:nose", "at:1", "wheels:3"] {
            assert_eq!(OwnRobot::parse(text), None, "{text}");
        }
    }

    #[test]
    fn an_own_robot_without_choices_is_its_model_but_for_the_name() {
        for model in MODELS.iter().filter(|model| model.id != SIZED_BY_CELLS) {
            let own = OwnRobot::default();
            assert_eq!(own.check(model), Ok(()), "{}", model.id);
            assert_eq!(RobotModel { title: model.title, summary: model.summary, ..own.of(model) }, **model);
        }
    }

    #[test]
    fn choices_take_the_place_of_the_models() {
        let roomba = model("roomba600").unwrap();
        let robot = wedge().of(roomba);
        assert_eq!(wedge().check(roomba), Ok(()));
        assert!((robot.radius - math::hypot(0.2, 0.1)).abs() < 1e-12);
        assert!((robot.turn_rate() - math::FRAC_PI_2).abs() < 1e-9 && robot.cruise_speed == 0.25);
        assert_eq!((robot.tool_width, robot.tool), (0.1, Tool::Disc([0.1, 0.0])));
        assert!(robot.sensors.light_bumper.is_none() && robot.sensors.bumper.is_some());
        // Sensors and wheels are inside.
        let outline = Outline::of(&robot);
        assert_eq!(outline.check(), Ok(()));
        let Outline::Polygon(corners) = &outline else { panic!("it has corners") };
        for [x, y] in robot.sensors.cliffs.into_iter().flatten() {
            assert!(crate::geometry::contains(corners, Point::new(x, y)), "{x} {y}");
        }
        assert!(robot.wheel_base < 0.2 && robot.side_brushes.is_empty());
        // The strip of a wide model is no wider than a narrow body.
        let narrow = OwnRobot { radius: Some(0.05), ..OwnRobot::default() };
        assert_eq!((narrow.of(roomba).tool_width, narrow.check(roomba)), (0.1, Ok(())));
        let all = OwnRobot { cleans_all: true, ..wedge() }.of(roomba);
        assert!(all.tool == Tool::Body && all.tool_width < 0.2);
    }

    #[test]
    fn what_no_robot_is_like_is_refused_with_advice() {
        let roomba = model("roomba600").unwrap();
        let crossing = vec![[-0.2, -0.1], [0.2, 0.1], [0.2, -0.1], [-0.2, 0.1]];
        for (own, message) in [
            (OwnRobot { corners: crossing, ..wedge() }, "sides 1 and 3 of the outline cross; move a corner of either"),
            (
                OwnRobot { tool_width: Some(0.6), ..wedge() },
                "reaches 0.400 m from the robot's centre, but its body only",
            ),
            (OwnRobot { tool_at: Some([0.3, 0.0]), ..wedge() }, "move it to the centre"),
            (OwnRobot { tool_width: Some(0.0), ..wedge() }, "tool width can't be 0 m; use 0.005 to 10 m"),
            (OwnRobot { tool_at: Some([0.0, f64::NAN]), ..wedge() }, "tool position can't be NaN"),
            (OwnRobot { speed_m_s: Some(0.0), ..wedge() }, "speed can't be 0 m/s; use 0.01 to 3 m/s"),
            (OwnRobot { turn_deg_s: Some(-5.0), ..wedge() }, "turn rate can't be -5 degrees a second"),
            (OwnRobot { radius: Some(0.0), ..wedge() }, "diameter can't be 0"),
        ] {
            let error = own.check(roomba).unwrap_err().to_string();
            assert!(error.contains(message), "{error}");
        }
        assert_eq!(wedge().check(model("cell").unwrap()), Err(OwnRobotFault::GridRobot));
    }
}

//! An own robot as it is typed into a form: the inverse of each other, as far as the texts are numbers.

use super::{OwnRobot, OwnSensor, WheelLayout};
use crate::{
    cspace::{CspaceError, Outline},
    geometry::Point,
};
use serde::{Deserialize, Serialize};

/// Digits after the point of figures that are made from corners: micrometres.
const PER_METRE: f64 = 1e6;
/// Distance within which corners are those of a rectangle or an octagon whose figures have these digits, m.
const SAME_M: f64 = 1e-5;

/// Figures of an own robot as they are typed, m, m/s and degrees a second; empty ones are the model's.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct OwnRobotForm {
    /// Kind of body.
    pub shape: OwnShape,
    /// Diameter or width.
    pub first: String,
    /// Length of a rectangle.
    pub second: String,
    /// Corners of a polygon: `x y; x y; …`.
    pub corners: String,
    /// Whether it cleans all floor under its body.
    pub cleans_all: bool,
    /// Width of the tool.
    pub tool: String,
    /// Middle of the tool: ahead, to the left.
    pub at: [String; 2],
    /// Speed of driving.
    pub speed: String,
    /// Speed of turning.
    pub turn: String,
    /// How it moves, if not as its model.
    pub wheels: Option<WheelLayout>,
    /// Sensors of its model that it lacks.
    pub without: Vec<OwnSensor>,
}

/// Kinds of bodies in the form.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum OwnShape {
    /// The model's.
    #[default]
    Model,
    /// A circle, of a diameter.
    Circle,
    /// A rectangle, of width and length.
    Rectangle,
    /// A regular octagon, of a width.
    Octagon,
    /// Any other, of corners.
    Polygon,
}

/// Reasons why a form can't be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OwnFormFault {
    /// A field that has to be a number.
    #[error("{name}: \"{text}\" is not a number; type metres, e.g. 0.35")]
    Figure {
        /// Name of the field.
        name: &'static str,
        /// What is in it.
        text: String,
    },
    /// A corner that isn't one.
    #[error("Corner {number}, \"{text}\", is not two numbers; write x y; x y; … in metres")]
    Corner {
        /// Its number, from 1 on.
        number: usize,
        /// What is in its place.
        text: String,
    },
    /// A body without corners.
    #[error(transparent)]
    Outline(#[from] CspaceError),
}

impl OwnRobotForm {
    /// The form with this robot in it.
    pub fn of(own: &OwnRobot) -> Self {
        let text = |figure: Option<f64>| figure.map(|figure| figure.to_string()).unwrap_or_default();
        let shaped = match own.radius {
            Some(radius) => Self { shape: OwnShape::Circle, first: plain(2.0 * radius), ..Self::default() },
            None if own.corners.is_empty() => Self::default(),
            None => Self::of_corners(&own.corners),
        };
        Self {
            cleans_all: own.cleans_all,
            tool: text(own.tool_width),
            at: own.tool_at.map(|at| at.map(|figure| figure.to_string())).unwrap_or_default(),
            speed: text(own.speed_m_s),
            turn: text(own.turn_deg_s),
            wheels: own.wheels,
            without: own.without.clone(),
            ..shaped
        }
    }

    /// The form with the simplest shape that has these corners.
    fn of_corners(corners: &[[f64; 2]]) -> Self {
        let extent = |axis: usize| plain(2.0 * corners.iter().map(|corner| corner[axis]).fold(f64::MIN, f64::max));
        let (width, length) = (extent(1), extent(0));
        let rectangle = Self { shape: OwnShape::Rectangle, first: width.clone(), second: length, ..Self::default() };
        let octagon = Self { shape: OwnShape::Octagon, first: width, ..Self::default() };
        for form in [rectangle, octagon] {
            let is_same = |known: &[[f64; 2]]| {
                let mut pairs = known.as_flattened().iter().zip(corners.as_flattened());
                known.len() == corners.len() && pairs.all(|(one, other)| (one - other).abs() < SAME_M)
            };
            if form.corners().is_ok_and(|known| known.is_some_and(|known| is_same(&known))) {
                return form;
            }
        }
        let corners: Vec<String> = corners.iter().map(|&[x, y]| format!("{} {}", plain(x), plain(y))).collect();
        Self { shape: OwnShape::Polygon, corners: corners.join("; "), ..Self::default() }
    }

    /// Corners of the body, m: ahead, to the left; `None` for a circle or the model's body.
    pub fn corners(&self) -> Result<Option<Vec<[f64; 2]>>, OwnFormFault> {
        let pairs = |corners: &[Point]| Some(corners.iter().map(|corner| [corner.x, corner.y]).collect());
        Ok(match self.shape {
            OwnShape::Model | OwnShape::Circle => None,
            OwnShape::Rectangle => {
                let (width, length) = (figure("Width", &self.first)?, figure("Length", &self.second)?);
                pairs(&Outline::rectangle_corners(length, width))
            }
            OwnShape::Octagon => pairs(&Outline::octagon_corners(figure("Width", &self.first)?)),
            OwnShape::Polygon => {
                let texts = self.corners.split([';', '\n']).map(str::trim).filter(|text| !text.is_empty());
                Some(texts.enumerate().map(|(index, text)| corner(index + 1, text)).collect::<Result<_, _>>()?)
            }
        })
    }

    /// The robot, unchecked but for its numbers: see [`OwnRobot::check`].
    ///
    /// ```
    /// use robovac_core::robot::{OwnRobotForm, OwnShape};
    /// let form = OwnRobotForm { shape: OwnShape::Circle, first: "0.4".into(), turn: "90".into(), ..OwnRobotForm::default() };
    /// assert_eq!(form.read().unwrap().to_string(), "radius:0.2,turn:90");
    /// ```
    pub fn read(&self) -> Result<OwnRobot, OwnFormFault> {
        let radius = match self.shape {
            OwnShape::Circle => Some(0.5 * figure("Diameter", &self.first)?),
            _ => None,
        };
        let corners = self.corners()?;
        if corners.as_ref().is_some_and(Vec::is_empty) {
            Outline::checked(Vec::new())?;
        }
        let chosen = |name, text: &str| (!text.is_empty()).then(|| figure(name, text)).transpose();
        let (tool_width, tool_at) = if self.cleans_all {
            (None, None)
        } else {
            let [ahead, left] = &self.at;
            let width = chosen("Tool width", &self.tool)?;
            let at = [chosen("Tool", ahead)?, chosen("Tool", left)?];
            (width, at.iter().any(Option::is_some).then(|| at.map(Option::unwrap_or_default)))
        };
        Ok(OwnRobot {
            radius,
            corners: corners.unwrap_or_default(),
            cleans_all: self.cleans_all,
            tool_width,
            tool_at,
            speed_m_s: chosen("Speed", &self.speed)?,
            turn_deg_s: chosen("Turns at", &self.turn)?,
            wheels: self.wheels,
            without: self.without.clone(),
        })
    }
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

fn figure(name: &'static str, text: &str) -> Result<f64, OwnFormFault> {
    number(text).ok_or_else(|| OwnFormFault::Figure { name, text: text.to_owned() })
}

fn corner(at: usize, text: &str) -> Result<[f64; 2], OwnFormFault> {
    let numbers = text.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty()).map(number);
    let numbers: Option<Vec<f64>> = numbers.collect();
    let pair = numbers.and_then(|numbers| numbers.try_into().ok());
    pair.ok_or_else(|| OwnFormFault::Corner { number: at, text: text.to_owned() })
}

/// A figure as people type it.
fn plain(figure: f64) -> String {
    // Adding 0 makes -0 one.
    ((figure * PER_METRE).round() / PER_METRE + 0.0).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn form(link: &str) -> OwnRobotForm {
        OwnRobotForm::of(&OwnRobot::parse(link).unwrap())
    }

    #[test]
    fn links_of_earlier_pages_open_in_the_form() {
        // As the page wrote them: the position after the tool.
        let wedge = "corners:0.2_-0.15_0.2_0.15_-0.1_0.15_-0.2_0_-0.1_-0.15,tool:0.25,at:0.02_0,speed:0.25,turn:90,\
                     wheels:omnidirectional,without:light-wheel_drops";
        let read = form(wedge);
        assert_eq!(read.shape, OwnShape::Polygon);
        assert_eq!(read.corners, "0.2 -0.15; 0.2 0.15; -0.1 0.15; -0.2 0; -0.1 -0.15");
        assert_eq!((read.tool.as_str(), &read.at), ("0.25", &["0.02".to_owned(), "0".to_owned()]));
        assert_eq!((read.speed.as_str(), read.turn.as_str()), ("0.25", "90"));
        assert_eq!(read.wheels, Some(WheelLayout::Omnidirectional));
        assert_eq!(read.without, [OwnSensor::Light, OwnSensor::WheelDrops]);
        assert_eq!(read.read().unwrap(), OwnRobot::parse(wedge).unwrap());
        assert_eq!(form(""), OwnRobotForm::default());
        let body = form("radius:0.17,tool:body");
        assert_eq!((body.shape, body.first.as_str(), body.cleans_all), (OwnShape::Circle, "0.34", true));
        assert_eq!((body.tool.as_str(), body.at.concat()), ("", String::new()));
    }

    #[test]
    fn corners_of_a_simple_shape_are_that_shape_again() {
        let typed = |shape, first: &str, second: &str| {
            let (first, second) = (first.to_owned(), second.to_owned());
            OwnRobotForm { shape, first, second, ..OwnRobotForm::default() }
        };
        for form in [
            typed(OwnShape::Rectangle, "0.3", "0.32"),
            typed(OwnShape::Rectangle, "0.3", "0.3"),
            typed(OwnShape::Octagon, "0.333", ""),
            typed(OwnShape::Circle, "0.34", ""),
            typed(OwnShape::Model, "", ""),
        ] {
            let link = form.read().unwrap().to_string();
            assert_eq!(OwnRobotForm::of(&OwnRobot::parse(&link).unwrap()), form, "{link}");
        }
        let rectangle = typed(OwnShape::Rectangle, "0.3", "0.32").read().unwrap();
        assert_eq!(rectangle.to_string(), "corners:0.16_-0.15_0.16_0.15_-0.16_0.15_-0.16_-0.15");
        // Turned by half a turn its corners begin elsewhere.
        assert_eq!(form("corners:-0.1_0.1_-0.1_-0.1_0.1_-0.1_0.1_0.1").shape, OwnShape::Polygon);
    }

    #[test]
    fn empty_fields_are_the_models() {
        let typed = OwnRobotForm { at: [String::new(), "-0.02".to_owned()], ..OwnRobotForm::default() };
        assert_eq!(typed.read().unwrap(), OwnRobot { tool_at: Some([0.0, -0.02]), ..OwnRobot::default() });
        // What is left of a tool doesn't count for one that cleans all.
        let all = OwnRobotForm { cleans_all: true, tool: "0.2".to_owned(), ..typed };
        assert_eq!(all.read().unwrap(), OwnRobot { cleans_all: true, ..OwnRobot::default() });
    }

    #[test]
    fn fields_that_are_no_numbers_are_named() {
        let fault = |form: OwnRobotForm| form.read().unwrap_err().to_string();
        let polygon = |corners: &str| OwnRobotForm {
            shape: OwnShape::Polygon,
            corners: corners.to_owned(),
            ..OwnRobotForm::default()
        };
        let circle = OwnRobotForm { shape: OwnShape::Circle, ..OwnRobotForm::default() };
        assert_eq!(fault(circle), "Diameter: \"\" is not a number; type metres, e.g. 0.35");
        let fast = OwnRobotForm { speed: "inf".to_owned(), ..OwnRobotForm::default() };
        assert_eq!(fault(fast), "Speed: \"inf\" is not a number; type metres, e.g. 0.35");
        assert_eq!(
            fault(polygon("0.2 -0.15; 0.2,0.15\n-0.1")),
            "Corner 3, \"-0.1\", is not two numbers; write x y; x y; … in metres"
        );
        assert!(fault(polygon("1 2 3")).starts_with("Corner 1, \"1 2 3\", is not"));
        assert!(fault(polygon(" ; ")).contains("can't have 0 corners"));
    }
}

//! The robot's outline as people say it.

use crate::{
    cspace::Outline,
    geometry::Point,
    math::{PI, TAU, cos, sin},
    robot::{self, Body},
};
use serde::{Deserialize, Serialize};

/// Largest length that a robot is given, m.
const MOST_M: f64 = 20.0;

/// An outline by its figures, m.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum BodyChoice {
    /// A robot that ships, by its id.
    Model {
        /// Its id.
        id: String,
    },
    /// A circle.
    Circle {
        /// Its radius.
        radius: f64,
    },
    /// A rectangle around the origin.
    Rectangle {
        /// Along the way that it looks.
        length: f64,
        /// Across.
        width: f64,
    },
    /// A regular octagon that rests on a side, as in 001.
    Octagon {
        /// From side to side.
        width: f64,
    },
    /// Any simple polygon that holds the origin.
    Polygon {
        /// Its corners, `x y; x y; ...`: x ahead, y to the left.
        corners: String,
    },
}

/// What is wrong with an outline.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BodyError {
    /// A length is out of range.
    #[error("the robot's {what} can't be {value} m; it takes 0.02 to {MOST_M} m")]
    Length {
        /// Which one.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A corner can't be read.
    #[error("corner {number} of the robot, \"{text}\", isn't two numbers; write \"x y; x y; ...\" in metres")]
    Corner {
        /// Which one, counted from 1.
        number: usize,
        /// What is there.
        text: String,
    },
    /// Fewer than three corners.
    #[error("a polygon needs three corners at least, there are {0}; write \"x y; x y; x y\" in metres")]
    Few(usize),
    /// There is no such robot.
    #[error("there is no robot \"{0}\"")]
    Unknown(String),
}

impl BodyChoice {
    /// The outline.
    pub fn outline(&self) -> Result<Outline, BodyError> {
        let length = |what, value: f64| {
            if (0.02..=MOST_M).contains(&value) { Ok(value) } else { Err(BodyError::Length { what, value }) }
        };
        Ok(match self {
            Self::Model { id } => {
                let model = robot::model(id).ok_or_else(|| BodyError::Unknown(id.clone()))?;
                match model.body {
                    Body::Round => Outline::Circle { radius: model.radius },
                    Body::Polygon(corners) => {
                        Outline::Polygon(corners.iter().map(|&[x, y]| Point::new(x, y)).collect())
                    }
                }
            }
            Self::Circle { radius } => Outline::Circle { radius: length("radius", *radius)? },
            Self::Rectangle { length: long, width } => {
                let (x, y) = (0.5 * length("length", *long)?, 0.5 * length("width", *width)?);
                Outline::Polygon(vec![Point::new(-x, -y), Point::new(x, -y), Point::new(x, y), Point::new(-x, y)])
            }
            Self::Octagon { width } => {
                let radius = 0.5 * length("width", *width)? / cos(PI / 8.0);
                let corner = |i: u8| (f64::from(i) + 0.5) * TAU / 8.0;
                Outline::Polygon((0..8).map(|i| Point::new(radius * cos(corner(i)), radius * sin(corner(i)))).collect())
            }
            Self::Polygon { corners } => Outline::Polygon(read_corners(corners)?),
        })
    }

    /// The id of a robot that ships, if it is one.
    pub fn model(&self) -> Option<&str> {
        if let Self::Model { id } = self { Some(id) } else { None }
    }
}

/// Reads `x y; x y; ...`; commas do as well as blanks, and corners may go round either way.
fn read_corners(text: &str) -> Result<Vec<Point>, BodyError> {
    let texts = text.split([';', '\n']).map(str::trim).filter(|corner| !corner.is_empty());
    let mut corners = texts
        .enumerate()
        .map(|(index, text)| {
            let numbers: Vec<f64> = text
                .split([' ', ',', '\t'])
                .filter(|number| !number.is_empty())
                .map_while(|number| number.parse().ok().filter(|n: &f64| n.abs() <= MOST_M))
                .collect();
            match numbers[..] {
                [x, y] => Ok(Point::new(x, y)),
                _ => Err(BodyError::Corner { number: index + 1, text: text.to_owned() }),
            }
        })
        .collect::<Result<Vec<_>, _>>()?;
    if corners.len() < 3 {
        return Err(BodyError::Few(corners.len()));
    }
    if crate::geometry::signed_area(&corners) < 0.0 {
        corners.reverse();
    }
    Ok(corners)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_octagon_is_as_wide_as_it_says() {
        let Ok(Outline::Polygon(corners)) = (BodyChoice::Octagon { width: 0.5 }).outline() else { panic!() };
        let far = |of: fn(&Point) -> f64| corners.iter().map(of).fold(f64::MIN, f64::max);
        assert!((far(|p| p.x) - 0.25).abs() < 1e-12 && (far(|p| p.y) - 0.25).abs() < 1e-12);
    }

    #[test]
    fn corners_go_counter_clockwise_whichever_way_they_are_typed() {
        let there = BodyChoice::Polygon { corners: "0 0; 1 0; 0, 1".into() };
        let back = BodyChoice::Polygon { corners: "0 1\n1 0;0 0;".into() };
        assert_eq!(there.outline(), back.outline());
    }

    #[test]
    fn what_is_no_outline_says_which_corner_or_figure() {
        let polygon = |corners: &str| BodyChoice::Polygon { corners: corners.into() }.outline();
        assert_eq!(polygon("0 0; 1 0"), Err(BodyError::Few(2)));
        assert_eq!(polygon("0 0; 1 x; 1 1"), Err(BodyError::Corner { number: 2, text: "1 x".into() }));
        assert_eq!(polygon("0 0; 1 1; NaN 1"), Err(BodyError::Corner { number: 3, text: "NaN 1".into() }));
        let circle = BodyChoice::Circle { radius: 0.0 };
        assert_eq!(circle.outline(), Err(BodyError::Length { what: "radius", value: 0.0 }));
    }
}

//! The robot's outline as entered by the user.

use robovac_core::{
    cspace::{CspaceError, Outline},
    geometry::Point,
    robot::{self, WheelLayout},
};
use serde::{Deserialize, Serialize};

/// An outline by its dimensions, m.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum BodyChoice {
    /// A built-in robot, by its id.
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
        /// Length along its heading.
        length: f64,
        /// Width.
        width: f64,
    },
    /// A regular octagon that rests on a side, as in 001.
    Octagon {
        /// From side to side.
        width: f64,
    },
    /// Any simple polygon around the origin.
    Polygon {
        /// Its corners, `x y; x y; ...`: x ahead, y to the left.
        corners: String,
    },
}

/// Errors of an outline.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BodyError {
    /// It is invalid.
    #[error(transparent)]
    Outline(#[from] CspaceError),
    /// A corner can't be read.
    #[error("corner {number} of the robot outline, \"{text}\", isn't two numbers; write \"x y; x y; ...\" in metres")]
    Corner {
        /// Its number, counted from 1.
        number: usize,
        /// Its text.
        text: String,
    },
    /// There is no such robot.
    #[error("there is no robot \"{0}\"")]
    Unknown(String),
}

impl BodyChoice {
    /// The outline.
    pub fn outline(&self) -> Result<Outline, BodyError> {
        Ok(match self {
            Self::Model { id } => Outline::of(robot::model(id).ok_or_else(|| BodyError::Unknown(id.clone()))?),
            Self::Circle { radius } => Outline::circle(*radius)?,
            Self::Rectangle { length, width } => Outline::rectangle(*length, *width)?,
            Self::Octagon { width } => Outline::octagon(*width)?,
            Self::Polygon { corners } => Outline::checked(read_corners(corners)?)?,
        })
    }

    /// Whether the robot turns to where it drives: a built-in one with two driven wheels. A robot with an outline of its
    /// own moves in every direction, as in 001.
    pub fn turns(&self) -> bool {
        let model = self.model().and_then(robot::model);
        model.is_some_and(|model| model.wheels == WheelLayout::Differential)
    }

    /// The id if it is a built-in robot.
    pub fn model(&self) -> Option<&str> {
        if let Self::Model { id } = self { Some(id) } else { None }
    }
}

/// Reads `x y; x y; ...`; commas are accepted in place of blanks.
fn read_corners(text: &str) -> Result<Vec<Point>, BodyError> {
    let texts = text.split([';', '\n']).map(str::trim).filter(|corner| !corner.is_empty());
    let read = |(index, text): (usize, &str)| {
        let numbers = text.split([' ', ',', '\t']).filter(|number| !number.is_empty());
        let numbers: Vec<f64> =
            numbers.map_while(|number| number.parse().ok().filter(|n: &f64| n.is_finite())).collect();
        match numbers[..] {
            [x, y] => Ok(Point::new(x, y)),
            _ => Err(BodyError::Corner { number: index + 1, text: text.to_owned() }),
        }
    };
    texts.enumerate().map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_go_counter_clockwise_whichever_way_they_are_typed() {
        let there = BodyChoice::Polygon { corners: "-1 -1; 1 -1; 0, 1".into() };
        let back = BodyChoice::Polygon { corners: "0 1\n1 -1;-1 -1;".into() };
        assert_eq!(there.outline(), back.outline());
    }

    #[test]
    fn what_is_no_outline_says_which_corner_or_figure() {
        let polygon = |corners: &str| BodyChoice::Polygon { corners: corners.into() }.outline();
        assert!(matches!(polygon("0 0; 1 0"), Err(BodyError::Outline(_))));
        assert_eq!(polygon("0 0; 1 x; 1 1"), Err(BodyError::Corner { number: 2, text: "1 x".into() }));
        assert_eq!(polygon("0 0; 1 1; NaN 1"), Err(BodyError::Corner { number: 3, text: "NaN 1".into() }));
        assert!(matches!(BodyChoice::Circle { radius: 0.0 }.outline(), Err(BodyError::Outline(_))));
    }
}

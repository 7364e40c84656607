//! The outline of a body from above.

use super::CspaceError;
use crate::{
    floor_plan::crossing,
    geometry::{Point, Vector, contains, convex_hull, convex_pieces, signed_area},
    math,
    robot::{Body, MAX_CORNERS, RobotModel},
};
use std::fmt;

/// Most corners of an outline.
pub const MAX_OUTLINE_CORNERS: usize = MAX_CORNERS;
/// Least and greatest extent of an outline in x and in y, m.
pub const EXTENTS: [f64; 2] = [0.02, 10.0];

/// Least area of an outline, m²: a square centimetre.
const LEAST_AREA: f64 = 1e-4;

/// Outline of a robot in its own frame: x ahead, y to the left, m.
#[derive(Debug, Clone, PartialEq)]
pub enum Outline {
    /// A circle around the origin.
    Circle {
        /// Its radius, m.
        radius: f64,
    },
    /// A simple polygon, convex or not, that holds the origin; counter-clockwise.
    Polygon(Vec<Point>),
}

impl Outline {
    /// The outline of a robot model.
    pub fn of(robot: &RobotModel) -> Self {
        match robot.body {
            Body::Round => Self::Circle { radius: robot.radius },
            Body::Polygon(corners) => Self::Polygon(corners.iter().map(|&[x, y]| Point::new(x, y)).collect()),
        }
    }

    /// A circle of `radius` metres.
    pub fn circle(radius: f64) -> Result<Self, CspaceError> {
        let outline = Self::Circle { radius };
        outline.check().map(|()| outline)
    }

    /// A rectangle around the origin, `length` metres ahead and back together, `width` metres across.
    pub fn rectangle(length: f64, width: f64) -> Result<Self, CspaceError> {
        Self::checked(Self::rectangle_corners(length, width).to_vec())
    }

    /// Its corners, whatever the numbers.
    pub(crate) fn rectangle_corners(length: f64, width: f64) -> [Point; 4] {
        let (x, y) = (0.5 * length, 0.5 * width);
        [(x, -y), (x, y), (-x, y), (-x, -y)].map(|(x, y)| Point::new(x, y))
    }

    /// A regular octagon that drives with a side ahead, `width` metres from side to side.
    pub fn octagon(width: f64) -> Result<Self, CspaceError> {
        Self::checked(Self::octagon_corners(width).to_vec())
    }

    /// Its corners, whatever the number.
    pub(crate) fn octagon_corners(width: f64) -> [Point; 8] {
        // Half a side is tan 22.5° of half the width.
        let (far, near) = (0.5 * width, 0.5 * width * 0.414_213_562_373_095);
        let half = [(far, -near), (far, near), (near, far), (-near, far)];
        std::array::from_fn(|at| {
            let ((x, y), side) = (half[at % 4], if at < 4 { 1.0 } else { -1.0 });
            Point::new(side * x, side * y)
        })
    }

    /// The polygon with these corners, in either direction, if it is valid as a robot's outline.
    pub fn checked(mut corners: Vec<Point>) -> Result<Self, CspaceError> {
        if signed_area(&corners) < 0.0 {
            corners.reverse();
        }
        let outline = Self::Polygon(corners);
        outline.check().map(|()| outline)
    }

    /// Checks that the outline is valid.
    pub fn check(&self) -> Result<(), CspaceError> {
        let refuse = |why: String| Err(CspaceError::Outline(why));
        let [least, most] = EXTENTS;
        match self {
            Self::Circle { radius } => {
                if !(0.5 * least..=0.5 * most).contains(radius) {
                    let wide = 2.0 * radius;
                    return refuse(format!("the robot's diameter can't be {wide} m; choose {least} to {most} m"));
                }
            }
            Self::Polygon(corners) => {
                let count = corners.len();
                if !(3..=MAX_OUTLINE_CORNERS).contains(&count) {
                    return refuse(format!("an outline can't have {count} corners; use 3 to {MAX_OUTLINE_CORNERS}"));
                }
                if let Some(at) = corners.iter().position(|p| !(p.x.is_finite() && p.y.is_finite())) {
                    return refuse(format!("corner {} of the outline isn't a number; set it again", at + 1));
                }
                let (low, high) = bounds(corners);
                for (extent, name) in [(high.x - low.x, "long"), (high.y - low.y, "wide")] {
                    if !(least..=most).contains(&extent) {
                        return refuse(format!("the outline is {extent:.3} m {name}; use {least} to {most} m"));
                    }
                }
                if let Some((first, second)) = crossing(corners) {
                    let (first, second) = (first + 1, second + 1);
                    return refuse(format!("sides {first} and {second} of the outline cross; move a corner of either"));
                }
                if signed_area(corners) < LEAST_AREA {
                    return refuse("the outline encloses no area; make it wider".to_owned());
                }
                if !contains(corners, Point::origin()) {
                    return refuse(
                        "the robot's origin (0, 0) is outside the outline; move the outline over it".to_owned(),
                    );
                }
            }
        }
        Ok(())
    }

    /// The circle in which it turns on the spot: the smallest one around the origin that holds it.
    #[must_use]
    pub fn turning_circle(&self) -> Self {
        match self {
            Self::Circle { radius } => Self::Circle { radius: *radius },
            Self::Polygon(corners) => {
                Self::Circle { radius: corners.iter().map(|corner| corner.coords.norm()).fold(0.0, f64::max) }
            }
        }
    }

    /// Extent perpendicular to the heading, m: the width of the strip that it sweeps at heading 0.
    pub fn width(&self) -> f64 {
        let (low, high) = self.bounds();
        high.y - low.y
    }

    /// Lower left and upper right corner of the box around it, m.
    pub fn bounds(&self) -> (Point, Point) {
        match self {
            Self::Circle { radius } => (Point::new(-radius, -radius), Point::new(*radius, *radius)),
            Self::Polygon(corners) => bounds(corners),
        }
    }

    /// Convex pieces of a polygon, turned by `heading` rad; none of a circle.
    pub(super) fn pieces(&self, heading: f64) -> Vec<Vec<Point>> {
        let Self::Polygon(corners) = self else { return Vec::new() };
        let (sin, cos) = math::sin_cos(heading);
        let turned = |p: Point| Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
        convex_pieces(corners).into_iter().map(|piece| piece.into_iter().map(turned).collect()).collect()
    }
}

/// In words that follow "for": `an octagon, 0.400 m wide`.
impl fmt::Display for Outline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let corners = match self {
            Self::Circle { radius } => return write!(f, "a circle of {radius:.3} m radius"),
            Self::Polygon(corners) => corners,
        };
        let (low, high) = self.bounds();
        let is_at_end = |p: &Point| (p.x == low.x || p.x == high.x) && (p.y == low.y || p.y == high.y);
        match corners.len() {
            4 if corners.iter().all(is_at_end) => write!(f, "a rectangle, {:.3} m long", high.x - low.x)?,
            8 => write!(f, "an octagon")?,
            count => write!(f, "a polygon of {count} corners")?,
        }
        write!(f, ", {:.3} m wide", high.y - low.y)
    }
}

/// Lower left and upper right corner of the box around some points; the origin if there are none.
pub(super) fn bounds(points: &[Point]) -> (Point, Point) {
    let Some(&first) = points.first() else { return (Point::origin(), Point::origin()) };
    points.iter().fold((first, first), |(low, high), p| (low.inf(p), high.sup(p)))
}

/// What a convex polygon covers while it moves straight `along` a way: the convex hull of its corners and of those moved,
/// counter-clockwise. The polygon itself for no way.
pub(super) fn drawn_out(corners: &[Point], along: Vector) -> Vec<Point> {
    if along == Vector::zeros() {
        return corners.to_vec();
    }
    convex_hull(corners.iter().flat_map(|&corner| [corner, corner + along]).collect())
}

/// Farthest extent of points in a direction.
pub(super) fn support(points: &[Point], direction: Vector) -> f64 {
    points.iter().map(|p| p.coords.dot(&direction)).fold(f64::MIN, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::MODELS;

    fn points(corners: &[(f64, f64)]) -> Vec<Point> {
        corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    #[test]
    fn outlines_are_told_by_their_shape_and_width() {
        let own = Outline::checked(points(&[(0.2, -0.1), (0.2, 0.1), (-0.2, 0.0)])).unwrap();
        let words = [Outline::octagon(0.4).unwrap(), Outline::rectangle(0.5, 0.3).unwrap(), own].map(|o| o.to_string());
        let expected = [
            "an octagon, 0.400 m wide",
            "a rectangle, 0.500 m long, 0.300 m wide",
            "a polygon of 3 corners, 0.200 m wide",
        ];
        assert_eq!(words, expected);
        assert_eq!(Outline::circle(0.17).unwrap().to_string(), "a circle of 0.170 m radius");
    }

    #[test]
    fn outlines_of_all_robots_and_shapes_are_sound() {
        for robot in MODELS {
            assert_eq!(Outline::of(robot).check(), Ok(()), "{}", robot.id);
        }
        assert_eq!(Outline::rectangle(0.4, 0.2).unwrap().width(), 0.2);
        let Outline::Polygon(corners) = Outline::octagon(0.36).unwrap() else { panic!("it has corners") };
        assert!(signed_area(&corners) > 0.0 && corners.len() == 8);
        let sides: Vec<f64> = (0..8).map(|i| (corners[(i + 1) % 8] - corners[i]).norm()).collect();
        assert!(sides.iter().all(|side| (side - sides[0]).abs() < 1e-12), "{sides:?}");
    }

    #[test]
    fn a_polygon_drawn_out_is_the_hull_of_both_ends() {
        let square = points(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
        let long = drawn_out(&square, Vector::new(2.0, 0.0));
        assert_eq!(long, points(&[(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (0.0, 1.0)]));
        let slanted = drawn_out(&square, Vector::new(1.0, 1.0));
        assert_eq!(slanted.len(), 6);
        assert!((signed_area(&slanted) - 3.0).abs() < 1e-12);
        assert_eq!(drawn_out(&points(&[(1.0, 2.0)]), Vector::new(0.0, 1.0)), points(&[(1.0, 2.0), (1.0, 3.0)]));
        let line = drawn_out(&points(&[(0.0, 0.0), (0.0, 1.0)]), Vector::new(0.0, -1.0));
        assert_eq!(line, points(&[(0.0, -1.0), (0.0, 1.0)]));
        assert_eq!(Outline::rectangle(0.6, 0.8).unwrap().turning_circle(), Outline::Circle { radius: 0.5 });
    }

    #[test]
    fn polygons_of_users_are_turned_round_or_refused_with_advice() {
        let clockwise = points(&[(-0.1, -0.1), (-0.1, 0.1), (0.1, 0.1), (0.1, -0.1)]);
        let Outline::Polygon(corners) = Outline::checked(clockwise).unwrap() else { panic!("it has corners") };
        assert!(signed_area(&corners) > 0.0);
        let why = |corners: &[(f64, f64)]| Outline::checked(points(corners)).unwrap_err().to_string();
        assert!(why(&[(0.0, 0.0), (1.0, 0.0)]).contains("use 3 to 64"));
        assert!(why(&[(-1.0, -1.0), (1.0, f64::NAN), (0.0, 1.0)]).contains("corner 2"));
        assert!(why(&[(-1.0, -1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, 1.0)]).contains("sides 1 and 3"));
        assert!(why(&[(1.0, 1.0), (2.0, 1.0), (2.0, 2.0)]).contains("origin"));
        assert!(why(&[(-9.0, -1.0), (9.0, -1.0), (0.0, 1.0)]).contains("18.000 m long"));
        assert!(why(&[(-1.0, 0.0), (0.0, 0.0), (1.0, 0.0)]).contains("wide"));
        for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Outline::circle(radius).is_err());
        }
        assert!(Outline::rectangle(f64::NAN, 1.0).is_err() && Outline::octagon(99.0).is_err());
    }
}

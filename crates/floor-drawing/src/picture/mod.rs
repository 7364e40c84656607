//! Floor plans in images: photographs, scans, exported pictures. Their shades become walls, and rooms are traced from
//! them as from drawings.

mod door_symbols;
#[cfg(test)]
mod drawn;
mod hollow;
mod lettering;
mod level;
mod local;
mod marks;
mod outlying;
mod sampler;
mod sheet_frame;
mod specks;
mod suggest;
mod surface;
mod thickness;

pub(crate) use sampler::PictureSampler;
pub use suggest::suggest;

use robovac_core::{
    floor_plan::Shading,
    geometry::Point,
    grid::{Grid, Occupancy},
    math::{cos, sin},
};
use serde::{Deserialize, Serialize};

/// How shades are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum ShadeMethod {
    /// As the ROS map server does: dark is wall, light is floor, grey between is unknown.
    #[default]
    Map,
    /// One level for the whole picture.
    Level,
    /// Compared with the shades around, for pictures that aren't evenly lit.
    Local,
}

/// How the shades of an image become walls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallShades {
    /// How shades are told apart.
    pub method: ShadeMethod,
    /// Darker shades are walls, 0 (black) to 1 (white). For [`ShadeMethod::Level`].
    pub level: f64,
    /// Walls are darker than the mean around them by this share of it, 0 to 1. For [`ShadeMethod::Local`].
    pub contrast: f64,
    /// Whether light shades are walls instead.
    pub negate: bool,
    /// Marks that are smaller than this are left out, pixels. Unless it is 0, so are words, symbols of doors and thin lines
    /// outside of the building, and walls drawn as two lines are filled. Not for [`ShadeMethod::Map`].
    pub specks: f64,
}

impl WallShades {
    /// What each pixel is.
    pub fn cells(&self, shades: &Grid<u8>) -> Grid<Occupancy> {
        let light = |is_wall: bool| if is_wall { Occupancy::Occupied } else { Occupancy::Free };
        let mut walls = match self.method {
            ShadeMethod::Map => {
                let shading = Shading { negate: self.negate, ..Shading::default() };
                let cells: Vec<Occupancy> = (0..=u8::MAX).map(|shade| shading.cell_of(shade)).collect();
                return shades.map(|&shade| cells[usize::from(shade)]);
            }
            ShadeMethod::Level => level::darker(shades, self.level, self.negate),
            ShadeMethod::Local => {
                let mut walls = local::darker(shades, self.contrast, self.negate);
                if !self.negate {
                    surface::remove(&mut walls, shades);
                }
                walls
            }
        };
        if self.specks > 0.0 {
            let is_even = self.method == ShadeMethod::Level;
            hollow::fill(&mut walls, is_even.then_some(shades));
            // While the pieces of their letters are there.
            lettering::remove(&mut walls);
            door_symbols::remove(&mut walls);
            outlying::remove(&mut walls);
        }
        specks::remove(&mut walls, self.specks);
        walls.map(|&is_wall| light(is_wall))
    }
}

/// An image as a drawing: its unit is a pixel, its origin the image's lower left corner, turned around that.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Its name.
    pub name: String,
    /// Pixels that aren't floor.
    pub blocked: Grid<bool>,
    /// Angle by which it is turned, rad, counter-clockwise.
    pub turn: f64,
}

impl Picture {
    /// Lower left and upper right corner of the turned picture.
    pub fn bounds(width: usize, height: usize, turn: f64) -> [Point; 2] {
        let (width, height) = (width as f64, height as f64);
        let corners = [(0.0, 0.0), (width, 0.0), (0.0, height), (width, height)];
        let turned = corners.map(|(x, y)| turned(Point::new(x, y), turn));
        let low = turned.iter().fold(turned[0], |low, corner| low.inf(corner));
        let high = turned.iter().fold(turned[0], |high, corner| high.sup(corner));
        // Rounding must not add a column.
        let whole = |value: f64| if (value - value.round()).abs() < 1e-9 { value.round() } else { value };
        [low, high].map(|point| Point::new(whole(point.x), whole(point.y)))
    }

    /// Where a place in the image lies in the turned picture.
    pub(crate) fn place(&self, pixel: Point) -> Point {
        turned(pixel, self.turn)
    }

    /// Where a place in the turned picture lies in the image.
    pub(crate) fn pixel(&self, place: Point) -> Point {
        turned(place, -self.turn)
    }
}

/// A point turned around the origin, counter-clockwise.
fn turned(point: Point, turn: f64) -> Point {
    let (sin, cos) = (sin(turn), cos(turn));
    Point::new(point.x * cos - point.y * sin, point.x * sin + point.y * cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    #[test]
    fn a_turned_picture_has_the_bounds_of_its_corners() {
        let blocked = from_picture("#...\n....\n", |c| c == '#').unwrap();
        let mut picture = Picture { name: String::new(), blocked, turn: 0.0 };
        assert_eq!(Picture::bounds(4, 2, 0.0), [Point::new(0.0, 0.0), Point::new(4.0, 2.0)]);
        // A quarter to the left: the upper left corner comes to the lower left.
        picture.turn = robovac_core::math::FRAC_PI_2;
        let [low, high] = Picture::bounds(4, 2, picture.turn);
        assert_eq!((low, high), (Point::new(-2.0, 0.0), Point::new(0.0, 4.0)));
    }
}

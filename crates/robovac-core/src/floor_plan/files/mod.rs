//! Floor plans in files: maps as text, images and ROS maps, and scenarios.

mod ascii;
mod check;
mod error;
mod foreign;
mod layout;
mod load;
mod place;
mod raster;
mod ros_map;
mod scenario;
mod scenario_object;
mod yaml;

pub use ascii::{DEFAULT_ASCII_RESOLUTION, to_ascii};
pub use check::{BEAMS, MAX_CORNERS, MAX_OBJECTS, PlacementFault, PlacementRefusal, RADII};
pub use error::{Flaw, MapError};
pub use foreign::{ForeignFile, TAKEN, foreign};
pub use load::{SourceFile, base_name, image_of, is_image, load, load_shades};
pub use place::JsonPlace;
pub use raster::{DEFAULT_IMAGE_RESOLUTION, MAX_PIXELS, OccupancyMode, PictureShades, Shading};
pub use ros_map::{MapImage, RosMap, RosMapError, to_ros_map};
pub use scenario::{SCENARIO_FORMAT, SCENARIO_SCHEMA, SCENARIO_VERSION, Scenario, ScenarioPose};

use super::{FloorPlan, MAX_RESOLUTION, MAX_SIDE, MIN_RESOLUTION, Object, Who, crossing, encloses, has_area, stem};

impl FloorPlan {
    /// The plan itself if it has free cells; `file` is named in errors.
    fn checked(self, file: &str) -> Result<Self, MapError> {
        if !self.occupancy.values().iter().any(|o| o.is_free()) {
            return Err(MapError::NoFreeCell { name: file.to_owned() });
        }
        Ok(self)
    }
}

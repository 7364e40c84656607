//! Files of a path.

use super::run_bag::BAG_TYPE;
use coverage_planners::sweep::{program, to_csv, to_ros_path};
use robovac_core::{
    geometry::Point,
    robot::{RobotModel, model},
};
use robovac_link::commands_text;
use serde::{Deserialize, Serialize};

/// The robot of command files: only its drive speaks the Open Interface.
pub(super) const ROOMBA: &str = "roomba600";

/// A kind of file that a path can be saved as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PathFormat {
    /// Bytes of the Open Interface with their times and meanings, as text. Always for the Roomba, the only robot that
    /// speaks it.
    Commands,
    /// A human-readable program of turns and straight moves.
    Program,
    /// Poses with times.
    Csv,
    /// A ROS path.
    Poses,
    /// Room, path and the drive along it as ROS 2 messages.
    Bag,
    /// The path on layers of its own, beside the drawing.
    Dxf,
}

impl PathFormat {
    /// All formats; one whose ending is part of another's comes after it.
    pub const ALL: [Self; 6] = [Self::Commands, Self::Program, Self::Csv, Self::Poses, Self::Bag, Self::Dxf];

    /// The ending of its files, and their media type.
    pub fn file_type(self) -> (&'static str, &'static str) {
        match self {
            Self::Commands => ("oi.txt", "text/plain"),
            Self::Program => ("txt", "text/plain"),
            Self::Csv => ("csv", "text/csv"),
            Self::Poses => ("yaml", "application/yaml"),
            Self::Bag => ("mcap", BAG_TYPE),
            Self::Dxf => ("dxf", "image/vnd.dxf"),
        }
    }

    /// The text of a path (corners, m, and the heading at its start) for `robot`, described by `planned`; `None` for a
    /// drawing and a bag, which are no texts and require more than a path.
    pub fn text(self, (path, heading): (&[Point], f64), robot: &RobotModel, planned: &str) -> Option<String> {
        Some(match self {
            Self::Commands => commands_text(path, heading, model(ROOMBA)?, planned),
            Self::Program => program(path, heading, robot, planned),
            Self::Csv => to_csv(path, heading, robot),
            Self::Poses => to_ros_path(path, heading, robot),
            Self::Bag | Self::Dxf => return None,
        })
    }
}

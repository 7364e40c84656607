//! Files of a path.

use super::{
    SavedPath,
    run_bag::{BAG_TYPE, path_bag},
};
use coverage_planners::sweep::{in_frame, program, smooth_program, to_csv, to_ros_path};
use floor_drawing::DrawingError;
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::Pose,
    robot::{RobotModel, model},
};
use robovac_link::{commands_text, smooth_commands_text};
use robovac_ros::BagError;
use serde::{Deserialize, Serialize};
use std::path::Path;

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

/// Reasons why the file of a path can't be written.
#[derive(Debug, thiserror::Error)]
pub enum PathFileError {
    /// The bag can't be.
    #[error(transparent)]
    Bag(#[from] BagError),
    /// The drawing can't be.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// The robot of command files isn't known.
    #[error("the robot model {ROOMBA} is missing from this build")]
    NoRoomba,
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

    /// The format that the ending of a file's name says.
    pub fn of_file(file: &Path) -> Option<Self> {
        let name = file.file_name()?.to_string_lossy().to_ascii_lowercase();
        Self::ALL.into_iter().find(|format| name.ends_with(&format!(".{}", format.file_type().0)))
    }

    /// The file of a path in `plan` for `robot`, in the frame of the map that the room came from. `planned` is what the path was
    /// planned for, in words that follow "for": see [`planned_for`](coverage_planners::sweep::planned_for). `drawing` makes the
    /// drawing that the path is on.
    pub fn bytes(
        self,
        path: SavedPath<'_>,
        plan: &FloorPlan,
        robot: &RobotModel,
        planned: &str,
        drawing: impl FnOnce() -> Result<Vec<u8>, DrawingError>,
    ) -> Result<Vec<u8>, PathFileError> {
        match self {
            Self::Bag => Ok(path_bag(plan, robot, path)?),
            Self::Dxf => Ok(drawing()?),
            Self::Commands | Self::Program | Self::Csv | Self::Poses => {
                let text = self.text(path, plan.origin, robot, planned);
                text.map(String::into_bytes).ok_or(PathFileError::NoRoomba)
            }
        }
    }

    /// The text of a path in the frame in which the room's origin is at `origin`; `None` without the Roomba's model, and for
    /// what is no text.
    fn text(self, path: SavedPath<'_>, origin: Pose, robot: &RobotModel, planned: &str) -> Option<String> {
        let stopped = || in_frame(path.corners, path.heading, origin);
        let smooth = path.smooth.map(|trajectory| trajectory.in_frame(origin));
        Some(match (self, smooth) {
            (Self::Commands, Some(trajectory)) => smooth_commands_text(&trajectory, robot, model(ROOMBA)?, planned),
            (Self::Commands, None) => {
                let (line, heading) = stopped();
                commands_text(&line, heading, model(ROOMBA)?, planned)
            }
            (Self::Program, Some(trajectory)) => smooth_program(&trajectory, robot, planned),
            (Self::Program, None) => {
                let (line, heading) = stopped();
                program(&line, heading, robot, planned)
            }
            (Self::Csv, _) => to_csv(&path.places(origin, robot)),
            (Self::Poses, _) => to_ros_path(&path.places(origin, robot)),
            (Self::Bag | Self::Dxf, _) => return None,
        })
    }
}

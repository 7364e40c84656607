//! Error messages and exit codes.

use floor_drawing::DrawingError;
use robovac_app::{ImportError, export::PathFileError};
use robovac_core::registry::ParamError;
use robovac_ros::BagError;
use robovac_sim::experiment::planning::PlanningError;
use std::{fmt, io, path::Path};

/// Exit code of a run that worked.
pub const OK: u8 = 0;
const IO: u8 = 1;
/// The same as clap's own for options that it doesn't know.
const USAGE: u8 = 2;
const BAD_MAP: u8 = 3;
const DOES_NOT_FIT: u8 = 4;
const PLANNER: u8 = 5;

/// A message for users and an exit code for scripts.
#[derive(Debug)]
pub struct Failure {
    /// Exit code.
    pub code: u8,
    message: String,
}

impl Failure {
    /// A file can't be read or written.
    pub fn io(path: impl fmt::Display, error: &io::Error) -> Self {
        Self { code: IO, message: format!("{path}: {error}; check the path and your permissions") }
    }

    /// A bag can't be written.
    pub fn bag(path: &Path, error: BagError) -> Self {
        match error {
            BagError::File(error) => Self::io(path.display(), &error),
            other @ BagError::Format(_) => Self::system(format!("{}: {other}; please report this", path.display())),
        }
    }

    /// The program has no node of ROS 2 in it.
    #[cfg(not(feature = "ros2"))]
    pub fn without_ros2() -> Self {
        let build = "cargo build --release -p robovac-cli --features ros2";
        Self::usage(format!("this program was built without its node of ROS 2; build it with \"{build}\""))
    }

    /// The system refuses something, with what helps.
    pub fn system(message: String) -> Self {
        Self { code: IO, message }
    }

    /// An option has a value that won't do.
    pub fn usage(message: String) -> Self {
        Self { code: USAGE, message }
    }

    /// The robot doesn't fit.
    pub fn misfit(message: String) -> Self {
        Self { code: DOES_NOT_FIT, message }
    }

    /// The planner gave up.
    pub fn planner(message: String) -> Self {
        Self { code: PLANNER, message }
    }

    /// There is no entry with that id; `command` lists those that there are.
    pub fn unknown(kind: &str, id: &str, command: &str) -> Self {
        Self::usage(format!("there is no {kind} \"{id}\"; \"robovac {command}\" lists them"))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message.fmt(f)
    }
}

impl From<PathFileError> for Failure {
    fn from(error: PathFileError) -> Self {
        match error {
            PathFileError::Bag(error) => Self::system(error.to_string()),
            PathFileError::Drawing(error) => error.into(),
            PathFileError::NoRoomba => Self::system(error.to_string()),
        }
    }
}

impl From<DrawingError> for Failure {
    fn from(error: DrawingError) -> Self {
        ImportError::from(error).into()
    }
}

impl From<ImportError> for Failure {
    fn from(error: ImportError) -> Self {
        Self { code: BAD_MAP, message: error.to_string() }
    }
}

impl From<ParamError> for Failure {
    fn from(error: ParamError) -> Self {
        Self::usage(error.to_string())
    }
}

impl From<PlanningError> for Failure {
    fn from(error: PlanningError) -> Self {
        let code = match error {
            PlanningError::CellSize { .. }
            | PlanningError::Heading(_)
            | PlanningError::NeedsNoCells { .. }
            | PlanningError::FillsItsCells
            | PlanningError::Coverage(_) => USAGE,
            PlanningError::StartOutside { .. }
            | PlanningError::StartInWall { .. }
            | PlanningError::StartTooTight { .. }
            | PlanningError::Floor(_) => DOES_NOT_FIT,
            PlanningError::Plan(_) | PlanningError::BadPath { .. } => PLANNER,
        };
        Self { code, message: error.to_string() }
    }
}

//! Why settings can't be as wanted.

use robovac_core::{
    program::ProgramFault,
    registry::{ParamError, nearest},
    robot::CustomRobotFault,
};

/// Longest list of names in a message, bytes, and the longest where one of them was probably meant.
const LONGEST_LIST: usize = 300;
const LONGEST_BESIDE_ONE_MEANT: usize = 100;

/// Errors of settings.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SettingsError {
    /// No such planner, robot, room, ...
    #[error("there is no {kind} \"{id}\"; {}", instead(id, known))]
    Unknown {
        /// Kind of the setting.
        kind: &'static str,
        /// The name given.
        id: String,
        /// The available names.
        known: String,
    },
    /// A behaviour that keeps a map, where none is kept.
    #[error("\"{0}\" keeps a map, which Explore does not draw; choose it in Compare or Map")]
    KeepsMap(String),
    /// A number that is invalid or out of range.
    #[error("{kind} can't be \"{value}\"; use {expected}")]
    Invalid {
        /// Name of the setting.
        kind: &'static str,
        /// The value given.
        value: String,
        /// Accepted values.
        expected: &'static str,
    },
    /// A path that a link is too short for, and that isn't here.
    #[error("the path is too long to fit into this link; ask the link's author for the scenario file and load that")]
    FarPath,
    /// The user's program isn't here.
    #[error("this link's program isn't in it; ask its author for the whole link or for the program's file")]
    NoProgram,
    /// A program that isn't accepted.
    #[error(transparent)]
    Program(#[from] ProgramFault),
    /// A planner's parameter.
    #[error(transparent)]
    Param(#[from] ParamError),
    /// A twin's figure, or one of an own robot.
    #[error(transparent)]
    Robot(#[from] CustomRobotFault),
}

/// What to choose in place of `id`, as the end of a sentence.
fn instead(id: &str, known: &str) -> String {
    match nearest(id, known) {
        Some(meant) if known.len() > LONGEST_BESIDE_ONE_MEANT => format!("did you mean \"{meant}\"?"),
        _ if known.len() <= LONGEST_LIST => format!("there are: {known}"),
        _ => "the page's menus and lists such as `robovac planners` have them all".to_owned(),
    }
}

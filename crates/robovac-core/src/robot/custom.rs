//! A robot of the user's own on the figures of a model: what settings, links and files carry beside the model's id.

use super::{OwnRobot, OwnRobotFault, RobotModel, Twin, TwinFault};
use serde::{Deserialize, Serialize};
use std::fmt;

/// What differs from the model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CustomRobot {
    /// Figures fitted to a recording.
    Twin(Twin),
    /// Choices of the user.
    Own(OwnRobot),
}

/// Reasons why no robot is like that.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CustomRobotFault {
    /// A twin.
    #[error(transparent)]
    Twin(#[from] TwinFault),
    /// An own robot.
    #[error(transparent)]
    Own(#[from] OwnRobotFault),
}

impl CustomRobot {
    /// Checks that there can be such a robot of that model.
    pub fn check(&self, model: &RobotModel) -> Result<(), CustomRobotFault> {
        match self {
            Self::Twin(twin) => twin.check(model)?,
            Self::Own(own) => own.check(model)?,
        }
        Ok(())
    }

    /// The robot.
    #[must_use]
    pub fn of(&self, model: &RobotModel) -> RobotModel {
        match self {
            Self::Twin(twin) => twin.of(model),
            Self::Own(own) => own.of(model),
        }
    }

    /// Its key in links.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Twin(_) => "twin",
            Self::Own(_) => "own",
        }
    }

    /// The twin, if it is one.
    pub fn twin(&self) -> Option<Twin> {
        if let Self::Twin(twin) = self { Some(*twin) } else { None }
    }

    /// The own robot, if it is one.
    pub fn own(&self) -> Option<&OwnRobot> {
        if let Self::Own(own) = self { Some(own) } else { None }
    }
}

/// As in links, behind its key.
impl fmt::Display for CustomRobot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Twin(twin) => twin.fmt(f),
            Self::Own(own) => own.fmt(f),
        }
    }
}

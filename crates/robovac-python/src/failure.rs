//! Errors as exceptions of the package.

use coverage_planners::smooth::SmoothError;
use floor_drawing::DrawingError;
use pyo3::prelude::*;
use robovac_app::ImportError;
use robovac_core::{coverage::FloorError, registry::ParamError};
use robovac_sim::experiment::{SettingsError, planning::PlanningError};

/// An error with the class of its exception, one of `robovac._errors`.
#[derive(Debug, Clone)]
pub struct Failure {
    class: &'static str,
    message: String,
}

impl Failure {
    /// A file can't be read.
    pub fn io(path: &str, error: &std::io::Error) -> Self {
        Self { class: "FileError", message: format!("{path}: {error}; check the path and your permissions") }
    }

    /// An argument won't do.
    pub fn usage(message: String) -> Self {
        Self { class: "UsageError", message }
    }

    /// There is no entry with that id; `function` lists those that there are.
    pub fn unknown(kind: &str, id: &str, function: &str) -> Self {
        Self::usage(format!("there is no {kind} \"{id}\"; robovac.{function}() lists them"))
    }

    /// A map can't be used.
    pub fn map(message: String) -> Self {
        Self { class: "MapError", message }
    }

    /// The robot doesn't fit.
    pub fn misfit(message: String) -> Self {
        Self { class: "PlacementError", message }
    }

    /// A planner failed.
    pub fn planner(message: String) -> Self {
        Self { class: "PlannerError", message }
    }

    /// A planner or behaviour broke its contract.
    pub fn contract(message: String) -> Self {
        Self { class: "ContractError", message }
    }
}

impl From<Failure> for PyErr {
    fn from(Failure { class, message }: Failure) -> Self {
        Python::attach(|py| {
            let made = py.import("robovac._errors").and_then(|errors| errors.getattr(class)?.call1((message,)));
            made.map_or_else(|error| error, PyErr::from_value)
        })
    }
}

impl From<ImportError> for Failure {
    fn from(error: ImportError) -> Self {
        Self::map(error.to_string())
    }
}

impl From<DrawingError> for Failure {
    fn from(error: DrawingError) -> Self {
        Self::map(error.to_string())
    }
}

impl From<ParamError> for Failure {
    fn from(error: ParamError) -> Self {
        Self::usage(error.to_string())
    }
}

impl From<SettingsError> for Failure {
    fn from(error: SettingsError) -> Self {
        Self::usage(error.to_string())
    }
}

impl From<FloorError> for Failure {
    fn from(error: FloorError) -> Self {
        Self::misfit(error.to_string())
    }
}

impl From<SmoothError> for Failure {
    fn from(error: SmoothError) -> Self {
        Self::usage(format!("smooth: {error}"))
    }
}

impl From<PlanningError> for Failure {
    fn from(error: PlanningError) -> Self {
        let message = error.to_string();
        match error {
            PlanningError::CellSize { .. }
            | PlanningError::Heading(_)
            | PlanningError::NeedsNoCells { .. }
            | PlanningError::FillsItsCells
            | PlanningError::Coverage(_) => Self::usage(message),
            PlanningError::StartOutside { .. }
            | PlanningError::StartInWall { .. }
            | PlanningError::StartTooTight { .. }
            | PlanningError::Floor(_) => Self::misfit(message),
            PlanningError::Plan(_) | PlanningError::BadPath { .. } => Self::planner(message),
        }
    }
}

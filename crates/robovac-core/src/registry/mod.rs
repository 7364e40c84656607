//! Shared by planners and behaviours: parameter specifications and explanations.

mod explainer;
mod params;

pub use explainer::{Example, Explainer};
pub use params::{ParamError, ParamKind, ParamSpec, ParamValue, Params};

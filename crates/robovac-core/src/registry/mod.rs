//! Shared by planners and behaviours: parameter specifications and explanations.

mod explainer;
mod params;
mod text;

pub use explainer::{Example, Explainer};
pub use params::{ParamError, ParamKind, ParamSpec, ParamValue, Params};
pub use text::{is_same, nearest};

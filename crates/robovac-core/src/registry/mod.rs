//! What planners and behaviours have in common: parameters that are described once, and explanations.

mod explainer;
mod params;

pub use explainer::{Example, Explainer};
pub use params::{ParamError, ParamKind, ParamSpec, ParamValue, Params};

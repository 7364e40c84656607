//! Parameters for forms.

use robovac_core::registry::{ParamKind, ParamSpec, ParamValue};
use serde::Serialize;

/// One parameter.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Param {
    id: &'static str,
    label: &'static str,
    help: &'static str,
    default: ParamValue,
    #[serde(flatten)]
    kind: FieldKind,
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "lowercase")]
enum FieldKind {
    Number { min: f64, max: f64, step: f64, unit: &'static str },
    Choice { options: &'static [(&'static str, &'static str)] },
    Flag,
}

/// The parameters for forms.
pub fn params(specs: &[ParamSpec]) -> Vec<Param> {
    specs.iter().map(Param::new).collect()
}

impl Param {
    fn new(spec: &ParamSpec) -> Self {
        let kind = match spec.kind {
            ParamKind::Number { min, max, step, unit, .. } => FieldKind::Number { min, max, step, unit },
            ParamKind::Choice { options } => FieldKind::Choice { options },
            ParamKind::Flag { .. } => FieldKind::Flag,
        };
        Self { id: spec.id, label: spec.label, help: spec.help, default: spec.kind.default(), kind }
    }
}

//! A planner with its parameters, as it takes part in comparisons and as links name it.

use crate::{
    app::SettingsError,
    planner::{self, Params, PlannerInfo},
};
use std::fmt;

/// A planner with its parameters.
#[derive(Debug, Clone)]
pub struct Entrant {
    /// The planner.
    pub planner: &'static PlannerInfo,
    /// Its parameters.
    pub params: Params,
}

/// Between a planner and its parameters, and between two of them; neither it nor [`IS`] needs escaping in links.
const AND: char = '~';
/// Between a parameter and its value.
const IS: char = ':';

impl Entrant {
    /// The planner with its default parameters.
    pub fn new(planner: &'static PlannerInfo) -> Self {
        Self { planner, params: Params::defaults(planner.params) }
    }

    /// What [`Display`](fmt::Display) wrote: `snake` or `snake~patience:3`.
    pub fn parse(text: &str) -> Result<Self, SettingsError> {
        let mut parts = text.split(AND);
        let id = parts.next().unwrap_or_default();
        let known = || planner::PLANNERS.iter().map(|p| p.id).collect::<Vec<_>>().join(", ");
        let planner = planner::find(id).ok_or_else(|| SettingsError::Unknown {
            kind: "planner",
            id: id.to_owned(),
            known: known(),
        })?;
        let mut entrant = Self::new(planner);
        for part in parts {
            let (id, value) = part.split_once(IS).unwrap_or((part, ""));
            entrant.set(id, value)?;
        }
        Ok(entrant)
    }

    /// Sets a parameter from what a form or a link says.
    pub fn set(&mut self, id: &str, text: &str) -> Result<(), SettingsError> {
        Ok(self.params.set_text(self.planner.params, id, text)?)
    }
}

/// The planner's id, then the parameters that aren't the default.
impl fmt::Display for Entrant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.planner.id)?;
        let defaults = Params::defaults(self.planner.params);
        for (id, value) in self.params.iter().filter(|&(id, value)| defaults.get(id) != Some(value)) {
            write!(f, "{AND}{id}{IS}{value}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_brings_back_planner_and_parameters() {
        for text in ["snake", "snake~patience:3", "boustrophedon~effort:0~lanes:vertical"] {
            assert_eq!(Entrant::parse(text).unwrap().to_string(), text);
        }
        assert_eq!(Entrant::parse("snake~patience:2").unwrap().to_string(), "snake");
    }

    #[test]
    fn errors_name_what_there_is() {
        assert!(Entrant::parse("snail").unwrap_err().to_string().contains("boustrophedon, "));
        let error = Entrant::parse("snake~patience:fast").unwrap_err();
        assert_eq!(error.to_string(), "parameter \"patience\" can't be \"fast\"; it takes a whole number from 0 to 20");
    }
}

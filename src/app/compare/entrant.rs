//! An algorithm with its parameters, as it takes part in comparisons and as links name it.

use crate::{
    app::{Algorithm, SettingsError},
    planner::{self, Params, PlannerInfo},
};
use std::fmt;

/// An algorithm with its parameters.
#[derive(Debug, Clone)]
pub struct Entrant {
    /// The planner or behaviour.
    pub algorithm: Algorithm,
    /// Its parameters.
    pub params: Params,
}

/// Between an algorithm and its parameters, and between two of them; neither it nor [`IS`] needs escaping in links.
const AND: char = '~';
/// Between a parameter and its value.
const IS: char = ':';

impl Entrant {
    /// The algorithm with its default parameters.
    pub fn new(algorithm: Algorithm) -> Self {
        Self { algorithm, params: Params::defaults(algorithm.params()) }
    }

    /// What [`Display`](fmt::Display) wrote: `snake`, `snake~patience:3` or `bounce`.
    pub fn parse(text: &str) -> Result<Self, SettingsError> {
        let (id, params) = text.split_once(AND).map_or((text, None), |(id, params)| (id, Some(params)));
        let mut entrant = Self::new(Algorithm::find(id)?);
        for part in params.into_iter().flat_map(|params| params.split(AND)) {
            let (id, value) = part.split_once(IS).unwrap_or((part, ""));
            entrant.set(id, value)?;
        }
        Ok(entrant)
    }

    /// A planner with its parameters; where only planners take part, nothing else is known.
    pub fn parse_planner(text: &str) -> Result<(Self, &'static PlannerInfo), SettingsError> {
        let id = text.split(AND).next().unwrap_or_default();
        let planner = planner::find(id).ok_or_else(|| SettingsError::Unknown {
            kind: "planner",
            id: id.to_owned(),
            known: planner::PLANNERS.iter().map(|p| p.id).collect::<Vec<_>>().join(", "),
        })?;
        Ok((Self::parse(text)?, planner))
    }

    /// Its id.
    pub fn id(&self) -> &'static str {
        self.algorithm.id()
    }

    /// Whether it comes to the same every time, whatever the seed.
    pub fn is_deterministic(&self) -> bool {
        self.algorithm.planner().is_some_and(|planner| planner.claims.deterministic)
    }

    /// Sets a parameter from what a form or a link says.
    pub fn set(&mut self, id: &str, text: &str) -> Result<(), SettingsError> {
        Ok(self.params.set_text(self.algorithm.params(), id, text)?)
    }
}

/// The algorithm's id, then the parameters that aren't the default.
impl fmt::Display for Entrant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())?;
        let defaults = Params::defaults(self.algorithm.params());
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
    fn text_brings_back_algorithm_and_parameters() {
        for text in ["bounce", "snake", "snake~patience:3", "boustrophedon~effort:0~lanes:vertical"] {
            assert_eq!(Entrant::parse(text).unwrap().to_string(), text);
        }
        assert_eq!(Entrant::parse("snake~patience:2").unwrap().to_string(), "snake");
    }

    #[test]
    fn errors_name_what_there_is() {
        assert!(Entrant::parse("snail").unwrap_err().to_string().contains(", bounce"));
        let planners = Entrant::parse_planner("bounce").unwrap_err().to_string();
        assert!(
            planners.starts_with("there is no planner \"bounce\"") && planners.contains("boustrophedon, "),
            "{planners}"
        );
        let error = Entrant::parse("snake~patience:fast").unwrap_err();
        assert_eq!(error.to_string(), "parameter \"patience\" can't be \"fast\"; it takes a whole number from 0 to 20");
    }
}

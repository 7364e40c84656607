//! An algorithm with its parameters in a comparison, and its form in a link.

use crate::experiment::{Algorithm, SettingsError};
use coverage_planners::{self, PlannerInfo};
use robovac_core::registry::Params;
use std::fmt;

/// An algorithm with its parameters.
#[derive(Debug, Clone)]
pub struct Entrant {
    /// The planner or behaviour.
    pub algorithm: Algorithm,
    /// Its parameters.
    pub params: Params,
}

/// The kinds of algorithms, see [`Algorithm::kind`].
pub const PLANNER: &str = "planner";
/// See [`PLANNER`].
pub const BEHAVIOUR: &str = "behaviour";

/// Separates an algorithm and its parameters; neither it nor [`IS`] needs escaping in links.
const AND: char = '~';
/// Separates a parameter and its value.
const IS: char = ':';

impl Entrant {
    /// The algorithm with its default parameters.
    pub fn new(algorithm: Algorithm) -> Self {
        Self { algorithm, params: Params::defaults(algorithm.params()) }
    }

    /// Parses the text of [`Display`](fmt::Display) for a `planner` or a `behaviour`: `snake`, or `snake~patience:3`.
    pub fn parse(kind: &'static str, text: &str) -> Result<Self, SettingsError> {
        let mut parts = text.split(AND);
        let mut entrant = Self::new(Algorithm::find_kind(kind, parts.next().unwrap_or_default())?);
        for part in parts {
            let (id, value) = part.split_once(IS).unwrap_or((part, ""));
            entrant.set(id, value)?;
        }
        Ok(entrant)
    }

    /// A planner with its parameters; behaviours aren't accepted.
    pub fn parse_planner(text: &str) -> Result<(Self, &'static PlannerInfo), SettingsError> {
        let entrant = Self::parse(PLANNER, text)?;
        // An entrant found among the planners is one.
        let planner = entrant.algorithm.planner().unwrap_or(coverage_planners::PLANNERS[0]);
        Ok((entrant, planner))
    }

    /// Its id.
    pub fn id(&self) -> &'static str {
        self.algorithm.id()
    }

    /// Whether its result doesn't depend on the seed.
    pub fn is_deterministic(&self) -> bool {
        self.algorithm.planner().is_some_and(|planner| planner.claims.deterministic)
    }

    /// Whether it explores: then the detected boundary is measured instead of the swept floor.
    pub fn explores(&self) -> bool {
        self.algorithm.behaviour().is_some_and(|info| info.claims.explores)
    }

    /// Sets a parameter from the text of a form or a link.
    pub fn set(&mut self, id: &str, text: &str) -> Result<(), SettingsError> {
        Ok(self.params.set_text(self.algorithm.params(), id, text)?)
    }
}

/// The algorithm's id, then the parameters that differ from their defaults.
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
        for text in ["snake", "snake~patience:3", "boustrophedon~effort:0~lanes:vertical"] {
            assert_eq!(Entrant::parse(PLANNER, text).unwrap().to_string(), text);
        }
        assert_eq!(Entrant::parse(PLANNER, "snake~patience:2").unwrap().to_string(), "snake");
    }

    #[test]
    fn planner_and_behaviour_may_share_a_name() {
        for algorithm in Algorithm::all() {
            let entrant = Entrant::parse(algorithm.kind(), algorithm.id()).unwrap();
            assert_eq!((entrant.id(), entrant.algorithm.kind()), (algorithm.id(), algorithm.kind()));
        }
    }

    #[test]
    fn errors_name_what_there_is() {
        assert!(Entrant::parse(PLANNER, "snail").unwrap_err().to_string().contains("did you mean \"snake\"?"));
        let planners = Entrant::parse_planner("bounce").unwrap_err().to_string();
        assert!(planners.starts_with("there is no planner \"bounce\""), "{planners}");
        let error = Entrant::parse(PLANNER, "snake~patience:fast").unwrap_err();
        assert_eq!(error.to_string(), "parameter \"patience\" can't be \"fast\"; use a whole number from 0 to 20");
    }
}

//! An algorithm: a planner whose path is followed, or a reactive behaviour.

use super::SettingsError;
use crate::controller::{self, BEHAVIOURS, BehaviourInfo};
use coverage_planners::{self, PLANNERS, PlannerInfo};
use robovac_core::registry::{Explainer, ParamSpec};

/// An entry of one of the two registries.
#[derive(Debug, Clone, Copy)]
pub enum Algorithm {
    /// Plans a path first; the robot follows it.
    Planner(&'static PlannerInfo),
    /// Drives by what the robot senses.
    Behaviour(&'static BehaviourInfo),
}

impl Algorithm {
    /// All algorithms: planners, then behaviours, in the order of the menus.
    pub fn all() -> impl Iterator<Item = Self> {
        let planners = PLANNERS.iter().map(|&info| Self::Planner(info));
        planners.chain(BEHAVIOURS.iter().map(|&info| Self::Behaviour(info)))
    }

    /// The algorithm with that id.
    pub fn find(id: &str) -> Result<Self, SettingsError> {
        let planner = coverage_planners::find(id).map(Self::Planner);
        planner.or_else(|| controller::find(id).map(Self::Behaviour)).ok_or_else(|| SettingsError::Unknown {
            kind: "algorithm",
            id: id.to_owned(),
            known: Self::all().map(Self::id).collect::<Vec<_>>().join(", "),
        })
    }

    /// The `planner` or the `behaviour` with that id.
    pub fn find_kind(kind: &'static str, id: &str) -> Result<Self, SettingsError> {
        let all = || Self::all().filter(|algorithm| algorithm.kind() == kind);
        all().find(|algorithm| algorithm.id() == id).ok_or_else(|| SettingsError::Unknown {
            kind,
            id: id.to_owned(),
            known: all().map(Self::id).collect::<Vec<_>>().join(", "),
        })
    }

    /// The planner, if it is one.
    pub fn planner(self) -> Option<&'static PlannerInfo> {
        match self {
            Self::Planner(info) => Some(info),
            Self::Behaviour(_) => None,
        }
    }

    /// The behaviour, if it is one.
    pub fn behaviour(self) -> Option<&'static BehaviourInfo> {
        match self {
            Self::Planner(_) => None,
            Self::Behaviour(info) => Some(info),
        }
    }

    /// What links and files call this kind of algorithm.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Planner(_) => "planner",
            Self::Behaviour(_) => "behaviour",
        }
    }

    /// Name in links, files and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            Self::Planner(info) => info.id,
            Self::Behaviour(info) => info.id,
        }
    }

    /// Name in menus.
    pub fn title(self) -> &'static str {
        match self {
            Self::Planner(info) => info.title,
            Self::Behaviour(info) => info.title,
        }
    }

    /// Its parameters.
    pub fn params(self) -> &'static [ParamSpec] {
        match self {
            Self::Planner(info) => info.params,
            Self::Behaviour(info) => info.params,
        }
    }

    /// What its panel explains.
    pub fn explainer(self) -> &'static Explainer {
        match self {
            Self::Planner(info) => &info.explainer,
            Self::Behaviour(info) => &info.explainer,
        }
    }
}

impl PartialEq for Algorithm {
    fn eq(&self, other: &Self) -> bool {
        (self.kind(), self.id()) == (other.kind(), other.id())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_unique_and_found() {
        let all: Vec<_> = Algorithm::all().collect();
        for (index, algorithm) in all.iter().enumerate() {
            assert!(!all[..index].contains(algorithm), "{} twice", algorithm.id());
            assert_eq!(Algorithm::find_kind(algorithm.kind(), algorithm.id()).unwrap(), *algorithm);
        }
        assert!(Algorithm::find("snail").unwrap_err().to_string().contains("bounce"));
    }
}

//! An algorithm: a planner whose path is followed, or a reactive behaviour.

use super::SettingsError;
use crate::{
    controller::{self, BehaviourInfo, Behaviours},
    program::{BEHAVIOUR_PROGRAM, PLANNER_PROGRAM},
};
use coverage_planners::{PLANNERS, PlannerInfo};
use robovac_core::{
    program::ProgramKind,
    registry::{Explainer, ParamSpec},
};

/// An entry of one of the two registries.
#[derive(Debug, Clone, Copy)]
pub enum Algorithm {
    /// Plans a path first; the robot follows it.
    Planner(&'static PlannerInfo),
    /// Drives by sensor readings.
    Behaviour(&'static BehaviourInfo),
}

impl Algorithm {
    /// All algorithms: planners, then behaviours, in the order of the menus.
    pub fn all() -> impl Iterator<Item = Self> + Clone {
        Self::with(controller::ALL)
    }

    /// All planners, then those behaviours.
    pub fn with(behaviours: Behaviours) -> impl Iterator<Item = Self> + Clone {
        let planners = PLANNERS.iter().map(|&info| Self::Planner(info));
        planners.chain(behaviours.infos().map(Self::Behaviour))
    }

    /// The entry that stands for a user's program. It isn't in the registries.
    pub fn of_program(kind: ProgramKind) -> Self {
        match kind {
            ProgramKind::Behaviour => Self::Behaviour(&BEHAVIOUR_PROGRAM),
            ProgramKind::Planner => Self::Planner(&PLANNER_PROGRAM),
        }
    }

    /// Whether it stands for a user's program.
    pub fn is_program(self) -> bool {
        Self::is_program_id(self.id())
    }

    /// Whether that is the id of the entry of a user's program.
    pub fn is_program_id(id: &str) -> bool {
        [BEHAVIOUR_PROGRAM.id, PLANNER_PROGRAM.id].contains(&id)
    }

    /// The algorithm of that `kind` with that id, among `these`.
    pub fn find(
        kind: &'static str,
        id: &str,
        these: impl Iterator<Item = Self> + Clone,
    ) -> Result<Self, SettingsError> {
        these.clone().find(|algorithm| algorithm.id() == id).ok_or_else(|| {
            if kind != "planner" && controller::WITH_MAP.contains(&id) {
                return SettingsError::KeepsMap(id.to_owned());
            }
            SettingsError::Unknown {
                kind,
                id: id.to_owned(),
                known: these.map(Self::id).collect::<Vec<_>>().join(", "),
            }
        })
    }

    /// The `planner` or the `behaviour` with that id.
    pub fn find_kind(kind: &'static str, id: &str) -> Result<Self, SettingsError> {
        let programs = [ProgramKind::Behaviour, ProgramKind::Planner].map(Self::of_program);
        if let Some(program) = programs.into_iter().find(|program| (program.kind(), program.id()) == (kind, id)) {
            return Ok(program);
        }
        Self::find(kind, id, Self::all().filter(|algorithm| algorithm.kind() == kind))
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

    /// Whether it is for cleaning: all planners are, and some behaviours.
    pub fn cleans(self) -> bool {
        self.behaviour().is_none_or(|info| info.claims.cleans)
    }

    /// Name of its kind in links and files.
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

    /// The explanation shown in its panel, if it is in a registry.
    pub fn explainer(self) -> Option<&'static Explainer> {
        match self {
            Self::Planner(info) => coverage_planners::explainer(info.id),
            Self::Behaviour(info) => controller::explainer(info.id),
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
        assert_eq!(
            Algorithm::find("algorithm", "snale", Algorithm::all()).unwrap_err().to_string(),
            "there is no algorithm \"snale\"; did you mean \"snake\"?"
        );
    }
}

//! Metadata of a planner.

use robovac_core::registry::{ParamKind, ParamSpec, Params, is_same};

/// Metadata of a planner for menus, forms and tests. For its construction see [`super::BuildPlanner`].
#[derive(Debug)]
pub struct PlannerInfo {
    /// Name in links, files and on the command line: lower case, `_` between words.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence on how it works.
    pub summary: &'static str,
    /// The properties that the contract tests check.
    pub claims: PlannerClaims,
    /// Its parameters, the important ones first.
    pub params: &'static [ParamSpec],
}

/// Properties that a planner promises and the contract test checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlannerClaims {
    /// Visits every free cell of every job.
    pub complete: bool,
    /// The result does not depend on the seed.
    pub deterministic: bool,
    /// Plans a million cells in about a second; others are meant for rooms of up to [`SLOW_CELLS`].
    pub fast: bool,
    /// Plans a path in metres and needs the job's place; others walk from cell to cell. It sweeps the share of the floor, in percent,
    /// that this parameter says.
    pub in_metres: Option<&'static str>,
    /// Whether it searches for a better walk than its first one.
    pub search: Search,
}

/// How long a planner searches for a better walk. Parameters are named by their ids, which must be numbers in
/// [`PlannerInfo::params`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Search {
    /// Not at all.
    None,
    /// For as long as a parameter says.
    Limited {
        /// The parameter; tests set it to its minimum in large rooms.
        effort: &'static str,
    },
    /// The same, but every reported walk is complete, so it can be stopped at any time.
    Anytime {
        /// As in [`Search::Limited`].
        effort: &'static str,
        /// The parameter for the cost of a quarter turn, in steps; 0 for the robot's time.
        turn: &'static str,
    },
}

/// What a planner shows of its search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShownSearch {
    /// What it considers and decides at each step, by [`PlanContext::trace`](super::PlanContext::trace).
    Decisions,
    /// Its paths, each better than the one before, in a [`Film`](super::Film).
    Film,
}

impl PlannerInfo {
    /// What it shows of its search.
    pub fn shown_search(&self) -> ShownSearch {
        match self.claims.search {
            Search::None => ShownSearch::Decisions,
            Search::Limited { .. } | Search::Anytime { .. } => ShownSearch::Film,
        }
    }

    /// Most planning cells of a room in which it is filmed: in larger ones, changes by single cells can't be seen.
    pub fn most_filmed_cells(&self) -> usize {
        if self.is_in_metres() { 20_000 } else { 2_000 }
    }

    /// Whether it plans paths in metres.
    pub fn is_in_metres(&self) -> bool {
        self.claims.in_metres.is_some()
    }

    /// The share of the floor that a path in metres has to sweep, 0 to 1. Where corners will be rounded
    /// ([`JobPlace::is_rounded`](super::JobPlace::is_rounded)), it may sweep more, which curves can leave out.
    pub fn asked_coverage(&self, params: &Params) -> Option<f64> {
        self.claims.in_metres.map(|coverage| params.number(coverage) / 100.0)
    }

    /// Whether its search can be stopped at any time.
    pub fn is_anytime(&self) -> bool {
        matches!(self.claims.search, Search::Anytime { .. })
    }

    /// The parameter that says how long it searches.
    pub fn effort(&self) -> Option<&'static ParamSpec> {
        match self.claims.search {
            Search::None => None,
            Search::Limited { effort } | Search::Anytime { effort, .. } => self.params.iter().find(|p| p.id == effort),
        }
    }

    /// An anytime planner's cost of a quarter turn, in steps; 0 for the robot's time.
    pub fn turn_weight(&self, params: &Params) -> Option<f64> {
        if let Search::Anytime { turn, .. } = self.claims.search { Some(params.number(turn)) } else { None }
    }

    /// Checks the parameters that claims name.
    ///
    /// # Panics
    ///
    /// If one of them isn't there. The registry has `const _: () = INFO.check();`, so an invalid entry is a compile
    /// error.
    pub const fn check(&self) {
        let is_there = match self.claims.search {
            Search::None => true,
            Search::Limited { effort } => self.has_number(effort),
            Search::Anytime { effort, turn } => self.has_number(effort) && self.has_number(turn),
        };
        assert!(is_there, "`claims.search` names a parameter that isn't a number in `params`");
        if let Some(coverage) = self.claims.in_metres {
            assert!(self.has_number(coverage), "`claims.in_metres` names a parameter that isn't a number in `params`");
        }
    }

    const fn has_number(&self, id: &str) -> bool {
        let mut index = 0;
        while index < self.params.len() {
            let ParamSpec { id: other, kind, .. } = &self.params[index];
            if is_same(other, id) && matches!(kind, ParamKind::Number { .. }) {
                return true;
            }
            index += 1;
        }
        false
    }
}

/// Free cells up to which planners that don't claim to be fast stay usable.
pub const SLOW_CELLS: usize = 200 * 200;

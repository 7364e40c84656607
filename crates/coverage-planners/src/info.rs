//! Metadata of a planner.

use robovac_core::registry::{Explainer, ParamSpec};

/// What menus, forms and tests know of a planner. How it is made is not in here: see [`super::BuildPlanner`].
#[derive(Debug)]
pub struct PlannerInfo {
    /// Name in links, files and on the command line: lower case, `_` between words.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence: how it goes about it.
    pub summary: &'static str,
    /// Where it comes from: authors, year, title, section.
    pub source: &'static str,
    /// Address of the source or of a good description; empty if there is none.
    pub link: &'static str,
    /// What its panel explains.
    pub explainer: Explainer,
    /// What the contract test holds it to.
    pub claims: PlannerClaims,
    /// Its parameters, the important ones first.
    pub params: &'static [ParamSpec],
}

/// Properties that a planner promises and the contract test checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools)]
pub struct PlannerClaims {
    /// Visits every free cell of every job.
    pub complete: bool,
    /// The result does not depend on the seed.
    pub deterministic: bool,
    /// Plans a million cells in about a second; others are meant for rooms of up to [`SLOW_CELLS`].
    pub fast: bool,
    /// Explains every step by [`PlanContext::trace`](super::PlanContext::trace).
    pub traces: bool,
    /// Every walk that it reports is complete, and it may be stopped at any time.
    pub anytime: bool,
}

/// Free cells up to which planners that don't claim to be fast stay usable.
pub const SLOW_CELLS: usize = 200 * 200;

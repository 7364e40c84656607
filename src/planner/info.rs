//! What a planner says of itself.

use super::{ParamSpec, Params, Planner};

/// Entry of the registry.
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
    /// What the contract test holds it to.
    pub claims: Claims,
    /// Its parameters, the important ones first.
    pub params: &'static [ParamSpec],
    /// Makes the planner for checked parameters.
    pub build: fn(&Params) -> Box<dyn Planner>,
}

/// Properties that a planner promises and the contract test checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Claims {
    /// Visits every free cell of every job.
    pub complete: bool,
    /// The result does not depend on the seed.
    pub deterministic: bool,
}

//! An algorithm as shown in menus, forms and panels.

use crate::{
    Mark,
    param::{Param, params},
};
use coverage_planners::PlannerInfo;
use robovac_sim::experiment::Algorithm;
use serde::Serialize;

/// A planner or behaviour. Claims that only the other kind has are false.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[expect(clippy::struct_excessive_bools)]
pub struct CatalogueEntry {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
    /// `planner` or `behaviour`.
    #[cfg_attr(feature = "types", ts(type = "\"planner\" | \"behaviour\""))]
    kind: &'static str,
    mark: Mark,
    complete: bool,
    deterministic: bool,
    fast: bool,
    anytime: bool,
    /// The parameter that says how much of the floor its plans sweep; others sweep what they can.
    coverage_param: Option<&'static str>,
    ends: bool,
    cleans: bool,
    manual: bool,
    params: Vec<Param>,
}

impl CatalogueEntry {
    /// The entry of an algorithm.
    pub fn new(algorithm: Algorithm) -> Self {
        let summary = match algorithm {
            Algorithm::Planner(p) => p.summary,
            Algorithm::Behaviour(b) => b.summary,
        };
        let (plans, reacts) = (algorithm.planner().map(|p| p.claims), algorithm.behaviour().map(|b| b.claims));
        Self {
            id: algorithm.id(),
            title: algorithm.title(),
            summary,
            kind: algorithm.kind(),
            mark: Mark::of(algorithm),
            complete: plans.is_some_and(|c| c.complete),
            deterministic: plans.is_some_and(|c| c.deterministic),
            fast: plans.is_some_and(|c| c.fast),
            anytime: algorithm.planner().is_some_and(PlannerInfo::is_anytime),
            coverage_param: plans.and_then(|c| c.in_metres),
            ends: reacts.is_some_and(|c| c.ends),
            cleans: reacts.is_some_and(|c| c.cleans),
            manual: reacts.is_some_and(|c| c.manual),
            params: params(algorithm.params()),
        }
    }
}

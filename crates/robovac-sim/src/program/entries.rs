//! The entries that stand for a user's program, beside those of the registries.

use crate::controller::{BehaviourClaims, BehaviourInfo};
use coverage_planners::{PlannerClaims, PlannerInfo, Search};

/// A program that drives the robot from its sensor readings.
pub const BEHAVIOUR_PROGRAM: BehaviourInfo = BehaviourInfo {
    id: "program",
    title: "Your program",
    summary: "Your program drives.",
    claims: BehaviourClaims { cleans: true, ..BehaviourClaims::NONE },
    params: &[],
};

/// A program that plans a walk.
pub const PLANNER_PROGRAM: PlannerInfo = PlannerInfo {
    id: "program_planner",
    title: "Your program",
    summary: "Your program plans.",
    claims: PlannerClaims { complete: false, deterministic: false, fast: false, in_metres: None, search: Search::None },
    params: &[],
};

const _: () = PLANNER_PROGRAM.check();

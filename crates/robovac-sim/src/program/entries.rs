//! The entries that stand for a user's program, beside those of the registries.

use crate::controller::{BehaviourClaims, BehaviourInfo};
use coverage_planners::{PlannerClaims, PlannerInfo, Search};
use robovac_core::registry::{Example, Explainer};

const SHINES: Example =
    Example { room: "thesis226", why: "One room with a few obstacles: a program's ways are easy to see." };
const FAILS: Example = Example { room: "maze", why: "A program that knows no maze is soon lost." };

/// A program that drives the robot from its sensor readings.
pub const BEHAVIOUR_PROGRAM: BehaviourInfo = BehaviourInfo {
    id: "program",
    title: "Your program",
    summary: "Drives as your program says.",
    source: "Your program",
    link: "",
    explainer: Explainer {
        idea: "Your program reads the sensors every 15 ms. It sets the speeds of the wheels. Nothing else drives the robot.",
        complexity: "As you wrote it.",
        use_when: "For ideas of your own.",
        shines: SHINES,
        fails: FAILS,
    },
    claims: BehaviourClaims {
        ends: false,
        cleans: true,
        walls_only: false,
        manual: false,
        explores: false,
        needs_laser: false,
    },
    params: &[],
};

/// A program that plans a walk.
pub const PLANNER_PROGRAM: PlannerInfo = PlannerInfo {
    id: "program_planner",
    title: "Your program",
    summary: "Plans as your program says.",
    source: "Your program",
    link: "",
    explainer: Explainer {
        idea: "Your program gets the grid of the room. It returns the cells in the order of the walk. The walk is checked \
               as all planners' are.",
        complexity: "As you wrote it.",
        use_when: "For ideas of your own.",
        shines: SHINES,
        fails: FAILS,
    },
    claims: PlannerClaims {
        complete: false,
        deterministic: false,
        fast: false,
        in_metres: false,
        traces: false,
        search: Search::None,
    },
    params: &[],
};

const _: () = BEHAVIOUR_PROGRAM.check();
const _: () = PLANNER_PROGRAM.check();

//! The entry in the registry.

use super::{LanesError, LanesObjective, LanesProgress, LanesSetup, plan_lanes, trade_off::trade_off};
use crate::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    TradeOffPoint,
};
use rand::RngExt;
use robovac_core::{
    geometry::Point,
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::Tool,
};
use std::ops::ControlFlow;

/// Choices of what is minimised.
const TIME: &str = "time";
const DISTANCE: &str = "distance";

/// Moves for every metre of the bound at effort 1.
const MOVES: f64 = 10_000.0;

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "lanes",
    title: "Lanes in metres",
    summary: "Lays lanes as far apart as the tool allows, and searches for the fastest path.",
    claims: PlannerClaims {
        complete: false,
        deterministic: false,
        fast: false,
        in_metres: Some("coverage"),
        search: Search::Limited { effort: "effort" },
    },
    params: &[
        ParamSpec {
            id: "coverage",
            label: "Coverage",
            help: "Share of the reachable floor to sweep; the last percent take longest.",
            kind: ParamKind::Number { min: 50.0, max: 100.0, step: 0.1, default: 99.0, unit: "%" },
        },
        ParamSpec {
            id: "minimise",
            label: "Minimise",
            help: "Time, or distance: the path is then shorter, but has more turns.",
            kind: ParamKind::Choice { options: &[(TIME, "time"), (DISTANCE, "distance")] },
        },
        ParamSpec {
            id: "effort",
            label: "Search time",
            help: "Search effort for a faster path; 0 keeps the first one.",
            kind: ParamKind::Number { min: 0.0, max: 100.0, step: 0.1, default: 1.0, unit: "" },
        },
        ParamSpec {
            id: "clearance",
            label: "Clearance",
            help: "Least distance between the robot's body and obstacles.",
            kind: ParamKind::Number { min: 0.0, max: 50.0, step: 1.0, default: 3.0, unit: "mm" },
        },
        ParamSpec {
            id: "overlap",
            label: "Overlap",
            help: "Overlap of neighbouring lanes, for a robot that drifts by up to half of it.",
            kind: ParamKind::Number { min: 0.0, max: 50.0, step: 1.0, default: 0.0, unit: "mm" },
        },
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "Plans straight pieces in metres, not steps between cells. Parts of the room get lanes along their \
           longer direction, a tool's width apart. Simulated annealing then shifts, drops and joins lanes and \
           corners until the required coverage takes the least time found, or the least distance.",
    complexity: "O(n) memory for n m²; effort 1 tries 10,000 changes per metre.",
    use_when: "When time counts. Stop it at any time: it keeps the best path so far.",
    shines: Example { room: "hotel", why: "Long lanes and short links." },
    fails: Example { room: "room12ft", why: "Slivers between legs of chairs cost detours." },
    source: "Kirkpatrick et al. 1983, Optimization by simulated annealing; the moves are ours",
    link: "https://doi.org/10.1126/science.220.4598.671",
};

/// Makes the planner.
pub(crate) const BUILD: BuildPlanner = |params| {
    Box::new(Lanes(LanesSetup {
        coverage: params.number("coverage") / 100.0,
        clearance: params.number("clearance") / 1000.0,
        overlap: params.number("overlap") / 1000.0,
        effort: MOVES * params.number("effort"),
        objective: if params.choice("minimise") == DISTANCE { LanesObjective::Distance } else { LanesObjective::Time },
        ..LanesSetup::default()
    }))
};

/// The planner; the seed comes from the context.
struct Lanes(LanesSetup);

impl Planner for Lanes {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let place = job.place.as_ref().ok_or(PlanError::NoFloor)?;
        if place.robot.tool == Tool::Body {
            return Err(PlanError::OtherTool);
        }
        let setup = LanesSetup { seed: ctx.rng.random(), is_rounded: place.is_rounded, ..self.0 };
        let mut is_cancelled = false;
        let found = plan_lanes(&place.floor, &place.robot, &setup, &mut |LanesProgress { done, path, .. }| {
            is_cancelled = ctx.checkpoint_in_metres(done, path).is_err();
            if is_cancelled { ControlFlow::Break(()) } else { ControlFlow::Continue(0.0) }
        });
        match found {
            Ok(plan) if !is_cancelled => Ok(CoveragePath::in_metres(plan.path)),
            Err(LanesError::Value { what, expected, .. }) => Err(PlanError::Unsuited { what, expected }),
            Ok(_) | Err(LanesError::Cancelled) => Err(PlanError::Cancelled),
        }
    }

    fn is_complete(&self) -> bool {
        false
    }

    fn trade_off(
        &self,
        job: &CoverageJob,
        path: &[Point],
        shares: &[f64],
        observe: &mut dyn FnMut(TradeOffPoint) -> ControlFlow<()>,
    ) {
        if let Some(place) = &job.place {
            let setup = LanesSetup { is_rounded: place.is_rounded, ..self.0 };
            trade_off(&place.floor, &place.robot, &setup, path, shares, observe);
        }
    }
}

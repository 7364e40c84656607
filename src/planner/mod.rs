//! Coverage planners: one file each, all in one registry.
//!
//! A planner gets a [`CoverageJob`], a grid of free cells that are all connected with the start, and returns a
//! [`CoveragePath`] that visits them. To add one, write its file with a [`PlannerInfo`] constant and list it in
//! [`PLANNERS`]; menus, parameter forms, command line, contract tests and benchmarks iterate that list.

mod boustrophedon;
mod context;
mod energy;
mod grid_tsp;
mod info;
mod job;
mod neural;
mod params;
mod path;
mod snake;

pub mod stage;

pub use context::{Observer, PlanContext, PlanError};
pub use info::{Claims, Example, Explainer, PlannerInfo, SLOW_CELLS};
pub use job::CoverageJob;
pub use params::{ParamError, ParamKind, ParamSpec, ParamValue, Params};
pub use path::{CoveragePath, PathError};

/// An algorithm that finds a walk over all free cells.
pub trait Planner {
    /// Plans a walk from `job.start`. Must return [`PlanError::Cancelled`] soon after the context says so.
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError>;
}

/// All planners, in the order of the menus.
pub const PLANNERS: &[&PlannerInfo] =
    &[&boustrophedon::INFO, &energy::INFO, &grid_tsp::INFO, &neural::INFO, &snake::INFO];

/// The planner with that id.
pub fn find(id: &str) -> Option<&'static PlannerInfo> {
    PLANNERS.iter().copied().find(|p| p.id == id)
}

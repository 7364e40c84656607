//! Coverage planners: one file each, all in one registry.
//!
//! A planner gets a [`CoverageJob`], a grid of free cells that are all connected with the start, and returns a
//! [`CoveragePath`] that visits them. To add one, write its file with a [`PlannerInfo`] constant and list it in
//! [`PLANNERS`]; menus, parameter forms, command line, contract tests and benchmarks iterate that list.

mod backtracking_spiral;
mod boustrophedon;
mod boustrophedon_cells;
mod context;
mod contour;
mod energy;
mod genetic;
mod grid_tsp;
mod info;
mod job;
mod neural;
mod params;
mod path;
mod s_shape;
mod snake;
mod spiral;
mod spiral_stc;
mod trace;
mod wavefront_distance;
mod wavefront_path;

pub mod stage;

pub use context::{Observer, PlanContext, PlanError, Tracer};
pub use info::{Claims, Example, Explainer, PlannerInfo, SLOW_CELLS};
pub use job::CoverageJob;
pub use params::{ParamError, ParamKind, ParamSpec, ParamValue, Params};
pub use path::{CoveragePath, PathError};
pub use trace::TraceStep;

/// An algorithm that finds a walk over all free cells.
pub trait Planner {
    /// Plans a walk from `job.start`. Must return [`PlanError::Cancelled`] soon after the context says so.
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError>;

    /// Whether it explains every step by [`PlanContext::trace`].
    fn traces(&self) -> bool {
        false
    }
}

/// All planners, in the order of the menus.
pub const PLANNERS: &[&PlannerInfo] = &[
    &boustrophedon::INFO,
    &boustrophedon_cells::INFO,
    &spiral_stc::INFO,
    &backtracking_spiral::INFO,
    &contour::INFO,
    &wavefront_distance::INFO,
    &wavefront_path::INFO,
    &s_shape::INFO,
    &spiral::INFO,
    &snake::INFO,
    &genetic::INFO,
    &grid_tsp::INFO,
    &energy::INFO,
    &neural::INFO,
];

/// The planner with that id.
pub fn find(id: &str) -> Option<&'static PlannerInfo> {
    PLANNERS.iter().copied().find(|p| p.id == id)
}

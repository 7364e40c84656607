//! Coverage path planners on grids, lower bounds on the cost of any walk, and the metrics to compare them by.
//!
//! For covering a grid with a robot, and for comparing a new planner with established ones. A planner gets a
//! [`CoverageJob`], a grid of free cells that are all connected with the start, and returns a [`CoveragePath`] that
//! visits them. Planners in metres, such as [`lanes`], need the floor that the grid lies on, too, and return straight
//! pieces.
//!
//! ```
//! use coverage_planners::{Bounds, CoverageJob, Params, PlanContext, find, metrics::WalkMetrics};
//! use robovac_core::grid::{Cell, Direction, from_picture};
//!
//! let free = from_picture(".....\n..#..\n.....", |glyph| glyph == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 0), Direction::Right).unwrap();
//!
//! let planner = find("boustrophedon").unwrap();
//! let path = planner.build(&Params::defaults(planner.params)).plan(&job, &mut PlanContext::new(1)).unwrap();
//! let walk = WalkMetrics::of(&job, &path);
//! assert_eq!(walk.visited_cells, 14);
//! assert!(Bounds::of(&job).cost <= walk.cost());
//! println!("{}", path.arrows(&job));
//! ```
//!
//! - [`PLANNERS`]: the registry, and [`find`] by id
//! - [`metrics`]: steps, turns, revisits, driven metres and seconds; [`Bounds`]: proven lower bounds
//! - [`smooth`]: paths with rounded corners, and their speeds
//! - [`stage`]: parts to build planners from; [`sweep`]: another planner in metres, for a body of any outline
//!
//! A planner outside this crate implements [`Planner`]; the example `own_planner` has one. To add one to the registry, write
//! its file with the constants `INFO` (a [`PlannerInfo`]), `EXPLAINER` (an [`Explainer`]) and `BUILD` (a [`BuildPlanner`]) and
//! list it below; menus,
//! parameter forms, command line, contract tests and benchmarks iterate [`PLANNERS`].

mod backtracking_spiral;
mod bounds;
mod boustrophedon;
mod boustrophedon_cells;
mod context;
mod contour;
mod energy;
mod film;
mod genetic;
mod grid_tsp;
mod info;
mod job;
mod near_optimal;
mod neural;
mod objective;
mod path;
mod s_shape;
mod snake;
mod spiral;
mod spiral_stc;
mod subgoal_sweep;
mod trace;
mod wavefront_distance;
mod wavefront_path;

pub mod lanes;
pub mod metrics;
pub mod smooth;
pub mod stage;
pub mod sweep;

pub use bounds::{Bounds, Relaxation, TURN_STEPS};
pub use context::{Observer, PlanContext, PlanError, ProgressReport, StepTracer};
pub use film::{Film, FilmFrame};
pub use info::{PlannerClaims, PlannerInfo, SLOW_CELLS, Search, ShownSearch};
pub use job::{CoverageJob, JobPlace};
pub use objective::{Finish, Objective, Proof};
pub use path::{CoveragePath, PathError};
pub use robovac_core::registry::{Example, Explainer, ParamError, ParamKind, ParamSpec, ParamValue, Params};
pub use snake::OnlineSnake;
pub use trace::{THE_END, TraceStep};

use robovac_core::geometry::Point;
use std::ops::ControlFlow;

/// An algorithm that finds a walk over all free cells, or a path in metres over their floor.
pub trait Planner {
    /// Plans a path from `job.start`. Must return [`PlanError::Cancelled`] soon after the context reports a
    /// cancellation.
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError>;

    /// Whether it visits every cell with its parameters. If not, it doesn't whatever [`PlannerClaims::complete`] says of
    /// its defaults.
    fn is_complete(&self) -> bool {
        true
    }

    /// Calls `observe` with what `path`, planned for that job, takes, and then paths for each of the `shares` of the floor, 0 to 1,
    /// until it breaks off: first those for less than was asked of `path`, from the nearest on. Only planners in metres have such paths.
    fn trade_off(
        &self,
        _job: &CoverageJob,
        _path: &[Point],
        _shares: &[f64],
        _observe: &mut dyn FnMut(TradeOffPoint) -> ControlFlow<()>,
    ) {
    }

    /// The planners whose walks, made with their defaults, this one begins with in `job`, and the job they are given; none
    /// for most.
    fn begins_with(&self, job: &CoverageJob) -> (CoverageJob, &'static [&'static PlannerInfo]) {
        (job.clone(), &[])
    }
}

/// What a path for another coverage takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TradeOffPoint {
    /// The share of the floor that it was to sweep, 0 to 1, and the one that it sweeps: less where no path was found that sweeps enough.
    pub asked: f64,
    /// See `asked`.
    pub coverage: f64,
    /// Its time by the robot's motion model, s.
    pub duration_s: f64,
    /// Its length, m.
    pub length_m: f64,
}

/// Makes a planner for checked parameters.
pub type BuildPlanner = fn(&Params) -> Box<dyn Planner>;

/// Three lists of the same planners: their metadata, their explanations and their constructors. They are separate so that a
/// program which only needs the metadata, such as the page, contains neither the texts nor the planners' code.
macro_rules! registry {
    ($($planner:ident),* $(,)?) => {
        /// All planners, in the order of the menus.
        pub const PLANNERS: &[&PlannerInfo] = &[$(&$planner::INFO),*];
        const EXPLAINERS: &[(&str, &Explainer)] = &[$(($planner::INFO.id, &$planner::EXPLAINER)),*];
        const BUILDERS: &[(&str, BuildPlanner)] = &[$(($planner::INFO.id, $planner::BUILD)),*];
        $(const _: () = $planner::INFO.check();)*
        $(const _: () = $planner::EXPLAINER.check($planner::INFO.summary);)*
    };
}

// One line per planner.
registry! {
    boustrophedon,
    boustrophedon_cells,
    spiral_stc,
    backtracking_spiral,
    contour,
    wavefront_distance,
    wavefront_path,
    s_shape,
    subgoal_sweep,
    spiral,
    snake,
    genetic,
    grid_tsp,
    near_optimal,
    energy,
    neural,
    lanes,
}

impl PlannerInfo {
    /// Makes the planner for checked parameters. For one that isn't in the registry, planning returns
    /// [`PlanError::Unlisted`].
    pub fn build(&self, params: &Params) -> Box<dyn Planner> {
        let listed = BUILDERS.iter().find(|(id, _)| *id == self.id);
        listed.map_or_else(|| Box::new(Unlisted) as Box<dyn Planner>, |(_, build)| build(params))
    }
}

/// Stands for planners that aren't in the registry.
struct Unlisted;

impl Planner for Unlisted {
    fn plan(&self, _: &CoverageJob, _: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        Err(PlanError::Unlisted)
    }
}

/// The explanation of the planner with that id.
pub fn explainer(id: &str) -> Option<&'static Explainer> {
    EXPLAINERS.iter().find(|(of, _)| *of == id).map(|(_, explainer)| *explainer)
}

/// The planner with that id.
pub fn find(id: &str) -> Option<&'static PlannerInfo> {
    PLANNERS.iter().copied().find(|p| p.id == id)
}

//! The grid that a user's planner gets.

use coverage_planners::CoverageJob;
use robovac_core::grid::picture;
use serde::Serialize;

/// A grid to be covered. Cells are column and row, counted from 0 at the lower left.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ProgramRoom {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Side of a cell, m.
    pub cell: f64,
    /// Cell in which the robot stands.
    pub start: [i32; 2],
    /// The cells, the top row first: `.` for those to be cleaned, `#` for all others.
    pub rows: Vec<String>,
}

impl ProgramRoom {
    /// The grid of `job`, whose cells have sides of `cell` metres.
    pub fn of(job: &CoverageJob, cell: f64) -> Self {
        let rows = picture(&job.free, |&free| if free { '.' } else { '#' }).lines().map(str::to_owned).collect();
        Self { width: job.free.width(), height: job.free.height(), cell, start: [job.start.x, job.start.y], rows }
    }

    /// As JSON.
    pub fn to_json(&self) -> String {
        // Strings, numbers and lists can always be serialised.
        serde_json::to_string(self).unwrap_or_default()
    }
}

//! Stage: a walk under construction, with the cells left to clean.

use super::{
    nearest_goal_bfs::NearestGoalBfs,
    told::{Reasons, tell_walk},
};
use crate::{CoverageJob, CoveragePath, PlanContext, PlanError};
use robovac_core::grid::{Cell, Direction, Grid};

/// The walk so far, the robot's pose, and the cells that are left.
#[derive(Debug)]
pub struct CoverageProgress<'j> {
    job: &'j CoverageJob,
    seeker: NearestGoalBfs,
    /// Cells that the walk hasn't visited.
    left: Grid<bool>,
    left_count: usize,
    cells: usize,
    walk: Vec<Cell>,
    /// The cell that the robot is in.
    pub at: Cell,
    /// The direction that it looks in.
    pub facing: Direction,
    next_report: usize,
}

/// Steps between two reports.
const REPORT_EVERY: usize = 4096;

impl<'j> CoverageProgress<'j> {
    /// At the start of `job`, with the cell there clean.
    pub fn new(job: &'j CoverageJob) -> Self {
        let cells = job.cells();
        let mut left = job.free.clone();
        left[job.start] = false;
        let mut walk = Vec::with_capacity(cells * 5 / 4);
        walk.push(job.start);
        Self {
            job,
            seeker: NearestGoalBfs::new(&job.free),
            left,
            left_count: cells - 1,
            cells,
            walk,
            at: job.start,
            facing: job.heading,
            next_report: 0,
        }
    }

    /// Whether all is clean.
    pub fn is_done(&self) -> bool {
        self.left_count == 0
    }

    /// The cells that are left.
    pub fn left(&self) -> &Grid<bool> {
        &self.left
    }

    /// Whether the cell next to the robot in this direction is left.
    #[inline]
    pub fn is_left(&self, towards: Direction) -> bool {
        self.left.is_set(self.at.step(towards))
    }

    /// Goes one step, which must lead to a free cell.
    #[inline]
    pub fn step(&mut self, towards: Direction) {
        self.facing = towards;
        self.at = self.at.step(towards);
        self.walk.push(self.at);
        if std::mem::take(&mut self.left[self.at]) {
            self.left_count -= 1;
        }
    }

    /// Goes by a shortest way to the nearest cell that is left; stays where all is clean.
    pub fn go_to_nearest_left(&mut self) {
        let left = &self.left;
        let way = self.seeker.nearest(&self.job.free, self.at, self.facing, |cell| left[cell]);
        self.follow(way);
    }

    /// Goes to `goal` by a shortest way.
    pub fn go_to(&mut self, goal: Cell) {
        if goal != self.at {
            let way = self.seeker.nearest(&self.job.free, self.at, self.facing, |cell| cell == goal);
            self.follow(way);
        }
    }

    fn follow(&mut self, way: Option<Vec<Cell>>) {
        for towards in way.into_iter().flatten() {
            // The way consists of 4-neighbour steps.
            if let Some(direction) = self.at.direction_to(towards) {
                self.step(direction);
            }
        }
    }

    /// Number of steps so far.
    pub fn steps(&self) -> usize {
        self.walk.len() - 1
    }

    /// Number of cells that are left.
    pub fn left_count(&self) -> usize {
        self.left_count
    }

    /// To be called every few steps; reports the walk every few thousand.
    pub fn report(&mut self, ctx: &mut PlanContext<'_>) -> Result<(), PlanError> {
        if self.walk.len() < self.next_report {
            return Ok(());
        }
        self.next_report = self.walk.len() + REPORT_EVERY;
        ctx.checkpoint(1.0 - self.left_count as f64 / self.cells as f64, &self.walk)
    }

    /// Traces the walk, made by `reasons`.
    pub(crate) fn tell(&self, ctx: &mut PlanContext<'_>, reasons: &mut dyn Reasons) {
        tell_walk(ctx, self.job, &self.walk, reasons);
    }

    /// The walk.
    pub fn into_path(self) -> CoveragePath {
        CoveragePath::walk(self.walk)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_walked_over_is_not_left() {
        let job = CoverageJob::new(&Grid::filled(4, 1, true), Cell::new(1, 0), Direction::Right).unwrap();
        let mut progress = CoverageProgress::new(&job);
        progress.go_to(Cell::new(3, 0));
        assert!(!progress.is_done() && !progress.is_left(Direction::Left));
        progress.go_to_nearest_left();
        assert!(progress.is_done());
        let walked: Vec<i32> = progress.into_path().cells.iter().map(|cell| cell.x).collect();
        assert_eq!(walked, [1, 2, 3, 2, 1, 0]);
    }
}

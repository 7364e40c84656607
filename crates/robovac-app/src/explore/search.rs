//! A planner's decisions, looked up by the robot's position on the walk.

use coverage_planners::{THE_END, TraceStep};
use robovac_core::{geometry::Point, grid::Cell};
use robovac_sim::{
    Run,
    experiment::planning::{Planned, RoomSetup},
};
use std::sync::Arc;

/// The decisions of a plan.
#[derive(Debug)]
pub struct PlanSearch {
    steps: Vec<TraceStep>,
    /// Distance along the line at which each cell of the walk is reached, m.
    arrivals: Vec<f64>,
    line: Arc<[Point]>,
    /// Distance along the line of each of its corners, m.
    corners: Vec<f64>,
}

impl PlanSearch {
    /// The decisions in `steps` that led to `walk`.
    pub fn new(prepared: &RoomSetup, planned: &Planned, walk: &[Cell], steps: Vec<TraceStep>) -> Self {
        let line = Arc::clone(&planned.line);
        let mut corners = vec![0.0];
        let mut length = 0.0;
        corners.extend(line.windows(2).map(|piece| {
            length += (piece[1] - piece[0]).norm();
            length
        }));
        let arrivals = prepared.planning_grid.arrivals(&prepared.floor, walk);
        Self { steps, arrivals, line, corners }
    }

    /// The decision that the robot is carrying out; `None` at the end.
    ///
    /// The follower gives the piece of the line, and the robot's position the distance along it, so the result is right
    /// where lanes touch or cross, and when the robot has slipped off its line.
    pub fn decision(&self, run: &Run) -> Option<&TraceStep> {
        let corner = run.corner().filter(|&corner| corner < self.line.len() && !run.is_finished())?;
        let before = corner.checked_sub(1)?;
        let (from, to) = (self.line[before], self.line[corner]);
        let length = (to - from).norm();
        let estimated = run.estimate().unwrap_or(run.pose()).position();
        let along = ((estimated - from).dot(&(to - from)) / length).clamp(0.0, length);
        // Rounding must not yield the previous cell at a corner that the robot has reached.
        let at = self.corners[before] + along + 1e-6;
        let index = self.arrivals.partition_point(|&arrival| arrival <= at).saturating_sub(1);
        let known = self.steps.partition_point(|step| step.step <= index);
        self.steps.get(known.checked_sub(1)?)
    }

    /// Why the walk ends before all is clean; `None` if it doesn't.
    pub fn ending(&self) -> Option<&TraceStep> {
        self.steps.last().filter(|step| step.rule == THE_END)
    }

    /// All decisions, in the order of the walk.
    pub fn steps(&self) -> &[TraceStep] {
        &self.steps
    }
}

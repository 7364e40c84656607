//! Input of a planner.

use robovac_core::{
    coverage::{PlanningGrid, ReachableFloor},
    grid::{Cell, Direction, Grid, reachable},
    robot::RobotModel,
};
use std::sync::Arc;

/// A grid to be covered from a start.
#[derive(Debug, Clone)]
pub struct CoverageJob {
    /// Free cells. Every one of them is connected with `start` by 4-neighbour steps.
    pub free: Grid<bool>,
    /// The start cell; free.
    pub start: Cell,
    /// The robot's heading at the start.
    pub heading: Direction,
    /// Time of one step straight on, s.
    pub step_s: f64,
    /// Time of a quarter turn, with braking and speeding up, s.
    pub turn_s: f64,
    /// The floor and the robot, for planners in metres; `None` for a bare grid.
    pub place: Option<Arc<JobPlace>>,
}

/// A robot on its floor.
#[derive(Debug, Clone)]
pub struct JobPlace {
    /// The floor, with the robot's start.
    pub floor: Arc<ReachableFloor>,
    /// The robot.
    pub robot: RobotModel,
    /// Whether corners of a path in metres will be rounded.
    pub is_rounded: bool,
}

impl CoverageJob {
    /// A job on a bare grid, for planners that walk from cell to cell, with the time of a step as the unit and a quarter turn as long as two.
    ///
    /// Cells that aren't connected with `start` are left out; `None` if `start` isn't free.
    pub fn new(free: &Grid<bool>, start: Cell, heading: Direction) -> Option<Self> {
        free.is_set(start).then(|| Self {
            free: reachable(free, start),
            start,
            heading,
            step_s: 1.0,
            turn_s: 2.0,
            place: None,
        })
    }

    /// The job of covering `planning_grid` with `robot`.
    pub fn on_planning_grid(planning_grid: &PlanningGrid, floor: &ReachableFloor, robot: &RobotModel) -> Self {
        let quarter = robot.turn_time(robovac_core::math::FRAC_PI_2);
        Self {
            free: planning_grid.free.clone(),
            start: planning_grid.start,
            heading: Direction::nearest(floor.start.heading),
            step_s: planning_grid.cells.size / robot.cruise_speed,
            turn_s: quarter + robot.cruise_speed / robot.acceleration,
            place: None,
        }
    }

    /// The same job for planners in metres, too.
    pub fn in_place(self, floor: &Arc<ReachableFloor>, robot: &RobotModel) -> Self {
        let place = JobPlace { floor: Arc::clone(floor), robot: robot.clone(), is_rounded: false };
        Self { place: Some(Arc::new(place)), ..self }
    }

    /// The same job for a robot that rounds corners, or stops at them.
    pub fn rounded(self, is_rounded: bool) -> Self {
        let place = self.place.map(|place| {
            if place.is_rounded == is_rounded { place } else { Arc::new(JobPlace { is_rounded, ..(*place).clone() }) }
        });
        Self { place, ..self }
    }

    /// Number of cells to be covered.
    pub fn cells(&self) -> usize {
        self.free.count()
    }
}

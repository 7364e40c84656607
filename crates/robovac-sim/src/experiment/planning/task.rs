//! Planning tasks of the command line, whose start in planning cells is used exactly or refused.

use super::{PlanRequest, Planned, PlanningError, RoomSetup};
use coverage_planners::{CoveragePath, Observer, PlannerInfo, smooth::SmoothSetup};
use robovac_core::{
    coverage::{FloorError, PlanningCells, ReachableFloor, fine_resolution},
    floor_plan::{FloorPlan, MAX_RESOLUTION},
    geometry::{Point, Pose, normalize},
    grid::Cell,
    registry::Params,
    robot::{RobotModel, cell_robot, model},
};

/// Id of the robot that fills one cell, whatever the cell's size.
pub const CELL_ROBOT: &str = "cell";

/// A robot in a room, with its start.
#[derive(Debug, Clone)]
pub struct Placement {
    /// The room.
    pub plan: FloorPlan,
    /// The robot.
    pub robot: RobotModel,
    /// The planning cells.
    pub cells: PlanningCells,
    /// The start; `None` for the plan's own, or else a corner.
    pub start: Option<GivenStart>,
    /// Degrees counter-clockwise from the right; `None` for 0 at a given start and the plan's own heading
    /// otherwise.
    pub heading_deg: Option<f64>,
}

/// Where a robot is to start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GivenStart {
    /// In the middle of a planning cell, or where the robot fits in it.
    Cell(Cell),
    /// At a point, m.
    Point(Point),
}

/// Everything that determines a walk.
#[derive(Debug, Clone)]
pub struct PlanningTask {
    /// Room and robot.
    pub placement: Placement,
    /// The planner.
    pub planner: &'static PlannerInfo,
    /// Its parameters.
    pub params: Params,
    /// Seed of its random numbers.
    pub seed: u64,
    /// Whether corners will be rounded.
    pub is_rounded: bool,
}

/// A walk with its setup and numbers.
#[derive(Debug, Clone)]
pub struct PlanSolution {
    /// The room laid out for the robot.
    pub prepared: RoomSetup,
    /// The walk.
    pub path: CoveragePath,
    /// Its line and numbers.
    pub planned: Planned,
    /// What rounding its corners may do.
    pub smooth: SmoothSetup,
}

/// The robot with that id and its planning cells in `plan`, m; `cell_size` overrides the default.
///
/// The grid robot has the size of a planning cell, which is a map cell by default: so it reaches exactly the free cells
/// that are connected with its start.
pub fn choose_robot(id: &str, plan: &FloorPlan, cell_size: Option<f64>) -> Option<(RobotModel, f64)> {
    if id == CELL_ROBOT {
        let side = cell_size.unwrap_or(plan.resolution);
        return Some((cell_robot(side), side));
    }
    model(id).map(|robot| (robot.clone(), cell_size.unwrap_or(robot.default_cell)))
}

impl PlanningTask {
    /// Plans a walk and computes its metrics. `clock` returns seconds since any moment, as the core has no clock of its
    /// own.
    pub fn solve(
        &self,
        clock: impl Fn() -> f64,
        observer: Option<Observer<'_>>,
    ) -> Result<PlanSolution, PlanningError> {
        let prepared = self.placement.prepare()?;
        let request = PlanRequest {
            id: 0,
            planner: self.planner,
            params: self.params.clone(),
            seed: self.seed,
            job: prepared.job.clone().rounded(self.is_rounded),
        };
        let answer = request.serve(clock, observer)?;
        let planned = Planned::new(&prepared, &answer)
            .map_err(|error| PlanningError::BadPath { planner: self.planner.id, error })?;
        Ok(PlanSolution { prepared, path: answer.path, planned, smooth: request.smooth_setup() })
    }
}

impl Placement {
    /// The room laid out for the robot, after checking all inputs.
    ///
    /// A given start cell is used exactly or refused.
    pub fn prepare(&self) -> Result<RoomSetup, PlanningError> {
        Ok(RoomSetup::on(&self.plan, self.floor()?, &self.robot, self.cells))
    }

    /// The floor as reached from the start, after checking all inputs.
    fn floor(&self) -> Result<ReachableFloor, PlanningError> {
        // Cells without a fine cell's centre would disconnect the planning grid.
        let least = fine_resolution(&self.plan);
        if !(least * (1.0 - 1e-9)..=MAX_RESOLUTION).contains(&self.cells.size) {
            return Err(PlanningError::CellSize { cell_size: self.cells.size, least });
        }
        if let Some(heading) = self.heading_deg.filter(|deg| !deg.is_finite()) {
            return Err(PlanningError::Heading(heading));
        }
        let mut floor = match self.start {
            None => ReachableFloor::new(&self.plan, &self.robot, None)?,
            Some(GivenStart::Cell(cell)) => self.floor_from(cell)?,
            Some(GivenStart::Point(at)) => self.floor_at(at)?,
        };
        if let Some(degrees) = self.heading_deg {
            floor.start.heading = normalize((degrees % 360.0).to_radians());
        }
        Ok(floor)
    }

    fn floor_from(&self, start: Cell) -> Result<ReachableFloor, PlanningError> {
        let (width, height) = (self.cells_along(0), self.cells_along(1));
        if !(0..width as i32).contains(&start.x) || !(0..height as i32).contains(&start.y) {
            return Err(PlanningError::StartOutside { start, width, height });
        }
        let floor = match self.floor_at(self.centre_of(start)) {
            Err(FloorError::StartInWall { free_x, free_y, .. }) => {
                // A table leg in the middle of a cell doesn't make the whole cell a wall.
                let place = Point::new(free_x, free_y);
                let nearest = self.cell_of(place);
                if nearest != start {
                    return Err(PlanningError::StartInWall { start, nearest });
                }
                self.floor_at(place)?
            }
            floor => floor?,
        };
        let nearest = self.cell_of(floor.start.position());
        if nearest != start {
            let diameter = 2.0 * self.robot.radius;
            return Err(PlanningError::StartTooTight { start, nearest, diameter });
        }
        Ok(floor)
    }

    fn floor_at(&self, start: Point) -> Result<ReachableFloor, FloorError> {
        ReachableFloor::new(&self.plan, &self.robot, Some(Pose::new(start.x, start.y, 0.0)))
    }

    /// Columns or rows (`axis` 0 or 1) of planning cells; the last one can extend beyond the map.
    fn cells_along(&self, axis: usize) -> usize {
        self.cells.along(axis, [self.plan.width_m(), self.plan.height_m()][axis])
    }

    fn cell_of(&self, point: Point) -> Cell {
        let cell = self.cells.at(point);
        let within = |index: i32, axis: usize| index.min(self.cells_along(axis) as i32 - 1);
        Cell::new(within(cell.x, 0), within(cell.y, 1))
    }

    /// Centre of a planning cell; for one that extends beyond the map, of its part inside.
    fn centre_of(&self, cell: Cell) -> Point {
        let low = self.cells.corner(cell);
        let centre = |low: f64, length: f64| f64::midpoint(low.max(0.0), (low + self.cells.size).min(length));
        Point::new(centre(low.x, self.plan.width_m()), centre(low.y, self.plan.height_m()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::planning::PlanReport;
    use coverage_planners::PlanError;
    use robovac_core::floor_plan::{SourceFile, load, room};
    use std::cell::Cell as Shared;

    fn snake() -> &'static PlannerInfo {
        coverage_planners::find("snake").unwrap()
    }

    fn text_map(text: &str) -> FloorPlan {
        load(&[SourceFile { name: "test.txt".into(), bytes: text.into() }]).unwrap()
    }

    fn planned(
        plan: &FloorPlan,
        robot: &str,
        cell: Option<f64>,
        start: Option<(i32, i32)>,
    ) -> Result<PlanReport, PlanningError> {
        let (robot, cell_size) = choose_robot(robot, plan, cell).unwrap();
        let start = start.map(|(x, y)| GivenStart::Cell(Cell::new(x, y)));
        let task = PlanningTask {
            placement: Placement { plan: plan.clone(), robot, cells: cell_size.into(), start, heading_deg: None },
            planner: snake(),
            params: Params::default(),
            seed: 0,
            is_rounded: false,
        };
        task.solve(|| 0.0, None).map(|solution| PlanReport::new(&task, solution))
    }

    #[test]
    fn grid_robot_covers_exactly_the_connected_free_cells_of_every_room() {
        for id in ["flat", "thesis8", "room12ft", "maze", "office"] {
            let plan = (room(id).unwrap().build)();
            let report = planned(&plan, CELL_ROBOT, None, None).unwrap();
            let free = plan.occupancy.values().iter().filter(|o| o.is_free()).count();
            assert_eq!((report.drive.coverage, report.walk.unwrap().reachable_cells), (1.0, free), "{id}");
            assert_eq!(
                (report.task.room.width, report.task.room.height),
                (plan.occupancy.width(), plan.occupancy.height())
            );
        }
    }

    #[test]
    fn roomba_covers_most_of_every_room_on_its_own_lattice() {
        for info in robovac_core::floor_plan::ROOMS {
            let report = planned(&(info.build)(), "roomba600", None, None).unwrap();
            let coverage = report.drive.coverage;
            assert!(coverage > 0.85, "{}: {coverage}", info.id);
        }
    }

    #[test]
    fn start_is_kept_or_refused_but_never_moved() {
        let plan = text_map("; resolution 0.2\n....\n.##.\n....\n....\n");
        for start in [(0, 0), (3, 3), (2, 1)] {
            let report = planned(&plan, CELL_ROBOT, None, Some(start)).unwrap();
            assert_eq!(
                (report.task.start, report.cells[0]),
                (Cell::new(start.0, start.1), Cell::new(start.0, start.1))
            );
        }
        let message = |robot, cell, start| planned(&plan, robot, cell, Some(start)).unwrap_err().to_string();
        assert_eq!(
            message(CELL_ROBOT, None, (1, 2)),
            "the start cell (1, 2) is inside a wall; the nearest cell where the robot fits is (1, 1)"
        );
        assert_eq!(
            message(CELL_ROBOT, None, (4, 0)),
            "the start cell (4, 0) lies outside the planning grid of 4 x 4 cells; \
             choose x from 0 to 3, y from 0 to 3 (counted from the lower left)"
        );
        assert!(message(CELL_ROBOT, None, (0, -1)).contains("outside"));
        let wide = text_map("; resolution 0.2\n....\n....\n....\n");
        let error = planned(&wide, "roomba600", Some(0.1), Some((0, 0))).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the robot, 0.35 m wide, doesn't fit into the start cell (0, 0); the nearest cell where it fits is (1, 1)"
        );
        assert!(planned(&wide, "roomba600", Some(0.1), Some((1, 1))).is_ok());
    }

    #[test]
    fn wall_in_the_middle_of_a_cell_leaves_the_cell_usable() {
        let plan = text_map("; resolution 0.1\n...\n.#.\n...\n");
        let fine = planned(&plan, CELL_ROBOT, None, Some((1, 1))).unwrap_err();
        assert!(matches!(fine, PlanningError::StartInWall { .. }), "{fine}");
        let (robot, _) = choose_robot(CELL_ROBOT, &plan, None).unwrap();
        let task = PlanningTask {
            placement: Placement {
                plan: plan.clone(),
                robot,
                cells: 0.3.into(),
                start: Some(GivenStart::Cell(Cell::new(0, 0))),
                heading_deg: Some(-450.0),
            },
            planner: snake(),
            params: Params::default(),
            seed: 0,
            is_rounded: false,
        };
        let report = PlanReport::new(&task, task.solve(|| 0.0, None).unwrap());
        assert_eq!((report.task.start, report.walk.unwrap().steps), (Cell::new(0, 0), 0));
        assert!((report.task.heading_deg + 90.0).abs() < 1e-9, "{}", report.task.heading_deg);
    }

    #[test]
    fn cells_that_dont_suit_are_refused() {
        let plan = text_map("; resolution 0.2\n....\n....\n....\n");
        for cell in [0.0, -0.2, f64::NAN, f64::INFINITY, 0.01, 1e9] {
            let error = planned(&plan, "roomba600", Some(cell), None).unwrap_err();
            assert!(matches!(error, PlanningError::CellSize { .. }), "{cell}: {error}");
            assert!(planned(&plan, CELL_ROBOT, Some(cell), None).is_err(), "{cell}");
        }
    }

    #[test]
    fn time_is_the_callers_and_cancelling_reaches_the_planner() {
        let plan = text_map("....\n....\n");
        let (robot, cell_size) = choose_robot(CELL_ROBOT, &plan, None).unwrap();
        let task = PlanningTask {
            placement: Placement { plan: plan.clone(), robot, cells: cell_size.into(), start: None, heading_deg: None },
            planner: snake(),
            params: Params::default(),
            seed: 0,
            is_rounded: false,
        };
        let now = Shared::new(10.0);
        let clock = || now.replace(now.get() + 2.5);
        assert_eq!(task.solve(clock, None).unwrap().planned.planning_s, 2.5);
        let mut stop = |_: coverage_planners::ProgressReport<'_>| std::ops::ControlFlow::Break(());
        assert_eq!(task.solve(|| 0.0, Some(&mut stop)).unwrap_err(), PlanningError::Plan(PlanError::Cancelled));
    }
}

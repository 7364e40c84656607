//! From a floor plan to a checked walk with its numbers: what "plan" means on the page and on the command line.

use crate::{
    coverage::{FloorError, Lattice, ReachableFloor},
    floorplan::{FloorPlan, MAX_RESOLUTION, MIN_RESOLUTION},
    geometry::{Point, Pose, normalize},
    grid::Cell,
    metrics::{DriveMetrics, WalkMetrics},
    planner::{CoverageJob, CoveragePath, Observer, Params, PathError, PlanContext, PlanError, PlannerInfo},
    robot::{RobotModel, cell_robot, model},
};
use serde::Serialize;

/// Id of the robot that fills one cell, whatever the cell's size.
pub const CELL_ROBOT: &str = "cell";

/// All that determines a walk.
#[derive(Debug, Clone)]
pub struct PlanningTask {
    /// The room.
    pub plan: FloorPlan,
    /// The robot.
    pub robot: RobotModel,
    /// Side of the planning cells, m.
    pub cell_size: f64,
    /// Planning cell to start in; the plan's own start if `None`, or else a corner.
    pub start: Option<Cell>,
    /// Degrees counter-clockwise from the right; if `None`, 0 in a given start cell and the plan's own heading else.
    pub heading_deg: Option<f64>,
    /// The planner.
    pub planner: &'static PlannerInfo,
    /// Its parameters.
    pub params: Params,
    /// Seed of its random numbers.
    pub seed: u64,
}

/// A walk with everything that it was planned on.
#[derive(Debug, Clone)]
pub struct Planned {
    /// The floor that the robot can reach.
    pub floor: ReachableFloor,
    /// The planning cells on it.
    pub lattice: Lattice,
    /// What the planner was asked.
    pub job: CoverageJob,
    /// What it answered.
    pub path: CoveragePath,
    /// The numbers.
    pub report: PlanReport,
}

/// What was asked for, as written by the command line at the head of every answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TaskReport {
    /// Id of the planner.
    pub planner: &'static str,
    /// All its parameters.
    pub params: Params,
    /// Seed of its random numbers.
    pub seed: u64,
    /// The room in planning cells.
    pub room: RoomReport,
    /// Id of the robot.
    pub robot: &'static str,
    /// The planning cell that the walk starts in.
    pub start: Cell,
    /// Heading at the start, degrees counter-clockwise from the right.
    pub heading_deg: f64,
}

/// Numbers of a walk, as written by the command line.
#[derive(Debug, Clone, Serialize)]
pub struct PlanReport {
    /// What was asked for.
    #[serde(flatten)]
    pub task: TaskReport,
    /// The walk over planning cells, `[x, y]` with x right and y up from the lower-left one, the start included.
    pub cells: Vec<Cell>,
    /// Swept share of the reachable floor, 0 to 1.
    pub coverage: f64,
    /// Planning cells that can be reached from the start, the start included.
    pub reachable_cells: usize,
    /// Steps from cell to cell.
    pub steps: usize,
    /// Quarter turns between consecutive steps; a reversal counts two.
    pub turns: usize,
    /// Quarter turns before the first step; not part of `turns`.
    pub initial_turns: usize,
    /// Visits to cells beyond the first to each.
    pub revisits: usize,
    /// Area swept again, as a share of the area swept.
    pub overlap: f64,
    /// Length of the line that the robot drives, m.
    pub length_m: f64,
    /// Sum of its turns, degrees, the one at the start included.
    pub turning_deg: f64,
    /// Time to drive it by the robot's motion model, s.
    pub duration_s: f64,
    /// Time that the planner took, s.
    pub planning_s: f64,
}

/// The planning grid of a room.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoomReport {
    /// Name of the room.
    pub name: String,
    /// Columns of planning cells.
    pub width: usize,
    /// Rows of planning cells.
    pub height: usize,
    /// Side of a planning cell, m.
    pub resolution_m: f64,
}

/// Why there is no walk.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanningError {
    /// No planning cells of that size can be laid over this map.
    #[error("planning cells of {cell_size} m don't suit this map; choose a side from {least} m to {MAX_RESOLUTION} m")]
    CellSize {
        /// The side asked for, m.
        cell_size: f64,
        /// Smallest side that would do, m.
        least: f64,
    },
    /// The heading isn't a number.
    #[error("the heading can't be {0}; give degrees, counter-clockwise from 0 = right")]
    Heading(f64),
    /// The start lies outside.
    #[error(
        "the start cell {start} lies outside the planning grid of {width} x {height} cells; \
         choose x from 0 to {}, y from 0 to {} (counted from the lower left)", width - 1, height - 1
    )]
    StartOutside {
        /// The cell asked for.
        start: Cell,
        /// Columns of planning cells.
        width: usize,
        /// Rows of planning cells.
        height: usize,
    },
    /// The start lies in a wall.
    #[error("the start cell {start} is inside a wall; the nearest cell where the robot fits is {nearest}")]
    StartInWall {
        /// The cell asked for.
        start: Cell,
        /// The nearest one that would do.
        nearest: Cell,
    },
    /// The robot doesn't fit between the walls around the start.
    #[error(
        "the robot, {diameter:.2} m wide, doesn't fit into the start cell {start}; the nearest where it does is {nearest}"
    )]
    StartTooTight {
        /// The cell asked for.
        start: Cell,
        /// The nearest one that would do.
        nearest: Cell,
        /// Diameter of the robot, m.
        diameter: f64,
    },
    /// The robot can't be put into the room.
    #[error(transparent)]
    Floor(#[from] FloorError),
    /// The planner gave up.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The planner is wrong.
    #[error("planner \"{planner}\" returned a walk that can't be driven: {error}; please report this with the map")]
    BadPath {
        /// Id of the planner.
        planner: &'static str,
        /// What is wrong with its walk.
        error: PathError,
    },
}

/// The robot with that id and the planning cells that it gets in `plan`, m, unless `cell_size` says otherwise.
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

/// Plans a walk and measures it. `clock` tells seconds since any moment, as the core has no clock of its own.
///
/// A start cell that was asked for is kept or refused, never moved.
pub fn run(
    task: &PlanningTask,
    clock: impl Fn() -> f64,
    observer: Option<Observer<'_>>,
) -> Result<Planned, PlanningError> {
    let floor = task.floor()?;
    let lattice = Lattice::new(&floor, task.cell_size);
    let job = CoverageJob::on_lattice(&lattice, &floor, &task.robot);
    let planner = (task.planner.build)(&task.params);
    let mut ctx = match observer {
        Some(observer) => PlanContext::observed(task.seed, observer),
        None => PlanContext::new(task.seed),
    };
    let begin = clock();
    let path = planner.plan(&job, &mut ctx)?;
    let planning_s = (clock() - begin).max(0.0);
    path.check(&job).map_err(|error| PlanningError::BadPath { planner: task.planner.id, error })?;
    let walk = WalkMetrics::of(&job, &path);
    let drive = DriveMetrics::of(&floor, &lattice, &task.robot, &path);
    let head = TaskReport {
        planner: task.planner.id,
        params: task.params.clone(),
        seed: task.seed,
        room: RoomReport {
            name: task.plan.name.clone(),
            width: lattice.free.width(),
            height: lattice.free.height(),
            resolution_m: task.cell_size,
        },
        robot: task.robot.id,
        start: job.start,
        heading_deg: floor.start.heading.to_degrees(),
    };
    let report = PlanReport {
        task: head,
        cells: path.cells.clone(),
        coverage: drive.coverage,
        reachable_cells: walk.reachable_cells,
        steps: walk.steps,
        turns: walk.turns,
        initial_turns: walk.initial_turns,
        revisits: walk.revisits,
        overlap: drive.overlap,
        length_m: drive.length_m,
        turning_deg: drive.turning_deg,
        duration_s: drive.duration_s,
        planning_s,
    };
    Ok(Planned { floor, lattice, job, path, report })
}

impl PlanningTask {
    /// The floor as reached from the start, with everything checked that was asked for.
    fn floor(&self) -> Result<ReachableFloor, PlanningError> {
        if !(MIN_RESOLUTION..=MAX_RESOLUTION).contains(&self.cell_size) {
            return Err(PlanningError::CellSize { cell_size: self.cell_size, least: self.plan.resolution });
        }
        if let Some(heading) = self.heading_deg.filter(|deg| !deg.is_finite()) {
            return Err(PlanningError::Heading(heading));
        }
        let mut floor = match self.start {
            None => ReachableFloor::new(&self.plan, &self.robot, None)?,
            Some(cell) => self.floor_from(cell)?,
        };
        // Cells without a fine cell's centre in them would tear the planning grid apart.
        if self.cell_size < floor.resolution * (1.0 - 1e-9) {
            return Err(PlanningError::CellSize { cell_size: self.cell_size, least: floor.resolution });
        }
        if let Some(degrees) = self.heading_deg {
            floor.start.heading = normalize((degrees % 360.0).to_radians());
        }
        Ok(floor)
    }

    fn floor_from(&self, start: Cell) -> Result<ReachableFloor, PlanningError> {
        let (width, height) = (self.cells_along(self.plan.width_m()), self.cells_along(self.plan.height_m()));
        if !(0..width as i32).contains(&start.x) || !(0..height as i32).contains(&start.y) {
            return Err(PlanningError::StartOutside { start, width, height });
        }
        let stand = |at: Point| ReachableFloor::new(&self.plan, &self.robot, Some(Pose::new(at.x, at.y, 0.0)));
        let floor = match stand(self.centre_of(start)) {
            Err(FloorError::StartInWall { free_x, free_y, .. }) => {
                // A table leg in the middle of a cell doesn't make the whole cell a wall.
                let place = Point::new(free_x, free_y);
                let nearest = self.cell_of(place);
                if nearest != start {
                    return Err(PlanningError::StartInWall { start, nearest });
                }
                stand(place)?
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

    /// Planning cells along `length` metres; the last one may stick out.
    fn cells_along(&self, length: f64) -> usize {
        ((length / self.cell_size - 1e-6).ceil() as usize).max(1)
    }

    fn cell_of(&self, point: Point) -> Cell {
        let index =
            |metres: f64, length: f64| ((metres / self.cell_size) as i32).min(self.cells_along(length) as i32 - 1);
        Cell::new(index(point.x, self.plan.width_m()), index(point.y, self.plan.height_m()))
    }

    /// Centre of a planning cell, of its part inside the map for one that sticks out.
    fn centre_of(&self, cell: Cell) -> Point {
        let centre = |index: i32, length: f64| {
            let low = f64::from(index) * self.cell_size;
            f64::midpoint(low, (low + self.cell_size).min(length))
        };
        Point::new(centre(cell.x, self.plan.width_m()), centre(cell.y, self.plan.height_m()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        floorplan::{SourceFile, load, room},
        grid::Grid,
        planner::{Claims, Planner},
    };
    use std::cell::Cell as Shared;

    /// Depth first, and back the way it came.
    struct DepthFirst;

    impl Planner for DepthFirst {
        fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
            let mut seen = Grid::filled(job.free.width(), job.free.height(), false);
            let (mut trail, mut cells) = (vec![job.start], vec![job.start]);
            while let Some(&cell) = trail.last() {
                ctx.checkpoint(cells.len() as f64 / (2 * job.cells()) as f64, &cells)?;
                seen[cell] = true;
                match cell.neighbours().into_iter().find(|&next| job.free.is_set(next) && !seen[next]) {
                    Some(next) => trail.push(next),
                    None => drop(trail.pop()),
                }
                cells.extend(trail.last());
            }
            Ok(CoveragePath { cells })
        }
    }

    static PLANNER: PlannerInfo = PlannerInfo {
        id: "depth_first",
        title: "Depth first",
        summary: "",
        source: "",
        link: "",
        claims: Claims { complete: true, deterministic: true },
        params: &[],
        build: |_| Box::new(DepthFirst),
    };

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
        let task = PlanningTask {
            plan: plan.clone(),
            robot,
            cell_size,
            start: start.map(|(x, y)| Cell::new(x, y)),
            heading_deg: None,
            planner: &PLANNER,
            params: Params::default(),
            seed: 0,
        };
        run(&task, || 0.0, None).map(|planned| planned.report)
    }

    #[test]
    fn grid_robot_covers_exactly_the_connected_free_cells_of_every_room() {
        for id in ["flat", "thesis8", "room12ft", "maze", "office"] {
            let plan = (room(id).unwrap().build)();
            let report = planned(&plan, CELL_ROBOT, None, None).unwrap();
            let free = plan.occupancy.values().iter().filter(|o| o.is_free()).count();
            assert_eq!((report.coverage, report.reachable_cells), (1.0, free), "{id}");
            assert_eq!(
                (report.task.room.width, report.task.room.height),
                (plan.occupancy.width(), plan.occupancy.height())
            );
        }
    }

    #[test]
    fn roomba_covers_most_of_every_room_on_its_own_lattice() {
        for info in crate::floorplan::ROOMS {
            let report = planned(&(info.build)(), "roomba600", None, None).unwrap();
            println!("{} {:.3}", info.id, report.coverage);
            assert!(report.coverage > 0.85, "{}: {}", info.id, report.coverage);
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
        assert_eq!(
            message("roomba600", Some(0.1), (0, 0)),
            "the robot, 0.35 m wide, doesn't fit into the start cell (0, 0); the nearest where it does is (1, 1)"
        );
    }

    #[test]
    fn wall_in_the_middle_of_a_cell_leaves_the_cell_usable() {
        let plan = text_map("; resolution 0.1\n...\n.#.\n...\n");
        let fine = planned(&plan, CELL_ROBOT, None, Some((1, 1))).unwrap_err();
        assert!(matches!(fine, PlanningError::StartInWall { .. }), "{fine}");
        let (robot, _) = choose_robot(CELL_ROBOT, &plan, None).unwrap();
        let task = PlanningTask {
            plan: plan.clone(),
            robot,
            cell_size: 0.3,
            start: Some(Cell::new(0, 0)),
            heading_deg: Some(-450.0),
            planner: &PLANNER,
            params: Params::default(),
            seed: 0,
        };
        let report = run(&task, || 0.0, None).unwrap().report;
        assert_eq!((report.task.start, report.steps), (Cell::new(0, 0), 0));
        assert!((report.task.heading_deg + 90.0).abs() < 1e-9, "{}", report.task.heading_deg);
    }

    #[test]
    fn cells_that_dont_suit_are_refused() {
        let plan = text_map("; resolution 0.2\n....\n....\n");
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
            plan: plan.clone(),
            robot,
            cell_size,
            start: None,
            heading_deg: None,
            planner: &PLANNER,
            params: Params::default(),
            seed: 0,
        };
        let now = Shared::new(10.0);
        let clock = || now.replace(now.get() + 2.5);
        assert_eq!(run(&task, clock, None).unwrap().report.planning_s, 2.5);
        let mut stop = |_: f64, _: &[Cell]| std::ops::ControlFlow::Break(());
        assert_eq!(run(&task, || 0.0, Some(&mut stop)).unwrap_err(), PlanningError::Plan(PlanError::Cancelled));
    }
}

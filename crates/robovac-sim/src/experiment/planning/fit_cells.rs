//! Chooses the planning cells for the coverage that a plan is to reach.

use super::{GivenStart, PlanRequest, Planned, PlanningError, PlanningTask, RoomSetup};
use coverage_planners::{CoverageJob, PlanError, PlannerInfo, lanes::swept_share};
use robovac_core::{
    coverage::{PlanningCells, PlanningGrid},
    registry::{ParamKind, ParamSpec, ParamValue, Params},
};
use std::{cmp::Ordering, ops::ControlFlow, sync::Arc};

/// Smallest and largest side of cells tried, as shares of the tool's width.
const SIDES: (f64, f64) = (0.45, 1.05);
/// Step from one side to the next, m: lanes move along the walls by far more than that, so that every side also has other
/// distances from them.
const STEP: f64 = 0.0025;
/// Sides for which other offsets are tried, and these, as shares of a side in each direction.
const PROMISING: usize = 6;
const OFFSETS: [f64; 3] = [0.0, 1.0 / 3.0, 2.0 / 3.0];
/// An offset can add that share of the floor: sides that fall short by less are promising, too.
const NEAR: f64 = 0.01;
/// How many of the best are planned with the planner's own effort, and with rounded corners.
const FINALS: usize = 4;
/// What rounded corners may leave out, as a share of the floor.
const ROUNDED: f64 = 0.001;
/// Free cells beyond which fewer are tried, so that the choice doesn't take minutes.
const MANY: usize = 60_000;

/// Planning cells that suit a coverage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedCells {
    /// Their side and where they begin.
    pub cells: PlanningCells,
    /// The share of the floor that the plan sweeps, 0 to 1, by [`swept_share`].
    pub coverage: f64,
    /// The plan's time, s: with rounded corners if these were asked for.
    pub duration_s: f64,
}

impl RoomSetup {
    /// The same room with those planning cells; a number is their side, m.
    pub fn with_cells(&self, cells: impl Into<PlanningCells>) -> Self {
        let planning_grid = PlanningGrid::new(&self.floor, cells);
        let job =
            CoverageJob::on_planning_grid(&planning_grid, &self.floor, &self.robot).in_place(&self.floor, &self.robot);
        Self { planning_grid: Arc::new(planning_grid), job, ..self.clone() }
    }

    /// The planning cells with which `planner` sweeps the share `coverage`, 0 to 1, in the least time; if none reach it, those
    /// with which it sweeps most. First sides are tried, from the room's corner, then other offsets for the promising ones.
    /// Planners that search do so with the least effort, fast ones in the end with their own. Where `is_rounded`, the time of
    /// the best few with rounded corners decides. There is no choice for planners in metres, which need no cells, and for a robot
    /// that fills a cell.
    ///
    /// `observe` gets the share that is done and returns whether to continue.
    pub fn fit_cells(
        &self,
        planner: &'static PlannerInfo,
        params: &Params,
        seed: u64,
        coverage: f64,
        is_rounded: bool,
        observe: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<FittedCells, PlanningError> {
        if planner.is_in_metres() {
            return Err(PlanningError::NeedsNoCells { planner: planner.id });
        }
        if self.robot.fills_cell {
            return Err(PlanningError::FillsItsCells);
        }
        if !(0.0..=1.0).contains(&coverage) {
            return Err(PlanningError::Coverage(coverage));
        }
        let quick = with_least_effort(planner, params);
        let least = SIDES.0 * self.robot.tool_width;
        // Finer cells than those of the floor contain none of its centres.
        let least = least.max(self.floor.resolution);
        let most = (SIDES.1 * self.robot.tool_width).max(least);
        let cells = self.floor.area() / (least * most);
        let many = (cells / MANY as f64).max(1.0);
        let step = STEP * many;
        let count = ((most - least) / step) as u32;
        let promising = (PROMISING as f64 / many).ceil() as usize;
        let (mut done, all) = (0, count as usize + 1 + promising * (OFFSETS.len().pow(2) - 1));
        // A planner that fails with some cells may not with others.
        let mut failed = PlanError::Unlisted;
        let mut try_all = |lattices: &[PlanningCells], tried: &mut Vec<FittedCells>| {
            for &cells in lattices {
                if observe(f64::from(done) / all as f64).is_break() {
                    return Err(PlanError::Cancelled);
                }
                done += 1;
                match self.with_cells(cells).try_cells(planner, &quick, seed, false) {
                    Ok(found) => tried.push(found),
                    Err(error) => failed = error,
                }
            }
            Ok(())
        };
        let mut tried = Vec::new();
        let sides: Vec<PlanningCells> = (0..=count).map(|i| short(most - f64::from(i) * step).into()).collect();
        try_all(&sides, &mut tried)?;
        let reached = tried.iter().map(|found| found.coverage).fold(0.0, f64::max);
        tried.sort_by(|a, b| a.compare(b, coverage.min(reached) - NEAR));
        let moved: Vec<PlanningCells> = tried.iter().take(promising).flat_map(|found| moved(found.cells)).collect();
        try_all(&moved, &mut tried)?;
        tried.sort_by(|a, b| a.compare(b, coverage));
        let Some(&first) = tried.first() else { return Err(failed.into()) };
        // With its effort, a plan can sweep a little less.
        let effort = if planner.claims.fast { params } else { &quick };
        if *effort == quick && !is_rounded {
            return Ok(first);
        }
        let mut finals: Vec<PlanningCells> = tried.iter().take(FINALS).map(|found| found.cells).collect();
        if is_rounded {
            tried.sort_by(|a, b| a.compare(b, coverage + ROUNDED));
            let spare = tried.iter().take(FINALS).map(|found| found.cells).filter(|cells| !finals.contains(cells));
            finals.extend(spare.collect::<Vec<_>>());
        }
        let finals = finals
            .into_iter()
            .filter_map(|cells| self.with_cells(cells).try_cells(planner, effort, seed, is_rounded).ok());
        Ok(finals.min_by(|a, b| a.compare(b, coverage)).unwrap_or(first))
    }

    fn try_cells(
        &self,
        planner: &'static PlannerInfo,
        params: &Params,
        seed: u64,
        is_rounded: bool,
    ) -> Result<FittedCells, PlanError> {
        let request = PlanRequest { id: 0, planner, params: params.clone(), seed, job: self.job.clone() };
        let answer = request.serve(|| 0.0, None)?;
        // A planner that returns no walk finds none with other cells either.
        let planned = Planned::new(self, &answer).map_err(|_| PlanError::Unlisted)?;
        let cells = self.planning_grid.cells;
        // A robot that can't round corners stops at them.
        if is_rounded && let Ok(smooth) = self.smooth(&planned.line, &request.smooth_setup(), false) {
            return Ok(FittedCells { cells, coverage: smooth.coverage, duration_s: smooth.trajectory.duration_s() });
        }
        let coverage = swept_share(&self.floor, &planned.line);
        Ok(FittedCells { cells, coverage, duration_s: planned.drive.duration_s })
    }
}

impl PlanningTask {
    /// Sets the planning cells with which the planner sweeps the share `coverage`, 0 to 1, in the least time, or most of it; see
    /// [`RoomSetup::fit_cells`]. A given start cell is one of the cells before; the robot starts in the same place.
    pub fn fit_cells(
        &mut self,
        coverage: f64,
        observe: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<FittedCells, PlanningError> {
        let room = self.placement.prepare()?;
        let fitted = room.fit_cells(self.planner, &self.params, self.seed, coverage, self.is_rounded, observe)?;
        self.placement.cells = fitted.cells;
        self.placement.start = self.placement.start.map(|_| GivenStart::Point(room.floor.start.position()));
        Ok(fitted)
    }
}

impl FittedCells {
    /// What suits a required coverage better comes first.
    fn compare(&self, other: &Self, required: f64) -> Ordering {
        match (self.coverage >= required, other.coverage >= required) {
            (true, true) => self.duration_s.total_cmp(&other.duration_s),
            (false, false) => other.coverage.total_cmp(&self.coverage),
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
        }
    }
}

/// In whole tenths of a millimetre, as it stands in links.
fn short(metres: f64) -> f64 {
    (metres * 1e4).round() / 1e4
}

/// The same cells with the other offsets.
fn moved(cells: PlanningCells) -> impl Iterator<Item = PlanningCells> {
    let places = OFFSETS.into_iter().flat_map(|y| OFFSETS.map(|x| [x, y]));
    places.skip(1).map(move |shares| PlanningCells { offset: shares.map(|share| short(share * cells.size)), ..cells })
}

fn with_least_effort(planner: &PlannerInfo, params: &Params) -> Params {
    let mut params = params.clone();
    if let Some(&ParamSpec { id, kind: ParamKind::Number { min, .. }, .. }) = planner.effort() {
        // The least is in range.
        let _ = params.set(planner.params, id, ParamValue::Number(min));
    }
    params
}

#[cfg(test)]
mod tests {
    use super::{super::Placement, *};
    use coverage_planners::find;
    use robovac_core::{floor_plan::generate::random_flat, grid::Cell, robot::model};

    fn room(robot: &str) -> RoomSetup {
        let robot = model(robot).unwrap();
        RoomSetup::new(&random_flat(1, 1, 2), robot, robot.default_cell, None).unwrap()
    }

    // slow: two dozen plans for each coverage
    #[test]
    fn cells_are_as_coarse_as_the_coverage_allows() {
        let room = room("roomba600");
        let planner = find("boustrophedon").unwrap();
        let params = Params::defaults(planner.params);
        let fit = |coverage| {
            room.fit_cells(planner, &params, 1, coverage, false, &mut |_| ControlFlow::Continue(())).unwrap()
        };
        let [some, much, all] = [0.9, 0.97, 1.0].map(fit);
        assert!(some.coverage >= 0.9 && much.coverage >= 0.97, "{some:?} {much:?}");
        assert!(some.duration_s < much.duration_s && some.cells.size > much.cells.size, "{some:?} {much:?}");
        assert!(all.coverage < 1.0 && all.coverage >= much.coverage, "as much as can be: {all:?}");
        // It is the plan that these cells give.
        let again = room.with_cells(much.cells).try_cells(planner, &params, 1, false);
        assert_eq!(again.unwrap().duration_s, much.duration_s);
    }

    // slow: some dozen plans
    #[test]
    fn other_offsets_and_rounded_corners_take_less_time() {
        let room = room("roomba600");
        let planner = find("boustrophedon").unwrap();
        let params = Params::defaults(planner.params);
        let fit =
            |rounds| room.fit_cells(planner, &params, 1, 0.97, rounds, &mut |_| ControlFlow::Continue(())).unwrap();
        let (stops, rounded) = (fit(false), fit(true));
        let at_corner: Vec<FittedCells> = (0..=40)
            .map(|i| short(SIDES.1 * room.robot.tool_width - f64::from(i) * STEP))
            .filter_map(|side| room.with_cells(side).try_cells(planner, &params, 1, false).ok())
            .collect();
        let best = at_corner.into_iter().min_by(|a, b| a.compare(b, 0.97)).unwrap();
        assert!(stops.coverage >= 0.97 && rounded.coverage >= 0.97, "{stops:?} {rounded:?}");
        assert!(stops.duration_s <= best.duration_s, "{stops:?} {best:?}");
        assert!(rounded.duration_s < 0.95 * stops.duration_s, "{rounded:?} {stops:?}");
        let with_curves = room.with_cells(rounded.cells).try_cells(planner, &params, 1, true).unwrap();
        assert_eq!(with_curves, rounded);
    }

    #[test]
    fn there_is_no_choice_without_cells_and_when_cancelled() {
        let go_on = &mut |_: f64| ControlFlow::Continue(());
        let mut error = |robot, planner: &str, share| {
            let planner = find(planner).unwrap();
            room(robot).fit_cells(planner, &Params::defaults(planner.params), 1, share, false, go_on).unwrap_err()
        };
        assert_eq!(error("roomba600", "lanes", 0.9), PlanningError::NeedsNoCells { planner: "lanes" });
        assert_eq!(error("cell", "snake", 0.9), PlanningError::FillsItsCells);
        let wrong = error("roomba600", "snake", 1.01);
        assert_eq!(wrong.to_string(), "the coverage can't be 101 %; give a number from 0 to 100");
        let planner = find("snake").unwrap();
        let mut asked = 0;
        let mut cancel = |_: f64| {
            asked += 1;
            if asked == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let params = Params::defaults(planner.params);
        let cancelled = room("roomba600").fit_cells(planner, &params, 1, 0.9, false, &mut cancel);
        assert_eq!(cancelled, Err(PlanningError::Plan(PlanError::Cancelled)));
        assert_eq!(asked, 3);
    }

    // slow: some dozen plans
    #[test]
    fn a_start_in_the_default_cells_is_the_same_place_in_the_fitted_ones() {
        let robot = model("roomba600").unwrap().clone();
        let cells = robot.default_cell.into();
        let start = Some(GivenStart::Cell(Cell::new(3, 6)));
        let placement = Placement { plan: random_flat(1, 1, 2), robot, cells, start, heading_deg: Some(90.0) };
        let planner = find("snake").unwrap();
        let params = Params::defaults(planner.params);
        let mut task = PlanningTask { placement, planner, params, seed: 1, is_rounded: false };
        let pose = task.placement.prepare().unwrap().floor.start;
        let fitted = task.fit_cells(0.9, &mut |_| ControlFlow::Continue(())).unwrap();
        let solved = task.solve(|| 0.0, None).unwrap();
        assert_eq!(solved.prepared.floor.start, pose);
        assert_eq!(solved.prepared.planning_grid.cells, fitted.cells);
        // So it is the plan that was chosen.
        assert_eq!(solved.planned.drive.duration_s, fitted.duration_s);
    }
}

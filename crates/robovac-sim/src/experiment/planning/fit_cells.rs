//! Chooses the planning cells for the coverage that a plan is to reach.

use super::{PlanRequest, Planned, RoomSetup};
use coverage_planners::{CoverageJob, PlanError, PlannerInfo, lanes::swept_share};
use robovac_core::{
    coverage::PlanningGrid,
    registry::{ParamKind, ParamSpec, ParamValue, Params},
};
use std::{cmp::Ordering, ops::ControlFlow, sync::Arc};

/// Smallest and largest side of cells tried, as shares of the tool's width.
const SIDES: (f64, f64) = (0.45, 1.05);
/// Step from one side to the next, m: lanes move along the walls by far more than that, so that every side also has other
/// distances from them.
const STEP: f64 = 0.0025;
/// How many of the best are planned with the planner's own effort.
const FINALS: usize = 4;
/// Free cells beyond which fewer sides are tried, so that the choice doesn't take minutes.
const MANY: usize = 60_000;

/// Planning cells that suit a coverage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedCells {
    /// Their side, m.
    pub cell_size: f64,
    /// The share of the floor that the plan sweeps, 0 to 1, by [`swept_share`].
    pub coverage: f64,
    /// The plan's time, s.
    pub duration_s: f64,
}

impl RoomSetup {
    /// The same room with planning cells of `cell_size` metres.
    pub fn with_cells(&self, cell_size: f64) -> Self {
        let planning_grid = PlanningGrid::new(&self.floor, cell_size);
        let job =
            CoverageJob::on_planning_grid(&planning_grid, &self.floor, &self.robot).in_place(&self.floor, &self.robot);
        Self { planning_grid: Arc::new(planning_grid), job, ..self.clone() }
    }

    /// The planning cells with which `planner` sweeps the share `coverage`, 0 to 1, in the least time; if none reach it, those
    /// with which it sweeps most. Planners that search do so with the least effort, fast ones in the end with their own. `None` for planners in metres, which need
    /// no cells, and for a robot that fills a cell, which has no choice.
    ///
    /// `observe` gets the share that is done and returns whether to continue; `None` if it doesn't.
    pub fn fit_cells(
        &self,
        planner: &'static PlannerInfo,
        params: &Params,
        seed: u64,
        coverage: f64,
        observe: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Option<FittedCells> {
        if planner.is_in_metres() || self.robot.fills_cell {
            return None;
        }
        let quick = with_least_effort(planner, params);
        let least = SIDES.0 * self.robot.tool_width;
        // Finer cells than those of the floor contain none of its centres.
        let least = least.max(self.floor.resolution);
        let most = (SIDES.1 * self.robot.tool_width).max(least);
        let cells = self.floor.area() / (least * most);
        let step = STEP * (cells / MANY as f64).max(1.0);
        let count = ((most - least) / step) as u32;
        let mut tried = Vec::new();
        for i in 0..=count {
            if observe(f64::from(i) / f64::from(count + 1)).is_break() {
                return None;
            }
            // In whole tenths of a millimetre, as it stands in links.
            let cell_size = ((most - f64::from(i) * step) * 1e4).round() / 1e4;
            tried.extend(self.with_cells(cell_size).try_cells(planner, &quick, seed, cell_size));
        }
        tried.sort_by(|a, b| a.compare(b, coverage));
        if planner.claims.fast && quick != *params {
            // With its effort, a plan can sweep a little less.
            let finals = tried.iter().take(FINALS).filter_map(|found| {
                self.with_cells(found.cell_size).try_cells(planner, params, seed, found.cell_size).ok()
            });
            return finals.min_by(|a, b| a.compare(b, coverage));
        }
        tried.first().copied()
    }

    fn try_cells(
        &self,
        planner: &'static PlannerInfo,
        params: &Params,
        seed: u64,
        cell_size: f64,
    ) -> Result<FittedCells, PlanError> {
        let request = PlanRequest { id: 0, planner, params: params.clone(), seed, job: self.job.clone() };
        let answer = request.serve(|| 0.0, None)?;
        // A planner that returns no walk finds none with other cells either.
        let planned = Planned::new(self, &answer).map_err(|_| PlanError::Unlisted)?;
        let coverage = swept_share(&self.floor, &planned.line);
        Ok(FittedCells { cell_size, coverage, duration_s: planned.drive.duration_s })
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
    use super::*;
    use coverage_planners::find;
    use robovac_core::{floor_plan::generate::random_flat, robot::model};

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
        let fit = |coverage| room.fit_cells(planner, &params, 1, coverage, &mut |_| ControlFlow::Continue(())).unwrap();
        let [some, much, all] = [0.9, 0.97, 1.0].map(fit);
        assert!(some.coverage >= 0.9 && much.coverage >= 0.97, "{some:?} {much:?}");
        assert!(some.duration_s < much.duration_s && some.cell_size > much.cell_size, "{some:?} {much:?}");
        assert!(all.coverage < 1.0 && all.coverage >= much.coverage, "as much as can be: {all:?}");
        // It is the plan that these cells give.
        let again = room.with_cells(much.cell_size).try_cells(planner, &params, 1, 0.0);
        assert_eq!(again.unwrap().duration_s, much.duration_s);
    }

    #[test]
    fn there_is_no_choice_without_cells_and_when_cancelled() {
        let go_on = &mut |_: f64| ControlFlow::Continue(());
        for (robot, planner) in [("roomba600", "lanes"), ("cell", "snake")] {
            let planner = find(planner).unwrap();
            assert_eq!(room(robot).fit_cells(planner, &Params::defaults(planner.params), 1, 0.9, go_on), None);
        }
        let planner = find("snake").unwrap();
        let mut asked = 0;
        let mut cancel = |_: f64| {
            asked += 1;
            if asked == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let params = Params::defaults(planner.params);
        assert_eq!(room("roomba600").fit_cells(planner, &params, 1, 0.9, &mut cancel), None);
        assert_eq!(asked, 3);
    }
}

//! Chooses the next goal when cleaning by a map.

use super::{
    ByMap, CleaningPhase, DOCK_S, RunEnd,
    remains::{Aim, Look, Remains},
};
use crate::{
    controller::parts::{Behaviour, Pilot, Route},
    mapping::CellMark,
};
use coverage_planners::{self, PlanContext};
use robovac_core::{geometry::Point, registry::Params};
use std::sync::Arc;

/// Its aims, in order. At first it keeps off obstacles, as strips along walls are mostly clean after exploring; then
/// come strips between lanes and along walls; in the end it accepts narrow gaps. Small pieces aren't worth the way by
/// then.
const AIMS: [Aim; 5] = [
    Aim { slack: -0.04, share: 0.4, cells: 1 },
    Aim { slack: 0.0, share: 0.4, cells: 2 },
    Aim { slack: -0.02, share: 0.2, cells: 2 },
    Aim { slack: 0.01, share: 0.2, cells: 4 },
    Aim { slack: 0.05, share: 0.4, cells: 4 },
];
/// Time limit for a line: s, s/m, and s for every corner.
const PATIENCE: (f64, f64, f64) = (8.0, 6.0, 3.0);
/// Map cells that must have been swept since nothing seemed left before it looks around again: half a square metre.
const WORTH: usize = 200;
/// Distance from the dock at which it continues by the beams, m.
const BEFORE_DOCK: f64 = 0.7;

impl ByMap {
    /// Chooses the next goal: the nearest part of the remaining floor. Without a way on the map, it accepts narrower
    /// gaps.
    pub(super) fn decide(&mut self, pilot: &mut Pilot) {
        for aim in AIMS {
            if self.set_out(pilot, aim) {
                return;
            }
        }
        let swept = self.mapper.marks().cells(CellMark::Cleaned).count();
        if swept > self.swept + WORTH {
            self.swept = swept;
            self.barred.forget();
            self.budget.forgive();
            return;
        }
        self.finish(pilot);
    }

    /// Whether there is a goal for this aim; starts towards it.
    fn set_out(&mut self, pilot: &Pilot, aim: Aim) -> bool {
        let is_spent = |cell| self.budget.is_spent(cell);
        let look = Look { robot: &pilot.robot, aim, barred: &self.barred, is_spent: &is_spent };
        let Some(remains) = Remains::new(&self.mapper, &look) else { return false };
        if aim.slack <= 0.0 {
            self.look_around(&remains);
        }
        let Some((part, start)) = remains.nearest(aim.cells) else { return false };
        let goal = remains.name(start);
        self.budget.set_out(goal);
        let job = remains.job(part, start, &pilot.robot);
        let Some(info) = coverage_planners::find(self.planner) else { return false };
        let planner = info.build(&Params::defaults(info.params));
        let seed = self.mapper.setup().seed;
        let Ok(path) = planner.plan(&job, &mut PlanContext::new(seed)) else { return false };
        let line = remains.line(&path.cells);
        let (route, patience) = self.route(line);
        self.phase = CleaningPhase::Clean { route, patience, goal };
        true
    }

    /// Stores the reachable floor. In a nook it is not much less than before.
    fn look_around(&mut self, remains: &Remains) {
        let reach = remains.reach();
        if 2 * reach.iter().count() > self.reach.iter().count() {
            self.reach = Arc::new(reach);
        }
    }

    fn route(&self, line: Vec<Point>) -> (Route, f64) {
        let from = self.mapper.pose().position();
        let corners = line.len() as f64;
        let route = Route::new(from, line);
        let patience = PATIENCE.0 + PATIENCE.1 * route.left(from) + PATIENCE.2 * corners;
        (route, patience)
    }

    /// Nothing is left: returns to its dock, if it knows one.
    fn finish(&mut self, pilot: &mut Pilot) {
        let look = Look { robot: &pilot.robot, aim: AIMS[1], barred: &self.barred, is_spent: &|_| false };
        let remains = Remains::new(&self.mapper, &look);
        let is_clean = remains.as_ref().is_some_and(|remains| remains.nearest(AIMS[1].cells).is_none());
        let end = if is_clean { RunEnd::Clean } else { RunEnd::NothingReachable };
        let Some(berth) = self.mapper.berth() else {
            self.phase = CleaningPhase::Done(end);
            return;
        };
        let before = berth.to_world(Point::new(-BEFORE_DOCK, 0.0));
        let way = remains.and_then(|remains| remains.way(before));
        self.phase = if let Some(line) = way {
            let (route, patience) = self.route(line);
            CleaningPhase::Return { route, patience, end }
        } else {
            self.dock.begin(pilot);
            CleaningPhase::Dock { patience: DOCK_S, end }
        };
    }
}

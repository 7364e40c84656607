//! What other coverages would take: the curve of time over coverage.

use super::{
    LanesSetup,
    anneal::{LaneSearch, SearchStage, anneal},
    cost::{self, MotionTimes},
    curves::CurveTimes,
    layout::RoomLayout,
    raster::SweptRaster,
    scan::swept_share,
};
use crate::TradeOffPoint;
use robovac_core::{coverage::ReachableFloor, geometry::Point, robot::RobotModel};
use std::ops::ControlFlow;

/// Moves for every metre of the bound between one point of the curve and the next, and most moves.
const EFFORT: f64 = 2000.0;
const MOST_MOVES: f64 = 1.5e6;
/// Shares that differ by less are the same.
const SAME: f64 = 1e-6;

/// Calls `observe` with what `path` takes, and then a path for each of the shares: first those below the share that `path` was planned
/// for and sweeps, from the nearest on, then those above. A short search changes `path` for one share, and what came of it for the next. Deterministic for a seed.
pub(super) fn trade_off(
    floor: &ReachableFloor,
    robot: &RobotModel,
    setup: &LanesSetup,
    path: &[Point],
    shares: &[f64],
    observe: &mut dyn FnMut(TradeOffPoint) -> ControlFlow<()>,
) {
    let (space, _) = super::free_space(floor, setup.clearance);
    let curves = setup.is_rounded.then(|| CurveTimes::of(robot)).flatten();
    let clock = MotionTimes::of(robot, curves);
    let times = clock.clone().with_stops(setup.objective.stops());
    let heading = floor.start.direction();
    let narrower = (setup.overlap > 0.0).then(|| super::narrowed(floor, setup.overlap));
    let (counted, part) = narrower.as_ref().map_or((floor, 1.0), |(narrow, part)| (narrow, *part));
    let raster = SweptRaster::new(counted, &RoomLayout::new(counted, &space).along());
    let metres = floor.area() / (2.0 * floor.tool_radius);
    let effort = EFFORT.min(MOST_MOVES / metres);
    let point_of = |asked: f64, path: &[Point]| {
        let coverage = swept_share(floor, path);
        let duration_s = clock.path(path, heading, Some(&space));
        TradeOffPoint { asked, coverage, duration_s, length_m: cost::length(path) }
    };
    let begin = point_of(setup.coverage, path);
    if observe(begin).is_break() {
        return;
    }
    let others = shares.iter().filter(|&&share| (share - setup.coverage).abs() > SAME);
    let (mut below, mut above): (Vec<f64>, Vec<f64>) =
        others.partition(|&&share| share < setup.coverage.min(begin.coverage));
    below.sort_by(|a, b| b.total_cmp(a));
    above.sort_by(f64::total_cmp);
    for side in [below, above] {
        let mut path = path.to_vec();
        for coverage in side {
            let asked = LanesSetup { coverage, effort, ..*setup };
            let setup = &LanesSetup { coverage: part * asked.with_spare(), ..asked };
            let search = LaneSearch { floor: counted, space: &space, times: &times, clock: &clock, heading, setup };
            path = anneal(&search, &raster, &[path], SearchStage::Change, &mut |_| ControlFlow::Continue(0.0));
            if observe(point_of(coverage, &path)).is_break() {
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{LanesObjective, plan_lanes},
        *,
    };
    use robovac_core::{floor_plan::generate::random_flat, robot::model};

    fn curve(setup: &LanesSetup, shares: &[f64], most: usize) -> Vec<TradeOffPoint> {
        let robot = model("roomba600").unwrap();
        let floor = ReachableFloor::new(&random_flat(1, 1, setup.seed), robot, None).unwrap();
        let plan = plan_lanes(&floor, robot, setup, &mut |_| ControlFlow::Continue(0.0)).unwrap();
        let mut points = Vec::new();
        trade_off(&floor, robot, setup, &plan.path, shares, &mut |point| {
            points.push(point);
            if points.len() < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        assert_eq!(points[0].coverage, plan.coverage, "it begins with the plan");
        points
    }

    #[test]
    fn more_coverage_takes_more_time_and_distance() {
        let shares = [0.8, 0.9, 0.95, 0.98];
        let usual = LanesSetup { coverage: 0.95, effort: 600.0, ..LanesSetup::default() };
        for setup in [
            usual,
            LanesSetup { seed: 1, objective: LanesObjective::Distance, ..usual },
            LanesSetup { is_rounded: true, ..usual },
            LanesSetup { overlap: 0.02, ..usual },
        ] {
            let setup = &setup;
            let mut points = curve(setup, &shares, 9);
            let asked: Vec<f64> = points[1..].iter().map(|point| point.asked).collect();
            assert_eq!(asked, [0.9, 0.8, 0.98], "the nearest first, and none for what is planned");
            assert_eq!(points, curve(setup, &shares, 9), "same seed, same curve");
            points.sort_by(|a, b| a.coverage.total_cmp(&b.coverage));
            for pair in points.windows(2) {
                let by = pair[1].coverage - pair[0].coverage;
                assert!(by < 0.01 || pair[1].duration_s > pair[0].duration_s, "{pair:?}");
                assert!(by < 0.01 || pair[1].length_m > pair[0].length_m, "{pair:?}");
            }
            // Curves leave some out. With an overlap the share is of what a narrower tool reaches, and the whole one sweeps more.
            let (less, more) = match setup {
                _ if setup.overlap > 0.0 => (0.03, 0.05),
                _ if setup.is_rounded => (0.0, 0.05),
                _ => (0.0, 0.02),
            };
            for point in &points {
                let above = point.coverage - point.asked;
                assert!(above >= -less && above < more, "{point:?}");
            }
            assert_eq!(points.iter().filter(|point| point.asked == setup.coverage).count(), 1, "the plan's own");
        }
    }

    #[test]
    fn it_ends_where_it_is_told_and_says_what_cannot_be_reached() {
        let setup = LanesSetup { coverage: 0.9, effort: 60.0, clearance: 0.05, ..LanesSetup::default() };
        assert_eq!(curve(&setup, &[0.5, 0.8], 2).len(), 2);
        let points = curve(&setup, &[1.0], 9);
        assert!(points[1].coverage < points[1].asked, "{points:?}");
    }
}

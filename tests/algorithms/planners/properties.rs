//! Properties of every planner that walks from cell to cell, in random rooms.

use super::support::{build, walking};
use coverage_planners::{CoverageJob, PlanContext, metrics::WalkMetrics};
use proptest::prelude::*;
use robovac_core::grid::{Direction, Grid};

/// A room of up to 24 x 16 cells, some of them blocked, with a start and a heading; the start is made free.
fn job() -> impl Strategy<Value = CoverageJob> {
    let room = (1..24_usize, 1..16_usize, 0.0..0.6_f64).prop_flat_map(|(width, height, share)| {
        let cells = proptest::collection::vec(proptest::bool::weighted(1.0 - share), width * height);
        (Just(width), cells, any::<prop::sample::Index>(), 0..4_usize)
    });
    room.prop_filter_map("the cells fill the room", |(width, cells, start, heading)| {
        let mut free = Grid::from_rows(width, cells)?;
        let start = free.cell(start.index(free.len()));
        free[start] = true;
        CoverageJob::new(&free, start, Direction::ALL[heading])
    })
}

/// Plans with all planners in so many rooms.
fn walks_hold(cases: u32) {
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    proptest!(config, |(job in job(), turn_s in 0.0..10.0_f64)| {
        let job = CoverageJob { turn_s, ..job };
        for info in walking() {
            let path = build(info, job.cells()).plan(&job, &mut PlanContext::new(0)).expect("nobody cancels");
            prop_assert_eq!(path.check(&job), Ok(()), "{}", info.id);
            let metrics = WalkMetrics::of(&job, &path);
            prop_assert!(!info.claims.complete || metrics.visited_cells == metrics.reachable_cells, "{}", info.id);
        }
    });
}

// slow: all planners, in as many rooms as find most mistakes
#[test]
fn walks_can_be_driven_and_cover_all() {
    walks_hold(40);
}

#[test]
#[ignore = "soak: many rooms"]
fn walks_in_many_rooms_can_be_driven_and_cover_all() {
    walks_hold(1000);
}

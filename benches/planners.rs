//! Planning time of every planner of the registry that walks from cell to cell.

#![allow(missing_docs, reason = "the macros make functions without any")]

use coverage_planners::{PLANNERS, PlanContext, SLOW_CELLS};
use criterion::{Criterion, criterion_group, criterion_main};
use robovac_app::bench::hall;
use robovac_core::registry::Params;
use std::{hint::black_box, time::Duration};

/// Sides of the square halls, in cells: those of `robovac bench`.
const SIDES: [usize; 2] = [100, 1000];

fn planners(criterion: &mut Criterion) {
    for side in SIDES {
        let Some(job) = hall(side) else { continue };
        let mut group = criterion.benchmark_group(format!("hall {side} x {side}"));
        group.sample_size(10).measurement_time(Duration::from_secs(3));
        for info in PLANNERS.iter().filter(|info| info.claims.fast || job.cells() <= SLOW_CELLS && !info.is_in_metres())
        {
            let planner = info.build(&Params::defaults(info.params));
            group.bench_function(info.id, |b| b.iter(|| planner.plan(black_box(&job), &mut PlanContext::new(0))));
        }
        group.finish();
    }
}

criterion_group!(benches, planners);
criterion_main!(benches);

//! How many steps a second the simulator makes.

#![allow(missing_docs, reason = "the macros make functions without any")]

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use robovac_playground::{app::bench::opening_run, sim::Run};
use std::time::Duration;

/// Steps from the start: five minutes of robot time, with straight pieces, turns and furniture.
const STEPS: u32 = 20_000;

fn simulator(criterion: &mut Criterion) {
    let Some(start) = opening_run() else { return };
    let mut group = criterion.benchmark_group("simulator");
    group.throughput(Throughput::Elements(u64::from(STEPS))).measurement_time(Duration::from_secs(3));
    let simulate = |mut run: Run| {
        for _ in 0..STEPS {
            run.step();
        }
        run
    };
    group.bench_function(format!("{STEPS} steps in the furnished flat"), |b| {
        b.iter_batched(|| start.clone(), simulate, BatchSize::LargeInput);
    });
    group.finish();
}

criterion_group!(benches, simulator);
criterion_main!(benches);

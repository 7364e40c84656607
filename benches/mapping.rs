//! Time to make a map and to measure its quality.

#![allow(missing_docs, reason = "the macros make functions without any")]

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use robovac_app::bench::MappingCase;
use std::time::Duration;

fn mapping(criterion: &mut Criterion) {
    let Some(case) = MappingCase::new() else { return };
    let mut group = criterion.benchmark_group("mapping");
    group.measurement_time(Duration::from_secs(3));
    group.throughput(Throughput::Elements(case.readings.len() as u64));
    group.bench_function("five minutes in the furnished flat", |b| {
        b.iter_batched(|| case.mapper.clone(), |mapper| case.map(mapper), BatchSize::LargeInput);
    });
    let done = case.map(case.mapper.clone());
    group.throughput(Throughput::Elements(1));
    group.bench_function("quality of that map", |b| b.iter(|| case.truth.quality(done.map())));
    group.bench_function("a copy of the mapper", |b| b.iter(|| done.clone()));
    group.finish();
}

criterion_group!(benches, mapping);
criterion_main!(benches);

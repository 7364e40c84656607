//! Generated flats per second.

#![allow(missing_docs, reason = "the macros make functions without any")]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use robovac_core::floor_plan::generate::{FlatSpec, generate_flat};
use std::{hint::black_box, time::Duration};

/// Flats for each measurement, of all sizes.
const FLATS: u64 = 100;

fn flats(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("flats");
    group.throughput(Throughput::Elements(FLATS)).measurement_time(Duration::from_secs(3)).sample_size(10);
    for (name, furniture) in [("empty", 0.0), ("furnished", FlatSpec::default().furniture), ("crammed", 1.0)] {
        let spec = FlatSpec { furniture, ..FlatSpec::default() };
        group.bench_function(format!("{FLATS} {name} flats"), |b| {
            b.iter(|| (0..FLATS).for_each(|seed| drop(black_box(generate_flat(seed, &spec)))));
        });
    }
    group.finish();
}

criterion_group!(benches, flats);
criterion_main!(benches);

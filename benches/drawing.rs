//! Reading and tracing of large drawings.

#![allow(missing_docs, reason = "the macros make functions without any")]

use criterion::{Criterion, criterion_group, criterion_main};
use floor_drawing::{DrawingRegion, Overlay, Role, Tracing, read, to_dxf, trace};
use robovac_app::{bench::office_drawing, floor_plan::DrawingSession};
use robovac_core::{floor_plan::SourceFile, geometry::Point};
use std::{hint::black_box, ops::ControlFlow, time::Duration};

fn drawings(criterion: &mut Criterion) {
    let file = SourceFile { name: "office.dxf".to_owned(), bytes: office_drawing(100_000) };
    let Ok(drawing) = read(&file) else { return };
    let roles: Vec<Role> = drawing.layers.iter().map(|layer| layer.role).collect();
    let how = Tracing { roles, metre: 0.001, gap: 0.1, resolution: 0.05, region: DrawingRegion::WHOLE };
    let mut group = criterion.benchmark_group(format!("drawing of {} MB", file.bytes.len() / 1_000_000));
    group.sample_size(10).measurement_time(Duration::from_secs(5));
    group.bench_function("read", |b| b.iter(|| read(black_box(&file))));
    group.bench_function("trace whole", |b| b.iter(|| trace(black_box(&drawing), &how)));
    let room = Tracing { region: DrawingRegion::Room(Point::new(52_500.0, 38_000.0)), ..how };
    group.bench_function("trace room", |b| b.iter(|| trace(black_box(&drawing), &room)));
    if let Ok(mut board) = DrawingSession::open(std::slice::from_ref(&file)) {
        group.bench_function("sweep", |b| b.iter(|| board.sweep(&mut |_| ControlFlow::Continue(()))));
    }
    let lines = vec![(0..10_000).map(|i| Point::new(f64::from(i), f64::from(i % 7))).collect()];
    let overlays = [Overlay { layer: "PATH".to_owned(), colour: 1, lines }];
    group.bench_function("write beside", |b| b.iter(|| to_dxf(Some(black_box(&file.bytes)), &overlays)));
    group.finish();
}

criterion_group!(benches, drawings);
criterion_main!(benches);

//! Reading and tracing of large drawings.

#![allow(missing_docs, reason = "the macros make functions without any")]

use criterion::{Criterion, criterion_group, criterion_main};
use robovac_playground::{
    drawing::{Overlay, Region, Role, Tracing, read, to_dxf, trace},
    floorplan::SourceFile,
    geometry::Point,
};
use std::{fmt::Write, hint::black_box, time::Duration};

/// An office block in millimetres: rooms of 4 m x 5 m with doors, a table in each, as 100,000 entities in about 10 MB.
fn office(entities: usize) -> Vec<u8> {
    let mut text = String::from(
        "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n",
    );
    let mut handle = 0x100;
    let mut line = |text: &mut String, layer: &str, a: [f64; 2], b: [f64; 2]| {
        handle += 1;
        let [[ax, ay], [bx, by]] = [a, b];
        let _ = write!(
            text,
            "  0\nLINE\n  5\n{handle:X}\n330\n1F\n100\nAcDbEntity\n  8\n{layer}\n100\nAcDbLine\n 10\n{ax:.6}\n 20\n{ay:.6}\n 30\n0.0\n \
             11\n{bx:.6}\n 21\n{by:.6}\n 31\n0.0\n"
        );
    };
    let rooms = entities / 10;
    let columns = (rooms as f64).sqrt() as usize;
    for room in 0..rooms {
        let (x, y) = ((room % columns) as f64 * 400.0, (room / columns) as f64 * 500.0);
        // Walls with a door of 90 cm at 1:10, so that the whole is a room of 40 m x 50 m.
        for (a, b) in [
            ([0.0, 0.0], [150.0, 0.0]),
            ([240.0, 0.0], [400.0, 0.0]),
            ([0.0, 0.0], [0.0, 500.0]),
            ([400.0, 0.0], [400.0, 500.0]),
        ] {
            line(&mut text, "WALL", [x + a[0], y + a[1]], [x + b[0], y + b[1]]);
        }
        for i in 0..6 {
            let step = f64::from(i) * 20.0;
            line(&mut text, "FURNITURE", [x + 100.0 + step, y + 200.0], [x + 110.0 + step, y + 300.0]);
        }
    }
    text.push_str("0\nENDSEC\n0\nEOF\n");
    text.into_bytes()
}

fn drawings(criterion: &mut Criterion) {
    let file = SourceFile { name: "office.dxf".to_owned(), bytes: office(100_000) };
    let Ok(drawing) = read(&file) else { return };
    let roles: Vec<Role> = drawing.layers.iter().map(|layer| layer.role).collect();
    let how = Tracing { roles, metre: 0.001, gap: 0.1, resolution: 0.02, region: Region::Whole };
    let mut group = criterion.benchmark_group(format!("drawing of {} MB", file.bytes.len() / 1_000_000));
    group.sample_size(10).measurement_time(Duration::from_secs(5));
    group.bench_function("read", |b| b.iter(|| read(black_box(&file))));
    group.bench_function("trace whole", |b| b.iter(|| trace(black_box(&drawing), &how)));
    let room = Tracing { region: Region::Room(Point::new(2050.0, 2450.0)), ..how };
    group.bench_function("trace room", |b| b.iter(|| trace(black_box(&drawing), &room)));
    let lines = vec![(0..10_000).map(|i| Point::new(f64::from(i), f64::from(i % 7))).collect()];
    let overlays = [Overlay { layer: "PATH".to_owned(), colour: 1, lines }];
    group.bench_function("write beside", |b| b.iter(|| to_dxf(Some(black_box(&file.bytes)), &overlays)));
    group.finish();
}

criterion_group!(benches, drawings);
criterion_main!(benches);

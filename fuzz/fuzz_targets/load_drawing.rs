//! Drawings of any content: no panic, what is taken in can be traced, and lines can be put beside it that come back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use floor_drawing::{Overlay, DrawingRegion, Role, Tracing, read, to_dxf, trace};
use robovac_core::{floor_plan::SourceFile, geometry::Point};

fuzz_target!(|bytes: &[u8]| {
    let file = SourceFile { name: "a.dxf".into(), bytes: bytes.into() };
    let Ok(drawing) = read(&file) else { return };
    let corner = drawing.points[0];
    for (role, region) in [(Role::Wall, DrawingRegion::WHOLE), (Role::Obstacle, DrawingRegion::Room(corner))] {
        let roles = vec![role; drawing.layers.len()];
        let metre = drawing.metre.unwrap_or(0.001);
        if let Ok(traced) = trace(&drawing, &Tracing { roles, metre, gap: 0.3, resolution: 0.1, region }) {
            traced.plan.check_objects(None).expect("what is traced can be a room");
        }
    }
    let line = vec![Point::new(1.0, 2.0), Point::new(3.0, 4.5)];
    let overlay = Overlay { layer: "PATH".into(), colour: 1, lines: vec![line.clone()] };
    // What isn't DXF can't be written beside.
    let Ok(written) = to_dxf(Some(bytes), &[overlay]) else { return };
    let again = read(&SourceFile { name: "b.dxf".into(), bytes: written }).expect("written beside a drawing that was read");
    assert_eq!(again.strokes.len(), drawing.strokes.len() + 1);
    assert!(again.strokes.iter().any(|stroke| again.corners(stroke) == line));
});

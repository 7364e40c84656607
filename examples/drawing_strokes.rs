//! Prints the strokes of a drawing as JSON, and writes a DXF with a line beside a drawing. For checking both with other
//! programs: `drawing_strokes DRAWING [DXF_BESIDE_IT [DXF_ALONE]]`.

use floor_drawing::{Overlay, read, to_dxf};
use robovac_core::{floor_plan::SourceFile, geometry::Point};
use std::{env, error::Error, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let name = arguments.next().ok_or("which drawing?")?;
    let file = SourceFile { bytes: fs::read(&name)?, name };
    let drawing = read(&file)?;
    let layers: Vec<&str> = drawing.layers.iter().map(|layer| layer.name.as_str()).collect();
    let strokes: Vec<serde_json::Value> = drawing
        .strokes
        .iter()
        .map(|stroke| {
            let points: Vec<[f64; 2]> = drawing.corners(stroke).iter().map(|p| [p.x, p.y]).collect();
            let layer = layers.get(stroke.layer as usize);
            serde_json::json!({
                "layer": layer, "entity": stroke.entity, "closed": stroke.is_closed, "points": points,
            })
        })
        .collect();
    println!("{}", serde_json::json!({ "metre": drawing.metre, "left_out": drawing.left_out, "strokes": strokes }));
    if let Some(out) = arguments.next() {
        let zigzag: Vec<Point> = (0..5).map(|i| Point::new(f64::from(i) * 100.25, f64::from(i % 2) * 50.5)).collect();
        let triangle = vec![zigzag[0], zigzag[1], zigzag[2], zigzag[0]];
        let overlays = [
            Overlay { layer: "SWEEP_PATH".to_owned(), colour: 1, lines: vec![zigzag, triangle.clone()] },
            Overlay { layer: "Überfahrt: 2".to_owned(), colour: 5, lines: vec![triangle] },
        ];
        fs::write(out, to_dxf(Some(&file.bytes), &overlays)?)?;
    }
    if let Some(out) = arguments.next() {
        let line = vec![Point::new(0.0, 0.0), Point::new(2.5, 1.5)];
        fs::write(out, to_dxf(None, &[Overlay { layer: "PATH".to_owned(), colour: 3, lines: vec![line] }])?)?;
    }
    Ok(())
}

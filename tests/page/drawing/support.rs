//! DXFs as text, and what is in a drawing.

use floor_drawing::{Drawing, DrawingError, read};
use robovac_core::{floor_plan::SourceFile, geometry::Point};

/// A file of that content.
pub fn file(name: &str, bytes: impl Into<Vec<u8>>) -> SourceFile {
    SourceFile { name: name.to_owned(), bytes: bytes.into() }
}

/// Group codes and values, as `"0 LINE 8 WALL 10 0.5"`, one a line each.
pub fn pairs(text: &str) -> String {
    text.split_whitespace().map(|word| format!("{word}\n")).collect()
}

/// A DXF with these sections.
pub fn dxf(sections: &[(&str, &str)]) -> String {
    let sections = sections.iter().map(|(name, body)| format!("0\nSECTION\n2\n{name}\n{}0\nENDSEC\n", pairs(body)));
    sections.chain(["0\nEOF\n".to_owned()]).collect()
}

/// A DXF with these entities in model space.
pub fn entities(text: &str) -> String {
    dxf(&[("ENTITIES", text)])
}

/// Reads a DXF.
pub fn drawn(text: &str) -> Result<Drawing, DrawingError> {
    read(&file("plan.dxf", text))
}

/// The message that refuses a DXF.
pub fn refusal(bytes: impl Into<Vec<u8>>) -> String {
    read(&file("plan.dxf", bytes)).expect_err("it is refused").to_string()
}

/// All corners stroke by stroke.
pub fn strokes(drawing: &Drawing) -> Vec<Vec<Point>> {
    drawing.strokes.iter().map(|stroke| drawing.corners(stroke).to_vec()).collect()
}

/// The only stroke's corners, rounded to a thousandth.
pub fn rounded(drawing: &Drawing) -> Vec<(f64, f64)> {
    let round = |x: f64| (x * 1000.0).round() / 1000.0 + 0.0;
    drawing.points.iter().map(|p| (round(p.x), round(p.y))).collect()
}

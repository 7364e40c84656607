//! `convert`: a map or drawing as text, scenario or drawing.

use super::{drawing::DrawingOptions, failure::Failure, source::Source};
use robovac_playground::{
    drawing::{is_drawing, outlines, to_dxf},
    floorplan::{FloorPlan, Scenario, to_ascii},
};
use std::{fs, path::PathBuf};

/// Write a map, or the room in a drawing, as text (.txt), scenario (.json) or drawing (.dxf)
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    source: Source,
    #[command(flatten)]
    drawing: DrawingOptions,
    /// File to write; its ending chooses the format
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

/// Writes the file; nothing is left to print.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let out = &arguments.out;
    let ending = out.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    let write = match ending.as_deref() {
        Some("txt") => |plan: &FloorPlan| Ok(to_ascii(plan).into_bytes()),
        Some("json") => |plan: &FloorPlan| Ok(Scenario::of(plan).to_json().into_bytes()),
        Some("dxf") => |plan: &FloorPlan| to_dxf(None, &outlines(plan)),
        _ => {
            let message = format!("--out {}: no format has this ending; use .txt, .json or .dxf", out.display());
            return Err(Failure::usage(message));
        }
    };
    let drawing = arguments.source.file()?.filter(is_drawing);
    let plan = match &drawing {
        Some(file) => arguments.drawing.trace(file)?,
        None => arguments.source.plan()?,
    };
    fs::write(out, write(&plan)?).map_err(|error| Failure::io(out.display(), &error))?;
    Ok(String::new())
}

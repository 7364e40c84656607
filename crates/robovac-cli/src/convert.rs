//! `convert`: a map or drawing in another format.

use super::{drawing::DrawingOptions, failure::Failure, source::RoomSource};
use floor_drawing::is_drawing;
use robovac_app::export::{ExportError, Exported};
use robovac_core::floor_plan::{OccupancyMode, Scenario};
use std::{fs, path::PathBuf};

/// Write a map, or the room in a drawing, as text (.txt), scenario (.json), ROS map (.pgm or .png, and its YAML file beside it) or
/// drawing (.dxf, .svg)
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    source: RoomSource,
    #[command(flatten)]
    drawing: DrawingOptions,
    /// Output file; its extension chooses the format
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Mode of a ROS map
    #[arg(long, value_name = "MODE", default_value = "trinary", value_parser = ["trinary", "scale", "raw"])]
    mode: String,
    /// Negate a ROS map: walls are light
    #[arg(long)]
    negate: bool,
}

/// Endings and the formats that they stand for.
const ENDINGS: [(&str, &str); 6] =
    [("txt", "text"), ("json", "scenario"), ("pgm", "ros_pgm"), ("png", "ros_png"), ("dxf", "dxf"), ("svg", "svg")];

/// Writes the files; nothing is left to print.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let out = &arguments.out;
    let ending = out.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
    let format = ENDINGS.iter().find(|(known, _)| *known == ending).map(|&(_, format)| format);
    let (Some(format), Some(stem)) = (format, out.file_stem().and_then(|stem| stem.to_str())) else {
        let endings = ENDINGS.map(|(ending, _)| format!(".{ending}")).join(", ");
        return Err(Failure::usage(format!("--out {}: unknown file extension; use one of {endings}", out.display())));
    };
    let drawing = arguments.source.file()?.filter(is_drawing);
    let plan = match &drawing {
        Some(file) => arguments.drawing.trace(file)?.plan,
        None => arguments.source.plan()?,
    };
    let scenario = Scenario::of(&plan);
    let mode = OccupancyMode::named(&arguments.mode).unwrap_or_default();
    let exported = Exported { scenario: &scenario, plan: &plan, path: &[], stem, mode, negate: arguments.negate };
    for file in exported.files(format)? {
        let path = out.with_file_name(&file.name);
        fs::write(&path, file.bytes).map_err(|error| Failure::io(path.display(), &error))?;
    }
    Ok(String::new())
}

impl From<ExportError> for Failure {
    fn from(error: ExportError) -> Self {
        Self::usage(error.to_string())
    }
}

//! `convert`: a map or drawing in another format.

use super::{drawing::DrawingOptions, failure::Failure, source::RoomSource};
use floor_drawing::is_drawing;
use robovac_app::export::{ExportError, Exported};
use robovac_core::floor_plan::{FloorPlan, OccupancyMode, Scenario};
use std::{
    fs,
    path::{Path, PathBuf},
};

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
    let out = Output::of(&arguments.out)?;
    let drawing = arguments.source.file()?.filter(is_drawing);
    let plan = match &drawing {
        Some(file) => arguments.drawing.trace(file)?.plan,
        None => arguments.source.plan()?,
    };
    out.write(&plan, OccupancyMode::named(&arguments.mode).unwrap_or_default(), arguments.negate)?;
    Ok(String::new())
}

/// A file that a map is written to.
pub struct Output<'a> {
    path: &'a Path,
    stem: &'a str,
    format: &'static str,
}

impl<'a> Output<'a> {
    /// The file with its format by its extension.
    pub fn of(path: &'a Path) -> Result<Self, Failure> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
        let format = ENDINGS.iter().find(|(known, _)| *known == ending).map(|&(_, format)| format);
        let (Some(format), Some(stem)) = (format, path.file_stem().and_then(|stem| stem.to_str())) else {
            let endings = ENDINGS.map(|(ending, _)| format!(".{ending}")).join(", ");
            let path = path.display();
            return Err(Failure::usage(format!("--out {path}: unknown file extension; use one of {endings}")));
        };
        Ok(Self { path, stem, format })
    }

    /// Writes the file, and what belongs to it beside it.
    pub fn write(&self, plan: &FloorPlan, mode: OccupancyMode, negate: bool) -> Result<(), Failure> {
        let scenario = Scenario::of(plan);
        let exported = Exported { scenario: &scenario, plan, path: &[], smooth: None, stem: self.stem, mode, negate };
        for file in exported.files(self.format)? {
            let path = self.path.with_file_name(&file.name);
            fs::write(&path, file.bytes).map_err(|error| Failure::io(path.display(), &error))?;
        }
        Ok(())
    }
}

impl From<ExportError> for Failure {
    fn from(error: ExportError) -> Self {
        Self::usage(error.to_string())
    }
}

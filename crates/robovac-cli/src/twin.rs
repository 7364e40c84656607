//! `twin`: the figures of one robot, fitted to a recording of its line.

use super::failure::Failure;
use robovac_link::{
    connection::LineRecording,
    twin::{Prediction, TwinError, TwinFigure, TwinFit},
};
use robovac_sim::experiment::TwinFile;
use std::{
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
};

/// Fit a twin to a recording by "robovac monitor --record" or the page: a simulated robot with the wheels, turns,
/// acceleration, slip and light bumper of the real one, for use in place of the model
#[derive(clap::Args)]
pub struct Arguments {
    /// The recording
    #[arg(value_name = "FILE")]
    recording: PathBuf,
    /// Another recording of the same robot: report how well the twin and the model predict it
    #[arg(long, value_name = "SECOND")]
    check: Option<PathBuf>,
    /// Write the twin, for "robovac simulate --twin" and the page
    #[arg(long, value_name = "OUT")]
    json: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let refuse = |path: &Path, error: &TwinError| Failure::usage(format!("{}: {error}", path.display()));
    let fit = TwinFit::of(read(&arguments.recording)?).map_err(|e| refuse(&arguments.recording, &e))?;
    let mut text = String::new();
    for figure in &fit.file().figures {
        line(&mut text, figure);
    }
    if let Some(path) = &arguments.check {
        let predictions = fit.check(read(path)?).map_err(|e| refuse(path, &e))?;
        let _ =
            writeln!(text, "\nErrors of predictions for {}:\n{:34} {:>9} {:>9}", path.display(), "", "twin", "model");
        for Prediction { what, unit, digits, twin, model, how } in predictions {
            let digits = usize::from(digits);
            let _ = writeln!(text, "{what:34} {twin:9.digits$} {model:9.digits$} {unit:6}  {how}");
        }
    }
    let _ = writeln!(text, "\nIn Explore: put this behind the page's address.\n#{}", fit.file().to_link());
    if let Some(path) = &arguments.json {
        fs::write(path, fit.file().to_json()).map_err(|e| Failure::io(path.display(), &e))?;
    }
    Ok(text)
}

/// Reads a twin.
pub fn open(path: &Path) -> Result<TwinFile, Failure> {
    let bytes = fs::read(path).map_err(|e| Failure::io(path.display(), &e))?;
    TwinFile::read(&bytes).map_err(|e| Failure::usage(format!("{}: {e}", path.display())))
}

fn read(path: &Path) -> Result<LineRecording, Failure> {
    let bytes = fs::read(path).map_err(|e| Failure::io(path.display(), &e))?;
    LineRecording::parse(&String::from_utf8_lossy(&bytes))
        .map_err(|e| Failure::usage(format!("{}: {e}", path.display())))
}

/// A figure: its value with its standard deviation, that of the model, and where it is from.
fn line(text: &mut String, figure: &TwinFigure) {
    let TwinFigure { name, value, uncertainty, model, unit, digits, how } = figure;
    let digits = usize::from(*digits);
    let number = |value: &Option<f64>| value.map_or("-".to_owned(), |value| format!("{value:.digits$}"));
    let around = uncertainty.map(|deviation| format!(" ± {deviation:.digits$}")).unwrap_or_default();
    let value = format!("{}{around} {unit}", number(value));
    // Writing to a string doesn't fail.
    let _ = writeln!(text, "{name:28} {value:24} model {:>8}   {how}", number(model));
}

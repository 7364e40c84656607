//! `convert`: a map as text or scenario.

use super::{failure::Failure, source::Source};
use robovac_playground::floorplan::{Scenario, to_ascii};
use std::{fs, path::PathBuf};

/// Write a map as text (.txt) or scenario (.json)
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    source: Source,
    /// File to write; its ending chooses the format
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

/// Writes the file; nothing is left to print.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let out = &arguments.out;
    let ending = out.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    let write = match ending.as_deref() {
        Some("txt") => to_ascii,
        Some("json") => |plan: &_| Scenario::of(plan).to_json(),
        _ => {
            let message = format!("--out {}: no format has this ending; use .txt or .json", out.display());
            return Err(Failure::usage(message));
        }
    };
    fs::write(out, write(&arguments.source.plan()?)).map_err(|error| Failure::io(out.display(), &error))?;
    Ok(String::new())
}

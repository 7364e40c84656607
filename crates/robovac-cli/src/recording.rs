//! `recording`: what a recording of a robot's line contains.

use super::{failure::Failure, output::json};
use robovac_app::export::recording_bag;
use robovac_link::{
    connection::LineRecording,
    recording::{Examination, Timeline, csv},
};
use std::{
    fmt::Write as _,
    fs::{self, File},
    io::{BufWriter, Write as _},
    path::{Path, PathBuf},
    sync::Arc,
};

/// Seconds of a recording that are examined at once.
const PART_S: f64 = 60.0;

/// Examine a recording of a robot's line, by "robovac monitor --record" or the page: print what happened and what went
/// wrong; write its readings as a table or for ROS 2 tools
#[derive(clap::Args)]
pub struct Arguments {
    /// The recording
    #[arg(value_name = "FILE")]
    recording: PathBuf,
    /// Write all sensor readings as comma-separated values, one row per frame. Values that a frame didn't contain are
    /// empty
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write ROS 2 messages as MCAP, for Foxglove and "ros2 bag". Times count from the start of the recording
    #[arg(long, value_name = "FILE")]
    mcap: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let path = &arguments.recording;
    let bytes = fs::read(path).map_err(|e| Failure::io(path.display(), &e))?;
    let parsed = LineRecording::parse(&String::from_utf8_lossy(&bytes));
    let recording = Arc::new(parsed.map_err(|e| Failure::usage(format!("{}: {e}", path.display())))?);
    drop(bytes);
    if let Some(path) = &arguments.csv {
        let fail = |e: &_| Failure::io(path.display(), e);
        let mut file = create(path)?;
        csv(Arc::clone(&recording), |piece| file.write_all(piece.as_bytes())).map_err(|e| fail(&e))?;
        file.flush().map_err(|e| fail(&e))?;
    }
    let mut examination = Examination::new(Arc::clone(&recording));
    while examination.go_on(PART_S) {}
    let timeline = examination.timeline();
    if let Some(path) = &arguments.mcap {
        recording_bag(&recording, &timeline, create(path)?).map_err(|e| Failure::bag(path, e))?;
    }
    Ok(if arguments.json { json(&timeline) } else { text(&timeline) })
}

fn create(path: &Path) -> Result<BufWriter<File>, Failure> {
    File::create(path).map(BufWriter::new).map_err(|e| Failure::io(path.display(), &e))
}

/// A line for each entry; `!` marks faults.
fn text(timeline: &Timeline) -> String {
    let mut text = timeline.summary() + "\n";
    for entry in &timeline.entries {
        let mark = if entry.is_fault { '!' } else { ' ' };
        // Writing to a string doesn't fail.
        let _ = writeln!(text, "{mark} {:>9}", entry.to_string());
    }
    if timeline.left_out > 0 {
        let _ = writeln!(text, "  and {} more", timeline.left_out);
    }
    text
}

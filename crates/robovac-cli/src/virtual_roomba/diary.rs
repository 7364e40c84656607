//! `--log`: received commands and wheel changes, each with seconds since ready and Unix time in milliseconds.

use crate::failure::Failure;
use robovac_link::emulator::ReceivedCommand;
use roomba_oi::Command;
use std::{
    fmt::{Arguments, Write as _},
    fs::File,
    io::Write,
    path::Path,
    time::{SystemTime, UNIX_EPOCH},
};

/// The file, if there is one.
pub struct Diary {
    file: Option<File>,
    /// The clock at ready, s; taken with the first note.
    began: Option<f64>,
}

impl Diary {
    pub fn create(path: Option<&Path>) -> Result<Self, Failure> {
        let file = path.map(|path| File::create(path).map_err(|e| Failure::io(path.display(), &e))).transpose()?;
        Ok(Self { file, began: None })
    }

    /// Notes a command or a byte that is none.
    pub fn command(&mut self, heard: &ReceivedCommand) {
        if self.file.is_none() {
            return;
        }
        let what = if heard.was_obeyed { "command" } else { "ignored" };
        let bytes = heard.bytes.iter().fold(String::new(), |mut text, byte| {
            let _ = write!(text, " {byte}");
            text
        });
        self.note(heard.time_s, format_args!("{what}{bytes}"));
    }

    /// Notes something that happened `time_s` seconds after ready. A disk that is full is no reason to stop the robot.
    pub fn note(&mut self, time_s: f64, what: Arguments<'_>) {
        let Some(file) = &mut self.file else { return };
        let began = *self.began.get_or_insert_with(|| {
            let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
            now.as_secs_f64() - time_s
        });
        let _ = writeln!(file, "{time_s:.4} {:.1} {what}", 1000.0 * (began + time_s));
    }
}

/// Whether a command makes the wheels turn, or starts one of the robot's own programs.
pub fn moves(bytes: &[u8]) -> bool {
    match Command::parse(bytes) {
        Ok(Command::DriveDirect { right, left } | Command::DrivePwm { right, left }) => (right, left) != (0, 0),
        Ok(Command::Drive { velocity, .. }) => velocity != 0,
        Ok(Command::Clean | Command::Spot | Command::Max | Command::SeekDock) => true,
        Ok(Command::Buttons(buttons)) => buttons.clean || buttons.spot || buttons.dock,
        _ => false,
    }
}

//! What a recording of a line contains: its timeline in words, and its readings as a table.
//!
//! The [format](crate::connection::LineRecording) holds the bytes alone. Here they are played through the same driver as on
//! the line, so that frames are taken and refused as they were then.
//!
//! ```
//! use robovac_link::{connection::LineRecording, recording::Examination};
//! let text = "robovac-oi-recording 1\n0.0 ! open\n0.5 > 80 87\n2.0 ! lost The port was unplugged.\n";
//! let mut examination = Examination::new(LineRecording::parse(text).unwrap());
//! while examination.go_on(60.0) {}
//! let timeline = examination.timeline();
//! let texts: Vec<String> = timeline.entries.iter().map(ToString::to_string).collect();
//! assert_eq!(texts[..2], ["0:00.0  The line was opened.", "0:00.5  Command Clean."]);
//! assert!(timeline.entries.iter().any(|entry| entry.is_fault));
//! ```

mod episode;
mod table;
mod timeline;
mod watch;
mod words;

pub use table::{csv, table_header, table_row};
pub use timeline::Examination;
pub use watch::{LineEvent, RecordedReading, Watch};
pub use words::{EntryKind, Timeline, TimelineEntry};

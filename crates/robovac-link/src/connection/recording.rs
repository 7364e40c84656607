//! Recording of all serial traffic, with times, as a text file.
//!
//! The file is read line by line. The first line is `robovac-oi-recording 1`. Every other line has a time in seconds since the
//! recording began, a sign, and something:
//!
//! | sign | what follows | meaning |
//! |---|---|---|
//! | `>` | bytes in hexadecimal | sent to the robot |
//! | `<` | bytes in hexadecimal | received from it |
//! | `!` | words | what happened to the line or was asked for: `open`, `lost why`, `baud 19200`, `brc low`, `brc high` |
//! | `?` | JSON | what the user asked for |
//!
//! Empty lines and lines that begin with `#` mean nothing.

use super::traffic::hex;
use std::fmt::Write;
use thiserror::Error;

/// First line of a recording.
pub const MAGIC: &str = "robovac-oi-recording 1";
/// Bytes of a recording that are kept: an hour at full rate takes about 25 MB.
const MOST_BYTES: usize = 96 << 20;
/// Longest time that is read, s: more than ten days.
const LONGEST_S: f64 = 1e6;
/// Largest file that is read.
const MOST_READ: usize = 512 << 20;

/// Something that happened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RecordedEvent {
    /// Bytes to the robot.
    Sent(Vec<u8>),
    /// Bytes from it.
    Received(Vec<u8>),
    /// To the line.
    Line(String),
    /// What the user asked for, as JSON.
    Asked(String),
}

/// What happened, and when, in s since it began.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LineRecording {
    /// In order.
    pub entries: Vec<(f64, RecordedEvent)>,
}

/// Why a file is no recording. The text names the line.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum RecordingError {
    /// It begins with something else.
    #[error("this is not a recording: its first line should be \"{MAGIC}\", but it is \"{0}\"")]
    NotARecording(String),
    /// It is of a later version.
    #[error("this recording has version {0}, but this program reads version 1; reload the page to update it")]
    Version(String),
    /// It is too long.
    #[error("the file has {0} MB; recordings can have at most {most} MB", most = MOST_READ >> 20)]
    TooLong(usize),
    /// A line isn't as it should be.
    #[error("line {line}: {what}; lines look like \"1.250 < 13 02 23 01 C7\"")]
    Line {
        /// Counted from 1.
        line: usize,
        /// What is wrong.
        what: String,
    },
}

impl LineRecording {
    /// Reads a file.
    ///
    /// ```
    /// use robovac_link::connection::{RecordedEvent, LineRecording};
    /// let recording = LineRecording::parse("robovac-oi-recording 1\n0.4 > 80 8E 23\n0.415 < 01\n").unwrap();
    /// assert_eq!(recording.entries[1], (0.415, RecordedEvent::Received(vec![1])));
    /// let error = LineRecording::parse("robovac-oi-recording 1\n0.4 > 8G\n").unwrap_err();
    /// assert_eq!(error.to_string(), "line 2: \"8G\" isn't a byte; lines look like \"1.250 < 13 02 23 01 C7\"");
    /// ```
    pub fn parse(text: &str) -> Result<Self, RecordingError> {
        if text.len() > MOST_READ {
            return Err(RecordingError::TooLong(text.len() >> 20));
        }
        let mut lines = text.lines().map(str::trim).enumerate();
        let first = lines.next().map_or("", |(_, line)| line.trim_start_matches('\u{feff}'));
        if first != MAGIC {
            return Err(match first.strip_prefix("robovac-oi-recording ") {
                Some(version) => RecordingError::Version(version.chars().take(20).collect()),
                None => RecordingError::NotARecording(first.chars().take(40).collect()),
            });
        }
        let mut entries = Vec::new();
        let mut before = 0.0;
        for (index, line) in lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#')) {
            let fail = |what: String| RecordingError::Line { line: index + 1, what };
            let (time, rest) = line.split_once(' ').ok_or_else(|| fail("nothing follows the time".into()))?;
            let at: f64 = time.parse().map_err(|_| fail(format!("\"{time}\" isn't a time")))?;
            if at.is_nan() || at > LONGEST_S {
                return Err(fail(format!("time {time} is out of range: recordings last {LONGEST_S} s at most")));
            }
            if at < before {
                return Err(fail(format!("time {at} comes after {before}; times must not decrease")));
            }
            before = at;
            let mut rest = rest.trim_start().chars();
            let sign = rest.next();
            let data = rest.as_str().trim_start();
            entries.push((
                at,
                match sign {
                    Some('>') => RecordedEvent::Sent(bytes(data).map_err(fail)?),
                    Some('<') => RecordedEvent::Received(bytes(data).map_err(fail)?),
                    Some('!') => RecordedEvent::Line(data.to_owned()),
                    Some('?') => RecordedEvent::Asked(data.to_owned()),
                    other => return Err(fail(format!("\"{}\" isn't one of > < ! ?", other.unwrap_or(' ')))),
                },
            ));
        }
        Ok(Self { entries })
    }
}

fn bytes(text: &str) -> Result<Vec<u8>, String> {
    let words = text.split_ascii_whitespace();
    let byte = |word: &str| {
        let is_two = word.len() == 2 && word.is_ascii();
        is_two.then(|| u8::from_str_radix(word, 16).ok()).flatten()
    };
    words
        .map(|word| byte(word).ok_or_else(|| format!("\"{}\" isn't a byte", word.chars().take(20).collect::<String>())))
        .collect()
}

/// Writes a recording as things happen.
#[derive(Debug, Default)]
pub(super) struct Recorder {
    entries: Vec<(f64, RecordedEvent)>,
    size: usize,
    is_full: bool,
}

impl Recorder {
    /// Something happened; bytes that come at once are one entry.
    pub fn note(&mut self, now: f64, entry: RecordedEvent) {
        if self.is_full {
            return;
        }
        self.size += match &entry {
            RecordedEvent::Sent(bytes) | RecordedEvent::Received(bytes) => bytes.len() + 40,
            RecordedEvent::Line(text) | RecordedEvent::Asked(text) => text.len() + 40,
        };
        if self.size > MOST_BYTES {
            self.is_full = true;
            self.entries.push((now, RecordedEvent::Line("recording full: nothing after this is recorded".to_owned())));
            return;
        }
        self.entries.push((now, entry));
    }

    /// The file.
    pub fn text(&self) -> String {
        let began = self.entries.first().map_or(0.0, |(at, _)| *at);
        let mut text = format!("{MAGIC}\n");
        for (at, entry) in &self.entries {
            let (sign, data) = match entry {
                RecordedEvent::Sent(bytes) => ('>', hex(bytes)),
                RecordedEvent::Received(bytes) => ('<', hex(bytes)),
                RecordedEvent::Line(words) => ('!', words.clone()),
                RecordedEvent::Asked(json) => ('?', json.clone()),
            };
            // Writing to a string doesn't fail.
            let _ = writeln!(text, "{:.4} {sign} {}", at - began, data.replace(['\n', '\r'], " "));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let mut recorder = Recorder::default();
        let entries = [
            (10.0, RecordedEvent::Line("open".into())),
            (10.5, RecordedEvent::Sent(vec![128, 142, 35])),
            (10.515, RecordedEvent::Received(vec![1])),
            (11.0, RecordedEvent::Asked(r#"{"do":"stop"}"#.into())),
        ];
        for (at, entry) in &entries {
            recorder.note(*at, entry.clone());
        }
        let read = LineRecording::parse(&recorder.text()).unwrap().entries;
        assert_eq!(read, entries.map(|(at, entry)| (at - 10.0, entry)).map(|(at, e)| ((at * 1e4).round() / 1e4, e)));
    }

    #[test]
    fn refusals_name_the_line() {
        let refused = |lines: &str| LineRecording::parse(&format!("{MAGIC}\n{lines}")).unwrap_err().to_string();
        assert!(LineRecording::parse("{}").unwrap_err().to_string().contains("but it is \"{}\""));
        assert!(LineRecording::parse("robovac-oi-recording 2").unwrap_err().to_string().contains("version 2"));
        assert!(refused("0.1 < 01\n0.05 < 02").starts_with("line 3: time 0.05 comes after 0.1"));
        assert!(refused("# fine\n\nsoon < 01").starts_with("line 4: \"soon\" isn't a time"));
        assert!(refused("1.0 = 01").starts_with("line 2: \"=\" isn't one of"));
        assert!(refused("1.0 < 1").starts_with("line 2: \"1\" isn't a byte"));
        assert!(refused("NaN < 1").starts_with("line 2: time NaN"));
        assert!(refused("1e18 < 01").starts_with("line 2: time 1e18"));
    }
}

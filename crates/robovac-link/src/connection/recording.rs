//! Recording of all serial traffic, with times, as a text file.
//!
//! The first line is `robovac-oi-recording 1`. Every other line has a time in seconds since the start of the recording,
//! a sign, and its content:
//!
//! | sign | what follows | meaning |
//! |---|---|---|
//! | `>` | bytes in hexadecimal | sent to the robot |
//! | `<` | bytes in hexadecimal | received from it |
//! | `!` | words | what happened to the line or was asked for: `open`, `lost why`, `baud 19200`, `brc low`, `brc high` |
//! | `?` | JSON | what the user asked for |
//!
//! Empty lines and lines that begin with `#` are ignored.

use super::traffic::hex;
use std::fmt::Write;
use thiserror::Error;

/// First line of a recording.
pub const MAGIC: &str = "robovac-oi-recording 1";
/// Most bytes of a recording that is kept in memory: more than two hours at full rate.
const MOST_BYTES: usize = 96 << 20;
/// Longest time that can be read, s: more than ten days.
const LONGEST_S: f64 = 1e6;
/// Largest file that can be read.
const MOST_READ: usize = 512 << 20;

/// A recorded event.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RecordedEvent {
    /// Bytes to the robot.
    Sent(Vec<u8>),
    /// Bytes from the robot.
    Received(Vec<u8>),
    /// A request to the line.
    Line(String),
    /// A request of the user, as JSON.
    Asked(String),
}

/// The events of a recording.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LineRecording {
    /// The events with their times, s since the start, in order.
    pub entries: Vec<(f64, RecordedEvent)>,
}

/// Reasons why a file isn't a recording. The message names the line.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum RecordingError {
    /// It begins with another text.
    #[error("this is not a recording: its first line should be \"{MAGIC}\", but it is \"{0}\"")]
    NotARecording(String),
    /// It is of a later version.
    #[error("this recording has version {0}, but this program reads version 1; reload the page to update it")]
    Version(String),
    /// It is too long.
    #[error("the file has {0} MB; recordings can have at most {most} MB", most = MOST_READ >> 20)]
    TooLong(usize),
    /// An invalid line.
    #[error("line {line}: {what}; lines look like \"1.250 < 13 02 23 01 C7\"")]
    Line {
        /// Counted from 1.
        line: usize,
        /// Description of the error.
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

/// Records events.
#[derive(Debug, Default)]
pub(super) struct Recorder {
    entries: Vec<(f64, RecordedEvent)>,
    size: usize,
    is_full: bool,
    is_news: bool,
    /// Time of the first entry, s.
    began: Option<f64>,
    has_header: bool,
}

impl Recorder {
    /// Adds an event; bytes at the same time become one entry.
    pub fn note(&mut self, now: f64, entry: RecordedEvent) {
        if self.is_full {
            return;
        }
        self.began.get_or_insert(now);
        self.size += match &entry {
            RecordedEvent::Sent(bytes) | RecordedEvent::Received(bytes) => bytes.len() + 40,
            RecordedEvent::Line(text) | RecordedEvent::Asked(text) => text.len() + 40,
        };
        if self.size > MOST_BYTES {
            (self.is_full, self.is_news) = (true, true);
            self.entries.push((now, RecordedEvent::Line("recording full: nothing after this is recorded".to_owned())));
            return;
        }
        self.entries.push((now, entry));
    }

    /// Whether it has become full since the last call: no more events are recorded.
    pub fn has_filled_up(&mut self) -> bool {
        std::mem::take(&mut self.is_news)
    }

    /// The file.
    pub fn text(&self) -> String {
        format!("{MAGIC}\n{}", self.lines())
    }

    /// What the file has had since the last call, which is forgotten here.
    pub fn take(&mut self) -> String {
        let lines = self.lines();
        self.entries.clear();
        self.size = 0;
        if std::mem::replace(&mut self.has_header, true) { lines } else { format!("{MAGIC}\n{lines}") }
    }

    fn lines(&self) -> String {
        let began = self.began.unwrap_or(0.0);
        let mut text = String::new();
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
    fn what_is_taken_bit_by_bit_is_the_same_file() {
        let (mut kept, mut taken) = (Recorder::default(), Recorder::default());
        let mut file = String::new();
        for (number, at) in [10.0, 10.5, 10.515, 12.0].into_iter().enumerate() {
            for recorder in [&mut kept, &mut taken] {
                recorder.note(at, RecordedEvent::Received(vec![number as u8; 3]));
            }
            if number % 2 == 1 {
                file += &taken.take();
            }
        }
        assert_eq!(file, kept.text());
        assert!(taken.take().is_empty());
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

//! Lines of a program: see docs/program-protocol.md.

use serde::Deserialize;

/// Version of the protocol.
pub const PROTOCOL: u32 = 1;
/// Most lines of an error message that are shown, and letters of each.
const MOST_LINES: usize = 20;
const MOST_LETTERS: usize = 400;

/// A line from a program. What a line doesn't have stays empty; other keys, such as those of drawings, are for the page.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(default)]
pub struct Reply {
    /// The answer to the greeting: `behaviour` or `planner`.
    pub ready: Option<String>,
    /// Whether it takes frames, which the greeting offers.
    pub frames: bool,
    /// Speed of the left wheel, mm/s.
    pub left: Option<f64>,
    /// Speed of the right wheel, mm/s.
    pub right: Option<f64>,
    /// Whether it has nothing left to do.
    pub done: bool,
    /// For how many steps after the next one the speeds stay as they are, unless contact with a thing or with the floor
    /// changes before: bumper, cliff sensors, wheel drops. So a motion doesn't need an answer for every step.
    pub hold: u32,
    /// What it printed.
    pub print: Vec<String>,
    /// Cells of a plan.
    pub cells: Vec<[i64; 2]>,
    /// What went wrong in it.
    pub error: Option<String>,
    /// Where: line of its text, from 1.
    pub line: Option<u64>,
}

/// Bytes of a program as text for users.
pub struct Words;

impl Words {
    /// The last lines, without control characters.
    pub fn of(bytes: &[u8]) -> String {
        let text = String::from_utf8_lossy(bytes);
        let lines: Vec<&str> = text.lines().map(str::trim_end).filter(|line| !line.is_empty()).collect();
        let last = &lines[lines.len().saturating_sub(MOST_LINES)..];
        let plain = |line: &&str| -> String {
            line.chars().filter(|c| !c.is_control() || *c == '\t').take(MOST_LETTERS).collect()
        };
        last.iter().map(plain).collect::<Vec<_>>().join("\n")
    }
}

impl Reply {
    /// Reads a line. An error that it reports is an error here.
    pub fn parse(line: &[u8]) -> Result<Self, String> {
        let reply: Self = serde_json::from_slice(line).map_err(|error| {
            let shown: String = Words::of(line).chars().take(80).collect();
            format!(
                "the program wrote \"{shown}\", which isn't a line of the protocol ({error}); print to standard error, \
                 or put the text into \"print\""
            )
        })?;
        match (&reply.error, reply.line) {
            (Some(error), Some(line)) => Err(format!("line {line}: {}", Words::of(error.as_bytes()))),
            (Some(error), None) => Err(Words::of(error.as_bytes())),
            (None, _) => Ok(reply),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read_and_faults_are_told() {
        let reply = Reply::parse(b"{\"left\": 300, \"right\": -12.5, \"mark\": [1, 2], \"print\": [\"x\"]}\n").unwrap();
        assert_eq!((reply.left, reply.right, reply.done), (Some(300.0), Some(-12.5), false));
        assert_eq!(reply.print, ["x"]);
        let error = Reply::parse(b"{\"error\": \"division by zero\", \"line\": 7}").unwrap_err();
        assert_eq!(error, "line 7: division by zero");
        for bad in ["hello", "{\"left\": \"fast\"}", "[1]", "{\"cells\": [[1]]}", "\u{1b}[31m{"] {
            let error = Reply::parse(bad.as_bytes()).unwrap_err();
            assert!(error.contains("isn't a line of the protocol") && !error.contains('\u{1b}'), "{error}");
        }
    }
}

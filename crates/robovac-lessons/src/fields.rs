//! The `key: value` lines of a fenced block, and the numbers in them.

use crate::{LessonFault, Link, fixed::short};

/// One line of a block.
#[derive(Debug, Clone)]
pub struct BlockLine {
    /// Line of the file, from 1.
    pub line: usize,
    key: String,
    /// What stands behind the colon.
    pub value: String,
}

/// Digits that a float holds exactly.
const MOST_DIGITS: usize = 15;

/// A number as people write it, `-42.5`. What a calculator shows beyond 15 digits makes no difference. All that is exact with
/// two floats and one division; the library's reader of any number weighs more than the rest of this crate.
pub fn decimal(text: &str) -> Option<f64> {
    let (sign, digits) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let is_number = [whole, part].iter().all(|digits| digits.bytes().all(|digit| digit.is_ascii_digit()));
    if !is_number || digits == "." || digits.is_empty() || whole.len() > MOST_DIGITS {
        return None;
    }
    let part = part.get(..MOST_DIGITS - whole.len()).unwrap_or(part);
    let all = whole.bytes().chain(part.bytes());
    let number = all.fold(0_u64, |number, digit| 10 * number + u64::from(digit - b'0'));
    let scale = part.bytes().fold(1.0, |scale, _| 10.0 * scale);
    Some(sign * (number as f64 / scale))
}

/// The lines of one block; they are taken out by their keys.
#[derive(Debug)]
pub struct BlockLines {
    kind: &'static str,
    line: usize,
    lines: Vec<BlockLine>,
    known: Vec<&'static str>,
    /// Keys that were there and taken.
    taken: Vec<&'static str>,
}

impl BlockLines {
    /// Reads the lines of the block `kind`, whose fence is on `line`. An indented line continues the one before.
    pub fn parse(kind: &'static str, line: usize, text: &str) -> Result<Self, LessonFault> {
        let mut lines: Vec<BlockLine> = Vec::new();
        for (index, row) in text.lines().enumerate() {
            let at = line + 1 + index;
            if row.trim().is_empty() {
                continue;
            }
            if let Some(last) = lines.last_mut().filter(|_| row.starts_with("  ")) {
                last.value.push(' ');
                last.value.push_str(row.trim());
                continue;
            }
            let pair = row.split_once(':').filter(|(key, _)| !key.trim().is_empty());
            let Some((key, value)) = pair else {
                let what =
                    format!("\"{}\" in the block \"{kind}\" is not a line of the form \"key: value\"", row.trim());
                return Err(LessonFault::new(
                    at,
                    what,
                    "write e.g. \"minutes: 12\", or indent a line that continues another",
                ));
            };
            lines.push(BlockLine { line: at, key: key.trim().to_owned(), value: value.trim().to_owned() });
        }
        Ok(Self { kind, line, lines, known: Vec::new(), taken: Vec::new() })
    }

    /// The settings links, each with its line: a row's stands on that of "in".
    pub fn links(&self) -> Vec<(usize, String)> {
        let base = self.lines.iter().find(|field| field.key == "in").map(|field| Link::parse(&field.value));
        let of = |field: &BlockLine| match (field.key.as_str(), &base) {
            ("in" | "link", _) => Some(field.value.clone()),
            ("row", Some(base)) => Some(base.with(&Link::parse(field.value.split_once('|')?.1)).to_string()),
            _ => None,
        };
        self.lines.iter().filter_map(|field| Some((field.line, of(field)?))).collect()
    }

    /// Line of the fence.
    pub fn line(&self) -> usize {
        self.line
    }

    /// Takes the field `key`, if there is one; a second one is a fault of [`BlockLines::finish`].
    pub fn take(&mut self, key: &'static str) -> Option<BlockLine> {
        self.known.push(key);
        let at = self.lines.iter().position(|field| field.key == key)?;
        self.taken.push(key);
        Some(self.lines.remove(at))
    }

    /// Whether there was a field `key`.
    pub fn has_had(&self, key: &str) -> bool {
        self.taken.contains(&key)
    }

    /// Takes all fields `key`.
    pub fn take_all(&mut self, key: &'static str) -> Vec<BlockLine> {
        self.known.push(key);
        let (taken, left) = self.lines.drain(..).partition(|field| field.key == key);
        self.lines = left;
        taken
    }

    /// Takes the text of `key`, or nothing.
    pub fn text(&mut self, key: &'static str) -> String {
        self.take(key).map(|field| field.value).unwrap_or_default()
    }

    /// Takes a field that must be there.
    pub fn need(&mut self, key: &'static str, example: &str) -> Result<BlockLine, LessonFault> {
        self.take(key).ok_or_else(|| self.lack(key, example))
    }

    /// The fault that `key` is missing.
    pub fn lack(&self, key: &str, example: &str) -> LessonFault {
        let what = format!("the block \"{}\" has no line \"{key}\"", self.kind);
        LessonFault::new(self.line, what, format!("add e.g. \"{key}: {example}\""))
    }

    /// Takes a number within a range, or the default.
    pub fn number(
        &mut self,
        key: &'static str,
        default: f64,
        range: std::ops::RangeInclusive<f64>,
    ) -> Result<f64, LessonFault> {
        let Some(field) = self.take(key) else { return Ok(default) };
        let number = decimal(&field.value).filter(|number| range.contains(number));
        number.ok_or_else(|| {
            let what = format!("\"{key}\" can't be \"{}\"", field.value);
            LessonFault::new(
                field.line,
                what,
                format!("use a number from {} to {}", short(*range.start()), short(*range.end())),
            )
        })
    }

    /// Fails if a field is left over.
    pub fn finish(self) -> Result<(), LessonFault> {
        let Some(field) = self.lines.first() else { return Ok(()) };
        let what = if self.known.contains(&field.key.as_str()) {
            format!("the block \"{}\" has a second line \"{}\"", self.kind, field.key)
        } else {
            format!("the block \"{}\" has no key \"{}\"", self.kind, field.key)
        };
        Err(LessonFault::new(field.line, what, format!("it takes: {}", self.known.join(", "))))
    }
}

#[cfg(test)]
mod tests {
    use super::decimal;

    #[test]
    fn numbers_are_those_of_the_library() {
        for text in ["0", "95", "0.1", "-42.5", "123456789.012345", "0.00000000000001", "999999999999999", ".5", "7."] {
            assert_eq!(decimal(text), text.parse().ok(), "{text}");
        }
        for text in ["", "-", ".", "1e3", "inf", "nan", "+1", "--1", "1.2.3", "1234567890123456", "١"] {
            assert_eq!(decimal(text), None, "{text}");
        }
    }
}

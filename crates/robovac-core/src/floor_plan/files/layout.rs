//! Formats a scenario's JSON: one line per key, map row and object.

use serde_json::ser::Formatter;
use std::io::{Result, Write};

/// Breaks the lines of the outermost object and of the lists in it, nothing deeper.
#[derive(Debug, Default)]
pub(super) struct JsonLayout {
    /// For every open list or object, whether it is broken into lines.
    open: Vec<bool>,
    is_empty: bool,
}

impl JsonLayout {
    fn begin<W: ?Sized + Write>(&mut self, writer: &mut W, bracket: &[u8], is_broken: bool) -> Result<()> {
        self.open.push(is_broken);
        self.is_empty = true;
        writer.write_all(bracket)
    }

    fn next<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool, space: &[u8]) -> Result<()> {
        self.is_empty = false;
        if !first {
            writer.write_all(b",")?;
        }
        if self.open.last() == Some(&true) {
            new_line(writer, self.open.len())
        } else {
            writer.write_all(if first { space } else { b" " })
        }
    }

    fn end<W: ?Sized + Write>(&mut self, writer: &mut W, space: &[u8], bracket: &[u8]) -> Result<()> {
        let is_broken = self.open.pop() == Some(true);
        if !std::mem::take(&mut self.is_empty) {
            if is_broken { new_line(writer, self.open.len())? } else { writer.write_all(space)? }
        }
        writer.write_all(bracket)
    }
}

fn new_line<W: ?Sized + Write>(writer: &mut W, depth: usize) -> Result<()> {
    writer.write_all(b"\n")?;
    (0..depth).try_for_each(|_| writer.write_all(b"  "))
}

impl Formatter for JsonLayout {
    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        let is_broken = self.open.len() == 1;
        self.begin(writer, b"[", is_broken)
    }

    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        self.end(writer, b"", b"]")
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> Result<()> {
        self.next(writer, first, b"")
    }

    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        let is_broken = self.open.is_empty();
        self.begin(writer, b"{", is_broken)
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        self.end(writer, b" ", b"}")
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> Result<()> {
        self.next(writer, first, b" ")
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> Result<()> {
        writer.write_all(b": ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Serialize;

    #[test]
    fn only_the_outermost_is_broken_into_lines() {
        let value = serde_json::json!({
            "a": { "b": [1, [], {}] }, "c": [], "d": [{ "e": [[1, 2], [3, 4]] }, "x"], "f": {}
        });
        let mut text = Vec::new();
        value.serialize(&mut serde_json::Serializer::with_formatter(&mut text, JsonLayout::default())).unwrap();
        let expected = "{\n  \"a\": { \"b\": [1, [], {}] },\n  \"c\": [],\n  \"d\": [\n    { \"e\": [[1, 2], [3, 4]] },\n    \"x\"\n  ],\n  \"f\": {}\n}";
        assert_eq!(String::from_utf8(text).unwrap(), expected);
    }
}

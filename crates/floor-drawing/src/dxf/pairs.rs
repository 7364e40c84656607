//! The syntax of DXF files: pairs of a group code and a value, in text or binary.

use crate::DrawingFlaw;
use std::borrow::Cow;

/// The first bytes of binary DXFs.
pub(crate) const BINARY: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

/// A value. In text files all values are text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum DxfValue<'a> {
    /// Text without the blanks around it; names may be in any encoding.
    Text(&'a [u8]),
    /// A floating-point number of a binary DXF.
    Real(f64),
    /// An integer of a binary DXF.
    Whole(i64),
}

/// A group code, its value and its position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair<'a> {
    pub code: i32,
    pub value: DxfValue<'a>,
    /// Position of the group code: in text its line, counted from 1; in binary its byte, counted from 0.
    pub at: usize,
    /// Bytes from the start of the file to the group code.
    pub start: usize,
}

/// A fault and its position, see [`Pair::at`].
pub(crate) type DxfFault = (usize, DrawingFlaw);

impl<'a> Pair<'a> {
    /// The value as text; nothing for numbers.
    pub fn text(&self) -> &'a [u8] {
        if let DxfValue::Text(text) = self.value { text } else { b"" }
    }

    /// The value as a number, finite or not.
    pub fn real(&self) -> Result<f64, DxfFault> {
        match self.value {
            DxfValue::Real(value) => Ok(value),
            DxfValue::Whole(value) => Ok(value as f64),
            DxfValue::Text(text) => std::str::from_utf8(text)
                .ok()
                .and_then(|text| text.parse().ok())
                .ok_or_else(|| (self.at + 1, DrawingFlaw::Value { code: self.code, found: shown(text) })),
        }
    }

    /// The value as an integer; some programs write integers with a decimal point.
    pub fn whole(&self) -> Result<i64, DxfFault> {
        match self.value {
            DxfValue::Whole(value) => Ok(value),
            _ => self.real().map(|value| value as i64),
        }
    }
}

/// Whether the bytes are a DXF: binary, or a text that begins with a section or a comment.
pub(crate) fn is_dxf(bytes: &[u8]) -> bool {
    if bytes.starts_with(BINARY) {
        return true;
    }
    let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let mut lines = start.splitn(3, |&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    match (lines.next(), lines.next()) {
        (Some(b"0"), Some(value)) => value == b"SECTION",
        (Some(b"999"), Some(_)) => true,
        _ => false,
    }
}

/// All pairs; ends after the first fault.
pub(crate) struct Pairs<'a> {
    bytes: &'a [u8],
    position: usize,
    line: usize,
    form: Form,
}

/// Form of a DXF file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// Text.
    Text,
    /// Up to R12: group codes of one byte, or 255 and two bytes.
    Short,
    /// From R13 on: group codes of two bytes.
    Long,
}

impl<'a> Pairs<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        let (position, form) = match bytes.strip_prefix(BINARY) {
            Some([0, 0, ..]) => (BINARY.len(), Form::Long),
            Some(_) => (BINARY.len(), Form::Short),
            None => (if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }, Form::Text),
        };
        Self { bytes, position, line: 0, form }
    }

    /// Form of the file.
    pub fn form(&self) -> Form {
        self.form
    }

    /// Whether the file is text.
    pub fn is_text(&self) -> bool {
        self.form == Form::Text
    }

    /// Lines read so far; 0 for binary files.
    pub fn line(&self) -> usize {
        self.line
    }

    /// Bytes from the start of the file to the next pair.
    pub fn position(&self) -> usize {
        self.position
    }

    /// The next pair; `None` at the end of the file.
    pub fn next(&mut self) -> Result<Option<Pair<'a>>, DxfFault> {
        if self.form == Form::Text { self.next_text() } else { self.next_binary() }
    }

    fn next_text(&mut self) -> Result<Option<Pair<'a>>, DxfFault> {
        let start = self.position;
        let Some(line) = self.take_line() else { return Ok(None) };
        let at = self.line;
        let line = line.trim_ascii();
        let Some(code) = number(line).filter(|code| (-5..=1071).contains(code)) else {
            // Empty lines at the end.
            if self.bytes[start..].trim_ascii().is_empty() {
                return Ok(None);
            }
            return Err((at, DrawingFlaw::Code { found: shown(line) }));
        };
        let Some(value) = self.take_line() else {
            return Err((at, DrawingFlaw::CutOff { place: "between a group code and its value" }));
        };
        Ok(Some(Pair { code, value: DxfValue::Text(value.trim_ascii()), at, start }))
    }

    fn take_line(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.position..).filter(|rest| !rest.is_empty())?;
        let end = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        self.position += end + 1;
        self.line += 1;
        Some(&rest[..end])
    }

    fn next_binary(&mut self) -> Result<Option<Pair<'a>>, DxfFault> {
        let start = self.position;
        if start >= self.bytes.len() {
            return Ok(None);
        }
        let code = if self.form == Form::Long {
            i32::from(i16::from_le_bytes(self.take(start)?))
        } else {
            match self.take::<1>(start)? {
                [255] => i32::from(i16::from_le_bytes(self.take(start)?)),
                [code] => i32::from(code),
            }
        };
        let value = match code {
            10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => {
                DxfValue::Real(f64::from_le_bytes(self.take(start)?))
            }
            60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => {
                DxfValue::Whole(i16::from_le_bytes(self.take(start)?).into())
            }
            90..=99 | 420..=429 | 440..=459 | 1071 => DxfValue::Whole(i32::from_le_bytes(self.take(start)?).into()),
            160..=169 => DxfValue::Whole(i64::from_le_bytes(self.take(start)?)),
            290..=299 => DxfValue::Whole(self.take::<1>(start)?[0].into()),
            310..=319 | 1004 => {
                let [length] = self.take::<1>(start)?;
                self.skip(start, usize::from(length))?;
                DxfValue::Text(b"")
            }
            -5..=1071 => {
                let rest = &self.bytes[self.position..];
                let end = rest.iter().position(|&byte| byte == 0).ok_or((start, CUT))?;
                self.position += end + 1;
                DxfValue::Text(rest[..end].trim_ascii())
            }
            _ => return Err((start, DrawingFlaw::Code { found: code.to_string() })),
        };
        Ok(Some(Pair { code, value, at: start, start }))
    }

    fn take<const N: usize>(&mut self, start: usize) -> Result<[u8; N], DxfFault> {
        let bytes = self.bytes[self.position..].first_chunk().ok_or((start, CUT))?;
        self.position += N;
        Ok(*bytes)
    }

    fn skip(&mut self, start: usize, length: usize) -> Result<(), DxfFault> {
        if self.bytes.len() - self.position < length {
            return Err((start, CUT));
        }
        self.position += length;
        Ok(())
    }
}

const CUT: DrawingFlaw = DrawingFlaw::CutOff { place: "within a value" };

fn number(text: &[u8]) -> Option<i32> {
    // Parsed by hand for speed, as such numbers make up half of a file.
    if let [first, rest @ ..] = text
        && text.len() <= 4
        && first.is_ascii_digit()
        && rest.iter().all(u8::is_ascii_digit)
    {
        return Some(text.iter().fold(0, |sum, digit| 10 * sum + i32::from(digit - b'0')));
    }
    std::str::from_utf8(text).ok()?.parse().ok()
}

/// Most bytes of an excerpt that isn't text.
const BYTES: usize = 8;

/// An excerpt of invalid bytes, for messages.
fn shown(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(40)]);
    if text.chars().take(30).any(|c| c.is_control() || c == char::REPLACEMENT_CHARACTER) {
        // Signs that can't be read would look like a fault of the message.
        let first: Vec<String> = bytes.iter().take(BYTES).map(|byte| format!("{byte:02x}")).collect();
        return format!("bytes {}{}", first.join(" "), if bytes.len() > BYTES { " ..." } else { "" });
    }
    text.chars().take(30).collect()
}

/// Decodes text: UTF-8 as of release 2007, else the code page; characters may be written as `\U+XXXX` too.
pub(crate) fn decode(bytes: &[u8], code_page: &'static encoding_rs::Encoding) -> String {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => code_page.decode_without_bom_handling(bytes).0,
    };
    let mut parts = text.split("\\U+");
    let mut result = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let letter = part.get(..4).and_then(|hex| u32::from_str_radix(hex, 16).ok()).and_then(char::from_u32);
        if let Some(letter) = letter {
            result.push(letter);
            result.push_str(&part[4..]);
        } else {
            result.push_str("\\U+");
            result.push_str(part);
        }
    }
    result
}

/// The encoding that `$DWGCODEPAGE` names, Western European if it is unknown.
pub(crate) fn code_page(name: &[u8]) -> &'static encoding_rs::Encoding {
    let name = name.to_ascii_lowercase();
    let label: &[u8] = match name.strip_prefix(b"ansi_").unwrap_or(&name) {
        b"932" | b"dos932" => b"shift_jis",
        b"936" => b"gbk",
        b"949" => b"euc-kr",
        b"950" => b"big5",
        b"874" => b"windows-874",
        b"1250" => b"windows-1250",
        b"1251" => b"windows-1251",
        b"1253" => b"windows-1253",
        b"1254" => b"windows-1254",
        b"1255" => b"windows-1255",
        b"1256" => b"windows-1256",
        b"1257" => b"windows-1257",
        b"1258" => b"windows-1258",
        _ => b"windows-1252",
    };
    encoding_rs::Encoding::for_label(label).unwrap_or(encoding_rs::WINDOWS_1252)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_of_text_with_their_lines() {
        let mut pairs = Pairs::new(b"  0\r\nSECTION\r\n 10\n 1.5 \n\n\n");
        let section = pairs.next().unwrap().unwrap();
        assert_eq!((section.code, section.text(), section.at), (0, &b"SECTION"[..], 1));
        let x = pairs.next().unwrap().unwrap();
        assert_eq!((x.code, x.real(), x.at, x.start), (10, Ok(1.5), 3, 14));
        assert_eq!(pairs.next(), Ok(None));
        let fault = Pairs::new(b"zero\nSECTION\n").next().unwrap_err();
        assert_eq!(fault, (1, DrawingFlaw::Code { found: "zero".to_owned() }));
        let fault = Pairs::new(b"\x07\x9c\xffabcdefgh\nSECTION\n").next().unwrap_err();
        assert_eq!(fault, (1, DrawingFlaw::Code { found: "bytes 07 9c ff 61 62 63 64 65 ...".to_owned() }));
        assert!(matches!(Pairs::new(b"0").next(), Err((1, DrawingFlaw::CutOff { .. }))));
    }

    #[test]
    fn pairs_of_both_binary_forms() {
        let short = [BINARY, b"\0SECTION\0\x0a", &1.5_f64.to_le_bytes(), b"\xff\xe8\x03x\0"].concat();
        let long = [BINARY, b"\0\0SECTION\0\x0a\0", &1.5_f64.to_le_bytes(), b"\xe8\x03x\0"].concat();
        for bytes in [short, long] {
            let mut pairs = Pairs::new(&bytes);
            assert_eq!(pairs.next().unwrap().unwrap().text(), b"SECTION");
            assert_eq!(pairs.next().unwrap().unwrap().value, DxfValue::Real(1.5));
            let named = pairs.next().unwrap().unwrap();
            assert_eq!((named.code, named.text()), (1000, &b"x"[..]));
            assert_eq!(pairs.next(), Ok(None));
            let mut cut = Pairs::new(&bytes[..bytes.len() - 9]);
            cut.next().unwrap();
            assert!(matches!(cut.next(), Err((_, DrawingFlaw::CutOff { .. }))));
        }
    }

    #[test]
    fn names_in_old_and_new_encodings() {
        assert_eq!(decode("Wände".as_bytes(), code_page(b"ANSI_1252")), "Wände");
        assert_eq!(decode(b"W\xe4nde", code_page(b"")), "Wände");
        assert_eq!(decode(b"\xd1\xf2\xe5\xed\xfb", code_page(b"ANSI_1251")), "Стены");
        assert_eq!(decode(br"W\U+00E4nde\U+zz", code_page(b"")), r"Wände\U+zz");
    }
}

//! Encodes DXF pairs in the format of the target file.

use crate::dxf::Form;
use encoding_rs::Encoding;

/// A value of a DXF pair.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum EncodedValue {
    Text(String),
    Real(f64),
    /// Of 16 bits in binary files, as 62 and 70 are.
    Short(i64),
    /// Of 32 bits in binary files, as 90 is.
    Long(i64),
}

/// Writes pairs as bytes.
pub(super) struct Writer {
    form: Form,
    line_end: &'static str,
    encoding: &'static Encoding,
    pub bytes: Vec<u8>,
}

impl Writer {
    /// `is_crlf`: whether lines of text end as on Windows.
    pub fn new(form: Form, is_crlf: bool, encoding: &'static Encoding) -> Self {
        Self { form, line_end: if is_crlf { "\r\n" } else { "\n" }, encoding, bytes: Vec::new() }
    }

    pub fn text(&mut self, code: i32, value: &str) {
        self.pair(code, &EncodedValue::Text(value.to_owned()));
    }

    pub fn real(&mut self, code: i32, value: f64) {
        self.pair(code, &EncodedValue::Real(value));
    }

    pub fn short(&mut self, code: i32, value: i64) {
        self.pair(code, &EncodedValue::Short(value));
    }

    pub fn pair(&mut self, code: i32, value: &EncodedValue) {
        match self.form {
            Form::Text => {
                let value = match value {
                    EncodedValue::Text(text) => text.clone(),
                    EncodedValue::Real(real) => format!("{real:?}"),
                    EncodedValue::Short(whole) | EncodedValue::Long(whole) => whole.to_string(),
                };
                let end = self.line_end;
                self.bytes.extend(format!("{code:3}{end}").into_bytes());
                self.bytes.extend_from_slice(&self.encoding.encode(&value).0);
                self.bytes.extend_from_slice(end.as_bytes());
                return;
            }
            // No code that is written exceeds 254 in the old form.
            Form::Short => self.bytes.push(code as u8),
            Form::Long => self.bytes.extend((code as i16).to_le_bytes()),
        }
        match value {
            EncodedValue::Text(text) => {
                let text = self.encoding.encode(text).0;
                self.bytes.extend(text.iter().filter(|&&byte| byte != 0));
                self.bytes.push(0);
            }
            EncodedValue::Real(real) => self.bytes.extend(real.to_le_bytes()),
            EncodedValue::Short(whole) => self.bytes.extend((*whole as i16).to_le_bytes()),
            EncodedValue::Long(whole) => self.bytes.extend((*whole as i32).to_le_bytes()),
        }
    }
}

//! Scans a DXF for the positions and names needed to insert entities.

use crate::{
    DrawingFlaw,
    dxf::{Form, Pairs, code_page},
};

/// Positions in a DXF, in bytes from its start, and names and handles in use.
pub(super) struct DxfLandmarks {
    pub form: Form,
    pub is_crlf: bool,
    /// Number of `$ACADVER`, 1009 for R12; the default as well.
    pub release: u32,
    /// The encoding of text of releases before 2007.
    pub code_page: &'static encoding_rs::Encoding,
    /// The largest handle.
    pub last_handle: u64,
    /// The pair with the value of `$HANDSEED`.
    pub seed: Option<[usize; 2]>,
    /// The end of the table of layers, before its ENDTAB.
    pub layers_end: Option<usize>,
    /// The end of the section of tables, before its ENDSEC.
    pub tables_end: Option<usize>,
    /// The start of blocks or entities, with their SECTION.
    pub body: Option<usize>,
    /// The end of the entities, before their ENDSEC.
    pub entities_end: Option<usize>,
    pub layer_names: Vec<String>,
    pub layer_table: Option<String>,
    /// The handle of layers' plot style.
    pub plot_style: Option<String>,
    /// The handle of model space.
    pub model: Option<String>,
}

impl DxfLandmarks {
    /// Scans the file; errors name the line or byte.
    pub fn of(bytes: &[u8]) -> Result<Self, (usize, DrawingFlaw)> {
        let mut pairs = Pairs::new(bytes);
        let first_line = bytes.iter().position(|&byte| byte == b'\n').map_or(&b""[..], |end| &bytes[..end]);
        let mut survey = Self {
            form: pairs.form(),
            is_crlf: first_line.ends_with(b"\r"),
            release: 1009,
            code_page: encoding_rs::WINDOWS_1252,
            last_handle: 0,
            seed: None,
            layers_end: None,
            tables_end: None,
            body: None,
            entities_end: None,
            layer_names: Vec::new(),
            layer_table: None,
            plot_style: None,
            model: None,
        };
        let mut place = SectionPlace::default();
        while let Some(pair) = pairs.next()? {
            let text = || String::from_utf8_lossy(pair.text()).into_owned();
            if pair.code == 0 {
                survey.structure(&mut place, pair.text(), pair.start);
                place.start = pair.start;
                place.record = pair.text().to_vec();
                place.handle = None;
                if place.record == b"EOF" {
                    break;
                }
                continue;
            }
            match (pair.code, place.record.as_slice()) {
                // Within a section whose end is missing, none begins.
                (2, b"SECTION") if place.section.is_none() => {
                    place.section = Some(pair.text().to_vec());
                    if matches!(pair.text(), b"BLOCKS" | b"ENTITIES") {
                        survey.body.get_or_insert(place.start);
                    }
                }
                (9, b"SECTION") => place.variable = pair.text().to_vec(),
                (1, b"SECTION") if place.variable == b"$ACADVER" => {
                    survey.release = text().strip_prefix("AC").and_then(|n| n.parse().ok()).unwrap_or(1009);
                }
                (3, b"SECTION") if place.variable == b"$DWGCODEPAGE" => survey.code_page = code_page(pair.text()),
                (5, b"SECTION") if place.variable == b"$HANDSEED" => {
                    survey.seed = Some([pair.start, pairs.position().min(bytes.len())]);
                    survey.take_handle(&text());
                }
                (2, b"TABLE") => {
                    place.table = pair.text().to_vec();
                    if place.table == b"LAYER" {
                        survey.layer_table = place.handle.take();
                    }
                }
                (2, b"LAYER") => survey.layer_names.push(text().to_uppercase()),
                (390, b"LAYER") => survey.plot_style = survey.plot_style.take().or_else(|| Some(text())),
                (2, b"BLOCK_RECORD") if pair.text().eq_ignore_ascii_case(b"*MODEL_SPACE") => {
                    survey.model = place.handle.take();
                }
                (5, b"DIMSTYLE") => {}
                (5 | 105, record) => {
                    survey.take_handle(&text());
                    if record == b"TABLE" && place.table == b"LAYER" && survey.layer_table.is_none() {
                        survey.layer_table = Some(text());
                    }
                    place.handle = Some(text());
                }
                _ => {}
            }
        }
        Ok(survey)
    }

    fn structure(&mut self, place: &mut SectionPlace, name: &[u8], start: usize) {
        match (name, place.section.as_deref()) {
            (b"ENDTAB", Some(b"TABLES")) => {
                if place.table == b"LAYER" {
                    self.layers_end.get_or_insert(start);
                }
                place.table.clear();
            }
            (b"ENDSEC", section) => {
                match section {
                    Some(b"TABLES") => self.tables_end = Some(start),
                    Some(b"ENTITIES") => self.entities_end = Some(start),
                    _ => {}
                }
                place.section = None;
            }
            _ => {}
        }
    }

    fn take_handle(&mut self, text: &str) {
        // Larger handles are invalid or leave no room for new ones.
        let handle = u64::from_str_radix(text, 16).unwrap_or(0);
        if handle < 1 << 60 {
            self.last_handle = self.last_handle.max(handle);
        }
    }
}

#[derive(Default)]
struct SectionPlace {
    /// Between sections `None`.
    section: Option<Vec<u8>>,
    table: Vec<u8>,
    record: Vec<u8>,
    variable: Vec<u8>,
    handle: Option<String>,
    start: usize,
}

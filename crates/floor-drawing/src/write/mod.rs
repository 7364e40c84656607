//! Adds lines to a DXF on separate layers; nothing else is changed.

mod encode;
mod landmarks;
mod room;
mod template;

pub use room::outlines;

use super::{
    DrawingError, DrawingFlaw, Overlay,
    dxf::{Pairs, is_dxf},
    error::bad,
};
use encode::{EncodedValue, Writer};
use encoding_rs::Encoding;
use landmarks::DxfLandmarks;

/// Name of the drawing in messages; its file name isn't known here.
const NAME: &str = "the drawing";
/// The first release in which entities have handles and polylines are one entity: 13.
const FIRST_WITH_HANDLES: u32 = 1012;
/// The first release with text in UTF-8: 2007.
const FIRST_UNICODE: u32 = 1021;

/// A DXF with `overlays` on layers of their own, added to `original` (the bytes of a DXF) if there is one.
///
/// The bytes of the original are kept, in text and in binary: records of layers and polylines are inserted, with new
/// handles. If a layer of the same name exists the new one gets a number. Without an original the drawing is of release
/// 2000, and its unit is the metre.
///
/// ```
/// use floor_drawing::{Overlay, read, to_dxf};
/// use robovac_core::{floor_plan::SourceFile, geometry::Point};
/// let path = Overlay { layer: "PATH".into(), colour: 1, lines: vec![vec![Point::new(0.0, 0.0), Point::new(2.0, 1.0)]] };
/// let bytes = to_dxf(None, &[path])?;
/// let drawing = read(&SourceFile { name: "path.dxf".into(), bytes })?;
/// assert_eq!((drawing.layers[0].name.as_str(), drawing.metre), ("PATH", Some(1.0)));
/// assert_eq!(drawing.points, [Point::new(0.0, 0.0), Point::new(2.0, 1.0)]);
/// # Ok::<(), floor_drawing::DrawingError>(())
/// ```
pub fn to_dxf(original: Option<&[u8]>, overlays: &[Overlay]) -> Result<Vec<u8>, DrawingError> {
    let template;
    let original = match original {
        Some(bytes) if is_dxf(bytes) => bytes,
        Some(_) => {
            return Err(bad(NAME, "", DrawingFlaw::NotADrawing { kind: "not a DXF file", remedy: "choose a DXF" }));
        }
        None => {
            template = template::empty();
            &template
        }
    };
    let survey = DxfLandmarks::of(original).map_err(|(at, flaw)| {
        bad(NAME, &format!("{} {at}", if Pairs::new(original).is_text() { "line" } else { "byte" }), flaw)
    })?;
    let Some(entities_end) = survey.entities_end else {
        return Err(bad(NAME, "", DrawingFlaw::CutOff { place: "before the end of its entities" }));
    };
    let mut pen = DxfPen { next_handle: survey.last_handle + 1, survey: &survey };
    let names = pen.names(overlays);
    let mut insertions: Vec<(usize, usize, Vec<u8>)> = Vec::new();
    insertions.extend(pen.layers(overlays, &names));
    let entities = pen.entities(overlays, &names);
    insertions.push((entities_end, entities_end, entities));
    if let Some([start, end]) = survey.seed {
        let mut writer = pen.writer();
        writer.text(5, &format!("{:X}", pen.next_handle));
        insertions.push((start, end, writer.bytes));
    }
    insertions.sort_by_key(|&(start, ..)| start);
    let mut result =
        Vec::with_capacity(original.len() + insertions.iter().map(|(.., bytes)| bytes.len()).sum::<usize>());
    let mut done = 0;
    for (start, end, bytes) in insertions {
        result.extend_from_slice(&original[done..start]);
        result.extend(bytes);
        done = end;
    }
    result.extend_from_slice(&original[done..]);
    Ok(result)
}

struct DxfPen<'a> {
    survey: &'a DxfLandmarks,
    next_handle: u64,
}

impl DxfPen<'_> {
    fn writer(&self) -> Writer {
        Writer::new(self.survey.form, self.survey.is_crlf, self.encoding())
    }

    fn encoding(&self) -> &'static Encoding {
        if self.survey.release < FIRST_UNICODE { self.survey.code_page } else { encoding_rs::UTF_8 }
    }

    fn has_handles(&self) -> bool {
        self.survey.release >= FIRST_WITH_HANDLES
    }

    fn handle(&mut self) -> String {
        self.next_handle += 1;
        format!("{:X}", self.next_handle - 1)
    }

    /// Names of the overlays' layers, with valid characters and not in use.
    fn names(&self, overlays: &[Overlay]) -> Vec<String> {
        let mut taken = self.survey.layer_names.clone();
        let mut names: Vec<String> = Vec::new();
        for (index, overlay) in overlays.iter().enumerate() {
            // Overlays of one name share a layer.
            if let Some(same) = overlays[..index].iter().position(|other| other.layer == overlay.layer) {
                names.push(names[same].clone());
                continue;
            }
            let plain = self.plain(&overlay.layer);
            let numbered = (2_u32..).map(|number| format!("{plain}_{number}"));
            let free =
                std::iter::once(plain.clone()).chain(numbered).find(|name| !taken.contains(&name.to_uppercase()));
            let name = free.unwrap_or(plain);
            taken.push(name.to_uppercase());
            names.push(name);
        }
        names
    }

    fn plain(&self, name: &str) -> String {
        let is_old = !self.has_handles();
        let plain = |c: char| match c {
            '<' | '>' | '/' | '\\' | '"' | ':' | ';' | '?' | '*' | '|' | '=' | '`' | ',' => "_".to_owned(),
            c if c.is_control() => "_".to_owned(),
            c if is_old && !matches!(c, 'a'..='z' | 'A'..='Z' | '0'..='9' | '$' | '_' | '-') => "_".to_owned(),
            c if is_old => c.to_ascii_uppercase().to_string(),
            c if self.encoding().encode(c.encode_utf8(&mut [0; 4])).2 => {
                // Beyond the basic plane there is no escape for characters that the code page lacks.
                if (c as u32) < 0x1_0000 { format!("\\U+{:04X}", c as u32) } else { "_".to_owned() }
            }
            c => c.to_string(),
        };
        // R12 allows 31 characters; a number can follow.
        let most = if is_old { 26 } else { 200 };
        let name: String = name.trim().chars().take(most).map(plain).collect();
        if name.is_empty() { "OVERLAY".to_owned() } else { name }
    }

    /// Records of the layers, and where to insert them; with a table or a section around them if there is none.
    fn layers(&mut self, overlays: &[Overlay], names: &[String]) -> Option<(usize, usize, Vec<u8>)> {
        let survey = self.survey;
        let mut writer = self.writer();
        let has_section = survey.tables_end.is_some();
        let place = survey.layers_end.or(survey.tables_end).or(survey.body)?;
        let has_table = survey.layers_end.is_some();
        if !has_section {
            writer.text(0, "SECTION");
            writer.text(2, "TABLES");
        }
        let table = survey.layer_table.clone().filter(|_| has_table).unwrap_or_else(|| self.handle());
        if !has_table {
            writer.text(0, "TABLE");
            writer.text(2, "LAYER");
            if self.has_handles() {
                writer.text(5, &table);
                writer.text(330, "0");
                writer.text(100, "AcDbSymbolTable");
            }
            writer.short(70, names.len() as i64);
        }
        for (index, (overlay, name)) in overlays.iter().zip(names).enumerate() {
            if names[..index].contains(name) {
                continue;
            }
            writer.text(0, "LAYER");
            if self.has_handles() {
                writer.text(5, &self.handle());
                writer.text(330, &table);
                writer.text(100, "AcDbSymbolTableRecord");
                writer.text(100, "AcDbLayerTableRecord");
            }
            writer.text(2, name);
            writer.short(70, 0);
            writer.short(62, overlay.colour.max(1).into());
            writer.text(6, if self.has_handles() { "Continuous" } else { "CONTINUOUS" });
            if let Some(style) = survey.plot_style.as_ref().filter(|_| self.has_handles()) {
                writer.text(390, style);
            }
        }
        if !has_table {
            writer.text(0, "ENDTAB");
        }
        if !has_section {
            writer.text(0, "ENDSEC");
        }
        Some((place, place, writer.bytes))
    }

    fn entities(&mut self, overlays: &[Overlay], names: &[String]) -> Vec<u8> {
        let mut writer = self.writer();
        for (overlay, name) in overlays.iter().zip(names) {
            for line in &overlay.lines {
                let is_closed = line.len() > 3 && line.first() == line.last();
                let corners = if is_closed { &line[..line.len() - 1] } else { line };
                let finite: Vec<_> =
                    corners.iter().filter(|corner| corner.x.is_finite() && corner.y.is_finite()).collect();
                if finite.len() < 2 {
                    continue;
                }
                if self.has_handles() {
                    writer.text(0, "LWPOLYLINE");
                    writer.text(5, &self.handle());
                    if let Some(model) = &self.survey.model {
                        writer.text(330, model);
                    }
                    writer.text(100, "AcDbEntity");
                    writer.text(8, name);
                    writer.text(100, "AcDbPolyline");
                    writer.pair(90, &EncodedValue::Long(finite.len() as i64));
                    writer.short(70, is_closed.into());
                    for corner in finite {
                        writer.real(10, corner.x);
                        writer.real(20, corner.y);
                    }
                    continue;
                }
                writer.text(0, "POLYLINE");
                writer.text(8, name);
                writer.short(66, 1);
                for code in [10, 20, 30] {
                    writer.real(code, 0.0);
                }
                writer.short(70, is_closed.into());
                for corner in finite {
                    writer.text(0, "VERTEX");
                    writer.text(8, name);
                    writer.real(10, corner.x);
                    writer.real(20, corner.y);
                    writer.real(30, 0.0);
                }
                writer.text(0, "SEQEND");
                writer.text(8, name);
            }
        }
        writer.bytes
    }
}

//! Reads files; the format is detected from the content.

use super::{Drawing, DrawingError, DrawingFlaw, dxf, error::bad, geojson, svg};
use robovac_core::floor_plan::{ForeignFile, SourceFile, foreign, is_image};

/// Largest file that is read, MB.
const MAX_MEGABYTES: usize = 256;

enum DrawingFormat {
    Dxf,
    Svg,
    GeoJson,
}

/// Whether a file looks like a drawing that [`read`] reads, by its content.
///
/// ```
/// use floor_drawing::is_drawing;
/// use robovac_core::floor_plan::SourceFile;
/// let file = |bytes: &[u8]| SourceFile { name: "room".into(), bytes: bytes.into() };
/// assert!(is_drawing(&file(b"  0\nSECTION\n  2\nENTITIES\n")));
/// assert!(is_drawing(&file(b"{\"type\": \"FeatureCollection\", \"features\": []}")));
/// assert!(!is_drawing(&file(b"####\n#..#\n####\n")));
/// ```
pub fn is_drawing(file: &SourceFile) -> bool {
    kind(&file.bytes).is_some()
}

/// Whether a file is a DXF, by its content.
///
/// ```
/// use floor_drawing::is_dxf;
/// use robovac_core::floor_plan::SourceFile;
/// let file = |bytes: &[u8]| SourceFile { name: "room".into(), bytes: bytes.into() };
/// assert!(is_dxf(&file(b"  0\nSECTION\n  2\nENTITIES\n")));
/// assert!(!is_dxf(&file(b"\xef\xbb\xbf<svg xmlns='http://www.w3.org/2000/svg'/>")));
/// ```
pub fn is_dxf(file: &SourceFile) -> bool {
    matches!(kind(&file.bytes), Some(DrawingFormat::Dxf))
}

/// The kind of a drawing, by its content, e.g. "a DXF drawing".
pub fn drawing_kind(file: &SourceFile) -> Option<&'static str> {
    match kind(&file.bytes) {
        Some(DrawingFormat::Dxf) => Some("a DXF drawing"),
        Some(DrawingFormat::Svg) => Some("an SVG drawing"),
        Some(DrawingFormat::GeoJson) => Some("a GeoJSON drawing"),
        None => None,
    }
}

fn kind(bytes: &[u8]) -> Option<DrawingFormat> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if dxf::is_dxf(bytes) {
        Some(DrawingFormat::Dxf)
    } else if svg::is_svg(bytes) {
        Some(DrawingFormat::Svg)
    } else if geojson::is_geojson(bytes) {
        Some(DrawingFormat::GeoJson)
    } else {
        None
    }
}

/// Reads a drawing.
///
/// - DXF, text and binary: lines, polylines, circles, arcs, ellipses, splines, solids, and blocks with their content.
/// - SVG: paths and shapes; groups with names are layers, else the colours of the strokes.
/// - GeoJSON: polygons and lines; the property `layer`, `class` or `name` is the layer.
///
/// Curves become chords that turn by 5° at most: those of an arc lie within 0.1 % of its radius from it.
///
/// ```
/// use floor_drawing::read;
/// use robovac_core::{floor_plan::SourceFile, geometry::Point};
/// let dxf = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nWALL\n10\n0\n20\n0\n11\n4\n21\n3\n0\nENDSEC\n0\nEOF\n";
/// let drawing = read(&SourceFile { name: "house.dxf".into(), bytes: dxf.into() })?;
/// assert_eq!((drawing.name.as_str(), drawing.layers[0].name.as_str()), ("house", "WALL"));
/// assert_eq!(drawing.points, [Point::new(0.0, 0.0), Point::new(4.0, 3.0)]);
/// assert_eq!(drawing.metre, None, "it says nothing of units");
/// # Ok::<(), floor_drawing::DrawingError>(())
/// ```
pub fn read(file: &SourceFile) -> Result<Drawing, DrawingError> {
    let bytes = &file.bytes;
    if bytes.trim_ascii().is_empty() {
        return Err(DrawingError::Empty { name: file.name.clone() });
    }
    let refuse = |flaw| Err(bad(&file.name, "", flaw));
    if bytes.len() > MAX_MEGABYTES << 20 {
        return refuse(DrawingFlaw::TooLong { found: bytes.len() >> 20, most: MAX_MEGABYTES });
    }
    match kind(bytes) {
        Some(DrawingFormat::Dxf) => dxf::read(file),
        Some(DrawingFormat::Svg) => svg::read(file),
        Some(DrawingFormat::GeoJson) => geojson::read(file),
        None => {
            let is_text = std::str::from_utf8(bytes).is_ok();
            let unknown = if is_text { "text of an unknown format" } else { "a file of an unknown format" };
            let kind = if is_image(file) { "an image" } else { unknown };
            let unknown = ForeignFile { kind, remedy: "choose a drawing (DXF, SVG or GeoJSON)" };
            let ForeignFile { kind, remedy } = foreign(bytes).unwrap_or(unknown);
            refuse(DrawingFlaw::NotADrawing { kind, remedy })
        }
    }
}

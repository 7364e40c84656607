//! Drawing units and the display of lengths.

use super::DrawingSource;
use serde::Serialize;

/// A unit for drawings.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Unit {
    /// Name in menus.
    pub name: &'static str,
    /// Metres per unit.
    pub metre: f64,
}

/// The units in the menu. Inch and foot are the international ones of 1959: 25.4 mm, and 12 inches.
pub const UNITS: [Unit; 5] = [
    Unit { name: "millimetres", metre: 0.001 },
    Unit { name: "centimetres", metre: 0.01 },
    Unit { name: "metres", metre: 1.0 },
    Unit { name: "inches", metre: 0.0254 },
    Unit { name: "feet", metre: 0.3048 },
];

/// Scales of plans on paper, with their names in menus.
type Scales = &'static [(f64, &'static str)];
const SCALES: Scales = &[(50.0, "1:50"), (100.0, "1:100"), (200.0, "1:200")];
/// A quarter, an eighth and a sixteenth of an inch for a foot; metric plans are printed on these sheets, too.
const US_SCALES: Scales = &[(48.0, "1:48"), (50.0, "1:50"), (96.0, "1:96"), (100.0, "1:100"), (192.0, "1:192")];
/// Sheets that are scanned: longer and shorter side, m, name, and scales (ISO 216; ANSI/ASME Y14.1, A and B).
const SHEETS: [([f64; 2], &str, Scales); 4] = [
    ([0.297, 0.21], "A4", SCALES),
    ([0.42, 0.297], "A3", SCALES),
    ([0.2794, 0.2159], "Letter", US_SCALES),
    ([0.4318, 0.2794], "Tabloid", US_SCALES),
];

/// The units of a plan that was drawn for paper: name and metres per unit.
pub fn paper_units(source: &DrawingSource) -> Vec<(String, f64)> {
    let is_image = matches!(source, DrawingSource::Image { .. });
    let sheets = SHEETS.iter().take(if is_image { SHEETS.len() } else { 1 });
    let units = sheets.flat_map(|&(sides, sheet, scales)| {
        let paper = source.paper(sides);
        let of = if is_image { format!("{sheet} sheet") } else { "on paper".to_owned() };
        scales.iter().filter_map(move |&(scale, name)| Some((format!("{of}, {name}"), scale * paper?)))
    });
    units.collect()
}

/// A size in metres, in words: `12.4 x 8.1 m`, with a third digit for small values.
///
/// ```
/// use robovac_app::floor_plan::size_in_words;
/// assert_eq!(size_in_words(12.42, 8.1), "12.4 × 8.1 m");
/// assert_eq!(size_in_words(59.25, 47.2), "59.3 × 47.2 m");
/// assert_eq!(size_in_words(0.0124, 0.0081), "12 × 8 mm");
/// assert_eq!(size_in_words(12400.0, 8100.0), "12.4 × 8.1 km");
/// ```
pub fn size_in_words(width: f64, height: f64) -> String {
    match width.max(height) {
        large if large >= 10_000.0 => format!("{:.1} × {:.1} km", width / 1000.0, height / 1000.0),
        large if large >= 1.0 => format!("{:.1} × {:.1} m", halves_up(width), halves_up(height)),
        _ => format!("{:.0} × {:.0} mm", width * 1000.0, height * 1000.0),
    }
}

/// To tenths, halves up as on the page.
fn halves_up(metres: f64) -> f64 {
    (10.0 * metres).round() / 10.0
}

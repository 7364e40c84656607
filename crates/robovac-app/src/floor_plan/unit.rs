//! Drawing units and the display of lengths.

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

/// A size in metres, in words: `12.4 x 8.1 m`, with a third digit for small values.
///
/// ```
/// use robovac_app::floor_plan::size_in_words;
/// assert_eq!(size_in_words(12.42, 8.1), "12.4 × 8.1 m");
/// assert_eq!(size_in_words(0.0124, 0.0081), "12 × 8 mm");
/// assert_eq!(size_in_words(12400.0, 8100.0), "12.4 × 8.1 km");
/// ```
pub fn size_in_words(width: f64, height: f64) -> String {
    match width.max(height) {
        large if large >= 10_000.0 => format!("{:.1} × {:.1} km", width / 1000.0, height / 1000.0),
        large if large >= 1.0 => format!("{width:.1} × {height:.1} m"),
        _ => format!("{:.0} × {:.0} mm", width * 1000.0, height * 1000.0),
    }
}

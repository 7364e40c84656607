//! Layer colours with enough contrast: CAD programs draw on black, prints are white.

/// Least contrast of a line with the background, as required by WCAG 2 for graphics (success criterion 1.4.11).
const LEAST_CONTRAST: f64 = 3.0;

/// `colour` (red, green, blue), lightened on a dark background and darkened on a light one until the contrast suffices.
///
/// ```
/// use robovac_app::floor_plan::seen_on;
/// assert_eq!(seen_on([255, 255, 255], true), [255, 255, 255]);
/// assert!(seen_on([255, 255, 255], false)[0] < 160);
/// assert!(seen_on([0, 0, 60], true)[2] > 100);
/// ```
pub fn seen_on(colour: [u8; 3], dark: bool) -> [u8; 3] {
    let (ground, towards) = if dark { (0.009, 255.0) } else { (0.92, 0.0) };
    // In steps of a sixteenth of the way.
    (0..=16_u8)
        .map(|step| {
            let share = f64::from(step) / 16.0;
            colour.map(|channel| (f64::from(channel) * (1.0 - share) + towards * share).round() as u8)
        })
        .find(|&mixed| {
            let light = luminance(mixed);
            (light.max(ground) + 0.05) / (light.min(ground) + 0.05) >= LEAST_CONTRAST
        })
        .unwrap_or(colour)
}

/// Relative luminance, 0 to 1; a square approximates sRGB's power of 2.4, accurately enough for choosing.
fn luminance(colour: [u8; 3]) -> f64 {
    let [red, green, blue] = colour.map(|channel| (f64::from(channel) / 255.0) * (f64::from(channel) / 255.0));
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

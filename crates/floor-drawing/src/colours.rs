//! AutoCAD's colour index.

/// Red, green and blue of a colour index; black for unknown ones, like 7 on paper.
///
/// 1 to 9 have names; from 10 on every ten are one hue, 15° further each, in five shades, the odd ones half as saturated;
/// 250 to 255 are greys.
pub(super) fn rgb(index: i32) -> [u8; 3] {
    const NAMED: [[u8; 3]; 10] = [
        [0, 0, 0],
        [255, 0, 0],
        [255, 255, 0],
        [0, 255, 0],
        [0, 255, 255],
        [0, 0, 255],
        [255, 0, 255],
        [0, 0, 0],
        [128, 128, 128],
        [192, 192, 192],
    ];
    const GREYS: [u8; 6] = [51, 91, 132, 173, 214, 255];
    /// Brightness of the five shades, of 255.
    const SHADES: [i32; 5] = [255, 165, 127, 76, 38];
    match index {
        0..=9 => NAMED[index as usize],
        10..=249 => {
            let (hue, shade) = (index / 10 - 1, SHADES[(index % 10 / 2) as usize]);
            let low = if index % 2 == 1 { shade / 2 } else { 0 };
            // Within a sixth of the circle, four steps of 15°, one channel goes up or down.
            let (sixth, step) = (hue / 4, hue % 4);
            let (up, down) = (low + (shade - low) * step / 4, low + (shade - low) * (4 - step) / 4);
            let channels = match sixth {
                0 => [shade, up, low],
                1 => [down, shade, low],
                2 => [low, shade, up],
                3 => [low, down, shade],
                4 => [up, low, shade],
                _ => [shade, low, down],
            };
            channels.map(|channel| channel as u8)
        }
        250..=255 => [GREYS[(index - 250) as usize]; 3],
        _ => [0; 3],
    }
}

/// Red, green and blue of a 24-bit colour.
pub(super) fn true_colour(value: i64) -> [u8; 3] {
    [(value >> 16) as u8, (value >> 8) as u8, value as u8]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hues_shades_and_greys() {
        for (index, expected) in [
            (1, [255, 0, 0]),
            (10, [255, 0, 0]),
            (20, [255, 63, 0]),
            (50, [255, 255, 0]),
            (90, [0, 255, 0]),
            (170, [0, 0, 255]),
            (11, [255, 127, 127]),
            (13, [165, 82, 82]),
            (255, [255, 255, 255]),
            (256, [0, 0, 0]),
            (-3, [0, 0, 0]),
        ] {
            assert_eq!(rgb(index), expected, "{index}");
        }
        assert_eq!(true_colour(0x12_34_56), [0x12, 0x34, 0x56]);
    }
}

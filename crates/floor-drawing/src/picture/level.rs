//! One level for a whole picture, and the one that separates its shades best.

use robovac_core::grid::Grid;

/// Pixels darker than `level`, 0 to 1; or lighter ones.
pub(super) fn darker(shades: &Grid<u8>, level: f64, negate: bool) -> Grid<bool> {
    let level = level * f64::from(u8::MAX);
    shades.map(|&shade| (f64::from(shade) < level) != negate)
}

/// How many pixels have each shade.
pub(super) fn histogram(shades: &Grid<u8>) -> [usize; 256] {
    let mut counts = [0; 256];
    for &shade in shades.values() {
        counts[usize::from(shade)] += 1;
    }
    counts
}

/// The level, 0 to 1, at which the shades below and above differ most (Otsu 1979), in the middle of all levels
/// that are as good; 0.5 for a single shade.
pub(super) fn otsu(counts: &[usize; 256]) -> f64 {
    let total = counts.iter().sum::<usize>() as f64;
    let mean = counts.iter().enumerate().map(|(shade, &count)| (shade * count) as f64).sum::<f64>() / total.max(1.0);
    let (mut below, mut moment) = (0.0, 0.0);
    let (mut best, mut first, mut last) = (0.0, 0, 0);
    for (shade, &count) in counts.iter().enumerate() {
        below += count as f64 / total;
        moment += (shade * count) as f64 / total;
        let between = if below > 0.0 && below < 1.0 {
            let apart = mean * below - moment;
            apart * apart / (below * (1.0 - below))
        } else {
            0.0
        };
        if between > best * (1.0 + 1e-12) {
            (best, first, last) = (between, shade, shade);
        } else if between >= best * (1.0 - 1e-12) {
            last = shade;
        }
    }
    if best > 0.0 { ((first + last) as f64 / 2.0 + 0.5) / 255.0 } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(shades: &[(usize, usize)]) -> [usize; 256] {
        let mut counts = [0; 256];
        for &(shade, count) in shades {
            counts[shade] = count;
        }
        counts
    }

    #[test]
    fn two_shades_are_separated_in_the_middle() {
        let level = otsu(&counts(&[(40, 10), (200, 90)]));
        assert!((level * 255.0 - 120.0).abs() < 1.0, "{level}");
    }

    #[test]
    fn it_is_the_level_of_the_definition() {
        // By brute force over all levels: the variance between the classes.
        let counts = counts(&[(10, 5), (30, 9), (90, 4), (150, 20), (180, 30), (220, 50)]);
        let class = |range: std::ops::Range<usize>| {
            let weight: usize = counts[range.clone()].iter().sum();
            let moment: usize = range.map(|shade| shade * counts[shade]).sum();
            (weight as f64, moment as f64 / (weight as f64).max(1.0))
        };
        let between = |level: usize| {
            let ((a, low), (b, high)) = (class(0..level), class(level..256));
            a * b * (high - low) * (high - low)
        };
        let best = (1..256).map(between).fold(0.0, f64::max);
        let found = (otsu(&counts) * 255.0).ceil() as usize;
        assert!((between(found) - best).abs() < 1e-6 * best, "{found}");
    }

    #[test]
    fn one_shade_has_no_level() {
        assert_eq!(otsu(&counts(&[(255, 7)])), 0.5);
        assert_eq!(otsu(&[0; 256]), 0.5);
    }
}

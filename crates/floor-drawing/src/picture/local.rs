//! Shades compared with those around them, for pictures that aren't evenly lit (Bradley & Roth 2007).

use robovac_core::grid::Grid;

/// Side of the window around a pixel, as a share of the picture's longer side: theirs.
const WINDOW: usize = 8;
/// How much darker than the mean walls are at least, in standard deviations of the noise (ours): in the dark corner of a photograph
/// the noise is more than a share of the mean.
const ABOVE_NOISE: f64 = 3.0;

/// Pixels darker than the mean of the window around them by more than `contrast`, 0 to 1, of it, and by more than noise; or
/// lighter ones, where black and white change places first.
pub(super) fn darker(shades: &Grid<u8>, contrast: f64, negate: bool) -> Grid<bool> {
    let (width, height) = (shades.width(), shades.height());
    let half = half(shades);
    let shade = |index: usize| {
        let shade = shades.values()[index];
        u32::from(if negate { u8::MAX - shade } else { shade })
    };
    let least = ABOVE_NOISE * noise(shades);
    let mut dark = shades.map(|_| false);
    // Sums of the window's columns, which move up with it.
    let mut columns = vec![0_u32; width];
    let mut rows = 0..0;
    for y in 0..height {
        let next = y.saturating_sub(half)..(y + half + 1).min(height);
        for row in rows.end..next.end {
            columns.iter_mut().enumerate().for_each(|(x, sum)| *sum += shade(row * width + x));
        }
        for row in rows.start..next.start {
            columns.iter_mut().enumerate().for_each(|(x, sum)| *sum -= shade(row * width + x));
        }
        rows = next;
        let mut sum: u64 = columns[..half.min(width)].iter().map(|&column| u64::from(column)).sum();
        for x in 0..width {
            if x + half < width {
                sum += u64::from(columns[x + half]);
            }
            if let Some(gone) = x.checked_sub(half + 1) {
                sum -= u64::from(columns[gone]);
            }
            let count = rows.len() * ((x + half + 1).min(width) - x.saturating_sub(half));
            let mean = sum as f64 / count as f64;
            dark.values_mut()[y * width + x] = f64::from(shade(y * width + x)) < mean - (mean * contrast).max(least);
        }
    }
    dark
}

/// Pixels on each side of one in its window.
pub(super) fn half(shades: &Grid<u8>) -> usize {
    (shades.width().max(shades.height()) / WINDOW / 2).max(2)
}

/// Standard deviation of the noise, from the median difference of neighbours: most have no edge between them.
fn noise(shades: &Grid<u8>) -> f64 {
    /// Of a normal distribution, the standard deviation by the median difference of two values.
    const BY_MEDIAN: f64 = 1.0484;
    let mut counts = [0_usize; 256];
    for row in shades.values().chunks_exact(shades.width()) {
        row.windows(2).for_each(|pair| counts[usize::from(pair[0].abs_diff(pair[1]))] += 1);
    }
    let half = counts.iter().sum::<usize>() / 2;
    let mut below = 0;
    for (difference, count) in counts.into_iter().enumerate() {
        if below + count > half {
            // Between whole differences.
            let within = difference as f64 - 0.5 + (half - below) as f64 / count as f64;
            return if difference == 0 { 0.0 } else { BY_MEDIAN * within };
        }
        below += count;
    }
    0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        grid::Cell,
        rng::{normal, seeded},
    };

    #[test]
    fn the_noise_of_a_dark_corner_is_no_wall_and_a_wall_in_the_light_is() {
        let mut rng = seeded(5, 0);
        let values = (0..300 * 200).map(|index| {
            let (x, y) = (f64::from(index % 300), f64::from(index / 300));
            // From 120 down to 12, with a wall that is a fifth as light.
            let light = 120.0 * (1.0 - 0.9 * x / 300.0);
            let is_wall = (40.0..46.0).contains(&x) && y > 20.0;
            (light * if is_wall { 0.2 } else { 1.0 } + 6.0 * normal(&mut rng)).clamp(0.0, 255.0) as u8
        });
        let shades = Grid::from_rows(300, values.collect()).unwrap();
        assert!((noise(&shades) - 6.0).abs() < 0.5, "{}", noise(&shades));
        let found = darker(&shades, 0.15, false);
        let share = |columns: std::ops::Range<i32>| {
            let cells = || found.iter().filter(|(cell, _)| columns.contains(&cell.x) && cell.y > 20);
            cells().filter(|(_, is_dark)| **is_dark).count() as f64 / cells().count() as f64
        };
        assert!(share(40..46) > 0.98 && share(60..300) < 0.01, "{} and {}", share(40..46), share(60..300));
        assert_eq!(noise(&shades.map(|_| 200)), 0.0);
    }

    #[test]
    fn a_window_that_moves_has_the_mean_of_its_pixels() {
        let mut rng = seeded(3, 0);
        for (width, height) in [(40, 25), (7, 61), (3, 3), (1, 1)] {
            let values: Vec<u8> = (0..width * height).map(|_| (128.0 + 10.0 * normal(&mut rng)) as u8).collect();
            let shades = Grid::from_rows(width, values).unwrap();
            let half = (width.max(height) / WINDOW / 2).max(2) as i32;
            let found = darker(&shades, 0.1, false);
            let least = ABOVE_NOISE * noise(&shades);
            for (cell, &shade) in shades.iter() {
                let around = (-half..=half).flat_map(|dy| (-half..=half).map(move |dx| (dx, dy)));
                let window: Vec<f64> = around
                    .filter_map(|(dx, dy)| shades.get(Cell::new(cell.x + dx, cell.y + dy)))
                    .map(|&shade| f64::from(shade))
                    .collect();
                let mean = window.iter().sum::<f64>() / window.len() as f64;
                assert_eq!(
                    found[cell],
                    f64::from(shade) < mean - least.max(mean * 0.1),
                    "{cell} of {width} x {height}"
                );
            }
        }
    }
}

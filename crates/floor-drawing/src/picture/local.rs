//! Shades compared with those around them, for pictures that aren't evenly lit (Bradley & Roth 2007).

use robovac_core::grid::Grid;

/// Side of the window around a pixel, as a share of the picture's longer side: theirs.
const WINDOW: usize = 8;

/// Pixels darker than the mean of the window around them by more than `contrast`, 0 to 1, of it; or lighter ones, where
/// black and white change places first.
pub(super) fn darker(shades: &Grid<u8>, contrast: f64, negate: bool) -> Grid<bool> {
    let (width, height) = (shades.width(), shades.height());
    let half = (width.max(height) / WINDOW / 2).max(2);
    let shade = |index: usize| {
        let shade = shades.values()[index];
        u32::from(if negate { u8::MAX - shade } else { shade })
    };
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
            dark.values_mut()[y * width + x] = f64::from(shade(y * width + x)) < mean * (1.0 - contrast);
        }
    }
    dark
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        grid::Cell,
        rng::{normal, seeded},
    };

    #[test]
    fn a_window_that_moves_has_the_mean_of_its_pixels() {
        let mut rng = seeded(3, 0);
        for (width, height) in [(40, 25), (7, 61), (3, 3), (1, 1)] {
            let values: Vec<u8> = (0..width * height).map(|_| (128.0 + 50.0 * normal(&mut rng)) as u8).collect();
            let shades = Grid::from_rows(width, values).unwrap();
            let half = (width.max(height) / WINDOW / 2).max(2) as i32;
            let found = darker(&shades, 0.1, false);
            for (cell, &shade) in shades.iter() {
                let around = (-half..=half).flat_map(|dy| (-half..=half).map(move |dx| (dx, dy)));
                let window: Vec<f64> = around
                    .filter_map(|(dx, dy)| shades.get(Cell::new(cell.x + dx, cell.y + dy)))
                    .map(|&shade| f64::from(shade))
                    .collect();
                let mean = window.iter().sum::<f64>() / window.len() as f64;
                assert_eq!(found[cell], f64::from(shade) < mean * 0.9, "{cell} of {width} x {height}");
            }
        }
    }
}

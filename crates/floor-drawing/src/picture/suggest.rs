//! How an image is best read, by its shades.

use super::{ShadeMethod, WallShades, level, local};
use robovac_core::{
    floor_plan::Shading,
    grid::{Grid, chessboard},
};

/// Pixels below which an image is taken for a map whose pixels are cells.
const SMALL: usize = 10_000;
/// Shades that `map_saver` writes for walls, unknown floor and floor, with their tolerance.
const MAP: [(u8, u8); 3] = [(0, 10), (205, 2), (254, 4)];
/// Share of a map's pixels with these shades, at least; and of those with the grey.
const MAP_SHARE: f64 = 0.9;
const MAP_GREY: f64 = 0.01;
/// Share of the pixels that one level takes for walls although they are paper in a shadow, above which shades are compared
/// with those around them (ours).
const SHADOW: f64 = 0.005;
/// Difference from the mean around a pixel: that of Bradley and Roth.
const CONTRAST: f64 = 0.15;
/// Light lines on a dark ground are walls if they are less than this share of the picture, and if hardly any of them is
/// wider than so much of the longer side.
const LIGHT_LINES: f64 = 0.35;
const LINE: usize = 30;

/// How an image is best read; `specks` is kept.
pub fn suggest(shades: &Grid<u8>, specks: f64) -> WallShades {
    let counts = level::histogram(shades);
    let total = shades.len().max(1) as f64;
    let share = |(shade, near): (u8, u8)| {
        let range = usize::from(shade.saturating_sub(near))..=usize::from(shade.saturating_add(near));
        counts[range].iter().sum::<usize>() as f64 / total
    };
    let level = level::otsu(&counts);
    let default = 1.0 - Shading::default().occupied_thresh;
    let is_map = share(MAP[1]) >= MAP_GREY && MAP.into_iter().map(share).sum::<f64>() >= MAP_SHARE;
    if is_map || shades.len() < SMALL {
        return WallShades { method: ShadeMethod::Map, level: default, contrast: CONTRAST, negate: false, specks };
    }
    // Thin light lines have no ink beside them, and the dark ground would be taken for shadow.
    let negate = has_light_lines(shades, level);
    let is_even = negate || shadow(shades, level) <= SHADOW;
    let method = if is_even { ShadeMethod::Level } else { ShadeMethod::Local };
    WallShades { method, level, contrast: CONTRAST, negate, specks }
}

/// The share of pixels that are darker than `level`, but not than those around them, and not as dark as ink: the insides of
/// thick walls are.
fn shadow(shades: &Grid<u8>, level: f64) -> f64 {
    let local = local::darker(shades, CONTRAST, false);
    let is_dark = |shade: u8| f64::from(shade) < level * 255.0;
    let (mut ink, mut doubtful) = ([0_usize; 256], [0_usize; 256]);
    for (&shade, &is_line) in shades.values().iter().zip(local.values()).filter(|(shade, _)| is_dark(**shade)) {
        if is_line { ink[usize::from(shade)] += 1 } else { doubtful[usize::from(shade)] += 1 }
    }
    let half = ink.iter().sum::<usize>() / 2;
    let median = ink.iter().scan(0, |sum, &count| {
        *sum += count;
        Some(*sum)
    });
    let median = median.take_while(|&sum| sum < half).count();
    let from = (0.75 * median as f64 + 0.25 * level * 255.0) as usize;
    doubtful.iter().skip(from).sum::<usize>() as f64 / shades.len().max(1) as f64
}

/// Whether what is light is lines rather than areas.
fn has_light_lines(shades: &Grid<u8>, level: f64) -> bool {
    let dark = level::darker(shades, level, false);
    let light = (dark.len() - dark.count()) as f64;
    if light > LIGHT_LINES * dark.len() as f64 {
        return false;
    }
    let radius = (shades.width().max(shades.height()) / LINE / 2).clamp(2, 254);
    let wide = chessboard(&dark).values().iter().filter(|&&moves| usize::from(moves) > radius).count();
    (wide as f64) < 0.02 * light
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        floor_plan::generate::random_flat,
        grid::{Cell, Occupancy},
        math::{exp, sin},
        rng::{normal, seeded},
    };

    /// Pixels on a side of a cell.
    const PIXELS: usize = 2;

    /// A sheet with the walls of a random flat in the middle, and what is wall there.
    fn sheet(seed: u64) -> Grid<bool> {
        let flat = random_flat(2, 2, seed).occupancy;
        let margin = 20 * PIXELS;
        let (width, height) = (flat.width() * PIXELS + 2 * margin, flat.height() * PIXELS + 2 * margin);
        let mut walls = Grid::filled(width, height, false);
        for index in 0..walls.len() {
            let at = walls.cell(index);
            let cell = Cell::new(
                (at.x - margin as i32).div_euclid(PIXELS as i32),
                (at.y - margin as i32).div_euclid(PIXELS as i32),
            );
            walls.values_mut()[index] = flat.get(cell) == Some(&Occupancy::Occupied);
        }
        walls
    }

    /// A photograph of the sheet: `shadow` darkens one side and a corner, `noise` is that of the sensor.
    fn photograph(walls: &Grid<bool>, seed: u64, [ink, paper]: [f64; 2], shadow: f64, noise: f64) -> Grid<u8> {
        let mut rng = seeded(seed, 9);
        let (width, height) = (walls.width() as f64, walls.height() as f64);
        let mut shades = walls.map(|_| 0);
        for (cell, &is_wall) in walls.iter() {
            let (u, v) = (f64::from(cell.x) / width, f64::from(cell.y) / height);
            let corner = 1.0 / (1.0 + exp(-12.0 * (u + v - 1.1)));
            let light = 1.0 - shadow * (0.6 * corner + 0.4 * (0.5 + 0.5 * sin(3.0 * u + seed as f64)));
            let shade = if is_wall { ink } else { paper };
            shades[cell] = (shade * light + noise * normal(&mut rng)).clamp(0.0, 255.0).round() as u8;
        }
        shades
    }

    /// Pixels that both have as walls, as a share of those that either has.
    fn agreement(found: &Grid<Occupancy>, walls: &Grid<bool>) -> f64 {
        let pairs = || found.values().iter().map(|cell| !cell.is_free()).zip(walls.values().iter().copied());
        let both = pairs().filter(|&(a, b)| a && b).count();
        let either = pairs().filter(|&(a, b)| a || b).count();
        both as f64 / either as f64
    }

    #[test]
    fn walls_of_scans_and_photographs_are_found_as_they_were_drawn() {
        for seed in 0..6 {
            let walls = sheet(seed);
            let scan = photograph(&walls, seed, [30.0, 235.0], 0.0, 6.0);
            let how = suggest(&scan, 3.0);
            assert_eq!((how.method, how.negate), (ShadeMethod::Level, false), "{seed}");
            let share = agreement(&how.cells(&scan), &walls);
            assert!(share > 0.97, "scan {seed}: {share}");
            // Most of the light is missing in the corner: no level serves the whole.
            let photo = photograph(&walls, seed, [40.0, 220.0], 0.75, 5.0);
            let how = suggest(&photo, 3.0);
            let share = agreement(&how.cells(&photo), &walls);
            let whole = WallShades { method: ShadeMethod::Level, ..how };
            let by_level = agreement(&whole.cells(&photo), &walls);
            assert_eq!(how.method, ShadeMethod::Local, "{seed}");
            assert!(share > 0.95 && by_level < share, "photograph {seed}: {share}, {by_level} by one level");
        }
    }

    #[test]
    fn a_blueprint_has_light_walls() {
        let walls = sheet(3);
        let depth = chessboard(&walls.map(|&is_wall| !is_wall));
        let widest = walls.width().max(walls.height()) / 30;
        // Lines rather than areas: the edges of the walls, or walls up to a thirtieth of the picture.
        for inner in [1, widest as u16 / 2] {
            let lines = depth.map(|&moves| (1..=inner).contains(&u16::from(moves)));
            let blueprint = photograph(&lines, 3, [230.0, 60.0], 0.0, 4.0);
            let how = suggest(&blueprint, 0.0);
            assert_eq!((how.method, how.negate), (ShadeMethod::Level, true), "up to {inner}");
            assert!(agreement(&how.cells(&blueprint), &lines) > 0.97, "up to {inner}");
        }
    }

    #[test]
    fn thin_light_lines_on_a_dark_ground_without_noise_are_walls() {
        let lines =
            Grid::from_rows(900, (0..900 * 600).map(|i| i % 900 % 300 < 3 || i / 900 % 200 < 3).collect()).unwrap();
        let how = suggest(&lines.map(|&is_line| if is_line { 240 } else { 70 }), 0.0);
        assert_eq!((how.method, how.negate), (ShadeMethod::Level, true));
    }

    #[test]
    fn maps_are_read_by_the_rules_of_their_server() {
        let mut map = Grid::filled(200, 100, 254);
        map.values_mut()[..2000].fill(205);
        map.values_mut()[2000..2600].fill(0);
        assert_eq!(suggest(&map, 0.0).method, ShadeMethod::Map);
        assert_eq!(suggest(&Grid::filled(40, 30, 255), 0.0).method, ShadeMethod::Map, "pixels are cells");
        // Dark areas of a map are no ground for light lines.
        let mut rock = Grid::filled(300, 300, 0);
        for row in 100..140 {
            rock.values_mut()[row * 300 + 50..row * 300 + 200].fill(255);
        }
        let how = suggest(&rock, 0.0);
        assert_eq!((how.method, how.negate), (ShadeMethod::Level, false));
    }
}

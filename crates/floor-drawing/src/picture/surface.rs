//! The surface that a photographed sheet lies on. Beside the light sheet it is darker than the mean around it, as walls are; but
//! farther away it is as dark, and isn't taken for wall.

use super::{
    local,
    marks::{area, erase, marks},
};
use robovac_core::grid::{Cell, Grid};

/// Longer side of the picture in which it is looked for, pixels: noise is less there.
const SIDE: usize = 400;
/// How much darker than the mean around them pixels are there: at the corners of a sheet, the mean is but little lighter.
const CONTRAST: f64 = 0.05;
/// A surface covers at least so much of the picture.
const LARGE: f64 = 0.002;
/// Dark pixels at its edge are as light as it is, at least by this share: walls are darker than what is beside them.
const AS_LIGHT: f64 = 0.75;
/// How much lighter the sheet is.
const SHEET: f64 = 1.25;
/// Share of the light pixels behind the dark ones that are the sheet's, at least; the others are noise.
const BESIDE_SHEET: f64 = 0.1;
/// Marks beside the surface with less than this share of the dark pixels belong to it.
const REST: f64 = 0.2;
/// Share of the picture that is still dark without the surface: the drawing.
const DRAWING: f64 = 0.002;

/// Removes from `dark`, which are pixels darker than the mean around them, those of the surface under a sheet.
pub(super) fn remove(dark: &mut Grid<bool>, shades: &Grid<u8>) {
    let by = shades.width().max(shades.height()).div_ceil(SIDE);
    let Some(surface) = surface(&reduced(shades, by)) else { return };
    let is_surface = |index: usize| {
        let Cell { x, y } = dark.cell(index);
        // A pixel more: the edge of the sheet.
        let at = Cell::new(x / by as i32, y / by as i32);
        at.block().any(|beside| surface.is_set(beside))
    };
    let mut left = dark.clone();
    for (index, is_dark) in left.values_mut().iter_mut().enumerate() {
        *is_dark &= !is_surface(index);
    }
    // Between the surface and the drawing is the sheet: what is left beside it belongs to it.
    let most = REST * left.count() as f64;
    let is_beside = |cell: Cell| cell.block().any(|beside| dark.is_set(beside) && !left[beside]);
    let rest = marks(&left, |mark| (mark.cells.len() as f64) < most && mark.cells.iter().any(|&cell| is_beside(cell)));
    erase(&mut left, &rest);
    if left.count() as f64 >= DRAWING * left.len() as f64 {
        *dark = left;
    }
}

/// Means of squares with `by` pixels a side.
fn reduced(shades: &Grid<u8>, by: usize) -> Grid<u8> {
    let (width, height) = (shades.width().div_ceil(by), shades.height().div_ceil(by));
    let mut sums = Grid::filled(width, height, [0_u32; 2]);
    for (Cell { x, y }, &shade) in shades.iter() {
        let [sum, count] = &mut sums[Cell::new(x / by as i32, y / by as i32)];
        (*sum, *count) = (*sum + u32::from(shade), *count + 1);
    }
    sums.map(|&[sum, count]| (sum / count.max(1)) as u8)
}

/// The pixels of the surface, if there is one.
fn surface(shades: &Grid<u8>) -> Option<Grid<bool>> {
    let dark = local::darker(shades, CONTRAST, false);
    let half = local::half(shades);
    let mut surface = dark.map(|_| false);
    let mut seen = dark.clone();
    let mut from = Vec::new();
    for start in edge(&dark) {
        if seen[start] {
            continue;
        }
        let area = area(start, &mut seen);
        if area.len() as f64 >= LARGE * dark.len() as f64 && is_surface(&dark, shades, &area, half) {
            from.extend(area);
        }
    }
    // Where the sheet is near the edge of the picture, all of the surface is dark.
    let least = AS_LIGHT * (!from.is_empty()).then(|| mean(shades, &from))?;
    from.extend(edge(&dark).filter(|&cell| dark[cell] && f64::from(shades[cell]) >= least));
    for &cell in &from {
        surface[cell] = true;
    }
    let is_at_edge = |cell: Cell| cell.neighbours().into_iter().any(|beside| dark.get(beside).is_none());
    let mut next = 0;
    while let Some(&cell) = from.get(next) {
        next += 1;
        for beside in cell.neighbours() {
            if dark.is_set(beside) && !surface[beside] && is_at_edge(beside) {
                surface[beside] = true;
                from.push(beside);
            }
        }
    }
    let (reached, _) = reach(&dark, from, half + half / 2);
    for cell in reached {
        surface[cell] = true;
    }
    Some(surface)
}

/// Whether an area is no paper: what is dark beside it is no darker, and some of what is light behind
/// that is lighter.
fn is_surface(dark: &Grid<bool>, shades: &Grid<u8>, area: &[Cell], half: usize) -> bool {
    let shade = mean(shades, area);
    let (reached, beyond) = reach(dark, area.to_vec(), half);
    let lighter = beyond.iter().filter(|&&cell| f64::from(shades[cell]) >= SHEET * shade).count();
    !reached.is_empty()
        && mean(shades, &reached) >= AS_LIGHT * shade
        && lighter as f64 >= BESIDE_SHEET * beyond.len() as f64
}

/// Dark pixels within so many moves from others through dark ones, and the light pixels beside them.
fn reach(dark: &Grid<bool>, from: Vec<Cell>, moves: usize) -> (Vec<Cell>, Vec<Cell>) {
    let mut seen = dark.map(|_| false);
    for &cell in &from {
        seen[cell] = true;
    }
    let mut reached: Vec<Cell> = from.iter().copied().filter(|&cell| dark[cell]).collect();
    let mut beyond = Vec::new();
    let mut front = from;
    for _ in 0..moves {
        let mut next = Vec::new();
        for cell in front.into_iter().flat_map(Cell::neighbours) {
            if dark.get(cell).is_some() && !seen[cell] {
                seen[cell] = true;
                if dark[cell] { next.push(cell) } else { beyond.push(cell) }
            }
        }
        reached.extend(&next);
        front = next;
    }
    (reached, beyond)
}

/// The pixels at the edge of the picture.
fn edge(dark: &Grid<bool>) -> impl Iterator<Item = Cell> + use<> {
    let (right, top) = (dark.width() as i32 - 1, dark.height() as i32 - 1);
    let rows = (0..=right).flat_map(move |x| [Cell::new(x, 0), Cell::new(x, top)]);
    rows.chain((0..=top).flat_map(move |y| [Cell::new(0, y), Cell::new(right, y)]))
}

fn mean(shades: &Grid<u8>, cells: &[Cell]) -> f64 {
    cells.iter().map(|&cell| f64::from(shades[cell])).sum::<f64>() / cells.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::RngExt;
    use robovac_core::{
        math::{cos, sin},
        rng::{normal, seeded},
    };

    const SIZE: [i32; 2] = [480, 360];
    /// How much less light there is on one side than on the other, at least and at most.
    const EVEN: [f64; 2] = [0.2, 0.5];

    /// A photograph of a house on a sheet, askew and unevenly lit, and its walls. The surface is `table` times as light as the sheet;
    /// the sheet fills the picture if there is none.
    fn photograph(seed: u64, table: Option<f64>, [least_dim, most_dim]: [f64; 2]) -> (Grid<u8>, Grid<bool>) {
        let mut rng = seeded(seed, 0);
        let mut noise = seeded(seed, 1);
        let mut any = |low: f64, high: f64| rng.random_range(low..high);
        let (turn, ink, noisy) = (any(-0.12, 0.12), any(0.1, 0.3), any(2.0, 6.0));
        let (dim, towards) = (any(least_dim, most_dim), any(-3.0, 3.0));
        let sheet = [0; 4].map(|_| any(1.0, 1.35));
        let (door, thick) = (any(-60.0, 30.0), any(5.0, 9.0));
        let mut shades = Grid::filled(SIZE[0] as usize, SIZE[1] as usize, 0);
        let mut walls = shades.map(|_| false);
        for index in 0..shades.len() {
            let cell = shades.cell(index);
            let (x, y) = (f64::from(cell.x - SIZE[0] / 2), f64::from(cell.y - SIZE[1] / 2));
            let (u, v) = (x * cos(turn) + y * sin(turn), y * cos(turn) - x * sin(turn));
            let is_in = |u: f64, v: f64, [low_u, low_v, high_u, high_v]: [f64; 4]| {
                u > low_u && v > low_v && u < high_u && v < high_v
            };
            let house = |by: f64| is_in(u, v, [-130.0 - by, -90.0 - by, 130.0 + by, 90.0 + by]);
            let is_outer = house(thick) && !house(0.0) && !is_in(u, v, [door, -100.0, door + 25.0, 0.0]);
            let is_inner = house(0.0) && u.abs() < 2.5 && !is_in(u, v, [-5.0, 20.0, 5.0, 45.0]);
            let is_sheet = table.is_none()
                || is_in(u, v, [-160.0 * sheet[0], -120.0 * sheet[1], 160.0 * sheet[2], 120.0 * sheet[3]]);
            let is_wall = is_outer || is_inner;
            walls[cell] = is_wall;
            let light = 1.0 - dim * (0.5 + (x * cos(towards) + y * sin(towards)) / 600.0);
            let shade = 235.0
                * if is_wall {
                    ink
                } else if is_sheet {
                    1.0
                } else {
                    table.unwrap_or(1.0)
                };
            shades[cell] = (shade * light + noisy * normal(&mut noise)).clamp(0.0, 255.0) as u8;
        }
        (shades, walls)
    }

    /// Shares of the walls that are missing, and of the picture that is dark but no wall.
    fn errors(dark: &Grid<bool>, walls: &Grid<bool>) -> [f64; 2] {
        let pairs = || dark.values().iter().zip(walls.values());
        let missing = pairs().filter(|(dark, wall)| !**dark && **wall).count() as f64;
        let extra = pairs().filter(|(dark, wall)| **dark && !**wall).count() as f64;
        [missing / walls.count() as f64, extra / walls.len() as f64]
    }

    #[test]
    fn the_table_under_a_photographed_sheet_is_no_wall() {
        let (mut worst, mut before) = ([0.0_f64; 2], 0.0);
        for seed in 0..12 {
            let table = 0.25 + 0.04 * seed as f64;
            let (shades, walls) = photograph(seed, Some(table), EVEN);
            let mut dark = local::darker(&shades, 0.15, false);
            before += errors(&dark, &walls)[1] / 12.0;
            remove(&mut dark, &shades);
            let [missing, extra] = errors(&dark, &walls);
            worst = [worst[0].max(missing), worst[1].max(extra)];
        }
        assert!(before > 0.05 && worst[0] < 0.03 && worst[1] < 0.02, "{before} {worst:?}");
    }

    #[test]
    fn dark_spots_of_the_table_beside_what_was_found_go_too() {
        // Those on which they were left.
        for seed in [5, 9, 10] {
            let (shades, walls) = photograph(seed, Some(0.25 + 0.02 * seed as f64), [0.7, 1.1]);
            let mut dark = local::darker(&shades, 0.15, false);
            remove(&mut dark, &shades);
            let [missing, extra] = errors(&dark, &walls);
            assert!(missing == 0.0 && extra < 2e-5, "{seed}: {missing} {extra}");
        }
    }

    #[test]
    fn without_a_table_nothing_goes() {
        for seed in 0..8 {
            let (shades, _) = photograph(seed, None, EVEN);
            let dark = local::darker(&shades, 0.15, false);
            let mut left = dark.clone();
            remove(&mut left, &shades);
            assert_eq!(left, dark, "{seed}");
        }
    }
}

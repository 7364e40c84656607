//! How thick the strokes of a picture are: walls beside lines.

use robovac_core::grid::{Cell, Grid};

/// Most pixels along the longer side of a picture in which strokes are looked at, unless walls get thinner than so many.
const LONGEST: usize = 1500;
const THINNEST_WALL: f64 = 6.0;
/// Least thickness of a wall, pixels.
const LEAST: u16 = 4;
/// Most of it, as a share of the picture's longer side: what is thicker is the ground round the plan.
const MOST: f64 = 0.07;
/// Least share of the dark pixels that are walls. Otherwise walls are drawn as outlines.
const WALLS: f64 = 0.3;
/// A thickness is that of walls if at least this share of the greatest length has it.
const MUCH: f64 = 0.9;

/// A picture reduced to a size at which it still shows all of its strokes.
pub(super) struct ReducedPicture {
    /// Pixels a side in one of its own.
    pub by: usize,
    pub cells: Grid<bool>,
    /// Usual thickness of its walls, in its own pixels.
    pub usual: f64,
}

impl ReducedPicture {
    /// `None` if hardly anything in it is as thick as a wall.
    pub fn new(walls: &Grid<bool>) -> Option<Self> {
        Self::by(walls, usual_thickness)
    }

    /// The same with another way to tell how thick walls are.
    pub fn by(walls: &Grid<bool>, usual: impl Fn(&Grid<bool>) -> Option<f64>) -> Option<Self> {
        // A large picture takes long, and shows no more.
        let mut by = walls.width().max(walls.height()).div_ceil(LONGEST).max(1);
        loop {
            let cells = reduced(walls, by);
            let usual = usual(&cells)?;
            if by == 1 || usual >= THINNEST_WALL {
                return Some(Self { by, cells, usual });
            }
            by -= 1;
        }
    }
}

/// Removes from a picture what is marked in it reduced.
pub(super) fn erase_reduced(walls: &mut Grid<bool>, by: usize, marked: &Grid<bool>) {
    for index in 0..walls.len() {
        let cell = walls.cell(index);
        walls.values_mut()[index] &= !marked[Cell::new(cell.x / by as i32, cell.y / by as i32)];
    }
}

/// The picture with `by` pixels a side in one, which is dark if one of them is: lines stay.
fn reduced(walls: &Grid<bool>, by: usize) -> Grid<bool> {
    if by == 1 {
        return walls.clone();
    }
    let mut reduced = Grid::filled(walls.width().div_ceil(by), walls.height().div_ceil(by), false);
    for (cell, _) in walls.iter().filter(|(_, is_wall)| **is_wall) {
        reduced[Cell::new(cell.x / by as i32, cell.y / by as i32)] = true;
    }
    reduced
}

/// The pixels of squares with `side` that are dark: what is thinner is gone.
pub(super) fn opened(dark: &Grid<bool>, side: u16) -> Grid<bool> {
    let at = |grid: &Grid<u16>, x: i32, y: i32| grid.get(Cell::new(x, y)).copied().unwrap_or(0);
    // Side of the largest dark square below and to the left of each pixel.
    let mut squares = dark.map(|_| 0_u16);
    for index in 0..dark.len() {
        if dark.values()[index] {
            let Cell { x, y } = dark.cell(index);
            let least = at(&squares, x - 1, y).min(at(&squares, x, y - 1)).min(at(&squares, x - 1, y - 1));
            squares.values_mut()[index] = least.saturating_add(1);
        }
    }
    // How far below and to the left of each pixel there is more of one.
    let mut reach = squares;
    for index in (0..dark.len()).rev() {
        let Cell { x, y } = dark.cell(index);
        let most = at(&reach, x + 1, y).max(at(&reach, x, y + 1)).max(at(&reach, x + 1, y + 1));
        let own = if reach.values()[index] >= side { side } else { 0 };
        reach.values_mut()[index] = own.max(most.saturating_sub(1));
    }
    reach.map(|&reach| reach > 0)
}

/// How many dark pixels there are of each thickness up to that of walls, and of all such.
fn thicknesses(dark: &Grid<bool>) -> (Vec<usize>, u32) {
    let (width, height) = (dark.width() as i32, dark.height() as i32);
    let mut thickness = dark.map(|_| u16::MAX);
    let mut measure = |first: Cell, [dx, dy]: [i32; 2], count: i32| {
        let cell = |step: i32| Cell::new(first.x + dx * step, first.y + dy * step);
        let mut from = 0;
        for step in 0..=count {
            if step < count && dark[cell(step)] {
                continue;
            }
            for inside in from..step {
                let least = &mut thickness[cell(inside)];
                *least = (*least).min((step - from) as u16);
            }
            from = step + 1;
        }
    };
    (0..height).for_each(|y| measure(Cell::new(0, y), [1, 0], width));
    (0..width).for_each(|x| measure(Cell::new(x, 0), [0, 1], height));
    let most = (MOST * f64::from(width.max(height))) as u16;
    let mut counts = vec![0_usize; usize::from(most) + 1];
    let mut all = 0;
    for (&thickness, _) in thickness.values().iter().zip(dark.values()).filter(|(_, is_dark)| **is_dark) {
        if thickness <= most {
            all += 1;
            counts[usize::from(thickness)] += usize::from(thickness >= LEAST);
        }
    }
    (counts, all)
}

/// The thickness of most of the walls, pixels; `None` if there are hardly any.
pub(super) fn usual_thickness(dark: &Grid<bool>) -> Option<f64> {
    let (counts, all) = thicknesses(dark);
    let total: usize = counts.iter().sum();
    if (total as f64) < WALLS * f64::from(all) || total == 0 {
        return None;
    }
    let mut below = 0;
    counts
        .iter()
        .position(|&count| {
            below += count;
            2 * below >= total
        })
        .map(|thickness| thickness as f64)
}

/// The largest thickness that much of the strokes' length has, pixels; `None` if there are none.
pub(super) fn longest_thickness(dark: &Grid<bool>) -> Option<f64> {
    let (counts, _) = thicknesses(dark);
    let length = |thickness: usize| {
        let alike = thickness - thickness / 5..=thickness + thickness / 5;
        alike.filter_map(|t| Some(*counts.get(t)? as f64 / t as f64)).sum::<f64>()
    };
    let lengths: Vec<f64> = (1..counts.len()).map(length).collect();
    let longest = lengths.iter().copied().fold(0.0, f64::max);
    let index = lengths.iter().rposition(|&length| longest > 0.0 && length >= MUCH * longest)?;
    Some((index + 1) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walls_are_the_longest_strokes_though_wider_ones_have_more_area() {
        let mut dark = Grid::filled(600, 200, false);
        let mut paint = |columns: std::ops::Range<i32>, rows: std::ops::Range<i32>| {
            rows.for_each(|y| columns.clone().for_each(|x| dark[Cell::new(x, y)] = true));
        };
        paint(10..410, 5..11);
        for left in [10, 130, 250] {
            paint(left..left + 100, 50..80);
        }
        assert_eq!((usual_thickness(&dark), longest_thickness(&dark).map(f64::round)), (Some(30.0), Some(7.0)));
        assert_eq!(longest_thickness(&dark.map(|_| false)), None);
    }
}

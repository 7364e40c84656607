//! Whether a robot still gets about in a room.

use super::area::Area;

/// Longest short side of a room, cells: a row of it is one number.
pub(super) const MOST_BITS: i32 = 124;
/// Half the width of what must stay free around a way, in cells, row by row from the middle: no obstacle is nearer to
/// its cells' centres than 20 cm. A robot 0.35 m wide has 2 cm to steer then.
const BRUSH: [u32; 5] = [4, 4, 4, 3, 2];
/// Share of the wide floor of a room that furniture can close off.
const MOST_CLOSED: f64 = 0.08;
/// Wide cells that are left at least: a quarter of a square metre, of places for the robot's centre.
const LEAST: u32 = 100;

/// Cells of a room that are taken, bit by bit; rows run along its short side.
#[derive(Debug, Clone)]
pub(super) struct Mask {
    area: Area,
    turned: bool,
    rows: Vec<u128>,
    width: u32,
}

impl Mask {
    pub fn new(area: Area) -> Self {
        let turned = area.width() > area.height();
        let (short, long) = if turned { (area.height(), area.width()) } else { (area.width(), area.height()) };
        Self { area, turned, rows: vec![0; long.max(0) as usize], width: short.clamp(0, MOST_BITS) as u32 }
    }

    /// Takes cells; those outside the room are ignored.
    pub fn take(&mut self, cells: &Area) {
        let (x0, x1) = (cells.left.max(self.area.left), cells.right.min(self.area.right));
        let (y0, y1) = (cells.bottom.max(self.area.bottom), cells.top.min(self.area.top));
        if x0 >= x1 || y0 >= y1 {
            return;
        }
        let (x0, x1) = (x0 - self.area.left, x1 - self.area.left);
        let (y0, y1) = (y0 - self.area.bottom, y1 - self.area.bottom);
        let (from, to, first, end) = if self.turned { (y0, y1, x0, x1) } else { (x0, x1, y0, y1) };
        let bits = ones(to as u32) & !ones(from as u32);
        self.rows[first as usize..end as usize].iter_mut().for_each(|row| *row |= bits);
    }

    /// Whether ways lead from each of `doors`, cells of the room, to all others and to nearly all floor that is wide enough.
    pub fn is_passable(&self, doors: &[(i32, i32)]) -> bool {
        let wide = self.wide();
        let mut seen = vec![0; wide.len()];
        let places: Vec<(usize, u128)> = doors.iter().map(|&door| self.place(door)).collect();
        let Some(&(row, bit)) = places.first() else { return true };
        if wide[row] & bit == 0 {
            return false;
        }
        seen[row] = bit;
        flood(&wide, &mut seen);
        let count = |rows: &[u128]| rows.iter().map(|row| row.count_ones()).sum::<u32>();
        let (all, reached) = (count(&wide), count(&seen));
        places.iter().all(|&(row, bit)| seen[row] & bit != 0)
            && reached >= LEAST
            && f64::from(all - reached) <= MOST_CLOSED * f64::from(all)
    }

    /// Row and bit of a cell of the plan.
    fn place(&self, (x, y): (i32, i32)) -> (usize, u128) {
        let (x, y) = (x - self.area.left, y - self.area.bottom);
        let (bit, row) = if self.turned { (y, x) } else { (x, y) };
        let row = (row.max(0) as usize).min(self.rows.len().saturating_sub(1));
        (row, 1 << bit.clamp(0, MOST_BITS - 1))
    }

    /// Cells around which the brush is free.
    fn wide(&self) -> Vec<u128> {
        let margin = BRUSH[0];
        let inside = ones(self.width.saturating_sub(margin)) & !ones(margin);
        let across = |row: u128, by: u32| (1..=by).fold(row, |sum, shift| sum | row << shift | row >> shift);
        // Of every row, spread by each half width of the brush.
        let spread: Vec<[u128; 3]> = self.rows.iter().map(|&row| [2, 3, 4].map(|by| across(row, by))).collect();
        let count = self.rows.len();
        let reach = BRUSH.len() - 1;
        let wide = |row: usize| {
            if row < reach || row + reach >= count {
                return 0;
            }
            let taken = BRUSH.iter().enumerate().fold(0, |taken, (off, &half)| {
                let which = half as usize - 2;
                taken | spread[row - off][which] | spread[row + off][which]
            });
            inside & !taken
        };
        (0..count).map(wide).collect()
    }
}

/// That many low bits.
fn ones(count: u32) -> u128 {
    if count >= 128 { u128::MAX } else { (1 << count) - 1 }
}

/// Spreads `seen` over all cells of `free` that are connected with it, in sweeps up and down until nothing changes.
fn flood(free: &[u128], seen: &mut [u128]) {
    loop {
        let mut changed = false;
        let mut visit = |row: usize, from: Option<usize>| {
            let fed = seen[row] | from.map_or(0, |from| seen[from] & free[row]);
            let full = along(fed, free[row]);
            changed |= full != seen[row];
            seen[row] = full;
        };
        (0..free.len()).for_each(|row| visit(row, row.checked_sub(1)));
        (0..free.len()).rev().for_each(|row| visit(row, Some(row + 1).filter(|&next| next < free.len())));
        if !changed {
            return;
        }
    }
}

/// `seen` spread along the runs of `free` that it is in: fills in steps of 1, 2, 4 and so on (Kogge and Stone 1973).
fn along(seen: u128, free: u128) -> u128 {
    if seen == 0 {
        return 0;
    }
    let (mut up, mut down) = (seen, seen);
    let (mut open_up, mut open_down) = (free, free);
    for step in [1, 2, 4, 8, 16, 32, 64] {
        up |= open_up & (up << step);
        open_up &= open_up << step;
        down |= open_down & (down >> step);
        open_down &= open_down >> step;
    }
    up | down
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Cell, Grid, clearance, reachable};
    use proptest::prelude::*;

    proptest! {
        /// The same floor as by exact distances and a flood cell by cell.
        #[test]
        fn wide_floor_is_that_of_the_exact_distance(
            (width, height) in (12..70_i32, 12..70_i32),
            pieces in prop::collection::vec((0..70_i32, 0..70_i32, 1..20_i32, 1..6_i32), 0..12),
        ) {
            let area = Area::new(7, 3, 7 + width, 3 + height);
            let mut mask = Mask::new(area);
            let mut blocked = Grid::filled(width as usize, height as usize, false);
            for (x, y, w, h) in pieces {
                mask.take(&Area::new(7 + x, 3 + y, 7 + x + w, 3 + y + h));
                for (y, x) in (y..(y + h).min(height)).flat_map(|y| (x..(x + w).min(width)).map(move |x| (y, x))) {
                    blocked[Cell::new(x, y)] = true;
                }
            }
            let exact = clearance(&blocked, 5.0).map(|&c| c >= 4.0);
            let wide = mask.wide();
            let get = |rows: &[u128], cell: Cell| {
                let (row, bit) = mask.place((cell.x + 7, cell.y + 3));
                rows[row] & bit != 0
            };
            for (cell, &expected) in exact.iter() {
                prop_assert_eq!(get(&wide, cell), expected, "{}", cell);
            }
            if let Some((start, _)) = exact.iter().find(|(_, is_wide)| **is_wide) {
                let mut seen = vec![0; wide.len()];
                let (row, bit) = mask.place((start.x + 7, start.y + 3));
                seen[row] = bit;
                flood(&wide, &mut seen);
                for (cell, &expected) in reachable(&exact, start).iter() {
                    prop_assert_eq!(get(&seen, cell), expected, "{}", cell);
                }
            }
        }
    }
}

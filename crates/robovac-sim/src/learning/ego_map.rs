//! A map that is read as square patches around the robot, turned with it, at several scales.
//!
//! The idea of multi-scale egocentric maps is that of Jonnarth, Zhao & Felsberg (Learning coverage paths in unknown
//! environments with deep reinforcement learning, 2024); the values and the pyramid are ours. Cells of 5 cm have one of three
//! values; each coarser level holds the sums of four cells of the finer one and the pixels that show them, kept up to date with
//! every change, so that reading a patch takes one look-up for each pixel at any scale.

use robovac_core::{
    geometry::{Point, Pose},
    math,
};

/// Number of scales.
pub const SCALES: usize = 4;
/// Pixels along a patch's side.
pub const SIDE: usize = 32;
/// Pixels of all patches.
pub const PATCH_LEN: usize = SCALES * SIDE * SIDE;
/// Side of the finest pixels, m. Each scale doubles it: patches are 1.6, 3.2, 6.4 and 12.8 m wide.
pub const CELL_M: f64 = 0.05;
/// How far the coarsest patch reaches from the robot at most, m: half its diagonal.
const VIEW_M: f64 = 9.1;
/// Levels of detail of a map: its side is between so many cells, as powers of two.
const BITS: (u32, u32) = (8, 12);
/// Pixels from the middle of a patch to the middle of its first row and column.
const FIRST: f64 = 0.5 * (SIDE as f64 - 1.0);

/// What is known of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(i8)]
pub enum PatchMark {
    /// Something is in the way.
    Obstacle = -1,
    /// Nothing is known.
    Unknown = 0,
    /// It was swept, so it is free.
    Swept = 1,
}

impl PatchMark {
    /// Of a pixel of the finest scale.
    fn of(pixel: u8) -> Self {
        match pixel {
            0 => Self::Obstacle,
            255 => Self::Swept,
            _ => Self::Unknown,
        }
    }
}

/// What a patch shows of cells whose values have this sum.
fn shade(sum: i8, level: usize) -> u8 {
    ((i32::from(sum) << (7 - 2 * level)) + 128).clamp(0, 255) as u8
}

/// The map. It wraps round: its side is a power of two cells, wide enough that no patch shows a place twice.
#[derive(Debug, Clone)]
pub struct EgoMap {
    /// Side in cells, as a power of two.
    bits: u32,
    /// What patches show of each cell, from fine to coarse.
    pixels: [Vec<u8>; SCALES],
    /// Sums of the cells' values at the coarser scales.
    sums: [Vec<i8>; SCALES - 1],
}

impl EgoMap {
    /// An unknown map for places up to `extent_m` metres apart along x and y. Beyond 190 m it wraps round.
    pub fn new(extent_m: f64) -> Self {
        let cells = ((extent_m.max(0.0) + VIEW_M) / CELL_M).min(f64::from(1_u32 << BITS.1));
        let bits = (cells as u32).next_power_of_two().trailing_zeros().clamp(BITS.0, BITS.1);
        let cells = |level: usize| 1 << (2 * (bits as usize - level));
        let pixels = std::array::from_fn(|level| vec![shade(0, level); cells(level)]);
        let sums = std::array::from_fn(|coarser| vec![0; cells(coarser + 1)]);
        Self { bits, pixels, sums }
    }

    /// Marks the cell at a point.
    pub fn mark(&mut self, at: Point, mark: PatchMark) {
        self.set(math::floor(at.x / CELL_M), math::floor(at.y / CELL_M), mark);
    }

    /// Marks all cells whose centres lie in a disc.
    pub fn mark_disc(&mut self, centre: Point, radius_m: f64, mark: PatchMark) {
        let (x, y, r) = (centre.x / CELL_M - 0.5, centre.y / CELL_M - 0.5, radius_m / CELL_M);
        for row in math::ceil(y - r)..=math::floor(y + r) {
            let off = f64::from(row) - y;
            let half = (r * r - off * off).max(0.0).sqrt();
            for column in math::ceil(x - half)..=math::floor(x + half) {
                self.set(column, row, mark);
            }
        }
    }

    fn set(&mut self, x: i32, y: i32, mark: PatchMark) {
        let index = index(self.bits, x, y);
        let [cells, coarser @ ..] = &mut self.pixels;
        let Some(pixel) = cells.get_mut(index) else { return };
        let change = mark as i8 - PatchMark::of(*pixel) as i8;
        if change == 0 {
            return;
        }
        *pixel = shade(mark as i8, 0);
        for (finer, (sums, pixels)) in self.sums.iter_mut().zip(coarser).enumerate() {
            let level = finer + 1;
            let index = index_at(self.bits, level, x, y);
            if let (Some(sum), Some(pixel)) = (sums.get_mut(index), pixels.get_mut(index)) {
                *sum += change;
                *pixel = shade(*sum, level);
            }
        }
    }

    /// What is known of the cell at a point.
    pub fn at(&self, point: Point) -> PatchMark {
        let index = index(self.bits, math::floor(point.x / CELL_M), math::floor(point.y / CELL_M));
        self.pixels[0].get(index).map_or(PatchMark::Unknown, |&pixel| PatchMark::of(pixel))
    }

    /// Writes the patches around `pose` into `out`, [`PATCH_LEN`] values: the finest scale first, each patch row by row. The
    /// robot is in the middle and looks up: the first row is farthest ahead, the first column farthest to the left.
    ///
    /// A pixel is 0 for an obstacle, 128 for the unknown, 255 for swept floor, and the mean of its cells at coarser scales.
    pub fn patches(&self, pose: Pose, out: &mut [u8]) {
        let (sin, cos) = math::sin_cos(pose.heading);
        let (across, down) = (fixed(sin), fixed(cos));
        for (level, (pixels, patch)) in self.pixels.iter().zip(out.chunks_exact_mut(SIDE * SIDE)).enumerate() {
            let size = CELL_M * f64::from(1_u32 << level);
            let bits = self.bits - level as u32;
            let columns = (1_usize << bits) - 1;
            let rows = columns << bits;
            let mut row_x = fixed(pose.x / size + FIRST * (cos - sin));
            let mut row_y = fixed(pose.y / size + FIRST * (sin + cos));
            for row in patch.chunks_exact_mut(SIDE) {
                let (mut x, mut y) = (row_x, row_y);
                for pixel in row {
                    let index = ((y >> (FRACTION - bits)) as usize & rows) | ((x >> FRACTION) as usize & columns);
                    *pixel = pixels.get(index).copied().unwrap_or(0);
                    (x, y) = (x.wrapping_add(across), y.wrapping_sub(down));
                }
                (row_x, row_y) = (row_x.wrapping_sub(down), row_y.wrapping_sub(across));
            }
        }
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        self.pixels.iter().map(Vec::len).chain(self.sums.iter().map(Vec::len)).sum()
    }
}

/// Binary digits behind the point of cell coordinates in [`EgoMap::patches`].
const FRACTION: u32 = 16;

fn fixed(cells: f64) -> i32 {
    (cells * f64::from(1_u32 << FRACTION)) as i64 as i32
}

fn index(bits: u32, x: i32, y: i32) -> usize {
    let mask = (1_usize << bits) - 1;
    ((y as usize & mask) << bits) | (x as usize & mask)
}

fn index_at(bits: u32, level: usize, x: i32, y: i32) -> usize {
    index(bits - level as u32, x >> level, y >> level)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn patches(map: &EgoMap, pose: Pose) -> Vec<u8> {
        let mut out = vec![7; PATCH_LEN];
        map.patches(pose, &mut out);
        out
    }

    #[test]
    fn the_robot_looks_up_whatever_its_heading() {
        for heading in [0.0, math::FRAC_PI_2, math::PI, -math::FRAC_PI_2] {
            let mut map = EgoMap::new(5.0);
            let pose = Pose::new(-3.0, 7.0, heading);
            map.mark(pose.to_world(Point::new(0.525, 0.225)), PatchMark::Obstacle);
            let out = patches(&map, pose);
            // 10 cells ahead, 4 cells to the left.
            assert_eq!(out.iter().take(SIDE * SIDE).position(|&p| p == 0), Some(5 * SIDE + 11), "{heading}");
            assert!(out.iter().take(SIDE * SIDE).filter(|&&p| p != 128).count() == 1);
            // One of four, of sixteen, of sixty-four.
            for (level, shade) in [(1, 96), (2, 120), (3, 126)] {
                let patch = &out[level * SIDE * SIDE..][..SIDE * SIDE];
                let found: u32 = patch.iter().map(|&p| u32::from(p == shade)).sum();
                assert_eq!(found, 1, "{heading} {level}");
            }
        }
    }

    #[test]
    fn swept_floor_is_white_at_all_scales_and_marks_can_be_taken_back() {
        let mut map = EgoMap::new(20.0);
        map.mark_disc(Point::new(2.0, 3.0), 12.0, PatchMark::Swept);
        let pose = Pose::new(2.0, 3.0, 0.4);
        assert!(patches(&map, pose).iter().all(|&pixel| pixel == 255));
        assert_eq!(map.at(Point::new(2.0, 3.0)), PatchMark::Swept);
        map.mark_disc(Point::new(2.0, 3.0), 12.1, PatchMark::Unknown);
        assert!(patches(&map, pose).iter().all(|&pixel| pixel == 128));
    }

    #[test]
    fn no_patch_shows_a_place_twice() {
        let mut map = EgoMap::new(10.0);
        map.mark_disc(Point::new(0.5, 0.5), 0.3, PatchMark::Obstacle);
        assert!(patches(&map, Pose::new(10.0, 10.0, 0.8)).iter().all(|&pixel| pixel == 128));
        assert!(EgoMap::new(f64::INFINITY).bytes() < 30_000_000);
        assert!(EgoMap::new(f64::NAN).bytes() > 0);
    }
}

//! Dirt spots and their pick-up by brushes.

use rand::RngExt;
use robovac_core::{
    geometry::{Point, Pose, Vector},
    rng::Rng,
    robot::RobotModel,
};

/// Share of the dirt under its bristles that a side brush brings before the tool in a step: 1 - 0.1^0.015, which is 90
/// % in a second. Ours: at 0.3 m/s, dirt in the middle of its reach is under it for 0.6 s, and three quarters of it are
/// swept in; the rest is missed or flung away.
const SWEPT_A_STEP: f32 = 0.033_949;
/// Average amount in a cell of a spot, and its variation to either side.
const VARIATION: f64 = 0.5;
/// Cells with a smaller share of a full one count as clean.
const CLEAN: f32 = 0.001;

/// A round spot of dirt on a grid of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Spot {
    /// Its centre.
    pub centre: Point,
    /// Its radius, m.
    pub radius: f64,
    /// Lower left corner of the grid.
    low: Point,
    /// Side of a cell, m.
    side: f64,
    /// Cells along each side of the grid.
    cells: usize,
    /// Amount in each cell, row by row from the bottom: 1 is a full spot.
    amounts: Vec<f32>,
}

impl Spot {
    /// A full spot. Dirt lies only where `is_floor`.
    pub(super) fn new(centre: Point, radius: f64, side: f64, rng: &mut Rng, is_floor: impl Fn(Point) -> bool) -> Self {
        // Large spots have at most 200 cells a side.
        let side = side.max(radius / 100.0);
        let cells = ((2.0 * radius / side).ceil() as usize).max(1);
        let low = centre - Vector::new(radius, radius);
        let mut spot = Self { centre, radius, low, side, cells, amounts: vec![0.0; cells * cells] };
        for index in 0..spot.amounts.len() {
            let place = spot.place(index);
            let varied = rng.random_range(1.0 - VARIATION..1.0 + VARIATION);
            if (place - centre).norm() <= radius && is_floor(place) {
                spot.amounts[index] = varied as f32;
            }
        }
        spot
    }

    /// Remaining amount, in m² of a full spot.
    pub fn amount(&self) -> f64 {
        self.amounts.iter().map(|&a| f64::from(a)).sum::<f64>() * self.side * self.side
    }

    /// The cells with dirt: centre and amount, about 0 to 1.5.
    pub fn cells(&self) -> impl Iterator<Item = (Point, f32)> {
        self.amounts.iter().enumerate().filter(|(_, a)| **a > 0.0).map(|(index, &a)| (self.place(index), a))
    }

    /// Side of its cells, m.
    pub fn cell_size(&self) -> f64 {
        self.side
    }

    /// Whether dirt can be less than `reach` metres from a point; a quick test.
    #[inline]
    pub(super) fn is_near(&self, point: Point, reach: f64) -> bool {
        let reach = self.radius + reach;
        (point - self.centre).norm_squared() < reach * reach
    }

    /// Removes the dirt picked up in one step: all dirt under the tool, a disc, and a share of that under the side
    /// brushes. Returns the amount.
    pub(super) fn sweep(&mut self, robot: &RobotModel, pose: Pose) -> f64 {
        let mut picked = self.take(pose.position(), 0.5 * robot.tool_width, 1.0);
        for brush in robot.side_brushes {
            let [x, y] = brush.at;
            picked += self.take(pose.to_world(Point::new(x, y)), brush.radius, SWEPT_A_STEP);
        }
        picked
    }

    /// Removes `share` of the dirt in cells with their centre in a disc.
    fn take(&mut self, at: Point, radius: f64, share: f32) -> f64 {
        let index = |v: f64| (v / self.side - 0.5).max(0.0);
        let (low, high) = (at - self.low, at - self.low);
        let columns = index(low.x - radius).ceil() as usize..=index(high.x + radius).floor() as usize;
        let rows = index(low.y - radius).ceil() as usize..=index(high.y + radius).floor() as usize;
        let mut taken = 0.0;
        for row in rows {
            for column in columns.clone() {
                if row >= self.cells || column >= self.cells {
                    continue;
                }
                let index = row * self.cells + column;
                if self.amounts[index] == 0.0 || (self.place(index) - at).norm_squared() > radius * radius {
                    continue;
                }
                let left = self.amounts[index] * (1.0 - share);
                let left = if left < CLEAN { 0.0 } else { left };
                taken += f64::from(self.amounts[index] - left);
                self.amounts[index] = left;
            }
        }
        taken * self.side * self.side
    }

    fn place(&self, index: usize) -> Point {
        let (column, row) = (index % self.cells, index / self.cells);
        self.low + Vector::new(column as f64 + 0.5, row as f64 + 0.5) * self.side
    }

    /// Memory size, bytes.
    pub(super) fn bytes(&self) -> usize {
        size_of::<Self>() + self.amounts.len() * size_of::<f32>()
    }
}

//! Dirt spots and their pick-up by brushes.

use rand::RngExt;
use robovac_core::{
    geometry::{Point, Pose, Vector},
    rng::Rng,
    robot::RobotModel,
};

/// Share of the dirt under its bristles that a side brush brings before the tool in a step: 1 - 0.1^0.015, which is 90 %
/// in a second. Ours: at 0.3 m/s, what lies in the middle of its reach is under it for 0.6 s, and three quarters of it are
/// swept in; the rest is missed or flung away.
const SWEPT_A_STEP: f32 = 0.033_949;
/// The amount that lies in a place of a spot on average, and how far it varies to either side: some crumbs here, more there.
const VARIATION: f64 = 0.5;
/// Below this share of what a cell can hold it counts as clean.
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
    /// What lies in each cell, row by row from the bottom: 1 is a full spot.
    amounts: Vec<f32>,
}

impl Spot {
    /// A spot that hasn't been cleaned. Dirt lies only where `is_floor`.
    pub(super) fn new(centre: Point, radius: f64, side: f64, rng: &mut Rng, is_floor: impl Fn(Point) -> bool) -> Self {
        // However large, a spot has no more than 200 cells a side.
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

    /// What lies there, in m² of a full spot.
    pub fn amount(&self) -> f64 {
        self.amounts.iter().map(|&a| f64::from(a)).sum::<f64>() * self.side * self.side
    }

    /// The cells where something lies: centre, and how much, about 0 to 1.5.
    pub fn cells(&self) -> impl Iterator<Item = (Point, f32)> {
        self.amounts.iter().enumerate().filter(|(_, a)| **a > 0.0).map(|(index, &a)| (self.place(index), a))
    }

    /// Side of its cells, m.
    pub fn cell_size(&self) -> f64 {
        self.side
    }

    /// Whether something of it lies less than `reach` metres from a point, perhaps.
    #[inline]
    pub(super) fn is_near(&self, point: Point, reach: f64) -> bool {
        let reach = self.radius + reach;
        (point - self.centre).norm_squared() < reach * reach
    }

    /// Takes away what a robot picks up in one step: all that lies under its tool, a disc, and a part of what its side
    /// brushes reach. Returns how much that was.
    pub(super) fn sweep(&mut self, robot: &RobotModel, pose: Pose) -> f64 {
        let mut picked = self.take(pose.position(), 0.5 * robot.tool_width, 1.0);
        for brush in robot.side_brushes {
            let [x, y] = brush.at;
            picked += self.take(pose.to_world(Point::new(x, y)), brush.radius, SWEPT_A_STEP);
        }
        picked
    }

    /// Takes `share` of what lies in cells with their centre in a disc.
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

    /// Memory taken, bytes.
    pub(super) fn bytes(&self) -> usize {
        size_of::<Self>() + self.amounts.len() * size_of::<f32>()
    }
}

//! Cliff sensors: light reflected by the floor.
//!
//! A Roomba's reads 2500 to 2680 over floor, and 0 with a cliff reported on all four while it stands on its dock, whose
//! ramp is black to them (Open Interface facts, section 6: measured on a 690). Both are simulated, so controllers must
//! ignore cliffs on the dock. Lifted, it detects no floor. A sensor senses a single point.
//!
//! Noise: at "typical", the signal has a standard deviation of 30, which gives the range above. At "harsh" it has 150,
//! and one in 256 tiles of the floor, 10 cm wide, is so dark that it reads as a cliff, as owners of dark carpets know.
//! Where these tiles are depends on the seed alone. The threshold and the figures of "harsh" are ours.

use super::{BodyFrame, Noisy};
use crate::{NoiseLevel, SensorKind, World};
use robovac_core::{
    geometry::Point,
    robot::{RobotModel, SensorReadings},
};

/// Signal over light floor: the middle of the measurements.
const FLOOR: f64 = 2590.0;
/// Signal over floor that is too dark.
const DARK: f64 = 400.0;
/// Signals below this are a cliff.
const THRESHOLD: u16 = 1000;
/// Side of a tile, m, and number of tiles per dark one.
const TILE: (f64, u64) = (0.1, 256);

/// Positions of the sensors.
#[derive(Debug, Clone)]
pub(super) struct Edges {
    places: [Option<[f64; 2]>; 4],
    /// Distance of the outermost from the body's origin, m.
    reach: f64,
    seed: u64,
}

impl Edges {
    pub fn new(model: &RobotModel, seed: u64) -> Self {
        let places = model.sensors.cliffs;
        let reach = places.iter().flatten().map(|[x, y]| (x * x + y * y).sqrt()).fold(0.0, f64::max);
        Self { places, reach, seed }
    }

    /// Reads all of them; `has_floor` is false for a robot that is lifted or stands on its dock.
    pub fn read(
        &self,
        world: &World,
        frame: &BodyFrame,
        has_floor: bool,
        noise: &Noisy<'_>,
        sensors: &mut SensorReadings,
    ) {
        let is_near_edge = world.drop_offs.iter().any(|outline| is_near(outline, frame.position, self.reach));
        let deviation = noise.pick(SensorKind::Cliff, [0.0, 30.0, 150.0]);
        let has_dark_tiles = noise.levels.of(SensorKind::Cliff) == NoiseLevel::Harsh;
        for (index, place) in self.places.iter().enumerate() {
            let Some(place) = *place else { continue };
            let light = if !has_floor {
                0.0
            } else if !is_near_edge && !has_dark_tiles {
                FLOOR
            } else {
                let point = frame.point(place);
                if world.is_drop_off(point) {
                    0.0
                } else if has_dark_tiles && self.is_dark(point) {
                    DARK
                } else {
                    FLOOR
                }
            };
            let error = if light > 0.0 { deviation * noise.normal(SensorKind::Cliff, index) } else { 0.0 };
            let signal = (light + error).clamp(0.0, 4095.0) as u16;
            sensors.cliff_signal[index] = signal;
            sensors.cliff[index] = signal < THRESHOLD;
        }
        // A single front sensor is listed twice.
        if self.places[1] == self.places[2] {
            sensors.cliff[2] = sensors.cliff[1];
            sensors.cliff_signal[2] = sensors.cliff_signal[1];
        }
    }

    /// Whether the tile that holds `point` is dark: determined by a hash of its position (`SplitMix64`, Steele et al.
    /// 2014).
    fn is_dark(&self, point: Point) -> bool {
        let tile = |x: f64| (x / TILE.0).floor() as i64 as u64;
        let mut hash = self.seed ^ tile(point.x).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ tile(point.y).rotate_left(32);
        hash = (hash ^ (hash >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        hash = (hash ^ (hash >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (hash ^ (hash >> 31)).is_multiple_of(TILE.1)
    }
}

/// Whether a square of half side `reach` around `point` meets the outline's bounding box.
fn is_near(outline: &[Point], point: Point, reach: f64) -> bool {
    let (mut low, mut high) = (Point::new(f64::MAX, f64::MAX), Point::new(f64::MIN, f64::MIN));
    for corner in outline {
        low = Point::new(low.x.min(corner.x), low.y.min(corner.y));
        high = Point::new(high.x.max(corner.x), high.y.max(corner.y));
    }
    let is_within = |x: f64, low: f64, high: f64| x > low - reach && x < high + reach;
    is_within(point.x, low.x, high.x) && is_within(point.y, low.y, high.y)
}

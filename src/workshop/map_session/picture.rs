//! The cells of a map, one pixel each.

use super::ink::MapInk;
use robovac_app::map::{CellVerdict, MapSession};
use robovac_core::{
    geometry::Point,
    grid::{Cell, Occupancy},
};
use robovac_playground::canvas::layer::OffscreenLayer;
use robovac_sim::mapping::{CellMark, Mapper, OccupancyMap};
use wasm_bindgen::JsValue;

/// Log odds at which an obstacle has its full colour, and the same for floor.
const SURE: f64 = 1.5;
/// Longest side of a picture, cells; cells beyond aren't drawn.
const MOST_SIDE: i32 = 4096;

/// A picture of the cells, and its position.
pub(super) struct CellPicture {
    pub layer: OffscreenLayer,
    low: Cell,
    size: [i32; 2],
    resolution: f64,
    /// Cells to be marked with a sign, in addition to their colour.
    pub signs: Vec<(Cell, Sign)>,
}

/// A sign on a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sign {
    /// See [`CellVerdict`].
    Verdict(CellVerdict),
    /// Dirt was found here.
    Dirt,
}

impl CellPicture {
    pub fn new() -> Result<Self, JsValue> {
        let (low, size) = (Cell::new(0, 0), [0; 2]);
        Ok(Self { layer: OffscreenLayer::new(1, 1)?, low, size, resolution: 1.0, signs: Vec::new() })
    }

    /// Draws the robot's present estimate.
    pub fn update(&mut self, session: &MapSession, ink: &MapInk) -> Result<(), JsValue> {
        self.signs.clear();
        let (Some(estimate), Some(map), Some(truth)) = (session.estimate(), session.shown(), session.truth()) else {
            self.size = [0; 2];
            return Ok(());
        };
        let layers = session.setup().layers;
        let (mut low, mut high) = truth.bounds();
        let baseline = session.run().and_then(robovac_sim::Run::baseline).filter(|_| layers.has("odometry"));
        for (a, b) in [Some(map), baseline.map(Mapper::map)].into_iter().flatten().filter_map(OccupancyMap::bounds) {
            low = Cell::new(low.x.min(a.x), low.y.min(a.y));
            high = Cell::new(high.x.max(b.x), high.y.max(b.y));
        }
        let size = [high.x - low.x + 1, high.y - low.y + 1].map(|side| side.clamp(1, MOST_SIDE));
        (self.low, self.size, self.resolution) = (low, size, map.resolution());

        let [shows_belief, shows_cleaned, compares] = ["belief", "cleaned", "difference"].map(|name| layers.has(name));
        let is_back = session.returned().is_none();
        let intent = session.run().and_then(robovac_sim::Run::intent).filter(|_| is_back && layers.has("left"));
        let reach = intent.and_then(|intent| intent.reach);
        let mut pixels = Vec::with_capacity((size[0] * size[1] * 4) as usize);
        for y in (low.y..low.y + size[1]).rev() {
            for x in low.x..low.x + size[0] {
                let cell = Cell::new(x, y);
                let odds = map.log_odds(cell);
                let mut colour = [0; 4];
                if shows_belief && odds != 0.0 {
                    let is_clean = shows_cleaned && estimate.marks.has(cell, CellMark::Cleaned);
                    colour = match odds {
                        odds if odds > 0.0 => faded(ink.occupied, odds),
                        _ if is_clean => faded(ink.cleaned, -odds),
                        _ => faded(ink.free, -odds),
                    };
                } else if shows_cleaned && estimate.marks.has(cell, CellMark::Cleaned) {
                    colour = ink.cleaned;
                }
                if reach.is_some_and(|reach| reach.get(cell)) && !estimate.marks.has(cell, CellMark::Cleaned) {
                    colour = ink.left;
                }
                if baseline.is_some_and(|other| other.map().occupancy(cell) == Occupancy::Occupied) {
                    colour = over(ink.odometry, colour);
                }
                if compares && let Some(verdict) = truth.verdict(map, cell) {
                    if verdict == CellVerdict::Right {
                        colour = ink.right;
                    } else {
                        self.signs.push((cell, Sign::Verdict(verdict)));
                    }
                }
                pixels.extend(colour);
            }
        }
        if layers.has("dirt") {
            self.signs.extend(estimate.marks.cells(CellMark::Dirty).map(|cell| (cell, Sign::Dirt)));
        }
        self.layer.clear(size[0] as u32, size[1] as u32);
        self.layer.put_rows(&pixels, size[0] as u32, 0)
    }

    /// Side of its cells, m.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// Its position: upper left corner, width and height, m; `None` if it is empty.
    pub fn place(&self) -> Option<(Point, [f64; 2])> {
        let [width, height] = self.size.map(|cells| f64::from(cells) * self.resolution);
        let (left, bottom) = (f64::from(self.low.x) * self.resolution, f64::from(self.low.y) * self.resolution);
        (width > 0.0).then(|| (Point::new(left, bottom + height), [width, height]))
    }
}

/// The colour, fainter if less certain.
fn faded([red, green, blue, opacity]: [u8; 4], odds: f64) -> [u8; 4] {
    let share = 0.15 + 0.85 * (odds / SURE).clamp(0.0, 1.0);
    [red, green, blue, (f64::from(opacity) * share) as u8]
}

/// One colour laid over another.
fn over(top: [u8; 4], ground: [u8; 4]) -> [u8; 4] {
    let [a, b] = [top, ground].map(|colour| f64::from(colour[3]) / 255.0);
    let all = a + b * (1.0 - a);
    let mix = |i: usize| ((f64::from(top[i]) * a + f64::from(ground[i]) * b * (1.0 - a)) / all.max(1e-9)) as u8;
    [mix(0), mix(1), mix(2), (255.0 * all) as u8]
}

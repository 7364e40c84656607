//! All settings of the Floor plan tab, as one value shared with the page.

use super::{BodyChoice, DrawingSource};
use coverage_planners::sweep::LinkOrder;
use floor_drawing::{DrawingRegion, Role, Tracing};
use robovac_core::{
    floor_plan::{DEFAULT_IMAGE_RESOLUTION, MAX_RESOLUTION, MIN_RESOLUTION, Shading},
    geometry::Point,
};
use serde::{Deserialize, Serialize};

/// Cell sizes in the menu for traced rooms, m.
pub const CELLS: [f64; 7] = [0.01, 0.02, 0.025, 0.05, 0.1, 0.2, 0.5];
/// Most cells on a side of a room by default: finer ones take long to trace and are seldom needed.
const MOST_UNASKED: f64 = 2000.0;
/// Widest gap between walls that can be closed, m: that of a double door.
const MOST_GAP: f64 = 1.5;
/// Most headings of an obstacle map: one per degree.
const MOST_HEADINGS: usize = 360;

/// Settings of the Floor plan tab.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct FloorPlanSettings {
    /// Metres per unit of the drawing; `None` until known.
    pub metre: Option<f64>,
    /// The role of every layer.
    pub roles: Vec<Role>,
    /// Widest gap between walls that is closed, m.
    pub gap: f64,
    /// Side of the room's cells, m.
    pub resolution: f64,
    /// The part to be traced.
    pub part: DrawingPart,
    /// Shades of an image that are walls: those darker than this, 0 (black) to 1 (white).
    pub shade: f64,
    /// Whether light shades are walls instead.
    pub negate: bool,
    /// The robot's outline.
    pub body: BodyChoice,
    /// Distance between scan lines, m; half the robot's width if `None`.
    pub scan_width: Option<f64>,
    /// The order in which subgoals are linked.
    #[serde(default)]
    pub order: LinkOrder,
    /// Distance that the sweep keeps from everything, m.
    #[serde(default)]
    pub clearance: f64,
    /// Side of the obstacle map's cells, m.
    pub cell: f64,
    /// Headings of the obstacle map.
    pub headings: usize,
}

/// The part of a drawing to be traced, in its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum DrawingPart {
    /// All of it.
    Whole,
    /// An axis-aligned rectangle, by two corners.
    Rectangle {
        /// Two opposite corners.
        corners: [[f64; 2]; 2],
    },
    /// A polygon.
    Polygon {
        /// Its corners.
        corners: Vec<[f64; 2]>,
    },
    /// The room around a point.
    Room {
        /// The point.
        at: [f64; 2],
    },
}

impl FloorPlanSettings {
    /// Default settings for a newly opened source.
    pub fn of(source: &DrawingSource) -> Self {
        let metre = source.metre();
        let side = source.extent().1.max() * metre.unwrap_or_default();
        let fits = CELLS.into_iter().find(|cell| *cell >= DEFAULT_IMAGE_RESOLUTION && side / cell <= MOST_UNASKED);
        let shading = Shading::default();
        Self {
            metre,
            roles: source
                .drawing()
                .map_or(Vec::new(), |drawing| drawing.layers.iter().map(|layer| layer.role).collect()),
            gap: 0.1,
            resolution: fits.unwrap_or(CELLS[CELLS.len() - 1]),
            part: DrawingPart::Whole,
            shade: 1.0 - shading.occupied_thresh,
            negate: false,
            body: BodyChoice::Octagon { width: 0.4 },
            scan_width: None,
            order: LinkOrder::default(),
            clearance: 0.0,
            cell: 0.05,
            headings: 36,
        }
    }

    /// The settings limited to valid values; an invalid unit is replaced by the one of `before`. Refuses cells of a map
    /// that are too small or too large, as no other width can be assumed.
    pub fn checked(mut self, source: &DrawingSource, before: &Self) -> Result<Self, String> {
        let positive = |value: f64| (value > 0.0).then_some(value);
        if !source.is_scalable() {
            self.metre = source.metre();
        } else if let (None, Some(metre)) = (source.drawing(), self.metre)
            && !(MIN_RESOLUTION..=MAX_RESOLUTION).contains(&metre)
        {
            let [found, least, most] = [metre, MIN_RESOLUTION, MAX_RESOLUTION].map(|metres| 100.0 * metres);
            return Err(format!("A cell can't be {found} cm wide. Choose {least} to {most} cm."));
        }
        self.metre = self.metre.and_then(positive).filter(|metre| metre.is_finite()).or(before.metre);
        self.roles.resize(source.drawing().map_or(0, |drawing| drawing.layers.len()), Role::Ignored);
        self.gap = self.gap.clamp(0.0, MOST_GAP);
        self.shade = self.shade.clamp(0.0, 1.0);
        self.resolution = self.resolution.clamp(0.005, 1.0);
        self.cell = self.cell.clamp(0.01, 1.0);
        self.clearance = self.clearance.clamp(0.0, 1.0);
        self.headings = self.headings.clamp(1, MOST_HEADINGS);
        self.scan_width = self.scan_width.and_then(positive);
        Ok(self)
    }

    /// Parameters of tracing, with `metre` metres per unit.
    pub fn tracing(&self, metre: f64) -> Tracing {
        let Self { roles, gap, resolution, part, .. } = self;
        Tracing { roles: roles.clone(), metre, gap: *gap, resolution: *resolution, region: part.region() }
    }

    /// Parameters for reading an image. Shades between wall and floor are unknown, unless the user has set the shade.
    pub fn shading(&self) -> Shading {
        let default = Shading::default();
        let occupied = if self.negate { self.shade } else { 1.0 - self.shade };
        if occupied == default.occupied_thresh && !self.negate {
            return default;
        }
        Shading { negate: self.negate, occupied_thresh: occupied, free_thresh: occupied, ..default }
    }
}

impl DrawingPart {
    /// The part in the form for tracing.
    pub fn region(&self) -> DrawingRegion {
        let point = |&[x, y]: &[f64; 2]| Point::new(x, y);
        match self {
            Self::Whole => DrawingRegion::Whole,
            Self::Rectangle { corners: [a, b] } => DrawingRegion::Rectangle {
                low: Point::new(a[0].min(b[0]), a[1].min(b[1])),
                high: Point::new(a[0].max(b[0]), a[1].max(b[1])),
            },
            Self::Polygon { corners } => DrawingRegion::Polygon(corners.iter().map(point).collect()),
            Self::Room { at } => DrawingRegion::Room(point(at)),
        }
    }
}

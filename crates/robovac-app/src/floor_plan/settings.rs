//! All settings of the Floor plan tab, as one value shared with the page.

use super::{BodyChoice, DrawingSource};
use coverage_planners::sweep::LinkOrder;
use floor_drawing::{DrawingRegion, OUTER_DOOR, Role, ShadeMethod, Tracing, WallShades};
use robovac_core::{
    floor_plan::{DEFAULT_IMAGE_RESOLUTION, MAX_RESOLUTION, MIN_RESOLUTION},
    geometry::Point,
    math::{cos, sin},
};
use serde::{Deserialize, Serialize};

/// Cell sizes in the menu for traced rooms, m.
pub const CELLS: [f64; 7] = [0.01, 0.02, 0.025, 0.05, 0.1, 0.2, 0.5];
/// Most cells on a side of a room by default: finer ones take long to trace and are seldom needed.
const MOST_UNASKED: f64 = 2000.0;
/// Widest gap between walls that can be closed, m: that of a double door.
pub(super) const MOST_GAP: f64 = 1.5;
/// Widest opening to the outside that can be closed, m: that of a wide terrace door. Cells of 1 cm allow for no more.
pub(super) const MOST_OUTER: f64 = 4.0;
/// Widest pixels, m, that are smaller than the cells of a room: those of photographs and scans (ours).
const FINE_PIXEL: f64 = 0.02;
/// Marks in images up to this size are left out by default, m: dots and small letters.
const SPECKS: f64 = 0.15;
/// Largest marks that can be left out, m.
const MOST_SPECKS: f64 = 1.0;
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
    /// Widest opening to the outside that is closed indoors, m.
    #[serde(default = "outer_door")]
    pub outer: f64,
    /// Side of the room's cells, m.
    pub resolution: f64,
    /// The part to be traced.
    pub part: DrawingPart,
    /// Angle by which the file is turned, degrees counter-clockwise, above -180 to 180.
    #[serde(default)]
    pub turn: f64,
    /// How the shades of an image are told apart.
    #[serde(default)]
    pub method: ShadeMethod,
    /// Shades of an image that are walls: those darker than this, 0 (black) to 1 (white). For the method *level*.
    pub shade: f64,
    /// How much darker than their surroundings walls are, 0 to 1. For the method *local*.
    #[serde(default)]
    pub contrast: f64,
    /// Marks of an image that are smaller than this are left out, m; and words and symbols of doors, unless it
    /// is 0. Not by the method *map*.
    #[serde(default)]
    pub specks: f64,
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
    /// The unit, m, whose unusual size the user has confirmed.
    #[serde(default)]
    pub confirmed: Option<f64>,
}

/// The part of a drawing to be traced, in its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum DrawingPart {
    /// The floor that walls enclose; all of it, if they enclose hardly any.
    Indoors,
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
        let suggestion = match source {
            DrawingSource::Image { suggestion, .. } => Some(suggestion),
            _ => None,
        };
        // The pixels of a map are cells, with nothing around them.
        let is_plan = suggestion.map_or(source.drawing().is_some(), |how| how.method != ShadeMethod::Map);
        Self {
            metre,
            roles: source
                .drawing()
                .map_or(Vec::new(), |drawing| drawing.layers.iter().map(|layer| layer.role).collect()),
            gap: 0.1,
            outer: OUTER_DOOR,
            resolution: default_cell(source, metre),
            part: if is_plan { DrawingPart::Indoors } else { DrawingPart::Whole },
            turn: 0.0,
            method: suggestion.map_or_else(ShadeMethod::default, |how| how.method),
            shade: suggestion.map_or(0.35, |how| how.level),
            contrast: suggestion.map_or(0.15, |how| how.contrast),
            specks: SPECKS,
            negate: suggestion.is_some_and(|how| how.negate),
            body: BodyChoice::Octagon { width: 0.4 },
            scan_width: None,
            order: LinkOrder::default(),
            clearance: 0.0,
            cell: 0.05,
            headings: 36,
            confirmed: None,
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
        // What suits the assumed size of a large scan is far too coarse for its true one.
        if self.resolution == before.resolution && before.resolution == default_cell(source, before.metre) {
            self.resolution = default_cell(source, self.metre);
        }
        self.roles.resize(source.drawing().map_or(0, |drawing| drawing.layers.len()), Role::Ignored);
        self.gap = self.gap.clamp(0.0, MOST_GAP);
        self.outer = self.outer.clamp(0.0, MOST_OUTER);
        [self.shade, self.contrast] = [self.shade, self.contrast].map(|share| share.clamp(0.0, 1.0));
        self.specks = self.specks.clamp(0.0, MOST_SPECKS);
        self.turn = if self.turn.is_finite() { 180.0 - (180.0 - self.turn).rem_euclid(360.0) } else { before.turn };
        if matches!(source, DrawingSource::Map { .. }) {
            self.turn = 0.0;
        }
        self.resolution = self.resolution.clamp(0.005, 1.0);
        self.cell = self.cell.clamp(0.01, 1.0);
        self.clearance = self.clearance.clamp(0.0, 1.0);
        self.headings = self.headings.clamp(1, MOST_HEADINGS);
        self.scan_width = self.scan_width.and_then(positive);
        Ok(self)
    }

    /// Parameters of tracing, with `metre` metres per unit.
    pub fn tracing(&self, metre: f64) -> Tracing {
        let Self { roles, gap, outer, resolution, part, .. } = self;
        Tracing { roles: roles.clone(), metre, gap: *gap, resolution: *resolution, region: part.region(*outer) }
    }

    /// Parameters for reading an image.
    pub fn shades(&self) -> WallShades {
        let Self { method, shade, contrast, negate, specks, metre, .. } = *self;
        let specks = metre.map_or(0.0, |metre| specks / metre);
        WallShades { method, level: shade, contrast, negate, specks }
    }

    /// Side of the room's cells: the pixels of a map, and those of other images unless they are finer than is needed.
    pub fn image_resolution(&self, metre: f64) -> f64 {
        if self.has_fine_pixels(metre) { self.resolution } else { metre }
    }

    /// Whether an image's pixels are finer than the cells of a room need to be.
    pub fn has_fine_pixels(&self, metre: f64) -> bool {
        self.method != ShadeMethod::Map && metre < FINE_PIXEL
    }

    /// The settings with the file turned by `degrees` more, and the part with it.
    pub fn turned(&self, degrees: f64) -> Self {
        let part = self.part.turned((degrees - self.turn).to_radians());
        Self { turn: degrees, part, ..self.clone() }
    }
}

/// The width of openings to the outside that are closed until another is chosen, m.
fn outer_door() -> f64 {
    OUTER_DOOR
}

/// The cell size for a source whose unit is `metre` m, until another is chosen.
fn default_cell(source: &DrawingSource, metre: Option<f64>) -> f64 {
    let side = source.extent().1.max() * metre.unwrap_or_default();
    let fits = CELLS.into_iter().find(|cell| *cell >= DEFAULT_IMAGE_RESOLUTION && side / cell <= MOST_UNASKED);
    fits.unwrap_or(CELLS[CELLS.len() - 1])
}

impl DrawingPart {
    /// The part in the form for tracing; openings to the outside up to `outer` metres are closed.
    pub fn region(&self, outer: f64) -> DrawingRegion {
        let point = |&[x, y]: &[f64; 2]| Point::new(x, y);
        match self {
            Self::Indoors => DrawingRegion::Indoors { outer },
            Self::Whole => DrawingRegion::Whole { outer },
            Self::Rectangle { corners: [a, b] } => DrawingRegion::Rectangle {
                low: Point::new(a[0].min(b[0]), a[1].min(b[1])),
                high: Point::new(a[0].max(b[0]), a[1].max(b[1])),
            },
            Self::Polygon { corners } => DrawingRegion::Polygon(corners.iter().map(point).collect()),
            Self::Room { at } => DrawingRegion::Room(point(at)),
        }
    }

    /// The part turned around the origin. A rectangle becomes a polygon unless its sides stay along the axes.
    fn turned(&self, by: f64) -> Self {
        if by == 0.0 {
            return self.clone();
        }
        let (sin, cos) = (sin(by), cos(by));
        let turned = |&[x, y]: &[f64; 2]| [x * cos - y * sin, x * sin + y * cos];
        match self {
            Self::Indoors | Self::Whole => self.clone(),
            Self::Rectangle { corners: [a, b] } if sin.abs() < 1e-9 || cos.abs() < 1e-9 => {
                Self::Rectangle { corners: [turned(a), turned(b)] }
            }
            Self::Rectangle { corners: [a, b] } => {
                let corners = [*a, [b[0], a[1]], *b, [a[0], b[1]]];
                Self::Polygon { corners: corners.iter().map(turned).collect() }
            }
            Self::Polygon { corners } => Self::Polygon { corners: corners.iter().map(turned).collect() },
            Self::Room { at } => Self::Room { at: turned(at) },
        }
    }
}

//! Elements of a drawing, and a builder with size limits.

use super::{
    DrawingFlaw,
    error::{DrawingError, bad},
};
use robovac_core::{
    floor_plan::{base_name, stem},
    geometry::Point,
};
use std::{collections::BTreeMap, ops::Range};

/// Most corners of all strokes of a drawing together.
pub const MAX_POINTS: usize = 2_000_000;
/// Most layers of a drawing.
pub const MAX_LAYERS: usize = 10_000;
/// Coordinates are finite and at most this far from the origin, in drawing units; enough for a country's grid in
/// millimetres.
pub const MAX_COORDINATE: f64 = 1e10;
/// Widest stroke that stays a line without width, as a share of the drawing's larger side (ours): 5 cm of 12 m. Floor plans draw
/// lines of up to a third of a percent, and walls as strokes of 1 % or more.
const HAIRLINE: f64 = 0.004;

/// The content of a vector file. x to the right, y up, in drawing units.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// The file's name without its ending.
    pub name: String,
    /// Metres per drawing unit, if the file states them ($INSUNITS of a DXF); if `None` the user must enter them.
    pub metre: Option<f64>,
    /// Layers with strokes, in the file's order.
    pub layers: Vec<DrawingLayer>,
    /// Straight strokes: arcs, bulges, ellipses and splines are flattened, blocks are inserted.
    pub strokes: Vec<Stroke>,
    /// Corners of all strokes.
    pub points: Vec<Point>,
    /// Content that isn't drawn, for users: "12 texts", "3 hatches".
    pub left_out: Vec<String>,
}

/// A layer of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawingLayer {
    /// Its name.
    pub name: String,
    /// Its colour in the drawing, red, green, blue.
    pub colour: [u8; 3],
    /// Number of strokes on it.
    pub strokes: usize,
    /// Its role, guessed from its name.
    pub role: Role,
}

/// Meaning of a layer for the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Walls: every stroke stops the robot, an outline encloses floor.
    Wall,
    /// Things on the floor: a closed outline is solid.
    Obstacle,
    /// Left out.
    Ignored,
}

/// How the area within all strokes of an entity is painted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AreaFill {
    /// Not at all, or in a way that says nothing.
    #[default]
    None,
    /// Dark and without a line round it: solid where it is a wall.
    Dark(FillRule),
    /// Light: it covers what was painted before.
    Light(FillRule),
}

/// Which part of several outlines is filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FillRule {
    /// What an odd number of them encloses.
    EvenOdd,
    /// What those in one direction enclose, less what those in the other do.
    NonZero,
}

/// A polyline.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Index of its layer.
    pub layer: u32,
    /// Number of the entity that it comes from, counted from 1: an entity of model space in a DXF (the insert for the
    /// content of blocks), a path in an SVG, a feature in GeoJSON.
    pub entity: u32,
    /// Whether its last corner is joined to its first.
    pub is_closed: bool,
    /// How wide its line is drawn, in drawing units; 0 for a line without width.
    pub width: f64,
    /// How the area within it is painted.
    pub fill: AreaFill,
    /// Its corners, in [`Drawing::points`].
    pub points: Range<u32>,
}

impl Drawing {
    /// The corners of a stroke of this drawing.
    pub fn corners(&self, stroke: &Stroke) -> &[Point] {
        self.points.get(stroke.points.start as usize..stroke.points.end as usize).unwrap_or_default()
    }
}

/// A drawing that is being read.
pub(super) struct Builder {
    layers: Vec<DrawingLayer>,
    by_name: BTreeMap<String, u32>,
    strokes: Vec<Stroke>,
    points: Vec<Point>,
    left_out: BTreeMap<&'static str, usize>,
    /// Width of the strokes to be added, and how their area is painted.
    pub pen: f64,
    pub fill: AreaFill,
}

impl Builder {
    pub fn new() -> Self {
        Self {
            layers: Vec::new(),
            by_name: BTreeMap::new(),
            strokes: Vec::new(),
            points: Vec::new(),
            left_out: BTreeMap::new(),
            pen: 0.0,
            fill: AreaFill::None,
        }
    }

    /// Index of the layer with that name, ignoring case; adds it if there is none yet.
    pub fn layer(&mut self, name: &str) -> Result<u32, DrawingFlaw> {
        let key = name.to_uppercase();
        if let Some(&index) = self.by_name.get(&key) {
            return Ok(index);
        }
        if self.layers.len() >= MAX_LAYERS {
            return Err(DrawingFlaw::TooMany { what: "layers", most: MAX_LAYERS });
        }
        let index = self.layers.len() as u32;
        let role = super::roles::guess(name);
        self.layers.push(DrawingLayer { name: name.to_owned(), colour: [0; 3], strokes: 0, role });
        self.by_name.insert(key, index);
        Ok(index)
    }

    /// A layer, mutably; it must exist.
    pub fn layer_mut(&mut self, index: u32) -> &mut DrawingLayer {
        &mut self.layers[index as usize]
    }

    /// Name of a layer, for messages.
    pub fn layer_name(&self, index: u32) -> &str {
        self.layers.get(index as usize).map_or("", |layer| &layer.name)
    }

    /// Counts something that isn't drawn, named in the plural.
    pub fn leave_out(&mut self, what: &'static str, count: usize) {
        if count > 0 {
            *self.left_out.entry(what).or_default() += count;
        }
    }

    /// Adds a polyline without consecutive duplicate points; one without length isn't added.
    pub fn stroke(
        &mut self,
        layer: u32,
        entity: u32,
        is_closed: bool,
        points: impl IntoIterator<Item = Point>,
    ) -> Result<(), DrawingFlaw> {
        let start = self.points.len();
        for point in points {
            check_coordinate(point.x)?;
            check_coordinate(point.y)?;
            if self.points[start..].last() == Some(&point) {
                continue;
            }
            if self.points.len() >= MAX_POINTS {
                return Err(DrawingFlaw::TooMany { what: "corners", most: MAX_POINTS });
            }
            self.points.push(point);
        }
        let drawn = &self.points[start..];
        let repeats = is_closed && drawn.len() > 1 && drawn.first() == drawn.last();
        if repeats {
            self.points.pop();
        }
        let count = self.points.len() - start;
        if count < 2 {
            self.points.truncate(start);
            return Ok(());
        }
        let points = start as u32..self.points.len() as u32;
        self.strokes.push(Stroke {
            layer,
            entity,
            is_closed: is_closed && count > 2,
            width: self.pen,
            fill: self.fill,
            points,
        });
        self.layers[layer as usize].strokes += 1;
        Ok(())
    }

    /// The drawing, with its non-empty layers.
    pub fn finish(mut self, file: &str, metre: Option<f64>) -> Result<Drawing, DrawingError> {
        let left_out: Vec<String> = self.left_out.iter().map(|(what, count)| format!("{what} ({count})")).collect();
        if self.strokes.is_empty() {
            return Err(bad(file, "", DrawingFlaw::Nothing { left_out }));
        }
        drop_empty_layers(&mut self.layers, &mut self.strokes);
        drop_hairlines(&mut self.strokes, &self.points);
        let Self { layers, strokes, points, .. } = self;
        let drawing = super::trace::without_page(Drawing {
            name: stem(base_name(file)),
            metre,
            layers,
            strokes,
            points,
            left_out,
        });
        Ok(super::lines::without_lines(drawing))
    }
}

/// Layers without strokes aren't shown.
pub(super) fn drop_empty_layers(layers: &mut Vec<DrawingLayer>, strokes: &mut [Stroke]) {
    let mut kept = 0;
    let moved: Vec<u32> = layers
        .iter()
        .map(|layer| {
            kept += u32::from(layer.strokes > 0);
            kept.saturating_sub(1)
        })
        .collect();
    layers.retain(|layer| layer.strokes > 0);
    for stroke in strokes {
        stroke.layer = moved[stroke.layer as usize];
    }
}

/// Widths that only make lines visible are none.
fn drop_hairlines(strokes: &mut [Stroke], points: &[Point]) {
    let low = points.iter().fold(Point::new(f64::MAX, f64::MAX), |low, point| low.inf(point));
    let high = points.iter().fold(Point::new(f64::MIN, f64::MIN), |high, point| high.sup(point));
    let hairline = HAIRLINE * (high - low).max();
    for stroke in strokes.iter_mut().filter(|stroke| stroke.width <= hairline) {
        stroke.width = 0.0;
    }
}

/// Refuses invalid coordinates.
pub(super) fn check_coordinate(value: f64) -> Result<(), DrawingFlaw> {
    // In this form it also refuses NaN, for which every comparison is false.
    if value.abs() <= MAX_COORDINATE { Ok(()) } else { Err(DrawingFlaw::Coordinate { value: value.to_string() }) }
}

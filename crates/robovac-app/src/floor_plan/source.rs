//! The loaded source: a map, or a drawing that needs layers, unit and region to become a room.

use crate::{Import, ImportError, ScenarioChoices};
use floor_drawing::{self, Drawing, Picture, ShadeMethod, WallShades, suggest};
use robovac_core::{
    floor_plan::{self, DEFAULT_IMAGE_RESOLUTION, FloorPlan, MapError, PictureShades, SourceFile, base_name, stem},
    geometry::{Point, Vector},
    grid::{Grid, Occupancy},
    math::{cos, sin},
};

/// How much the ratio of an image's sides can differ from that of a sheet of paper.
const SHEET_NEAR: f64 = 0.02;
/// Longer side of the largest sheet, A0 with some margin, m.
const LARGEST_SHEET: f64 = 1.3;

/// Longer side of a photograph or scan whose size isn't known yet, m, at most (ours): a flat or a house with some paper round it.
/// Doors are as wide as doors then, give or take.
const ASSUMED: f64 = 20.0;

/// The loaded source.
// There is one at a time.
#[allow(clippy::large_enum_variant)]
#[derive(Debug, Clone)]
pub enum DrawingSource {
    /// A line drawing.
    Drawing {
        /// The lines, turned.
        drawing: Drawing,
        /// Their corners as in the file, if they are turned.
        unturned: Option<Vec<Point>>,
        /// The file's bytes if it is a DXF, for exports that add to it.
        original: Option<Vec<u8>>,
    },
    /// An image without metadata on its scale and shades.
    Image {
        /// Its name.
        name: String,
        /// Its shades, 0 (black) to 255 (white), row 0 at the bottom.
        shades: Grid<u8>,
        /// How its shades are best read.
        suggestion: WallShades,
        /// What each pixel is, with the present settings.
        cells: Grid<Occupancy>,
        /// Angle by which it is turned around its lower left corner, rad.
        turn: f64,
        /// Pixels of the file on a side of one of these; more than 1 for a large picture.
        times: usize,
        /// Columns and rows of the file.
        size: [usize; 2],
    },
    /// Any other map, or a scenario.
    Map {
        /// The room.
        plan: FloorPlan,
        /// The other choices of a scenario.
        choices: Option<ScenarioChoices>,
    },
}

impl DrawingSource {
    /// Reads files that belong together. May take seconds.
    pub fn read(files: &[SourceFile]) -> Result<Self, ImportError> {
        if let Some(file) = files.iter().find(|file| floor_drawing::is_drawing(file)) {
            if let Some(other) = files.iter().find(|&other| !std::ptr::eq(other, file)) {
                return Err(MapError::TwoMaps { first: file.name.clone(), second: other.name.clone() }.into());
            }
            let original = floor_drawing::is_dxf(file).then(|| file.bytes.clone());
            return Ok(Self::Drawing { drawing: floor_drawing::read(file)?, unturned: None, original });
        }
        if let [file] = files
            && floor_plan::is_image(file)
        {
            let PictureShades { shades, times, size } = floor_plan::load_shades(file)?;
            let suggestion = suggest(&shades, 0.0);
            let cells = suggestion.cells(&shades);
            let name = stem(base_name(&file.name));
            return Ok(Self::Image { name, shades, suggestion, cells, turn: 0.0, times, size });
        }
        let Import { plan, choices } = Import::read(files)?;
        Ok(Self::Map { plan, choices })
    }

    /// Reads the shades of an image in another way.
    pub fn shade(&mut self, how: &WallShades) {
        if let Self::Image { shades, cells, .. } = self {
            *cells = how.cells(shades);
        }
    }

    /// Turns a drawing or an image around its origin, to `turn` rad from how it is in the file.
    pub fn turn(&mut self, to: f64) {
        match self {
            Self::Drawing { drawing, unturned, .. } => {
                let from = unturned.take().unwrap_or_else(|| drawing.points.clone());
                if to == 0.0 {
                    drawing.points = from;
                    return;
                }
                let (sin, cos) = (sin(to), cos(to));
                let turned = |p: &Point| Point::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos);
                drawing.points = from.iter().map(turned).collect();
                *unturned = Some(from);
            }
            Self::Image { turn, .. } => *turn = to,
            Self::Map { .. } => {}
        }
    }

    /// The image, for tracing.
    pub fn picture(&self) -> Option<Picture> {
        let Self::Image { name, cells, turn, .. } = self else { return None };
        Some(Picture { name: name.clone(), blocked: cells.map(|cell| !cell.is_free()), turn: *turn })
    }

    /// Its name.
    pub fn name(&self) -> &str {
        match self {
            Self::Drawing { drawing, .. } => &drawing.name,
            Self::Image { name, .. } => name,
            Self::Map { plan, .. } => &plan.name,
        }
    }

    /// The drawing, if it is one.
    pub fn drawing(&self) -> Option<&Drawing> {
        if let Self::Drawing { drawing, .. } = self { Some(drawing) } else { None }
    }

    /// Metres per unit, if the files state it; what is assumed of an image. The unit of a map is its cell.
    pub fn metre(&self) -> Option<f64> {
        match self {
            Self::Drawing { drawing, .. } => drawing.metre,
            Self::Image { times, cells, suggestion, .. } => {
                let metre = DEFAULT_IMAGE_RESOLUTION * *times as f64;
                let most = ASSUMED / cells.width().max(cells.height()) as f64;
                Some(if suggestion.method == ShadeMethod::Map { metre } else { metre.min(most) })
            }
            Self::Map { plan, .. } => Some(plan.resolution),
        }
    }

    /// Metres per unit on paper, if it can be a sheet of paper: of the file's unit, or of an image's pixel on a sheet with
    /// these sides, m, the longer first. Drawings without unit are in pixels of 1/96 inch.
    pub fn paper(&self, [longer, shorter]: [f64; 2]) -> Option<f64> {
        let size = self.extent().1;
        match self {
            Self::Drawing { drawing, original, .. } => {
                let unknown = if original.is_some() { 0.001 } else { 0.0254 / 96.0 };
                Some(drawing.metre.unwrap_or(unknown)).filter(|metre| size.max() * metre <= LARGEST_SHEET)
            }
            Self::Image { shades, .. } => {
                // As it is in the file: turned, its box has other sides.
                let size = Vector::new(shades.width() as f64, shades.height() as f64);
                let is_sheet = (size.min() * longer / (size.max() * shorter) - 1.0).abs() <= SHEET_NEAR;
                is_sheet.then(|| longer / size.max())
            }
            Self::Map { .. } => None,
        }
    }

    /// Pixels of the file on a side of one that is shown, and the size of the file in pixels, of a picture that was reduced.
    pub fn reduced(&self) -> Option<(usize, [usize; 2])> {
        if let Self::Image { times, size, .. } = self { (*times > 1).then_some((*times, *size)) } else { None }
    }

    /// Whether its unit can be changed: objects in a scenario's room are in metres.
    pub fn is_scalable(&self) -> bool {
        !matches!(self, Self::Map { plan, choices } if choices.is_some() || !plan.objects.is_empty())
    }

    /// Lower left corner and size, in its unit.
    pub fn extent(&self) -> (Point, Vector) {
        match self {
            Self::Drawing { drawing, .. } => {
                let first = drawing.points.first().copied().unwrap_or_else(Point::origin);
                let (low, high) = drawing.points.iter().fold((first, first), |(low, high), point| {
                    (low.coords.inf(&point.coords).into(), high.coords.sup(&point.coords).into())
                });
                (low, high - low)
            }
            Self::Image { cells, turn, .. } => {
                let [low, high] = Picture::bounds(cells.width(), cells.height(), *turn);
                (low, high - low)
            }
            Self::Map { plan, .. } => {
                let (width, height) = (plan.occupancy.width() as f64, plan.occupancy.height() as f64);
                (Point::origin(), Vector::new(width, height))
            }
        }
    }
}

//! The loaded source: a map, or a drawing that needs layers, unit and region to become a room.

use crate::{Import, ImportError, ScenarioChoices};
use floor_drawing::{self, Drawing};
use robovac_core::{
    floor_plan::{self, FloorPlan, MapError, Shading, SourceFile},
    geometry::{Point, Vector},
};

/// The loaded source.
// There is one at a time.
#[expect(clippy::large_enum_variant)]
#[derive(Debug, Clone)]
pub enum DrawingSource {
    /// A line drawing.
    Drawing {
        /// The lines.
        drawing: Drawing,
        /// The file's bytes if it is a DXF, for exports that add to it.
        original: Option<Vec<u8>>,
    },
    /// An image without metadata on its scale and shades.
    Image {
        /// The image, to be read again with other shades.
        file: SourceFile,
        /// The map read from it.
        plan: FloorPlan,
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
            return Ok(Self::Drawing { drawing: floor_drawing::read(file)?, original });
        }
        if let [file] = files
            && floor_plan::is_image(file)
        {
            return Ok(Self::Image { file: file.clone(), plan: floor_plan::load(files)? });
        }
        let Import { plan, choices } = Import::read(files)?;
        Ok(Self::Map { plan, choices })
    }

    /// Reads an image again with other shades; returns whether the source is an image.
    pub fn shade(&mut self, shading: &Shading) -> Result<bool, MapError> {
        let Self::Image { file, plan } = self else { return Ok(false) };
        *plan = floor_plan::load_image(file, shading)?;
        Ok(true)
    }

    /// Its name.
    pub fn name(&self) -> &str {
        match self {
            Self::Drawing { drawing, .. } => &drawing.name,
            Self::Image { plan, .. } | Self::Map { plan, .. } => &plan.name,
        }
    }

    /// The drawing, if it is one.
    pub fn drawing(&self) -> Option<&Drawing> {
        if let Self::Drawing { drawing, .. } = self { Some(drawing) } else { None }
    }

    /// The room, if no tracing is needed.
    pub fn plan(&self) -> Option<&FloorPlan> {
        match self {
            Self::Drawing { .. } => None,
            Self::Image { plan, .. } | Self::Map { plan, .. } => Some(plan),
        }
    }

    /// Metres per unit, if the files state it. The unit of a map is its cell.
    pub fn metre(&self) -> Option<f64> {
        match self {
            Self::Drawing { drawing, .. } => drawing.metre,
            Self::Image { plan, .. } | Self::Map { plan, .. } => Some(plan.resolution),
        }
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
            Self::Image { plan, .. } | Self::Map { plan, .. } => {
                let (width, height) = (plan.occupancy.width() as f64, plan.occupancy.height() as f64);
                (Point::origin(), Vector::new(width, height))
            }
        }
    }
}

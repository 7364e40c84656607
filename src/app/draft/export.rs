//! What leaves the drawing board as files.

use super::{Board, Source};
use crate::{
    app::outlines,
    drawing::{Overlay, Traced, to_dxf},
    geometry::Point,
    grid::Occupancy,
};
use serde::{Deserialize, Serialize};

/// Corners of walls above which they are left out beside a sweep that wasn't drawn in CAD.
const MOST_CORNERS: usize = 200_000;

/// A kind of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Format {
    /// The path on layers of its own, beside the drawing.
    Dxf,
}

/// A file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Export {
    /// Its name.
    pub name: String,
    /// Its media type.
    pub media: &'static str,
    /// Its content.
    pub bytes: Vec<u8>,
}

impl Board {
    /// The sweep as a file.
    pub fn export(&self, format: Format) -> Result<Export, String> {
        let (Some(room), Some(_)) = (self.room(), self.planned()) else {
            return Err("plan the sweep first".to_owned());
        };
        let name = |ending: &str| format!("{}-sweep.{ending}", self.source().name());
        match format {
            Format::Dxf => {
                let original =
                    if let Source::Drawing { original, .. } = self.source() { original.as_deref() } else { None };
                let mut overlays = self.overlays(room);
                if original.is_none() {
                    overlays.extend(walls(room));
                }
                let bytes = to_dxf(original, &overlays).map_err(|error| error.to_string())?;
                Ok(Export { name: name("dxf"), media: "image/vnd.dxf", bytes })
            }
        }
    }

    fn overlays(&self, room: &Traced) -> Vec<Overlay> {
        let Some(sweep) = self.planned() else { return Vec::new() };
        let to_drawing = |point: &Point| Point::from(room.corner + point.coords / room.metre);
        let line = |points: &[Point]| points.iter().map(to_drawing).collect::<Vec<_>>();
        // A cross of a tenth of the scan width at every subgoal.
        let arm = 0.05 * sweep.scan_width;
        let crosses = sweep.subgoals.iter().flat_map(|subgoal| {
            let Point { coords } = subgoal.at;
            let at = |x: f64, y: f64| Point::new(coords.x + x, coords.y + y);
            [line(&[at(-arm, 0.0), at(arm, 0.0)]), line(&[at(0.0, -arm), at(0.0, arm)])]
        });
        let detours = sweep.links.iter().filter(|link| link.collides && !link.way.is_empty());
        vec![
            Overlay { layer: "SWEEP_PATH".to_owned(), colour: 5, lines: vec![line(&sweep.path)] },
            Overlay {
                layer: "SWEEP_DETOURS".to_owned(),
                colour: 3,
                lines: detours.map(|link| line(&link.way)).collect(),
            },
            Overlay { layer: "SWEEP_SUBGOALS".to_owned(), colour: 1, lines: crosses.collect() },
        ]
    }
}

/// Walls of a room that wasn't drawn in CAD.
fn walls(room: &Traced) -> Option<Overlay> {
    let cells = room.plan.occupancy.map(|&cell| cell == Occupancy::Occupied);
    let side = room.plan.resolution / room.metre;
    let lines = outlines(&cells, MOST_CORNERS)?.into_iter().map(|corners| {
        let closed = corners.iter().chain(corners.first());
        closed
            .map(|corner| Point::from(room.corner) + Point::new(f64::from(corner.x), f64::from(corner.y)).coords * side)
            .collect()
    });
    Some(Overlay { layer: "WALLS".to_owned(), colour: 7, lines: lines.collect() })
}

//! Export of the Floor plan tab as files.

use super::{DrawingPart, DrawingSession, DrawingSource};
use crate::{
    export::{ExportFile, PathFormat, SavedPath},
    floor_plan::sweep_dxf,
};
use coverage_planners::sweep::planned_for;
use robovac_core::{
    cspace::Outline,
    robot::{self, WheelLayout},
};

impl DrawingSession {
    /// The sweep as a file.
    pub fn export(&self, format: PathFormat) -> Result<ExportFile, String> {
        let (Some(room), Some(sweep)) = (self.room(), self.planned()) else {
            return Err("plan the sweep first".to_owned());
        };
        let chosen = self.settings().body.model().and_then(robot::model);
        let roomba = robot::model("roomba600").ok_or("the robot model roomba600 is missing from this build")?;
        let outline = self.outline()?;
        // An own outline moves like a built-in robot: a round one turns; any other keeps its heading, as the path was
        // planned.
        let like = if matches!(outline, Outline::Circle { .. }) { Some(roomba) } else { robot::model("octagon") };
        let model = chosen.or(like).unwrap_or(roomba);
        let planned = chosen.map_or_else(|| outline.to_string(), planned_for);
        // A robot that turns begins as the room's start says; any other keeps the heading that the path was planned for.
        let turns = model.wheels == WheelLayout::Differential;
        let start = room.plan.start.filter(|_| turns).map_or(0.0, |start| start.heading);
        let path = SavedPath::with_stops(&sweep.path, start);
        let original =
            if let DrawingSource::Drawing { original, .. } = self.source() { original.as_deref() } else { None };
        let drawing = || sweep_dxf(sweep, room, original);
        let bytes = format.bytes(path, &room.plan, model, &planned, drawing).map_err(|error| error.to_string())?;
        let (ending, kind) = format.file_type();
        // Files of the whole and of a part must not have the same name.
        let part = match self.settings().part {
            DrawingPart::Indoors | DrawingPart::Whole => "",
            DrawingPart::Room { .. } => "-room",
            DrawingPart::Rectangle { .. } | DrawingPart::Polygon { .. } => "-part",
        };
        Ok(ExportFile { name: format!("{}{part}-sweep.{ending}", self.source().name()), kind, bytes })
    }
}

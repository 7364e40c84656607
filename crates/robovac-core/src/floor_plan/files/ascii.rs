//! Text maps: one character a cell, the top row first.
//!
//! ```text
//! ; resolution 0.2
//! ; name Two rooms
//! S...#...
//! ........
//! ....#..?
//! ```
//!
//! `#` is wall, `.` floor, `?` unknown, `S` floor on which the robot starts, heading right. Lines that begin with `;`
//! set `resolution` (metres per cell), `name` and `note`; other keys are ignored, so that tools can add theirs.

use super::{FloorPlan, MAX_SIDE, MapError, error::checked_resolution, stem};
use crate::{
    geometry::Pose,
    grid::{Cell, Grid, Occupancy, picture},
};

/// Metres per cell of a text map without a resolution.
pub const DEFAULT_ASCII_RESOLUTION: f64 = 0.1;

/// Whether a text looks like a map: its first line is a header or consists of cells only.
pub(super) fn is_ascii(text: &str) -> bool {
    let first = text.lines().map(str::trim).find(|line| !line.is_empty());
    first.is_some_and(|line| line.starts_with(';') || line.chars().all(|c| "#.?S".contains(c)))
}

/// Reads a text map from the file `name`.
pub(super) fn read(name: &str, text: &str) -> Result<FloorPlan, MapError> {
    let mut plan = Header { name: stem(name), note: String::new(), resolution: DEFAULT_ASCII_RESOLUTION };
    let mut rows = Rows::default();
    for (index, line) in text.trim_end().lines().enumerate() {
        let line = line.trim_end();
        match line.strip_prefix(';') {
            Some(header) => plan.read_line(name, index + 1, header)?,
            None if rows.is_empty() && line.is_empty() => {}
            None => rows.push(name, index + 1, line)?,
        }
    }
    plan.with_cells(name, &rows)
}

/// Writes a floor plan as a text map. The start's position within its cell and its heading are lost.
///
/// ```
/// use robovac_core::floor_plan::{Sketch, to_ascii};
/// let plan = Sketch::open(0.6, 0.4, 0.2).fill(&[[0.4, 0.0, 0.6, 0.2]]).start(0.1, 0.3, 0.0).finish("Nook", "");
/// assert_eq!(to_ascii(&plan), "; resolution 0.2\n; name Nook\nS..\n..#\n");
/// ```
pub fn to_ascii(plan: &FloorPlan) -> String {
    use std::fmt::Write;
    let mut text = String::new();
    let one_line = |value: &str| value.split_whitespace().collect::<Vec<_>>().join(" ");
    let _ = writeln!(text, "; resolution {}", plan.resolution);
    for (key, value) in [("name", &plan.name), ("note", &plan.note)] {
        if !value.trim().is_empty() {
            let _ = writeln!(text, "; {key} {}", one_line(value));
        }
    }
    let start = plan.start.map(|pose| plan.cell_at(pose.position()));
    let start = start.and_then(|cell| plan.occupancy.get(cell).filter(|o| o.is_free()).map(|_| cell));
    let mut cells = plan.occupancy.map(|&occupancy| glyph(occupancy));
    if let Some(start) = start {
        cells[start] = 'S';
    }
    text + &picture(&cells, |&c| c)
}

/// The character that stands for a cell.
pub(super) const fn glyph(occupancy: Occupancy) -> char {
    match occupancy {
        Occupancy::Free => '.',
        Occupancy::Occupied => '#',
        Occupancy::Unknown => '?',
    }
}

/// The cell that a character stands for.
pub(super) const fn cell_of(glyph: char) -> Option<Occupancy> {
    match glyph {
        '.' | 'S' => Some(Occupancy::Free),
        '#' => Some(Occupancy::Occupied),
        '?' => Some(Occupancy::Unknown),
        _ => None,
    }
}

/// The values of the header lines.
struct Header {
    name: String,
    note: String,
    resolution: f64,
}

impl Header {
    fn read_line(&mut self, file: &str, line: usize, header: &str) -> Result<(), MapError> {
        let (key, value) = header.trim().split_once(char::is_whitespace).unwrap_or((header.trim(), ""));
        match key {
            "resolution" => self.resolution = checked_resolution(file, &format!("line {line}"), value)?,
            "name" => value.trim().clone_into(&mut self.name),
            "note" => value.trim().clone_into(&mut self.note),
            _ => {}
        }
        Ok(())
    }

    fn with_cells(self, file: &str, rows: &Rows) -> Result<FloorPlan, MapError> {
        let width = rows.width;
        // Rows came from the top; the grid wants the bottom row first.
        let cells = rows.cells.chunks(width.max(1)).rev().flatten().copied().collect();
        let occupancy = Grid::from_rows(width, cells).ok_or_else(|| MapError::NoFreeCell { name: file.to_owned() })?;
        let height = occupancy.height() as i32;
        let start = rows.start.map(|(_, cell)| {
            let (x, y) = (f64::from(cell.x) + 0.5, f64::from(height - 1 - cell.y) + 0.5);
            Pose::new(x * self.resolution, y * self.resolution, 0.0)
        });
        Ok(FloorPlan {
            name: self.name,
            note: self.note,
            resolution: self.resolution,
            occupancy,
            objects: Vec::new(),
            start,
            origin: Pose::new(0.0, 0.0, 0.0),
        })
    }
}

/// Cells in the file's order, from the top.
#[derive(Default)]
struct Rows {
    width: usize,
    cells: Vec<Occupancy>,
    /// Line and cell of the start, rows counted from the top.
    start: Option<(usize, Cell)>,
}

impl Rows {
    fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    fn push(&mut self, file: &str, line: usize, row: &str) -> Result<(), MapError> {
        let y = self.cells.len() / self.width.max(1);
        let before = self.cells.len();
        for (x, found) in row.chars().enumerate() {
            let cell = cell_of(found).ok_or_else(|| MapError::BadCharacter {
                name: file.to_owned(),
                line,
                column: x + 1,
                found: found.escape_debug().to_string(),
            })?;
            if found == 'S'
                && let Some((first, _)) = self.start.replace((line, Cell::new(x as i32, y as i32)))
            {
                return Err(MapError::TwoStarts { name: file.to_owned(), line, first });
            }
            self.cells.push(cell);
        }
        let found = self.cells.len() - before;
        if before == 0 {
            self.width = found;
        }
        if found.max(y + 1) > MAX_SIDE {
            return Err(MapError::TooLarge { name: file.to_owned(), width: found, height: y + 1 });
        }
        if found != self.width {
            return Err(MapError::UnequalRows { name: file.to_owned(), line, found, expected: self.width });
        }
        Ok(())
    }
}

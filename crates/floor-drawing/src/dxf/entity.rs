//! Reads one entity and checks its numbers.

use super::pairs::{DxfFault, Pair};
use crate::{
    DrawingFlaw,
    model::{MAX_COORDINATE, MAX_POINTS},
};

/// Kind of a drawn entity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum EntityKind {
    Line,
    Circle,
    Arc,
    Ellipse,
    Spline,
    LwPolyline,
    /// The older form, whose vertices are entities of their own.
    Polyline,
    Solid,
    Face,
    Insert,
}

/// Kind of the entities with this type name: drawn, left out under a name, or not counted at all.
pub(super) fn kind_of(name: &[u8]) -> Result<EntityKind, Option<&'static str>> {
    Ok(match name {
        b"LINE" => EntityKind::Line,
        b"CIRCLE" => EntityKind::Circle,
        b"ARC" => EntityKind::Arc,
        b"ELLIPSE" => EntityKind::Ellipse,
        b"SPLINE" => EntityKind::Spline,
        b"LWPOLYLINE" => EntityKind::LwPolyline,
        b"POLYLINE" => EntityKind::Polyline,
        b"SOLID" | b"TRACE" => EntityKind::Solid,
        b"3DFACE" => EntityKind::Face,
        b"INSERT" => EntityKind::Insert,
        b"VERTEX" | b"SEQEND" | b"VIEWPORT" | b"ATTDEF" => return Err(None),
        b"TEXT" | b"MTEXT" | b"ATTRIB" | b"ARCALIGNEDTEXT" | b"RTEXT" => return Err(Some("texts")),
        b"DIMENSION" | b"LARGE_RADIAL_DIMENSION" | b"ARC_DIMENSION" | b"LEADER" | b"MULTILEADER" | b"TOLERANCE" => {
            return Err(Some("dimensions"));
        }
        b"HATCH" | b"MPOLYGON" => return Err(Some("hatches")),
        b"POINT" => return Err(Some("points")),
        b"IMAGE" | b"WIPEOUT" | b"OLEFRAME" | b"OLE2FRAME" | b"PDFUNDERLAY" | b"DWFUNDERLAY" => {
            return Err(Some("images"));
        }
        b"3DSOLID" | b"BODY" | b"REGION" | b"SURFACE" | b"MESH" => return Err(Some("solid bodies")),
        b"RAY" | b"XLINE" => return Err(Some("infinite lines")),
        _ => return Err(Some("other entities")),
    })
}

/// The part of an entity that has been read.
pub(super) struct Entity<'a> {
    pub kind: EntityKind,
    pub number: u32,
    pub at: usize,
    pub body: usize,
    /// Its layer's name as written.
    pub layer: &'a [u8],
    /// The name of the block that it inserts, as written.
    pub block: &'a [u8],
    pub is_on_paper: bool,
    pub is_hidden: bool,
    /// The group codes and values used for drawing, in the file's order.
    pub numbers: Vec<(i32, f64)>,
    /// Index in `numbers` of the current POLYLINE's vertex.
    vertex: Option<usize>,
    flags: i64,
}

impl<'a> Entity<'a> {
    pub fn new(kind: EntityKind, number: u32, at: usize, body: usize) -> Self {
        Self {
            kind,
            number,
            at,
            body,
            layer: b"",
            block: b"",
            is_on_paper: false,
            is_hidden: false,
            numbers: Vec::new(),
            vertex: None,
            flags: 0,
        }
    }

    /// A VERTEX of a POLYLINE begins.
    pub fn begin_vertex(&mut self) {
        self.vertex = Some(self.numbers.len());
    }

    /// Takes one pair.
    pub fn take(&mut self, pair: &Pair<'a>) -> Result<(), DxfFault> {
        let in_vertex = self.vertex.is_some();
        match pair.code {
            8 if !in_vertex => self.layer = pair.text(),
            2 if self.kind == EntityKind::Insert => self.block = pair.text(),
            67 if !in_vertex => self.is_on_paper = pair.whole()? == 1,
            60 if !in_vertex => self.is_hidden = pair.whole()? == 1,
            70 if in_vertex => self.vertex_flags(pair.whole()?),
            70 if matches!(self.kind, EntityKind::LwPolyline | EntityKind::Polyline | EntityKind::Spline) => {
                self.flags = pair.whole()?;
            }
            // Integers have 16 bits.
            70 | 71 if self.takes(pair.code) => self.push(pair, pair.whole()?.clamp(-0x8000, 0x7fff) as f64)?,
            code if self.takes(code) => {
                let value = pair.real()?;
                let is_usual = value.abs() <= MAX_COORDINATE;
                if !is_usual {
                    let value = match pair.text() {
                        b"" => value.to_string(),
                        text => String::from_utf8_lossy(&text[..text.len().min(30)]).into_owned(),
                    };
                    return Err((pair.at + 1, DrawingFlaw::Coordinate { value }));
                }
                self.push(pair, value)?;
            }
            _ => {}
        }
        Ok(())
    }

    fn push(&mut self, pair: &Pair<'_>, value: f64) -> Result<(), DxfFault> {
        if self.numbers.len() >= 3 * MAX_POINTS {
            return Err((pair.at, DrawingFlaw::TooMany { what: "corners", most: MAX_POINTS }));
        }
        self.numbers.push((pair.code, value));
        Ok(())
    }

    /// Bit 16: a control point of a smoothed polyline.
    fn vertex_flags(&mut self, flags: i64) {
        if flags & 16 != 0 {
            self.numbers.truncate(self.vertex.unwrap_or(usize::MAX));
            // The rest of it is left out as well.
            self.vertex = Some(usize::MAX);
        }
    }

    fn takes(&self, code: i32) -> bool {
        if matches!(code, 210 | 220 | 230) {
            return self.vertex.is_none();
        }
        match self.kind {
            EntityKind::Line => matches!(code, 10 | 20 | 11 | 21),
            EntityKind::Circle => matches!(code, 10 | 20 | 40),
            EntityKind::Arc => matches!(code, 10 | 20 | 40 | 50 | 51),
            EntityKind::Ellipse => matches!(code, 10 | 20 | 11 | 21 | 40 | 41 | 42),
            EntityKind::Spline => matches!(code, 10 | 20 | 11 | 21 | 40 | 41 | 71),
            EntityKind::LwPolyline => matches!(code, 10 | 20 | 42),
            EntityKind::Polyline => matches!(code, 10 | 20 | 42) && self.vertex.is_some_and(|start| start < usize::MAX),
            EntityKind::Solid | EntityKind::Face => matches!(code, 10..=13 | 20..=23),
            EntityKind::Insert => matches!(code, 10 | 20 | 41 | 42 | 44 | 45 | 50 | 70 | 71),
        }
    }

    /// Whether its last corner is joined to its first.
    pub fn is_closed(&self) -> bool {
        self.flags & 1 != 0
    }

    /// Whether it is a mesh, which isn't drawn.
    pub fn is_mesh(&self) -> bool {
        self.kind == EntityKind::Polyline && self.flags & (16 | 64) != 0
    }

    /// Whether it is in world coordinates, as 3D polylines are, rather than in a plane of its own.
    pub fn is_in_world(&self) -> bool {
        match self.kind {
            EntityKind::Line | EntityKind::Spline | EntityKind::Face => true,
            EntityKind::Polyline => self.flags & 8 != 0,
            _ => false,
        }
    }
}

//! One entity between its type and the next one: what of it is drawn, checked number by number.

use super::{
    entities::Batch,
    local::Source,
    pairs::{Fault, Pair},
};
use crate::model::{MAX_COORDINATE, MAX_POINTS};
use robovac_core::floorplan::DrawingFlaw;

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Line,
    Circle,
    Arc,
    Ellipse,
    Spline,
    LwPolyline,
    Polyline,
    Solid,
    Trace,
    Face,
    Insert,
}

/// What becomes of an entity of that type: it is drawn, or left out under a name, or not even counted.
pub(super) fn kind_of(name: &[u8]) -> Result<Kind, Option<&'static str>> {
    Ok(match name {
        b"LINE" => Kind::Line,
        b"CIRCLE" => Kind::Circle,
        b"ARC" => Kind::Arc,
        b"ELLIPSE" => Kind::Ellipse,
        b"SPLINE" => Kind::Spline,
        b"LWPOLYLINE" => Kind::LwPolyline,
        b"POLYLINE" => Kind::Polyline,
        b"SOLID" => Kind::Solid,
        b"TRACE" => Kind::Trace,
        b"3DFACE" => Kind::Face,
        b"INSERT" => Kind::Insert,
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
        b"RAY" | b"XLINE" => return Err(Some("endless lines")),
        _ => return Err(Some("other entities")),
    })
}

/// An entity as far as it has been read.
pub(super) struct Entity {
    pub kind: Kind,
    pub number: u32,
    pub at: usize,
    pub body: usize,
    /// Its layer's name as it is written.
    pub layer: Vec<u8>,
    /// The name of the block that it inserts, as it is written.
    pub block: Vec<u8>,
    pub is_on_paper: bool,
    pub is_hidden: bool,
    numbers: Vec<(i32, f64)>,
    /// Number of the vertex of a POLYLINE that is being read: where it begins in `numbers`.
    vertex: Option<usize>,
    flags: i64,
}

impl Entity {
    pub fn new(kind: Kind, number: u32, at: usize, body: usize) -> Self {
        Self {
            kind,
            number,
            at,
            body,
            layer: Vec::new(),
            block: Vec::new(),
            is_on_paper: false,
            is_hidden: false,
            numbers: Vec::new(),
            vertex: None,
            flags: 0,
        }
    }

    /// Whether vertices belong to it that are entities of their own.
    pub fn is_polyline(&self) -> bool {
        self.kind == Kind::Polyline
    }

    /// A VERTEX of a POLYLINE begins.
    pub fn begin_vertex(&mut self) {
        self.vertex = Some(self.numbers.len());
    }

    /// Takes in one pair.
    pub fn take(&mut self, pair: &Pair<'_>) -> Result<(), Fault> {
        let (code, in_vertex) = (pair.code, self.vertex.is_some());
        match code {
            8 if !in_vertex => self.layer = pair.text().to_vec(),
            2 if self.kind == Kind::Insert => self.block = pair.text().to_vec(),
            67 if !in_vertex => self.is_on_paper = pair.whole()? == 1,
            60 if !in_vertex => self.is_hidden = pair.whole()? == 1,
            70 if self.kind == Kind::Polyline => self.polyline_flags(pair.whole()?),
            70 | 71 if matches!(self.kind, Kind::LwPolyline | Kind::Spline | Kind::Insert) => {
                self.numbers.push((code, pair.whole()? as f64));
            }
            _ if self.takes(code) => {
                let value = pair.real()?;
                let is_usual = value.abs() <= MAX_COORDINATE;
                if !is_usual {
                    let value = match pair.text() {
                        b"" => value.to_string(),
                        text => String::from_utf8_lossy(&text[..text.len().min(30)]).into_owned(),
                    };
                    return Err((pair.at + 1, DrawingFlaw::Coordinate { value }));
                }
                if self.numbers.len() >= 3 * MAX_POINTS {
                    return Err((pair.at, DrawingFlaw::TooMany { what: "corners", most: MAX_POINTS }));
                }
                self.numbers.push((code, value));
            }
            _ => {}
        }
        Ok(())
    }

    /// 3D polylines, meshes: bits 8, 16, 64; of a vertex, 16 for a control point of a smoothed polyline.
    fn polyline_flags(&mut self, flags: i64) {
        match self.vertex {
            None => self.flags = flags,
            Some(start) if flags & 16 != 0 => {
                self.numbers.truncate(start);
                // What follows of it is left out as well.
                self.vertex = Some(usize::MAX);
            }
            Some(_) => {}
        }
    }

    fn takes(&self, code: i32) -> bool {
        if matches!(code, 210 | 220 | 230) {
            return self.vertex.is_none();
        }
        match self.kind {
            Kind::Line => matches!(code, 10 | 20 | 11 | 21),
            Kind::Circle => matches!(code, 10 | 20 | 40),
            Kind::Arc => matches!(code, 10 | 20 | 40 | 50 | 51),
            Kind::Ellipse => matches!(code, 10 | 20 | 11 | 21 | 40 | 41 | 42),
            Kind::Spline => matches!(code, 10 | 20 | 11 | 21 | 40 | 41),
            Kind::LwPolyline => matches!(code, 10 | 20 | 42),
            Kind::Polyline => matches!(code, 10 | 20 | 42) && self.vertex.is_some_and(|start| start < usize::MAX),
            Kind::Solid | Kind::Trace | Kind::Face => matches!(code, 10..=13 | 20..=23),
            Kind::Insert => matches!(code, 10 | 20 | 41 | 42 | 44 | 45 | 50),
        }
    }

    /// Whether it is a mesh, which isn't drawn.
    pub fn is_mesh(&self) -> bool {
        self.kind == Kind::Polyline && self.flags & (16 | 64) != 0
    }

    /// Hands the entity over to be read. `block` is the name of the block that it inserts.
    pub fn hand_over(&self, source: Source, block: String, batch: &mut Batch) {
        let name = match self.kind {
            Kind::Line => "LINE",
            Kind::Circle => "CIRCLE",
            Kind::Arc => "ARC",
            Kind::Ellipse => "ELLIPSE",
            Kind::Spline => "SPLINE",
            // The older form, whose vertices are entities of their own, is put as the newer.
            Kind::LwPolyline | Kind::Polyline => "LWPOLYLINE",
            Kind::Solid => "SOLID",
            Kind::Trace => "TRACE",
            Kind::Face => "3DFACE",
            Kind::Insert => "INSERT",
        };
        batch.begin(name, source, block);
        if self.kind == Kind::Polyline {
            batch.whole(70, self.flags & 1);
        }
        let mut has_vertex = false;
        for &(code, value) in &self.numbers {
            has_vertex |= code == 10;
            match (self.kind, code) {
                // 3D polylines are in the world's coordinates.
                (Kind::Polyline, 210..) if self.flags & 8 != 0 => {}
                (Kind::LwPolyline | Kind::Polyline, 20 | 42) if !has_vertex => {}
                (_, 70 | 71) => batch.whole(code, value as i64),
                _ => batch.real(code, value),
            }
            // The crate counts on three coordinates.
            if self.kind == Kind::Spline && matches!(code, 20 | 21) {
                batch.real(code + 10, 0.0);
            }
        }
    }
}

//! Reads the pairs of a DXF once: header, layers, blocks and entities.

use super::{
    entity::{Entity, EntityKind, kind_of},
    local::{DxfBlock, DxfContent, EntitySource, RefusedEntity},
    pairs::{DxfFault, Pair, Pairs, code_page, decode},
    units,
};
use crate::{
    DrawingFlaw, Role, colours,
    model::{Builder, check_coordinate},
};
use encoding_rs::Encoding;
use robovac_core::geometry::Point;

/// Most blocks of a drawing.
const MAX_BLOCKS: usize = 100_000;

/// A flaw and its place in words.
pub(super) type Stopped = (String, DrawingFlaw);

/// The content of a DXF.
pub(super) struct Scanned {
    pub content: DxfContent,
    pub builder: Builder,
    pub metre: Option<f64>,
    pub is_text: bool,
}

/// Reads the drawn parts of a DXF.
pub(super) fn scan(bytes: &[u8]) -> Result<Scanned, Stopped> {
    let mut scan = Scan {
        pairs: Pairs::new(bytes),
        code_page: encoding_rs::WINDOWS_1252,
        metre: None,
        builder: Builder::new(),
        content: DxfContent::new(),
        entity: None,
        counted: 0,
        has_entities: false,
    };
    match scan.sections() {
        Ok(()) => {}
        Err(ScanStop::At(at, flaw)) => return Err((place(scan.pairs.is_text(), at), flaw)),
        Err(ScanStop::In((source, flaw))) => {
            return Err((scan.content.place(&source, &scan.builder, scan.pairs.is_text()), flaw));
        }
    }
    let is_text = scan.pairs.is_text();
    Ok(Scanned { content: scan.content, builder: scan.builder, metre: scan.metre, is_text })
}

fn place(is_text: bool, at: usize) -> String {
    format!("{} {at}", if is_text { "line" } else { "byte" })
}

impl DxfContent {
    /// The place of an entity, in words.
    pub fn place(&self, source: &EntitySource, builder: &Builder, is_text: bool) -> String {
        let block = match self.bodies.get(source.body).map(|body| body.name.as_str()) {
            None | Some("") => String::new(),
            Some(name) => format!(" of block \"{name}\""),
        };
        let layer = builder.layer_name(source.layer);
        format!("entity {}{block} on layer \"{layer}\" ({})", source.number, place(is_text, source.at))
    }
}

enum ScanStop {
    At(usize, DrawingFlaw),
    In(RefusedEntity),
}

impl From<DxfFault> for ScanStop {
    fn from((at, flaw): DxfFault) -> Self {
        Self::At(at, flaw)
    }
}

impl From<RefusedEntity> for ScanStop {
    fn from(refused: RefusedEntity) -> Self {
        Self::In(refused)
    }
}

struct Scan<'a> {
    pairs: Pairs<'a>,
    code_page: &'static Encoding,
    metre: Option<f64>,
    builder: Builder,
    content: DxfContent,
    /// The entity that is being read.
    entity: Option<Entity<'a>>,
    /// Entities of the current body so far.
    counted: u32,
    has_entities: bool,
}

impl<'a> Scan<'a> {
    fn sections(&mut self) -> Result<(), ScanStop> {
        while let Some(pair) = self.pairs.next()? {
            match (pair.code, pair.text()) {
                (0, b"EOF") => break,
                (0, b"SECTION") => match self.section_name()? {
                    b"HEADER" => self.header()?,
                    b"TABLES" => self.tables()?,
                    b"BLOCKS" => self.blocks()?,
                    b"ENTITIES" if self.has_entities => {
                        let what = "there is a second ENTITIES section";
                        return Err(ScanStop::At(pair.at, DrawingFlaw::Structure { what }));
                    }
                    b"ENTITIES" => self.model()?,
                    _ => while !is_end(&self.must("inside a section")?, b"ENDSEC") {},
                },
                (0, _) => {
                    let what = "a section should begin here";
                    return Err(ScanStop::At(pair.at, DrawingFlaw::Structure { what }));
                }
                _ => {}
            }
        }
        if !self.has_entities {
            return Err(ScanStop::At(0, DrawingFlaw::CutOff { place: "before the ENTITIES section" }));
        }
        Ok(())
    }

    fn section_name(&mut self) -> Result<&'a [u8], ScanStop> {
        let pair = self.must("after the start of a section")?;
        if pair.code != 2 {
            return Err(ScanStop::At(pair.at, DrawingFlaw::Structure { what: "the previous section has no name" }));
        }
        Ok(pair.text())
    }

    /// The next pair, where the file must not end.
    fn must(&mut self, place: &'static str) -> Result<Pair<'a>, DxfFault> {
        let end = self.pairs.position();
        let is_text = self.pairs.is_text();
        match self.pairs.next()? {
            Some(pair) => Ok(pair),
            None => Err((if is_text { self.pairs.line() } else { end }, DrawingFlaw::CutOff { place })),
        }
    }

    fn header(&mut self) -> Result<(), ScanStop> {
        let mut variable: &[u8] = b"";
        loop {
            let pair = self.must("within its header")?;
            match (pair.code, variable) {
                (0, _) if is_end(&pair, b"ENDSEC") => return Ok(()),
                (9, _) => variable = pair.text(),
                (70, b"$INSUNITS") => self.metre = units::metres(pair.whole()?),
                (3, b"$DWGCODEPAGE") => self.code_page = code_page(pair.text()),
                _ => {}
            }
        }
    }

    fn tables(&mut self) -> Result<(), ScanStop> {
        let mut layer: Option<LayerRecord<'a>> = None;
        loop {
            let pair = self.must("within its tables")?;
            if pair.code == 0 {
                if let Some(layer) = layer.take() {
                    self.add_layer(&layer).map_err(|flaw| ScanStop::At(pair.at, flaw))?;
                }
                match pair.text() {
                    b"ENDSEC" => return Ok(()),
                    b"LAYER" => layer = Some(LayerRecord::default()),
                    _ => {}
                }
            } else if let Some(layer) = &mut layer {
                match pair.code {
                    2 => layer.name = pair.text(),
                    62 => layer.colour = pair.whole()?,
                    70 => layer.flags = pair.whole()?,
                    420 => layer.true_colour = Some(pair.whole()?),
                    _ => {}
                }
            }
        }
    }

    fn add_layer(&mut self, record: &LayerRecord<'_>) -> Result<(), DrawingFlaw> {
        // The head of the table has no name.
        if record.name.is_empty() {
            return Ok(());
        }
        let index = self.builder.layer(&decode(record.name, self.code_page))?;
        let layer = self.builder.layer_mut(index);
        let by_index = || colours::rgb(i32::try_from(record.colour.abs()).unwrap_or(0));
        layer.colour = record.true_colour.map_or_else(by_index, colours::true_colour);
        // Switched off or frozen.
        if record.colour < 0 || record.flags & 1 != 0 {
            layer.role = Role::Ignored;
        }
        Ok(())
    }

    fn blocks(&mut self) -> Result<(), ScanStop> {
        loop {
            let pair = self.must("within its blocks")?;
            match (pair.code, pair.text()) {
                (0, b"ENDSEC") => return Ok(()),
                (0, b"BLOCK") => self.block(pair.at)?,
                _ => {}
            }
        }
    }

    fn block(&mut self, at: usize) -> Result<(), ScanStop> {
        if self.content.bodies.len() > MAX_BLOCKS {
            return Err(ScanStop::At(at, DrawingFlaw::TooMany { what: "blocks", most: MAX_BLOCKS }));
        }
        let (mut name, mut base) = (&b""[..], Point::origin());
        let first = loop {
            let pair = self.must("within a block")?;
            match pair.code {
                0 => break pair,
                2 => name = pair.text(),
                10 => base.x = pair.real()?,
                20 => base.y = pair.real()?,
                _ => {}
            }
        };
        check_coordinate(base.x).and(check_coordinate(base.y)).map_err(|flaw| ScanStop::At(at, flaw))?;
        let name = decode(name, self.code_page);
        self.content.bodies.push(DxfBlock { name, base, strokes: 0..0, inserts: 0..0 });
        self.entities(first, self.content.bodies.len() - 1, b"ENDBLK")
    }

    fn model(&mut self) -> Result<(), ScanStop> {
        self.has_entities = true;
        let first = self.must("within its entities")?;
        self.entities(first, 0, b"ENDSEC")
    }

    /// Reads entities until `end`. A block whose end is missing ends with its section.
    fn entities(&mut self, first: Pair<'a>, body: usize, end: &[u8]) -> Result<(), ScanStop> {
        self.counted = 0;
        let mut pair = first;
        loop {
            if pair.code == 0 {
                let name = pair.text();
                let polyline = self.entity.as_mut().filter(|entity| entity.kind == EntityKind::Polyline);
                if let (Some(entity), b"VERTEX") = (polyline, name) {
                    entity.begin_vertex();
                } else {
                    self.finish_entity()?;
                    if name == end {
                        return Ok(());
                    }
                    if matches!(name, b"ENDSEC" | b"EOF" | b"BLOCK" | b"SECTION") {
                        let what = "the end of the previous block or section is missing";
                        return Err(ScanStop::At(pair.at, DrawingFlaw::Structure { what }));
                    }
                    self.begin_entity(name, pair.at, body);
                }
            } else if let Some(entity) = &mut self.entity
                && let Err((at, flaw)) = entity.take(&pair)
            {
                // The entity is more helpful in messages than the line alone.
                let source = self.source(at)?;
                return Err(ScanStop::In((source, flaw)));
            }
            pair = self.must(if body == 0 { "within its entities" } else { "within a block" })?;
        }
    }

    fn begin_entity(&mut self, name: &[u8], at: usize, body: usize) {
        let kind = kind_of(name);
        if !matches!(kind, Err(None)) {
            self.counted = self.counted.saturating_add(1);
        }
        match kind {
            Ok(kind) => self.entity = Some(Entity::new(kind, self.counted, at, body)),
            Err(Some(what)) => self.builder.leave_out(what, 1),
            Err(None) => {}
        }
    }

    /// The source of the current entity, with `at` as its position.
    fn source(&mut self, at: usize) -> Result<EntitySource, ScanStop> {
        let Some(entity) = &self.entity else { return Ok(EntitySource { number: 0, layer: 0, at, body: 0 }) };
        let name = if entity.layer.is_empty() { "0".into() } else { decode(entity.layer, self.code_page) };
        let (number, body) = (entity.number, entity.body);
        let layer = self.builder.layer(&name).map_err(|flaw| ScanStop::At(at, flaw))?;
        Ok(EntitySource { number, layer, at, body })
    }

    fn finish_entity(&mut self) -> Result<(), ScanStop> {
        let Some(at) = self.entity.as_ref().map(|entity| entity.at) else { return Ok(()) };
        let source = self.source(at)?;
        let Some(entity) = self.entity.take() else { return Ok(()) };
        let left_out = if entity.is_on_paper {
            Some("entities in paper space")
        } else if entity.is_hidden {
            Some("hidden entities")
        } else if entity.is_mesh() {
            Some("meshes")
        } else {
            let block = decode(entity.block, self.code_page);
            entity.draw(source, block, &mut self.content).map_err(|flaw| (source, flaw))?
        };
        if let Some(what) = left_out {
            self.builder.leave_out(what, 1);
        }
        Ok(())
    }
}

/// The part of a layer's record that has been read.
#[derive(Default)]
struct LayerRecord<'a> {
    name: &'a [u8],
    colour: i64,
    flags: i64,
    true_colour: Option<i64>,
}

fn is_end(pair: &Pair<'_>, end: &[u8]) -> bool {
    pair.code == 0 && pair.text() == end
}

//! SVG floor plans.
//!
//! `usvg` resolves styles, transforms, units and `use`, in single precision: seven digits. Names of layers are read
//! from the file itself.

use super::{
    Drawing, DrawingError, DrawingFlaw,
    colours::true_colour,
    error::bad,
    flatten::Nurbs,
    model::{AreaFill, Builder, FillRule, MAX_POINTS},
    roles::is_known,
};
use robovac_core::{floor_plan::SourceFile, geometry::Point};
use std::collections::BTreeMap;
use usvg::{
    Group, LineCap, Node, Options, Paint, Tree,
    roxmltree::{Document, Node as Element, ParsingOptions},
    tiny_skia_path::PathSegment,
};

/// Most elements and texts of a file.
const MAX_NODES: u32 = 2_000_000;
/// Deepest nesting of elements; a `use` includes the depth of its target.
const MAX_DEPTH: usize = 100;
/// Size of a pixel where lengths have units: CSS has 96 per inch.
const MM_PER_PIXEL: f64 = 25.4 / 96.0;
/// Bytes at the start of a file in which its first element is searched.
const HEAD: usize = 1 << 16;
/// Brightest channel of a colour that walls are filled with, of 255, and least opacity of what counts (ours).
const DARK: u8 = 96;
const OPAQUE: f32 = 0.9;
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";
const XLINK: &str = "http://www.w3.org/1999/xlink";

/// Whether the bytes are XML with an `svg` element in front.
pub(super) fn is_svg(bytes: &[u8]) -> bool {
    let head = bytes.trim_ascii_start();
    let head = &head[..head.len().min(HEAD)];
    head.starts_with(b"<") && (head.windows(4).any(|window| window == b"<svg" || window == b":svg"))
}

/// Reads an SVG. Its y axis is turned up. If its width has a physical unit, the drawing is in millimetres; else in
/// pixels, whose size the user must enter.
pub(super) fn read(file: &SourceFile) -> Result<Drawing, DrawingError> {
    let refuse = |place: &str, flaw| bad(&file.name, place, flaw);
    let bytes = file.bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&file.bytes);
    let not_text = |error: std::str::Utf8Error| {
        refuse(&format!("byte {}", error.valid_up_to()), DrawingFlaw::Parser { cause: "this isn't UTF-8".to_owned() })
    };
    let text = std::str::from_utf8(bytes).map_err(not_text)?;
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let at = error.pos();
        refuse(&format!("line {}, column {}", at.row, at.col), DrawingFlaw::Parser { cause: error.to_string() })
    })?;
    let line = |element: Element<'_, '_>| {
        let at = document.text_pos_at(element.range().start);
        format!("line {}, column {}", at.row, at.col)
    };
    check_depth(&document)
        .map_err(|element| refuse(&line(element), DrawingFlaw::TooMany { what: "nested elements", most: MAX_DEPTH }))?;
    let tree = Tree::from_xmltree(&document, &Options::default())
        .map_err(|error| refuse("", DrawingFlaw::Parser { cause: error.to_string() }))?;
    let is_physical = has_physical_size(&document);
    let scale = if is_physical { MM_PER_PIXEL } else { 1.0 };
    let mut painter = SvgPainter {
        builder: Builder::new(),
        labels: labels(&document),
        height: f64::from(tree.size().height()),
        page: [tree.size().width(), tree.size().height()],
        scale,
        paths: 0,
        has_widths: !text.contains("non-scaling-stroke"),
    };
    for name in ["text", "image"] {
        let count = document.descendants().filter(|element| element.tag_name().name() == name).count();
        painter.builder.leave_out(if name == "text" { "texts" } else { "images" }, count);
    }
    let place = |(path, flaw): (u32, DrawingFlaw)| refuse(&format!("path {path}"), flaw);
    painter.group(tree.root(), &Names::default()).map_err(place)?;
    painter.builder.finish(&file.name, is_physical.then_some(1e-3))
}

/// Whether the width has a physical unit.
fn has_physical_size(document: &Document<'_>) -> bool {
    let width = document.root_element().attribute("width").unwrap_or_default().trim();
    ["mm", "cm", "in", "pt", "pc", "Q"].iter().any(|unit| width.ends_with(unit))
}

/// Inkscape's names of layers and groups by their ids.
fn labels(document: &Document<'_>) -> BTreeMap<String, String> {
    let groups = document.descendants().filter(|element| element.tag_name().name() == "g");
    groups
        .filter_map(|group| Some((group.attribute("id")?.to_owned(), group.attribute((INKSCAPE, "label"))?.to_owned())))
        .collect()
}

/// Refuses elements that are nested so deeply, `use` targets included, that reading them could overflow the stack.
fn check_depth<'a, 'i>(document: &'a Document<'i>) -> Result<(), Element<'a, 'i>> {
    let mut by_id = BTreeMap::new();
    for element in document.descendants() {
        if let Some(id) = element.attribute("id") {
            by_id.entry(id).or_insert(element);
        }
    }
    // The greatest depth at which every element was visited; smaller depths are skipped.
    let mut seen: BTreeMap<usize, usize> = BTreeMap::new();
    let mut left = 4 * MAX_NODES;
    let mut stack = vec![(document.root_element(), 1)];
    while let Some((element, depth)) = stack.pop() {
        left = left.saturating_sub(1);
        if depth > MAX_DEPTH || left == 0 {
            return Err(element);
        }
        let before = seen.entry(element.range().start).or_default();
        if *before >= depth {
            continue;
        }
        *before = depth;
        let used = element.attribute("href").or_else(|| element.attribute((XLINK, "href")));
        let is_use = element.tag_name().name() == "use";
        let used = used.filter(|_| is_use).and_then(|href| by_id.get(href.strip_prefix('#')?).copied());
        // Elements that use themselves aren't drawn by `usvg`.
        let used = used.filter(|used| !element.ancestors().any(|outer| outer == *used));
        stack.extend(element.children().chain(used).filter(Element::is_element).map(|child| (child, depth + 1)));
    }
    Ok(())
}

/// Names of the groups around a path.
#[derive(Clone, Default)]
struct Names {
    /// The innermost name given in Inkscape.
    label: Option<String>,
    /// The outermost id, or the outermost that says what the group is.
    id: Option<String>,
}

struct SvgPainter {
    builder: Builder,
    labels: BTreeMap<String, String>,
    /// Height of the picture, pixels.
    height: f64,
    /// Width and height of the page, pixels.
    page: [f32; 2],
    scale: f64,
    paths: u32,
    /// Whether widths are those of the drawing. A `vector-effect` makes them those of a screen; `usvg` doesn't say of which paths.
    has_widths: bool,
}

impl SvgPainter {
    fn group(&mut self, group: &Group, names: &Names) -> Result<(), (u32, DrawingFlaw)> {
        for node in group.children() {
            match node {
                Node::Group(inner) => {
                    let mut names = names.clone();
                    if !inner.id().is_empty() {
                        names.label = self.labels.get(inner.id()).cloned().or(names.label);
                        // A group round all others may say nothing, and those within it what they are.
                        names.id = names.id.filter(|id| is_known(id) || !is_known(inner.id()));
                        names.id = names.id.or_else(|| Some(inner.id().to_owned()));
                    }
                    self.group(inner, &names)?;
                }
                Node::Path(path) => {
                    self.paths += 1;
                    let number = self.paths;
                    self.path(path, names).map_err(|flaw| (number, flaw))?;
                }
                Node::Image(_) | Node::Text(_) => {}
            }
        }
        Ok(())
    }

    /// Whether a path is a filled rectangle as large as the page.
    fn is_background(&self, path: &usvg::Path) -> bool {
        let bounds = path.abs_bounding_box();
        let [width, height] = self.page;
        let is_plain = path.stroke().is_none() && path.data().segments().count() <= 6;
        is_plain
            && bounds.left() <= 0.01 * width
            && bounds.top() <= 0.01 * height
            && bounds.right() >= 0.99 * width
            && bounds.bottom() >= 0.99 * height
    }

    fn path(&mut self, path: &usvg::Path, names: &Names) -> Result<(), DrawingFlaw> {
        if !path.is_visible() {
            self.builder.leave_out("hidden paths", 1);
            return Ok(());
        }
        let paint = path.stroke().map(usvg::Stroke::paint).or_else(|| path.fill().map(usvg::Fill::paint));
        let colour = match paint {
            Some(Paint::Color(colour)) => [colour.red, colour.green, colour.blue],
            _ => true_colour(0),
        };
        // Drawing programs number paths: only ids with a word that says something are names.
        let own = || Some(path.id()).filter(|id| is_known(id)).map(str::to_owned);
        let name = names.label.clone().or_else(|| names.id.clone()).or_else(own).unwrap_or_else(|| {
            let [red, green, blue] = colour;
            format!("#{red:02x}{green:02x}{blue:02x}")
        });
        // The paper isn't a wall, whatever it is called.
        let name = if self.is_background(path) { "background" } else { &name };
        let layer = self.builder.layer(name)?;
        if self.builder.layer_mut(layer).strokes == 0 {
            self.builder.layer_mut(layer).colour = colour;
        }
        // Outlines that are filled without a stroke are closed.
        let is_area = path.stroke().is_none();
        let transform = path.abs_transform();
        let [sx, kx, ky, sy] = [transform.sx, transform.kx, transform.ky, transform.sy].map(f64::from);
        let stroke = path.stroke().filter(|_| self.has_widths);
        // The mean, where a transform stretches.
        let width = stroke
            .map_or(0.0, |stroke| f64::from(stroke.width().get()) * (sx * sy - kx * ky).abs().sqrt() * self.scale);
        let cap = stroke.filter(|stroke| stroke.linecap() != LineCap::Butt).map_or(0.0, |_| 0.5 * width);
        self.builder.pen = width;
        self.builder.fill = fill_of(path);
        let at = |point: usvg::tiny_skia_path::Point| {
            let (x, y) = (f64::from(point.x), f64::from(point.y));
            let across = sx * x + kx * y + f64::from(transform.tx);
            let down = ky * x + sy * y + f64::from(transform.ty);
            Point::new(across * self.scale, (self.height - down) * self.scale)
        };
        let mut points: Vec<Point> = Vec::new();
        for segment in path.data().segments() {
            if points.len() > MAX_POINTS {
                break;
            }
            let curve = match segment {
                PathSegment::MoveTo(to) => {
                    self.builder.stroke(layer, self.paths, is_area, capped(&points, cap))?;
                    points = vec![at(to)];
                    continue;
                }
                PathSegment::LineTo(to) => {
                    points.push(at(to));
                    continue;
                }
                PathSegment::Close => {
                    self.builder.stroke(layer, self.paths, true, points.iter().copied())?;
                    // A subpath without a move starts where the last outline began.
                    points.truncate(1);
                    continue;
                }
                PathSegment::QuadTo(a, b) => vec![at(a), at(b)],
                PathSegment::CubicTo(a, b, c) => vec![at(a), at(b), at(c)],
            };
            let controls: Vec<Point> = points.last().copied().into_iter().chain(curve).collect();
            let bent = Nurbs { degree: controls.len() - 1, knots: &[], weights: &[], controls: &controls }.flatten();
            points.extend(bent.into_iter().skip(1));
        }
        self.builder.stroke(layer, self.paths, is_area, capped(&points, cap))
    }
}

/// How the area of a path is painted. Where there is a line, too, a dark area is often one that nobody chose: black is what SVG
/// fills with by default.
fn fill_of(path: &usvg::Path) -> AreaFill {
    let Some(fill) = path.fill().filter(|fill| fill.opacity().get() >= OPAQUE) else { return AreaFill::None };
    let Paint::Color(colour) = fill.paint() else { return AreaFill::None };
    let rule = match fill.rule() {
        usvg::FillRule::EvenOdd => FillRule::EvenOdd,
        usvg::FillRule::NonZero => FillRule::NonZero,
    };
    match [colour.red, colour.green, colour.blue].into_iter().max() {
        Some(brightest) if brightest <= DARK => {
            if path.stroke().is_none() {
                AreaFill::Dark(rule)
            } else {
                AreaFill::None
            }
        }
        _ => AreaFill::Light(rule),
    }
}

/// The corners with both ends moved on by `cap`, as square and round caps reach beyond them.
fn capped(corners: &[Point], cap: f64) -> Vec<Point> {
    let mut corners = corners.to_vec();
    if let ([first, second, ..], [.., before, last]) = (&corners[..], &corners[..]) {
        let beyond = |end: &Point, from: &Point| end + (end - from).try_normalize(0.0).unwrap_or_default() * cap;
        let (first, last) = (beyond(first, second), beyond(last, before));
        let end = corners.len() - 1;
        (corners[0], corners[end]) = (first, last);
    }
    corners
}

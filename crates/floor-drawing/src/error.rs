//! Errors in drawings, with a hint how to fix each.

use robovac_core::floor_plan::{MAX_RESOLUTION, MAX_SIDE, MIN_RESOLUTION, TAKEN, base_name};

/// A drawing that can't be read or written, or from which no room can be traced. Every message names the cause, the
/// place and the remedy.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DrawingError {
    /// A file has no content.
    #[error("\"{name}\" is empty; choose another file or save the map again. {TAKEN}")]
    Empty {
        /// The file.
        name: String,
    },
    /// A flaw in the file.
    #[error("\"{name}\"{}{place}: {flaw}", if place.is_empty() { "" } else { ", " })]
    Bad {
        /// The file.
        name: String,
        /// The place in the file, e.g. "line 12"; empty for the whole file.
        place: String,
        /// The flaw at that place.
        flaw: Box<DrawingFlaw>,
    },
}

/// Reasons why a drawing can't be read or no room can be traced from it, with remedies.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DrawingFlaw {
    /// A file that isn't a drawing.
    #[error("this is {kind}: {remedy}")]
    NotADrawing {
        /// Its likely type, e.g. "a PDF document".
        kind: &'static str,
        /// How to make a drawing of it.
        remedy: &'static str,
    },
    /// A file that is too large.
    #[error("the file has {found} MB, but the limit is {most} MB; split the drawing or remove what isn't needed")]
    TooLong {
        /// Its size, MB.
        found: usize,
        /// The largest size, MB.
        most: usize,
    },
    /// A DXF without a group code where one is expected.
    #[error(
        "expected a group code (a number from -5 to 1071), found \"{found}\"; the DXF is damaged from here on, export \
         it again"
    )]
    Code {
        /// The text found instead.
        found: String,
    },
    /// An invalid number in a DXF.
    #[error("group code {code} needs a number, found \"{found}\"; export the drawing again")]
    Value {
        /// The group code.
        code: i32,
        /// The text found instead.
        found: String,
    },
    /// Sections of a DXF out of order.
    #[error("{what}; the DXF is damaged, export it again")]
    Structure {
        /// What was found.
        what: &'static str,
    },
    /// The file ends prematurely.
    #[error("the file is cut off {place}; copy or export it again")]
    CutOff {
        /// The part that isn't complete.
        place: &'static str,
    },
    /// A file without anything that can be drawn.
    #[error("nothing in the drawing can be used{}; draw walls as lines, polylines, arcs or blocks", but(.left_out))]
    Nothing {
        /// Its content, none of which is drawn.
        left_out: Vec<String>,
    },
    /// A coordinate that isn't finite or is far beyond any building.
    #[error(
        "the coordinate {value} is out of range (-1e10 to 1e10); delete what lies there or move the drawing to the \
         origin"
    )]
    Coordinate {
        /// The value as written.
        value: String,
    },
    /// A drawing that exceeds a limit.
    #[error("the drawing has more than {most} {what}; remove blocks or layers that aren't needed")]
    TooMany {
        /// The elements of which there are too many.
        what: &'static str,
        /// The limit.
        most: usize,
    },
    /// A block that contains itself.
    #[error("the block \"{block}\" inserts itself{}; remove that insert", by(.through))]
    Cycle {
        /// Its name.
        block: String,
        /// The blocks between, outermost first.
        through: Vec<String>,
    },
    /// Blocks nested too deeply.
    #[error("blocks are nested more than {most} deep; explode the block \"{block}\"")]
    Depth {
        /// The innermost block.
        block: String,
        /// The greatest depth.
        most: usize,
    },
    /// An error of the SVG or GeoJSON parser.
    #[error("{cause}; fix it there or export the drawing again")]
    Parser {
        /// The parser's message.
        cause: String,
    },
    /// A unit whose length is invalid.
    #[error("a drawing unit can't be {value} m long; enter its length, e.g. 0.001 for millimetres")]
    Metre {
        /// The given length, m.
        value: f64,
    },
    /// A cell size that is invalid.
    #[error("the cell size can't be {value} m; use {MIN_RESOLUTION} to {MAX_RESOLUTION} m")]
    Resolution {
        /// The given side, m.
        value: f64,
    },
    /// A room with more cells than a map can have.
    #[error(
        "{} m x {} m is more than {MAX_SIDE} x {MAX_SIDE} cells of {resolution} m; {}check the unit, or choose a \
         smaller region", in_short(*width), in_short(*height), coarser(*would_do)
    )]
    TooManyCells {
        /// Width of the region, m.
        width: f64,
        /// Its height, m.
        height: f64,
        /// The given side of the cells, m.
        resolution: f64,
        /// A side that is large enough, m.
        would_do: f64,
    },
    /// The region is smaller than a few cells.
    #[error(
        "the region is {width:.4} m x {height:.4} m, less than three cells of {resolution} m; check the unit or choose a larger region"
    )]
    TooSmall {
        /// Width of the region, m.
        width: f64,
        /// Its height, m.
        height: f64,
        /// Side of the cells, m.
        resolution: f64,
    },
    /// Layers and roles don't match.
    #[error("the drawing has {layers} layers, but {roles} roles are given; give each layer one role")]
    Roles {
        /// Number of layers.
        layers: usize,
        /// Number of roles.
        roles: usize,
    },
    /// All layers are ignored.
    #[error("no layer is a wall or an obstacle; set the roles of the layers")]
    AllIgnored,
    /// A polygon region without area.
    #[error("the region must be a simple polygon with 3 to {most} corners; draw it again without crossing lines")]
    Outline {
        /// Most corners.
        most: usize,
    },
    /// A chosen point of a room that lies on a wall or an obstacle.
    #[error("there is {what} at ({x:.2}, {y:.2}); click on free floor, or use smaller cells")]
    NotFloor {
        /// What lies at the point.
        what: &'static str,
        /// x of the point, drawing units.
        x: f64,
        /// y of the point, drawing units.
        y: f64,
    },
    /// A chosen room that isn't closed.
    #[error(
        "the room isn't closed: there is an opening at most {width:.2} m wide near ({x:.2}, {y:.2}); raise the gap \
         tolerance above that or pick a rectangle"
    )]
    Leak {
        /// x of the opening, drawing units.
        x: f64,
        /// y of the opening, drawing units.
        y: f64,
        /// Width of the opening, m.
        width: f64,
    },
    /// A room without floor.
    #[error("no floor is left in the region; choose another region, or mark fewer layers as walls")]
    NoFloor,
}

fn but(left_out: &[String]) -> String {
    if left_out.is_empty() { String::new() } else { format!(", only {}", left_out.join(", ")) }
}

/// The widest cells that are recommended, m.
const WIDEST_CELLS: f64 = 1.0;

/// A length in as few decimals as are of use, m.
fn in_short(metres: f64) -> f64 {
    let unit = if metres < 10.0 { 1e4 } else { 1.0 };
    (metres * unit).round() / unit
}

/// Advice to use coarser cells, where these aren't too coarse for a room.
fn coarser(would_do: f64) -> String {
    if would_do <= WIDEST_CELLS { format!("use cells of {would_do} m, ") } else { String::new() }
}

fn by(blocks: &[String]) -> String {
    if blocks.is_empty() { String::new() } else { format!(" through \"{}\"", blocks.join("\", \"")) }
}

/// The error for a place in a file.
pub(super) fn bad(file: &str, place: &str, flaw: DrawingFlaw) -> DrawingError {
    DrawingError::Bad { name: base_name(file).to_owned(), place: place.to_owned(), flaw: Box::new(flaw) }
}

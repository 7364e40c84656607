//! Errors in drawings, with a hint how to fix each.

use robovac_core::floor_plan::{MAX_RESOLUTION, MAX_SIDE, MIN_RESOLUTION, base_name};

/// A drawing that can't be read or written, or that no room can be made of. Every message names the cause, the place and
/// what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DrawingError {
    /// A file has no content.
    #[error("\"{name}\" is empty; choose another file or save the map again")]
    Empty {
        /// The file.
        name: String,
    },
    /// Something in it is wrong.
    #[error("\"{name}\"{}{place}: {flaw}", if place.is_empty() { "" } else { ", " })]
    Bad {
        /// The file.
        name: String,
        /// Where in the file, e.g. "line 12"; empty for all of it.
        place: String,
        /// What is wrong there.
        flaw: Box<DrawingFlaw>,
    },
}

/// Why a drawing can't be read, or no room be made of it: the cause, and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DrawingFlaw {
    /// A DWG file, whatever it is called.
    #[error(
        "this is a DWG drawing, AutoCAD's own format; save it as DXF in the CAD program or convert it with LibreDWG"
    )]
    Dwg,
    /// Something else than a drawing.
    #[error("this is {kind}, not a drawing; choose a DXF, SVG or GeoJSON file")]
    NotADrawing {
        /// What it seems to be, e.g. "a PNG image".
        kind: &'static str,
    },
    /// The file is larger than any that is read.
    #[error("the file has {found} MB, but the limit is {most} MB; split the drawing or remove what isn't needed")]
    TooLong {
        /// Its size, MB.
        found: usize,
        /// The largest size, MB.
        most: usize,
    },
    /// A DXF where a group code should be and isn't.
    #[error(
        "expected a group code (a number from -5 to 1071), found \"{found}\"; the DXF is damaged from here on, export \
         it again"
    )]
    Code {
        /// What is there instead.
        found: String,
    },
    /// A number of a DXF that is none.
    #[error("group code {code} needs a number, found \"{found}\"; export the drawing again")]
    Value {
        /// The group code.
        code: i32,
        /// What is there instead.
        found: String,
    },
    /// Sections of a DXF out of order.
    #[error("{what}; the DXF is damaged, export it again")]
    Structure {
        /// What was found.
        what: &'static str,
    },
    /// The file ends before its content does.
    #[error("the file is cut off {place}; copy or export it again")]
    CutOff {
        /// Where.
        place: &'static str,
    },
    /// Nothing in it can be drawn.
    #[error("nothing in the drawing can be used{}; draw walls as lines, polylines, arcs or blocks", but(.left_out))]
    Nothing {
        /// What it holds instead.
        left_out: Vec<String>,
    },
    /// A coordinate that isn't finite or far beyond any building.
    #[error(
        "the coordinate {value} is out of range (-1e10 to 1e10); delete what lies there or move the drawing to the \
         origin"
    )]
    Coordinate {
        /// The value as it is written.
        value: String,
    },
    /// More than a drawing may hold.
    #[error("the drawing has more than {most} {what}; remove blocks or layers that aren't needed")]
    TooMany {
        /// What there is too much of.
        what: &'static str,
        /// How much is taken.
        most: usize,
    },
    /// A block that holds itself.
    #[error("the block \"{block}\" inserts itself{}; remove that insert", by(.through))]
    Cycle {
        /// Its name.
        block: String,
        /// The blocks between, outermost first.
        through: Vec<String>,
    },
    /// Blocks in blocks in blocks.
    #[error("blocks are nested more than {most} deep; explode the block \"{block}\"")]
    Depth {
        /// The block that is too deep.
        block: String,
        /// The greatest depth.
        most: usize,
    },
    /// What the reader of SVG or GeoJSON says.
    #[error("{cause}; fix it there or export the drawing again")]
    Parser {
        /// In its words.
        cause: String,
    },
    /// The length of a unit is no length.
    #[error("a drawing unit can't be {value} m long; enter its length, e.g. 0.001 for millimetres")]
    Metre {
        /// What was given, m.
        value: f64,
    },
    /// The side of a cell is no length.
    #[error("the cell size can't be {value} m; use {MIN_RESOLUTION} to {MAX_RESOLUTION} m")]
    Resolution {
        /// What was given, m.
        value: f64,
    },
    /// The room has more cells than a map may.
    #[error(
        "{width:.4} m x {height:.4} m is more than {MAX_SIDE} x {MAX_SIDE} cells of {resolution} m; use cells of \
         {would_do} m, check the unit, or choose a smaller region"
    )]
    TooManyCells {
        /// Width of the region, m.
        width: f64,
        /// Its height, m.
        height: f64,
        /// Side of the cells that were asked for, m.
        resolution: f64,
        /// Side that would do, m.
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
    /// The corners of the region enclose nothing.
    #[error("the region must be a simple polygon with 3 to {most} corners; draw it again without crossing lines")]
    Outline {
        /// Most corners.
        most: usize,
    },
    /// The click that chooses a room hit a wall or an obstacle.
    #[error("there is {what} at ({x:.2}, {y:.2}); click on free floor, or use smaller cells")]
    NotFloor {
        /// What is there.
        what: &'static str,
        /// Where, drawing units.
        x: f64,
        /// Where, drawing units.
        y: f64,
    },
    /// One gets out of the chosen room.
    #[error(
        "the room isn't closed: there is an opening about {width:.2} m wide near ({x:.2}, {y:.2}); raise the gap \
         tolerance above that or pick a rectangle"
    )]
    Leak {
        /// Where, drawing units.
        x: f64,
        /// Where, drawing units.
        y: f64,
        /// How wide the opening is, m.
        width: f64,
    },
    /// Nothing is left to clean.
    #[error("no floor is left in the region; choose another region, or make fewer layers walls")]
    NoFloor,
}

fn but(left_out: &[String]) -> String {
    if left_out.is_empty() { String::new() } else { format!(", only {}", left_out.join(", ")) }
}

fn by(blocks: &[String]) -> String {
    if blocks.is_empty() { String::new() } else { format!(" through \"{}\"", blocks.join("\", \"")) }
}

/// The error for a place in a file.
pub(super) fn bad(file: &str, place: &str, flaw: DrawingFlaw) -> DrawingError {
    DrawingError::Bad { name: base_name(file).to_owned(), place: place.to_owned(), flaw: Box::new(flaw) }
}

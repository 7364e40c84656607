//! Errors in map files, with a hint how to fix each.

use super::{JsonPlace, MAX_PIXELS, MAX_RESOLUTION, MAX_SIDE, MIN_RESOLUTION, PlacementFault, SCENARIO_VERSION, TAKEN};

/// Reasons why files aren't a valid floor plan. Every message names the cause, the place and the remedy.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MapError {
    /// No file was given.
    #[error("no file was given; choose a floor plan. {TAKEN}")]
    NoFile,
    /// A file has no content.
    #[error("\"{name}\" is empty; choose another file or save the map again. {TAKEN}")]
    Empty {
        /// The file.
        name: String,
    },
    /// A file of an unsupported type.
    #[error("\"{name}\" is {kind}: {remedy}. {TAKEN}")]
    NotAMap {
        /// The file.
        name: String,
        /// Its likely type, e.g. "a PDF document".
        kind: &'static str,
        /// How to make a floor plan of it.
        remedy: &'static str,
    },
    /// The map has too many rows or columns.
    #[error(
        "\"{name}\" has {width} x {height} cells, but the limit is {MAX_SIDE} x {MAX_SIDE}; crop it or save it at a \
         coarser resolution. {TAKEN}"
    )]
    TooLarge {
        /// The file.
        name: String,
        /// Columns.
        width: usize,
        /// Rows counted so far.
        height: usize,
    },
    /// A picture that is larger than memory allows.
    #[error(
        "\"{name}\" has {width} x {height} pixels, but at most {} million are read; scale it down to {}. {TAKEN}",
        MAX_PIXELS / 1_000_000, fitting(*width, *height)
    )]
    TooManyPixels {
        /// The file.
        name: String,
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// The file ends prematurely.
    #[error("\"{name}\" is cut off: its {part} ends too early; copy or export the file again. {TAKEN}")]
    Truncated {
        /// The file.
        name: String,
        /// The part that isn't complete.
        part: &'static str,
    },
    /// An image can't be decoded.
    #[error("\"{name}\" is damaged: {cause}; save the image again, best as PNG. {TAKEN}")]
    BadImage {
        /// The file.
        name: String,
        /// The decoder's message.
        cause: String,
    },
    /// A text map contains an unknown character.
    #[error(
        "\"{name}\", line {line}, column {column}: '{found}' is not allowed in a text map; use # for walls, . for \
         floor, ? for unknown and one S for the start"
    )]
    BadCharacter {
        /// The file.
        name: String,
        /// Line, counted from 1.
        line: usize,
        /// Column, counted from 1.
        column: usize,
        /// The character, escaped where it can't be shown.
        found: String,
    },
    /// Rows of a text map differ in length.
    #[error(
        "\"{name}\", line {line}: this row has {found} cells, but the rows above have {expected}; make all rows \
         equally long"
    )]
    UnequalRows {
        /// The file.
        name: String,
        /// Line, counted from 1.
        line: usize,
        /// Cells of that row.
        found: usize,
        /// Cells of the rows above.
        expected: usize,
    },
    /// A text map marks two starts.
    #[error("\"{name}\", line {line}: there is a second start S, the first one is in line {first}; keep one of them")]
    TwoStarts {
        /// The file.
        name: String,
        /// Line of the second one, counted from 1.
        line: usize,
        /// Line of the first one.
        first: usize,
    },
    /// A value is out of range or of the wrong kind.
    #[error("\"{name}\", {place}: {key} can't be \"{value}\"; use {expected}")]
    BadValue {
        /// The file.
        name: String,
        /// Where in the file.
        place: String,
        /// Name of the value.
        key: &'static str,
        /// The value found.
        value: String,
        /// Accepted values.
        expected: String,
    },
    /// A ROS map lacks a required key.
    #[error("\"{name}\" has no \"{key}\"; add the line \"{key}: {example}\"")]
    MissingKey {
        /// The file.
        name: String,
        /// The missing key.
        key: &'static str,
        /// An example of its value.
        example: &'static str,
    },
    /// YAML or JSON is malformed.
    #[error("\"{name}\", line {line}, column {column}: {cause}; fix that line or export the file again")]
    Syntax {
        /// The file.
        name: String,
        /// Line, counted from 1.
        line: usize,
        /// Column, counted from 1.
        column: usize,
        /// The parser's message.
        cause: String,
    },
    /// A ROS map without its image.
    #[error("\"{name}\" only describes a map; its cells are in \"{image}\"; choose both files together")]
    ImageMissing {
        /// The YAML file.
        name: String,
        /// The image that it names.
        image: String,
    },
    /// A ROS map with another image than its own.
    #[error(
        "\"{name}\" names the image \"{wanted}\", but \"{given}\" was given; \
         choose \"{wanted}\" instead or change the line \"image\""
    )]
    WrongImage {
        /// The YAML file.
        name: String,
        /// The image that it names.
        wanted: String,
        /// The image that was given.
        given: String,
    },
    /// More files than one map can have.
    #[error("\"{first}\" and \"{second}\" are two maps; choose one of them, or one YAML file with its image")]
    TwoMaps {
        /// One file.
        first: String,
        /// Another one.
        second: String,
    },
    /// A map without free cells.
    #[error(
        "\"{name}\" has no free cell; floor is . in text and light in images \
         (for ROS maps check negate, free_thresh and mode)"
    )]
    NoFreeCell {
        /// The file.
        name: String,
    },
    /// JSON that isn't a scenario.
    #[error(
        "\"{name}\" is JSON but not a scenario (no \"format\": \"robovac-scenario\"); choose a file that was saved here. \
         {TAKEN}"
    )]
    NotAScenario {
        /// The file.
        name: String,
    },
    /// JSON that doesn't match the schema of scenarios.
    #[error("\"{name}\", {place}: {cause}; fix that line or export the file again")]
    BadJson {
        /// The file.
        name: String,
        /// Where in the file.
        place: JsonPlace,
        /// The parser's message.
        cause: String,
    },
    /// An invalid scenario.
    #[error("\"{name}\", {place}: {flaw}")]
    BadScenario {
        /// The file.
        name: String,
        /// Where in the file.
        place: JsonPlace,
        /// The flaw at that place.
        flaw: Box<Flaw>,
    },
}

/// Flaws of a value of a scenario: the cause, and the remedy.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Flaw {
    /// A scenario of another version.
    #[error(
        "this scenario has version {found}, but this program reads 1 and {known}; reload the page or update the program"
    )]
    Version {
        /// Its version.
        found: String,
        /// The latest version that can be read.
        known: u64,
    },
    /// A key that an older version doesn't have.
    #[error("version 1 has no such key; write \"version\": {SCENARIO_VERSION}, or remove the key")]
    KeyOfLaterVersion,
    /// Both a planner and a behaviour.
    #[error("a robot follows either a planner or a behaviour; remove \"planner\" or \"behaviour\"")]
    TwoAlgorithms,
    /// Rows don't match the size.
    #[error("found {found}, but \"{key}\" is {expected}; correct \"{key}\" or the rows")]
    WrongSize {
        /// The key of the size.
        key: &'static str,
        /// Cells or rows found.
        found: usize,
        /// Cells or rows announced.
        expected: usize,
    },
    /// The map has too many rows or columns.
    #[error("{found} cells are too many, the limit is {MAX_SIDE}; crop the room or save it at a coarser resolution")]
    TooLarge {
        /// Rows or columns.
        found: usize,
    },
    /// An unknown character in the map.
    #[error("a cell can't be \"{found}\"; write # for wall, . for floor or ? for unknown")]
    Cell {
        /// The character, escaped where it can't be shown.
        found: String,
    },
    /// A map without free cells.
    #[error("there is no free cell; write . for floor")]
    NoFreeCell,
    /// A number out of range, or an object that can't be placed.
    #[error(transparent)]
    Fault(#[from] PlacementFault),
}

/// A resolution in metres per cell, or the error that names its place.
pub(super) fn checked_resolution(name: &str, place: &str, text: &str) -> Result<f64, MapError> {
    match text.trim().parse::<f64>() {
        Ok(metres) if (MIN_RESOLUTION..=MAX_RESOLUTION).contains(&metres) => Ok(metres),
        _ => Err(MapError::BadValue {
            name: name.to_owned(),
            place: place.to_owned(),
            key: "resolution",
            value: text.trim().to_owned(),
            expected: format!("metres per cell from {MIN_RESOLUTION} to {MAX_RESOLUTION}"),
        }),
    }
}

/// A whole fraction of a picture's size that has no more than [`MAX_PIXELS`], in words.
fn fitting(width: usize, height: usize) -> String {
    let fits = |times: &usize| (width / times).saturating_mul(height / times) <= MAX_PIXELS;
    let times = (2..=width.max(2)).find(fits).unwrap_or(2);
    format!("{} x {}", width / times, height / times)
}

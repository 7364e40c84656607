//! Errors in map files, with a hint how to fix each.

use super::{JsonPlace, MAX_RESOLUTION, MAX_SIDE, MIN_RESOLUTION, PlacementFault, SCENARIO_VERSION};

/// Why files don't make a floor plan. Every message names the cause, the place and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MapError {
    /// No file was given.
    #[error("no file was given; choose a floor plan (PNG, PGM or text), a ROS map (YAML and its image) or a scenario")]
    NoFile,
    /// A file has no content.
    #[error("\"{name}\" is empty; choose another file or save the map again")]
    Empty {
        /// The file.
        name: String,
    },
    /// A file is of a kind that isn't read.
    #[error(
        "\"{name}\" is {kind}, not a supported map; use a PNG or PGM image, a ROS map (YAML and its image), a text map \
         of # and . or a scenario"
    )]
    NotAMap {
        /// The file.
        name: String,
        /// What it seems to be, e.g. "a JPEG image".
        kind: &'static str,
    },
    /// The map has too many rows or columns.
    #[error(
        "\"{name}\" has {width} x {height} cells, but the limit is {MAX_SIDE} x {MAX_SIDE}; crop it or save it at a \
         coarser resolution"
    )]
    TooLarge {
        /// The file.
        name: String,
        /// Columns.
        width: usize,
        /// Rows, as far as they were counted.
        height: usize,
    },
    /// The file ends before its content does.
    #[error("\"{name}\" is cut off: its {part} ends too early; copy or export the file again")]
    Truncated {
        /// The file.
        name: String,
        /// What ends too early.
        part: &'static str,
    },
    /// An image can't be decoded.
    #[error("\"{name}\" is damaged: {cause}; save the image again as PNG or PGM")]
    BadImage {
        /// The file.
        name: String,
        /// What the decoder says.
        cause: String,
    },
    /// A text map contains a character without a meaning.
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
        /// What the value is for.
        key: &'static str,
        /// The value found.
        value: String,
        /// What would do.
        expected: String,
    },
    /// A ROS map leaves out something that it needs.
    #[error("\"{name}\" has no \"{key}\"; add the line \"{key}: {example}\"")]
    MissingKey {
        /// The file.
        name: String,
        /// What is missing.
        key: &'static str,
        /// A value that would do.
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
        /// What the parser says.
        cause: String,
    },
    /// A ROS map came without its image.
    #[error("\"{name}\" only describes a map; its cells are in \"{image}\"; choose both files together")]
    ImageMissing {
        /// The YAML file.
        name: String,
        /// The image that it names.
        image: String,
    },
    /// A ROS map came with another image than its own.
    #[error(
        "\"{name}\" names the image \"{wanted}\", but \"{given}\" was given; \
         choose \"{wanted}\" instead or change the line \"image\""
    )]
    WrongImage {
        /// The YAML file.
        name: String,
        /// The image that it names.
        wanted: String,
        /// The image that came.
        given: String,
    },
    /// More files than one map has.
    #[error("\"{first}\" and \"{second}\" are two maps; choose one of them, or one YAML file with its image")]
    TwoMaps {
        /// One file.
        first: String,
        /// Another one.
        second: String,
    },
    /// There is nowhere to drive.
    #[error(
        "\"{name}\" has no free cell; floor is . in text and light in images \
         (for ROS maps check negate, free_thresh and mode)"
    )]
    NoFreeCell {
        /// The file.
        name: String,
    },
    /// JSON, but something else than a scenario.
    #[error(
        "\"{name}\" is JSON but not a scenario (no \"format\": \"robovac-scenario\"); choose a file that was saved here"
    )]
    NotAScenario {
        /// The file.
        name: String,
    },
    /// JSON that isn't what a scenario is made of.
    #[error("\"{name}\", {place}: {cause}; fix that line or export the file again")]
    BadJson {
        /// The file.
        name: String,
        /// Where in the file.
        place: JsonPlace,
        /// What the parser says.
        cause: String,
    },
    /// A scenario that can't be.
    #[error("\"{name}\", {place}: {flaw}")]
    BadScenario {
        /// The file.
        name: String,
        /// Where in the file.
        place: JsonPlace,
        /// What is wrong there.
        flaw: Box<Flaw>,
    },
}

/// What can be wrong with a value of a scenario: the cause, and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Flaw {
    /// A scenario of another program.
    #[error(
        "this scenario has version {found}, but this program reads 1 and {known}; reload the page or update the program"
    )]
    Version {
        /// Its version.
        found: String,
        /// The latest version that is read.
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
        /// The size that isn't kept.
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
    /// A character that stands for no cell.
    #[error("a cell can't be \"{found}\"; write # for wall, . for floor or ? for unknown")]
    Cell {
        /// The character, escaped where it can't be shown.
        found: String,
    },
    /// There is nowhere to drive.
    #[error("there is no free cell; write . for floor")]
    NoFreeCell,
    /// A number out of range, or an object that can't be there.
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

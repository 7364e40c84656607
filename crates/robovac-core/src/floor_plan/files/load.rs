//! Loads a floor plan from files. The format is detected from the content; names are used for messages and to find
//! images.

use super::{
    DEFAULT_IMAGE_RESOLUTION, FloorPlan, ForeignFile, MapError, PictureShades, Scenario, Shading, ascii, foreign,
    raster, stem,
    yaml::{self, MapYaml},
};
use crate::geometry::Pose;
use image::ImageFormat;

/// A file with its name and content.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourceFile {
    /// Its name; leading folders are ignored.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// Largest description of a ROS map, bytes; a longer text isn't one.
const MAX_YAML_BYTES: usize = 1 << 16;

/// The content of a file by its type.
enum FileContent {
    Image(ImageFormat),
    Yaml(MapYaml),
    /// A map that needs no other file.
    Plan(Box<FloorPlan>),
}

/// Reads a map: one text map, scenario or image, or a ROS map's YAML file with its image, in any order.
///
/// - Text map: see [`super::to_ascii`]; without a header a cell is [`super::DEFAULT_ASCII_RESOLUTION`].
/// - PNG, PGM (P2, P5; other Netpbm too), 8 or 16 bits, grey or colour, alpha laid on white. Dark is wall, light is floor,
///   grey between is unknown ([`Shading::default`]); a pixel is [`DEFAULT_IMAGE_RESOLUTION`] unless a YAML file says more.
/// - JPEG and WebP, likewise, with the feature `photos`.
/// - ROS `map_server` YAML with its modes, see [`super::OccupancyMode`].
/// - Scenario, see [`Scenario`]; its other content is read by [`Scenario::read`].
pub fn load(files: &[SourceFile]) -> Result<FloorPlan, MapError> {
    let (mut image, mut yaml, mut plan) = (None, None, None);
    for file in files {
        let previous = match recognise(file)? {
            FileContent::Image(format) => image.replace((file, format)).map(|(other, _)| other),
            FileContent::Yaml(content) => yaml.replace((file, content)).map(|(other, _)| other),
            FileContent::Plan(content) => plan.replace((file, content)).map(|(other, _)| other),
        };
        if let Some(other) = previous {
            return Err(two_maps(other, file));
        }
    }
    match (plan, yaml, image) {
        (None, None, None) => Err(MapError::NoFile),
        (Some((_, plan)), None, None) => Ok(*plan),
        (None, None, Some((file, format))) => bare_image(file, format, &Shading::default()),
        (None, Some((file, yaml)), image) => ros_map(file, &yaml, image),
        (Some((first, _)), Some((second, _)), _) | (Some((first, _)), None, Some((second, _))) => {
            Err(two_maps(first, second))
        }
    }
}

/// The image that a file requires, as named by its YAML (a path relative to the file); `None` if it requires none.
pub fn image_of(file: &SourceFile) -> Option<String> {
    if let Ok(FileContent::Yaml(yaml)) = recognise(file) { Some(yaml.image) } else { None }
}

/// Whether a file is an image that [`load`] accepts alone.
pub fn is_image(file: &SourceFile) -> bool {
    raster::format_of(&file.bytes).is_some()
}

/// Shades of an image, reduced to no more than [`super::MAX_SIDE`] on a side; transparency is laid on white.
pub fn load_shades(file: &SourceFile) -> Result<PictureShades, MapError> {
    let name = base_name(&file.name);
    let none = ForeignFile { kind: "no image", remedy: "choose an image" };
    let format = raster::format_of(&file.bytes).ok_or_else(|| not_a_map(name, none))?;
    raster::shades(name, &file.bytes, format)
}

fn recognise(file: &SourceFile) -> Result<FileContent, MapError> {
    let name = base_name(&file.name);
    let bytes = file.bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&file.bytes);
    if bytes.trim_ascii().is_empty() {
        return Err(MapError::Empty { name: name.to_owned() });
    }
    if let Some(format) = raster::format_of(bytes) {
        return Ok(FileContent::Image(format));
    }
    let unknown = |kind| not_a_map(name, ForeignFile { kind, remedy: "choose another file" });
    if bytes.trim_ascii_start().starts_with(b"{") {
        return Ok(FileContent::Plan(Box::new(Scenario::read(name, bytes)?.plan(name)?)));
    }
    if let Some(other) = foreign(bytes) {
        return Err(not_a_map(name, other));
    }
    let text = std::str::from_utf8(bytes).map_err(|_| unknown("a file of an unknown format"))?;
    if ascii::is_ascii(text) {
        return Ok(FileContent::Plan(Box::new(ascii::read(name, text)?.checked(name)?)));
    }
    if text.len() <= MAX_YAML_BYTES && yaml::is_yaml(text) {
        return Ok(FileContent::Yaml(MapYaml::read(name, text)?));
    }
    Err(unknown("text of an unknown format"))
}

fn not_a_map(name: &str, ForeignFile { kind, remedy }: ForeignFile) -> MapError {
    MapError::NotAMap { name: name.to_owned(), kind, remedy }
}

fn bare_image(file: &SourceFile, format: ImageFormat, shading: &Shading) -> Result<FloorPlan, MapError> {
    let name = base_name(&file.name);
    let plan = FloorPlan {
        name: stem(name),
        note: String::new(),
        resolution: DEFAULT_IMAGE_RESOLUTION,
        occupancy: raster::read(name, &file.bytes, format, shading)?,
        objects: Vec::new(),
        start: None,
        origin: Pose::new(0.0, 0.0, 0.0),
    };
    plan.checked(name)
}

fn ros_map(
    file: &SourceFile,
    yaml: &MapYaml,
    image: Option<(&SourceFile, ImageFormat)>,
) -> Result<FloorPlan, MapError> {
    let (name, wanted) = (base_name(&file.name), yaml.image_name().to_owned());
    let Some((image, format)) = image else {
        return Err(MapError::ImageMissing { name: name.to_owned(), image: wanted });
    };
    let given = base_name(&image.name);
    if given != wanted {
        return Err(MapError::WrongImage { name: name.to_owned(), wanted, given: given.to_owned() });
    }
    let plan = FloorPlan {
        name: stem(name),
        note: String::new(),
        resolution: yaml.resolution,
        occupancy: raster::read(given, &image.bytes, format, &yaml.shading)?,
        objects: Vec::new(),
        start: None,
        origin: yaml.origin,
    };
    plan.checked(given)
}

fn two_maps(first: &SourceFile, second: &SourceFile) -> MapError {
    MapError::TwoMaps { first: base_name(&first.name).to_owned(), second: base_name(&second.name).to_owned() }
}

/// A file's name without the folders in front of it.
pub fn base_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

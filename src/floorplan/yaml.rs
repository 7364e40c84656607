//! The YAML file of a ROS map: which image, how large, what its shades mean.

use super::{MapError, Mode, Shading, error::checked_resolution};
use crate::geometry::Pose;
use saphyr_parser::{Event, Parser};
use std::{collections::BTreeMap, ops::RangeInclusive};

/// Description of a ROS map (`map_server`). Files contain a handful of lines.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MapYaml {
    /// Path of the image, as written.
    pub image: String,
    /// Metres per pixel.
    pub resolution: f64,
    /// Pose of the lower-left pixel.
    pub origin: Pose,
    /// How shades turn into cells.
    pub shading: Shading,
}

/// Values under one key, and where they are.
struct Entry {
    line: usize,
    values: Vec<String>,
}

/// Whether a text is meant as the description of a ROS map.
pub(super) fn is_yaml(text: &str) -> bool {
    let keys = ["image", "resolution", "origin", "occupied_thresh", "free_thresh", "negate", "mode"];
    let key_of = |line: &str| line.split_once(':').map(|(key, _)| key.trim().trim_matches(['"', '\'']).to_owned());
    text.lines().filter_map(key_of).any(|key| keys.contains(&key.as_str()))
}

impl MapYaml {
    /// Reads the file `name`. Only image and resolution must be given; the rest has the map server's usual values.
    pub fn read(name: &str, text: &str) -> Result<Self, MapError> {
        let fields = Fields { name, entries: entries(name, text)? };
        let image = fields.word("image")?.ok_or_else(|| fields.missing("image", "map.pgm"))?;
        let (place, resolution) = fields.one("resolution")?.ok_or_else(|| fields.missing("resolution", "0.05"))?;
        let usual = Shading::default();
        let shading = Shading {
            mode: fields.mode()?,
            negate: fields.negate()?,
            occupied_thresh: fields.share("occupied_thresh")?.unwrap_or(usual.occupied_thresh),
            free_thresh: fields.share("free_thresh")?.unwrap_or(usual.free_thresh),
        };
        if shading.free_thresh > shading.occupied_thresh {
            let expected = format!("at most occupied_thresh, which is {}", shading.occupied_thresh);
            return Err(fields.bad("free_thresh", &shading.free_thresh.to_string(), expected));
        }
        Ok(Self {
            image: image.to_owned(),
            resolution: checked_resolution(name, &place, resolution)?,
            origin: fields.origin()?,
            shading,
        })
    }

    /// The image's name without folders.
    pub fn image_name(&self) -> &str {
        self.image.rsplit(['/', '\\']).next().unwrap_or(&self.image)
    }
}

/// Keys of a file with their values, read one by one.
struct Fields<'a> {
    name: &'a str,
    entries: BTreeMap<String, Entry>,
}

impl Fields<'_> {
    /// Place and value of a key that has one value.
    fn one(&self, key: &'static str) -> Result<Option<(String, &str)>, MapError> {
        match self.entries.get(key).map(|entry| (entry, entry.values.as_slice())) {
            None => Ok(None),
            Some((entry, [value])) => Ok(Some((format!("line {}", entry.line), value))),
            Some((_, values)) => Err(self.bad(key, &values.join(", "), "one value".to_owned())),
        }
    }

    fn word(&self, key: &'static str) -> Result<Option<&str>, MapError> {
        Ok(self.one(key)?.map(|(_, value)| value).filter(|value| !value.is_empty()))
    }

    fn mode(&self) -> Result<Mode, MapError> {
        match self.word("mode")? {
            None | Some("trinary") => Ok(Mode::Trinary),
            Some("scale") => Ok(Mode::Scale),
            Some("raw") => Ok(Mode::Raw),
            Some(other) => Err(self.bad("mode", other, "trinary, scale or raw".to_owned())),
        }
    }

    fn negate(&self) -> Result<bool, MapError> {
        match self.word("negate")? {
            None | Some("0" | "false" | "False") => Ok(false),
            Some("1" | "true" | "True") => Ok(true),
            Some(other) => Err(self.bad("negate", other, "0 or 1".to_owned())),
        }
    }

    fn share(&self, key: &'static str) -> Result<Option<f64>, MapError> {
        self.word(key)?.map(|value| self.number(key, value, 0.0..=1.0, "a number from 0 to 1")).transpose()
    }

    fn origin(&self) -> Result<Pose, MapError> {
        const EXPECTED: &str = "[x, y, yaw] in metres and radians";
        let Some(entry) = self.entries.get("origin") else { return Ok(Pose::new(0.0, 0.0, 0.0)) };
        let values = entry.values.as_slice();
        let [x, y, yaw] = values else { return Err(self.bad("origin", &values.join(", "), EXPECTED.to_owned())) };
        let number = |value: &str| self.number("origin", value, -1e9..=1e9, EXPECTED);
        Ok(Pose::new(number(x)?, number(y)?, number(yaw)?))
    }

    fn number(
        &self,
        key: &'static str,
        value: &str,
        range: RangeInclusive<f64>,
        expected: &str,
    ) -> Result<f64, MapError> {
        let number = value.parse().ok().filter(|number| range.contains(number));
        number.ok_or_else(|| self.bad(key, value, expected.to_owned()))
    }

    fn bad(&self, key: &'static str, value: &str, expected: String) -> MapError {
        let place = self.entries.get(key).map_or_else(|| "default".to_owned(), |entry| format!("line {}", entry.line));
        MapError::BadValue { name: self.name.to_owned(), place, key, value: value.to_owned(), expected }
    }

    fn missing(&self, key: &'static str, example: &'static str) -> MapError {
        MapError::MissingKey { name: self.name.to_owned(), key, example }
    }
}

/// The keys of the outermost mapping with their scalar values; lists are flattened.
///
/// Works on the parser's events: no tree is built, so neither deep nesting nor aliases can blow it up.
fn entries(name: &str, text: &str) -> Result<BTreeMap<String, Entry>, MapError> {
    let mut entries: BTreeMap<String, Entry> = BTreeMap::new();
    let mut depth = 0_usize;
    let mut key: Option<String> = None;
    for event in Parser::new_from_str(text) {
        let (event, span) = event.map_err(|error| MapError::Syntax {
            name: name.to_owned(),
            line: error.marker().line().max(1),
            column: error.marker().col() + 1,
            cause: error.info().to_owned(),
        })?;
        match event {
            Event::MappingStart(..) | Event::SequenceStart(..) => depth += 1,
            Event::MappingEnd | Event::SequenceEnd => depth = depth.saturating_sub(1),
            Event::DocumentEnd => break,
            Event::Scalar(value, ..) => {
                if let Some(key) = &key {
                    let entry = entries.entry(key.clone());
                    let entry = entry.or_insert(Entry { line: span.start.line(), values: Vec::new() });
                    entry.values.push(value.into_owned());
                } else {
                    key = (depth == 1).then(|| value.into_owned());
                    continue;
                }
            }
            _ => continue,
        }
        // Back in the outermost mapping after a value: the next scalar is a key.
        if depth <= 1 {
            key = None;
        }
    }
    Ok(entries)
}

//! The YAML file of a ROS map: image, resolution, thresholds.

use super::{MapError, OccupancyMode, Shading, error::checked_resolution};
use crate::geometry::Pose;
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
    /// How shades are converted to cells.
    pub shading: Shading,
}

/// The values of a key, and their place.
struct YamlEntry {
    line: usize,
    values: Vec<String>,
}

/// Whether a text looks like the description of a ROS map.
pub(super) fn is_yaml(text: &str) -> bool {
    let keys = ["image", "resolution", "origin", "occupied_thresh", "free_thresh", "negate", "mode"];
    let key_of = |line: &str| line.split_once(':').map(|(key, _)| key.trim().trim_matches(['"', '\'']).to_owned());
    text.lines().filter_map(key_of).any(|key| keys.contains(&key.as_str()))
}

impl MapYaml {
    /// Reads the file `name`. Only image and resolution must be given; the others default to the map server's usual
    /// values.
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
    entries: BTreeMap<String, YamlEntry>,
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

    fn mode(&self) -> Result<OccupancyMode, MapError> {
        match self.word("mode")? {
            None => Ok(OccupancyMode::default()),
            Some(word) => {
                OccupancyMode::named(word).ok_or_else(|| self.bad("mode", word, "trinary, scale or raw".to_owned()))
            }
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

/// The keys with their values, as `map_saver` and people write them: a line `key: value` each, where a value is a word,
/// quoted or not, a list in brackets, or a list of `- value` lines below; with comments.
///
/// A whole YAML parser would be a twelfth of the page's download, for a file of seven lines.
fn entries(name: &str, text: &str) -> Result<BTreeMap<String, YamlEntry>, MapError> {
    let mut entries: BTreeMap<String, YamlEntry> = BTreeMap::new();
    // The list in brackets that continues on the next line, and the key of the lines below.
    let mut open_list = String::new();
    let mut last_key: Option<String> = None;
    for (index, raw) in text.lines().enumerate() {
        let line = index + 1;
        let wrong = |cause: &str| MapError::Syntax {
            name: name.to_owned(),
            line,
            column: raw.len() - raw.trim_start().len() + 1,
            cause: cause.to_owned(),
        };
        let content = without_comment(raw);
        if content.trim().is_empty() || content.starts_with('%') || content.trim_end() == "---" {
            continue;
        }
        if content.trim_end() == "..." {
            break;
        }
        let item = content.trim().strip_prefix('-').filter(|rest| rest.is_empty() || rest.starts_with([' ', '\t']));
        let value = if !open_list.is_empty() {
            format!("{open_list} {}", content.trim())
        } else if let Some(item) = item {
            item.trim().to_owned()
        } else if content.starts_with([' ', '\t']) {
            return Err(wrong("a map description can't have indented lines outside a list"));
        } else {
            let (key, value) = content.split_once(':').ok_or_else(|| wrong("expected a line \"key: value\""))?;
            let key = unquoted(key.trim()).to_owned();
            if entries.insert(key.clone(), YamlEntry { line, values: Vec::new() }).is_some() {
                return Err(wrong("duplicate key"));
            }
            last_key = Some(key);
            value.trim().to_owned()
        };
        if value.starts_with('[') && !value.ends_with(']') {
            open_list = value;
            continue;
        }
        open_list.clear();
        let entry = last_key.as_ref().and_then(|key| entries.get_mut(key));
        let entry = entry.ok_or_else(|| wrong("expected a line \"key: value\" before this list"))?;
        match value.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            Some(list) => entry.values.extend(list.split(',').map(|item| unquoted(item.trim()).to_owned())),
            // The value is a list that follows.
            None if value.is_empty() => {}
            None => entry.values.push(unquoted(&value).to_owned()),
        }
    }
    if open_list.is_empty() {
        return Ok(entries);
    }
    let line = last_key.and_then(|key| entries.get(&key).map(|entry| entry.line)).unwrap_or(1);
    let cause = "the list isn't closed; add a \"]\"".to_owned();
    Err(MapError::Syntax { name: name.to_owned(), line, column: 1, cause })
}

/// The line up to a `#` that begins a comment: outside quotes, at the beginning or after a blank.
fn without_comment(line: &str) -> &str {
    let mut quote = None;
    let mut before = ' ';
    for (at, c) in line.char_indices() {
        match quote {
            Some(open) if c == open => quote = None,
            None if c == '#' && before.is_ascii_whitespace() => return &line[..at],
            None if (c == '"' || c == '\'') && !before.is_ascii_alphanumeric() => quote = Some(c),
            _ => {}
        }
        before = c;
    }
    line
}

/// The text between a pair of quotes, or the text itself.
fn unquoted(text: &str) -> &str {
    let inner = |quote| text.strip_prefix(quote).and_then(|rest| rest.strip_suffix(quote));
    inner('"').or_else(|| inner('\'')).unwrap_or(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str, key: &str) -> Vec<String> {
        entries("map.yaml", text).unwrap().remove(key).map(|entry| entry.values).unwrap_or_default()
    }

    #[test]
    fn lists_come_in_brackets_over_lines_or_as_items() {
        for text in ["origin: [-1, 2.5, 0]", "origin: [-1,\n  2.5, # y\n  0]", "origin:\n- -1\n- 2.5\n- 0\nnegate: 0"] {
            assert_eq!(values(text, "origin"), ["-1", "2.5", "0"], "{text}");
        }
    }

    #[test]
    fn quotes_protect_what_looks_like_a_comment() {
        let text = "%YAML 1.2\n---\n\"image\": 'my #1 map.pgm' # the picture\nmode: raw#x\n...\nresolution: 5";
        assert_eq!((values(text, "image"), values(text, "mode")), (vec!["my #1 map.pgm".into()], vec!["raw#x".into()]));
        assert!(values(text, "resolution").is_empty());
    }

    #[test]
    fn what_is_no_map_description_is_named_with_its_line() {
        for (text, line, cause) in [
            ("image: a\nnonsense", 2, "expected a line"),
            ("image: a\n\n  x: 1", 3, "indented"),
            ("- 1", 1, "before this list"),
            ("image: a\norigin: [1, 2", 2, "isn't closed"),
            ("image: a\nimage: b", 2, "duplicate key"),
        ] {
            let error = entries("map.yaml", text).err().unwrap();
            let MapError::Syntax { line: at, cause: why, .. } = &error else { panic!("{error}") };
            assert!(*at == line && why.contains(cause), "{text}: {error}");
        }
    }
}

//! Position of a value in a scenario's JSON.

use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// A place in a JSON file, for messages.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JsonPlace {
    /// The value, e.g. `objects[3].leg.radius`; empty for the file itself.
    pub path: String,
    /// Line and column, counted from 1, if the value is in the file.
    pub at: Option<(usize, usize)>,
}

impl JsonPlace {
    /// The place of the value with that path; for a missing value, that of the one that should contain it.
    pub fn of(path: &str, bytes: &[u8]) -> Self {
        let steps: Vec<&str> =
            path.split(['.', '[']).map(|step| step.trim_end_matches(']')).filter(|step| !step.is_empty()).collect();
        let at = (0..=steps.len()).rev().find_map(|count| {
            // The place is returned as an error, as only errors know their place.
            let error = Seek(&steps[..count]).deserialize(&mut serde_json::Deserializer::from_slice(bytes)).err()?;
            Some((error.line(), error.column()))
        });
        Self { path: path.to_owned(), at }
    }
}

impl fmt::Display for JsonPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((line, column)) = self.at {
            write!(f, "line {line}, column {column}{}", if self.path.is_empty() { "" } else { ", " })?;
        }
        f.write_str(&self.path)
    }
}

/// Follows the steps, each a key or an index, and fails at their end.
struct Seek<'a>(&'a [&'a str]);

impl Seek<'_> {
    fn found<T, E: Error>() -> Result<T, E> {
        Err(E::custom("here"))
    }

    fn value<E: Error>(&self) -> Result<(), E> {
        if self.0.is_empty() { Self::found() } else { Ok(()) }
    }
}

impl<'de> DeserializeSeed<'de> for Seek<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Seek<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        let Some((&step, rest)) = self.0.split_first() else { return Self::found() };
        while let Some(key) = map.next_key::<String>()? {
            if key == step {
                map.next_value_seed(Seek(rest))?;
            } else {
                map.next_value::<IgnoredAny>()?;
            }
        }
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        let Some((&step, rest)) = self.0.split_first() else { return Self::found() };
        for _ in 0..step.parse().unwrap_or(0_usize) {
            if list.next_element::<IgnoredAny>()?.is_none() {
                return Ok(());
            }
        }
        list.next_element_seed(Seek(rest))?;
        while list.next_element::<IgnoredAny>()?.is_some() {}
        Ok(())
    }

    fn visit_bool<E: Error>(self, _: bool) -> Result<(), E> {
        self.value()
    }

    fn visit_i64<E: Error>(self, _: i64) -> Result<(), E> {
        self.value()
    }

    fn visit_u64<E: Error>(self, _: u64) -> Result<(), E> {
        self.value()
    }

    fn visit_f64<E: Error>(self, _: f64) -> Result<(), E> {
        self.value()
    }

    fn visit_str<E: Error>(self, _: &str) -> Result<(), E> {
        self.value()
    }

    fn visit_unit<E: Error>(self) -> Result<(), E> {
        self.value()
    }
}

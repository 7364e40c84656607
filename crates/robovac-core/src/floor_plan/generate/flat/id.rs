//! A generated flat's name: `7`, or `7~area:40..60~furniture:0.5~rugs:no`.

use super::{FlatSpec, FlatSpecError, generate_flat};
use crate::floor_plan::FloorPlan;
use std::{fmt, str::FromStr};

/// A flat by its seed and by what it has in common with others; its text names it in links, files and commands.
///
/// ```
/// use robovac_core::floor_plan::generate::FlatId;
/// let id: FlatId = "7~area:40..60".parse()?;
/// assert_eq!((id.seed, id.spec.area_m2), (7, [40.0, 60.0]));
/// assert_eq!(id.to_string(), "7~area:40..60");
/// assert_eq!(id.build().name, "Flat 7");
/// # Ok::<(), robovac_core::floor_plan::generate::FlatIdError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FlatId {
    /// The seed.
    pub seed: u64,
    /// What the flat is like.
    pub spec: FlatSpec,
}

/// Reasons why a text names no flat.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FlatIdError {
    /// It isn't of that form.
    #[error("\"{0}\" names no flat; give its seed, as in 7, or more, as in 7~area:40..60~furniture:0.5~rugs:no")]
    Text(String),
    /// There are no such flats.
    #[error(transparent)]
    Spec(#[from] FlatSpecError),
}

/// How the note of a generated flat begins.
const NOTE: &str = "Generated flat ";

impl FlatId {
    /// The note of the flat, which ends with `about`.
    pub(super) fn note(&self, about: &str) -> String {
        format!("{NOTE}{self}: {about}")
    }

    /// The name in the note of a flat, and what the note says about it; `None` for other notes.
    pub fn in_note(note: &str) -> Option<(&str, &str)> {
        note.strip_prefix(NOTE)?.split_once(": ")
    }

    /// The flat.
    pub fn build(&self) -> FloorPlan {
        generate_flat(self.seed, &self.spec)
    }
}

impl fmt::Display for FlatId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { seed, spec: FlatSpec { area_m2: [low, high], furniture, rugs } } = self;
        let usual = FlatSpec::default();
        write!(f, "{seed}")?;
        if [*low, *high] != usual.area_m2 {
            write!(f, "~area:{low}..{high}")?;
        }
        if *furniture != usual.furniture {
            write!(f, "~furniture:{furniture}")?;
        }
        if *rugs != usual.rugs {
            write!(f, "~rugs:{}", if *rugs { "yes" } else { "no" })?;
        }
        Ok(())
    }
}

impl FromStr for FlatId {
    type Err = FlatIdError;

    fn from_str(text: &str) -> Result<Self, FlatIdError> {
        let wrong = || FlatIdError::Text(text.to_owned());
        let mut parts = text.split('~');
        let seed = parts.next().and_then(|seed| seed.parse().ok()).ok_or_else(wrong)?;
        let mut spec = FlatSpec::default();
        for part in parts {
            let (key, value) = part.split_once(':').ok_or_else(wrong)?;
            match (key, value) {
                ("area", area) => {
                    let (low, high) = area.split_once("..").unwrap_or((area, area));
                    let number = |text: &str| text.parse().map_err(|_| wrong());
                    spec.area_m2 = [number(low)?, number(high)?];
                }
                ("furniture", share) => spec.furniture = share.parse().map_err(|_| wrong())?,
                ("rugs", "yes") => spec.rugs = true,
                ("rugs", "no") => spec.rugs = false,
                _ => return Err(wrong()),
            }
        }
        spec.check()?;
        Ok(Self { seed, spec })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_brings_back_the_flat() {
        for text in ["0", "18446744073709551615", "7~area:40..60", "7~area:25.5..120~furniture:0.5~rugs:no"] {
            assert_eq!(text.parse::<FlatId>().unwrap().to_string(), text);
        }
        assert_eq!("7~area:60".parse::<FlatId>().unwrap().spec.area_m2, [60.0, 60.0]);
    }

    #[test]
    fn notes_name_the_flat() {
        let id: FlatId = "7~area:40..60".parse().unwrap();
        let note = id.build().note;
        let (name, about) = FlatId::in_note(&note).unwrap();
        assert_eq!((name.parse(), id.note(about)), (Ok(id), note.clone()));
        assert!(about.contains(" rooms."), "{about}");
        for other in ["", "Generated flat", "Generated flat 7.", "A flat: 7"] {
            assert_eq!(FlatId::in_note(other), None, "{other}");
        }
    }

    #[test]
    fn other_texts_are_refused() {
        for text in ["", "-1", "seven", "7~", "7~area", "7~area:x..9", "7~rugs:maybe", "7~colour:red", "7.5"] {
            assert!(text.parse::<FlatId>().unwrap_err().to_string().contains("names no flat"), "{text}");
        }
        assert!("7~area:10..20".parse::<FlatId>().unwrap_err().to_string().contains("from 25 to 120"));
        assert!("7~furniture:2".parse::<FlatId>().unwrap_err().to_string().contains("from 0 (empty)"));
    }
}

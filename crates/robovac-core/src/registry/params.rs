//! Parameters of planners and controllers: one specification to check, display and save them.

use serde::{Deserialize, Serialize};
use std::{collections::BTreeMap, fmt};

/// One parameter.
#[derive(Debug)]
pub struct ParamSpec {
    /// Name in links and on the command line.
    pub id: &'static str,
    /// Name in forms.
    pub label: &'static str,
    /// One sentence on its effect.
    pub help: &'static str,
    /// Kind, range and default.
    pub kind: ParamKind,
}

/// Kind, range and default of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ParamKind {
    /// A number from `min` to `max`.
    Number {
        /// Smallest value.
        min: f64,
        /// Largest value.
        max: f64,
        /// Step of the value in forms; if it is 1, only whole numbers are valid.
        step: f64,
        /// Default value.
        default: f64,
        /// Unit shown behind the value; can be empty.
        unit: &'static str,
    },
    /// One of several words.
    Choice {
        /// Words with their labels; the first is the default.
        options: &'static [(&'static str, &'static str)],
    },
    /// Yes or no.
    Flag {
        /// Default value.
        default: bool,
    },
}

/// Value of a parameter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(untagged)]
pub enum ParamValue {
    /// Value of a flag.
    Flag(bool),
    /// Value of a number.
    Number(f64),
    /// Value of a choice.
    Choice(String),
}

impl fmt::Display for ParamValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flag(flag) => flag.fmt(f),
            Self::Number(number) => number.fmt(f),
            Self::Choice(word) => word.fmt(f),
        }
    }
}

/// Errors of parameters.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ParamError {
    /// There is no such parameter.
    #[error("there is no parameter \"{id}\"; there {known}")]
    Unknown {
        /// The name given.
        id: String,
        /// The names that exist, as the end of a sentence.
        known: String,
    },
    /// The value is not of the parameter's kind or range.
    #[error("parameter \"{id}\" can't be \"{value}\"; use {expected}")]
    Invalid {
        /// Name of the parameter.
        id: &'static str,
        /// The value given.
        value: String,
        /// Accepted values.
        expected: String,
    },
}

/// Values for all parameters of one planner or controller; complete and within range.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(transparent)]
pub struct Params(BTreeMap<&'static str, ParamValue>);

impl Params {
    /// The defaults.
    pub fn defaults(specs: &[ParamSpec]) -> Self {
        // One by one: to collect them needs a sort, whose code the page would carry for each kind of map.
        let mut values = BTreeMap::new();
        values.extend(specs.iter().map(|spec| (spec.id, spec.kind.default())));
        Self(values)
    }

    /// The defaults with `given` values on top, each checked.
    pub fn checked<'a>(
        specs: &[ParamSpec],
        given: impl IntoIterator<Item = (&'a str, ParamValue)>,
    ) -> Result<Self, ParamError> {
        let mut params = Self::defaults(specs);
        for (id, value) in given {
            params.set(specs, id, value)?;
        }
        Ok(params)
    }

    /// Sets one value after checking it against its description in `specs`.
    pub fn set(&mut self, specs: &[ParamSpec], id: &str, value: ParamValue) -> Result<(), ParamError> {
        let spec = specs.iter().find(|s| s.id == id).ok_or_else(|| ParamError::Unknown {
            id: id.to_owned(),
            known: match specs.iter().map(|s| s.id).collect::<Vec<_>>().join(", ") {
                names if names.is_empty() => "are none here".to_owned(),
                names => format!("are: {names}"),
            },
        })?;
        if !spec.kind.accepts(&value) {
            let expected = spec.kind.to_string();
            return Err(ParamError::Invalid { id: spec.id, value: value.to_string(), expected });
        }
        self.0.insert(spec.id, value);
        Ok(())
    }

    /// Sets one value from the text of a form, a link or a command line.
    pub fn set_text(&mut self, specs: &[ParamSpec], id: &str, text: &str) -> Result<(), ParamError> {
        let parsed = specs.iter().find(|s| s.id == id).map(|s| s.kind.parse(text));
        self.set(specs, id, parsed.unwrap_or_else(|| ParamValue::Choice(text.to_owned())))
    }

    /// All values by name.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &ParamValue)> {
        self.0.iter().map(|(&id, value)| (id, value))
    }

    /// One value.
    pub fn get(&self, id: &str) -> Option<&ParamValue> {
        self.0.get(id)
    }

    /// Value of the number `id`; 0 if the planner's list has no such number, which its tests would detect.
    pub fn number(&self, id: &str) -> f64 {
        if let Some(ParamValue::Number(number)) = self.0.get(id) { *number } else { 0.0 }
    }

    /// Value of the choice `id`.
    pub fn choice(&self, id: &str) -> &str {
        if let Some(ParamValue::Choice(word)) = self.0.get(id) { word } else { "" }
    }

    /// Value of the flag `id`.
    pub fn flag(&self, id: &str) -> bool {
        matches!(self.0.get(id), Some(ParamValue::Flag(true)))
    }
}

impl ParamKind {
    /// Default value.
    pub fn default(&self) -> ParamValue {
        match self {
            Self::Number { default, .. } => ParamValue::Number(*default),
            Self::Choice { options } => ParamValue::Choice(options.first().map_or("", |o| o.0).to_owned()),
            Self::Flag { default } => ParamValue::Flag(*default),
        }
    }

    /// The value of `text`, as on a command line or in a link; other texts are choices.
    pub fn parse(&self, text: &str) -> ParamValue {
        match self {
            Self::Number { .. } => text.parse().map(ParamValue::Number).ok(),
            Self::Flag { .. } => text.parse().map(ParamValue::Flag).ok(),
            Self::Choice { .. } => None,
        }
        .unwrap_or_else(|| ParamValue::Choice(text.to_owned()))
    }

    fn accepts(&self, value: &ParamValue) -> bool {
        match (self, value) {
            (Self::Number { min, max, step, .. }, ParamValue::Number(number)) => {
                (min..=max).contains(&number) && (*step != 1.0 || number.fract() == 0.0)
            }
            (Self::Choice { options }, ParamValue::Choice(word)) => options.iter().any(|o| o.0 == word),
            (Self::Flag { .. }, ParamValue::Flag(_)) => true,
            _ => false,
        }
    }
}

impl fmt::Display for ParamKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number { min, max, step, .. } if *step == 1.0 => write!(f, "a whole number from {min} to {max}"),
            Self::Number { min, max, .. } => write!(f, "a number from {min} to {max}"),
            Self::Choice { options } => {
                write!(f, "one of: {}", options.iter().map(|o| o.0).collect::<Vec<_>>().join(", "))
            }
            Self::Flag { .. } => write!(f, "true or false"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPECS: &[ParamSpec] = &[
        ParamSpec {
            id: "rate",
            label: "Rate",
            help: "",
            kind: ParamKind::Number { min: 0.0, max: 1.0, step: 0.1, default: 0.5, unit: "" },
        },
        ParamSpec {
            id: "order",
            label: "Order",
            help: "",
            kind: ParamKind::Choice { options: &[("near", ""), ("far", "")] },
        },
    ];

    #[test]
    fn values_are_checked_and_defaults_filled_in() {
        let params = Params::checked(SPECS, [("order", SPECS[1].kind.parse("far"))]).unwrap();
        assert_eq!((params.number("rate"), params.choice("order")), (0.5, "far"));
    }

    #[test]
    fn errors_say_what_would_do() {
        let too_high = Params::checked(SPECS, [("rate", SPECS[0].kind.parse("2"))]).unwrap_err();
        assert_eq!(too_high.to_string(), "parameter \"rate\" can't be \"2\"; use a number from 0 to 1");
        let unknown = Params::checked(SPECS, [("size", ParamValue::Number(1.0))]).unwrap_err();
        assert_eq!(unknown.to_string(), "there is no parameter \"size\"; there are: rate, order");
        assert!(Params::checked(SPECS, [("rate", SPECS[0].kind.parse("NaN"))]).is_err());
    }
}

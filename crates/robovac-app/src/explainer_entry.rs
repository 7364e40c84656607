//! The explanation of an algorithm as shown in its panel.

use robovac_core::registry::Example;
use robovac_sim::experiment::Algorithm;
use serde::Serialize;
use std::collections::BTreeMap;

/// An explanation. The page loads them from `www/explainers.json`, and the opening scene's from a file of its own.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct ExplainerEntry {
    idea: &'static str,
    complexity: &'static str,
    use_when: &'static str,
    shines: ExampleEntry,
    fails: ExampleEntry,
    source: &'static str,
    link: &'static str,
}

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
struct ExampleEntry {
    room: &'static str,
    why: &'static str,
}

impl ExplainerEntry {
    /// The explanations of all algorithms, by id.
    pub fn all() -> BTreeMap<&'static str, Self> {
        Algorithm::all().filter_map(|algorithm| Some((algorithm.id(), Self::of(algorithm)?))).collect()
    }

    fn of(algorithm: Algorithm) -> Option<Self> {
        let explainer = algorithm.explainer()?;
        Some(Self {
            idea: explainer.idea,
            complexity: explainer.complexity,
            use_when: explainer.use_when,
            shines: ExampleEntry::new(&explainer.shines),
            fails: ExampleEntry::new(&explainer.fails),
            source: explainer.source,
            link: explainer.link,
        })
    }
}

impl ExampleEntry {
    fn new(example: &Example) -> Self {
        Self { room: example.room, why: example.why }
    }
}

//! The explanations of the algorithms: the opening scene's, which the page loads at once, and all of them.

use coverage_planners::PLANNERS;
use robovac_app::ExplainerEntry;
use std::{collections::BTreeMap, env, fs};

#[test]
fn explainers_of_the_page_are_those_of_the_registries() {
    let all = ExplainerEntry::all();
    let opening: BTreeMap<_, _> = all.iter().filter(|(id, _)| **id == PLANNERS[0].id).collect();
    let texts = [serde_json::to_string_pretty(&opening).unwrap(), serde_json::to_string_pretty(&all).unwrap()];
    for (name, text) in ["explainers-opening.json", "explainers.json"].into_iter().zip(texts) {
        let (path, new) = (format!("{}/www/{name}", env!("CARGO_MANIFEST_DIR")), text + "\n");
        if env::var_os("UPDATE").is_some() {
            fs::write(path, new).unwrap();
            continue;
        }
        let old = fs::read_to_string(path).unwrap_or_default();
        assert!(new == old, "www/{name} is out of date: run `UPDATE=1 cargo test --test page explainers`");
    }
}

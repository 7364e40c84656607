//! The explanations of the algorithms, which the page loads after its first picture.

use robovac_app::ExplainerEntry;
use std::{env, fs};

#[test]
fn explainers_of_the_page_are_those_of_the_registries() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/www/explainers.json");
    let new = serde_json::to_string_pretty(&ExplainerEntry::all()).unwrap() + "\n";
    if env::var_os("UPDATE").is_some() {
        fs::write(path, new).unwrap();
        return;
    }
    let old = fs::read_to_string(path).unwrap_or_default();
    assert!(new == old, "www/explainers.json is out of date: run `UPDATE=1 cargo test --test page explainers`");
}

//! One name means one thing: no two types share a name, whichever crate they are in.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

/// Names that stand more than once and mean the same each time.
const SAME_MEANING: [(&str, &str); 8] = [
    ("Arguments", "of one subcommand, in its file"),
    ("Comparison", "of the library, and its class in JavaScript"),
    ("ConditionsArguments", "of the command line and of Python"),
    ("Connection", "of the library, and its class in JavaScript"),
    ("Failure", "of a command, and of a call from Python"),
    ("MapSession", "of the library, and its class in JavaScript"),
    ("Replay", "of the library, and its class in JavaScript"),
    ("Twin", "of the library, and its class in JavaScript"),
];

/// All files of Rust below `folder` but those that hold tests alone.
fn sources(folder: &Path, into: &mut Vec<PathBuf>) {
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.is_dir() && name != "tests" {
            sources(&path, into);
        } else if path.extension().is_some_and(|ending| ending == "rs") && name != "tests.rs" {
            into.push(path);
        }
    }
}

/// The name of the type that a line defines. Type aliases count: readers take them for types.
fn defined(line: &str) -> Option<&str> {
    let mut rest = line;
    if let Some(after) = rest.strip_prefix("pub") {
        rest = after.trim_start();
        if rest.starts_with('(') {
            rest = rest.split_once(") ")?.1;
        }
    }
    let (keyword, rest) = rest.split_once(' ')?;
    let name = rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()?;
    ["struct", "enum", "trait", "type"].contains(&keyword).then_some(name)
}

#[test]
fn no_two_types_share_a_name() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    sources(&root.join("src"), &mut files);
    for path in fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path().join("src")) {
        if path.exists() {
            sources(&path, &mut files);
        }
    }
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for path in &files {
        let text = fs::read_to_string(path).unwrap();
        for name in text.lines().filter_map(defined) {
            let place = path.strip_prefix(&root).unwrap().display().to_string();
            places.entry(name.to_owned()).or_default().push(place);
        }
    }
    assert!(places.len() > 1000, "only {} types found: has the layout of the repository changed?", places.len());
    let shared: Vec<_> = places
        .iter()
        .filter(|(name, places)| places.len() > 1 && !SAME_MEANING.iter().any(|(same, _)| same == name))
        .collect();
    assert!(shared.is_empty(), "give each meaning its own name: {shared:#?}");
    for (name, why) in SAME_MEANING {
        assert!(
            places.get(name).is_some_and(|places| places.len() > 1),
            "{name} ({why}) stands once: not a special case"
        );
    }
}

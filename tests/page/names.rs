//! One name means one thing: no two types share a name, whichever crate they are in, and none stands in a sentence.

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

/// What can follow the name of a type in code.
const KEYWORDS: [&str; 6] = ["as", "else", "for", "if", "in", "where"];

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

/// All files of [`sources`] with their text.
fn texts() -> Vec<(String, String)> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    sources(&root.join("src"), &mut files);
    for path in fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path().join("src")) {
        if path.exists() {
            sources(&path, &mut files);
        }
    }
    let text = |path: &PathBuf| fs::read_to_string(path).unwrap();
    files.iter().map(|path| (path.strip_prefix(&root).unwrap().display().to_string(), text(path))).collect()
}

/// The names of all types, and the files that define them.
fn types(texts: &[(String, String)]) -> BTreeMap<&str, Vec<&str>> {
    let mut places: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (place, text) in texts {
        for name in text.lines().filter_map(defined) {
            places.entry(name).or_default().push(place);
        }
    }
    assert!(places.len() > 1000, "only {} types found: has the layout of the repository changed?", places.len());
    places
}

#[test]
fn no_two_types_share_a_name() {
    let texts = texts();
    let places = types(&texts);
    let shared: Vec<_> = places
        .iter()
        .filter(|(name, places)| places.len() > 1 && !SAME_MEANING.iter().any(|(same, _)| same == *name))
        .collect();
    assert!(shared.is_empty(), "give each meaning its own name: {shared:#?}");
    for (name, why) in SAME_MEANING {
        assert!(
            places.get(name).is_some_and(|places| places.len() > 1),
            "{name} ({why}) stands once: not a special case"
        );
    }
}

/// Whether a name is of several words, as no word of a sentence is.
fn is_compound(name: &str) -> bool {
    name.split(char::is_uppercase).filter(|part| !part.is_empty()).count() > 1
}

/// The types in a line that a word follows, as in a sentence; keywords follow them in code.
fn in_sentence<'a>(line: &'a str, types: &BTreeMap<&str, Vec<&str>>) -> Vec<&'a str> {
    let code = if line.trim_start().starts_with("//") { "" } else { line.split(" // ").next().unwrap_or_default() };
    let words: Vec<&str> = code.split(' ').collect();
    let is_word = |word: &str| word.starts_with(|c: char| c.is_ascii_lowercase()) && !KEYWORDS.contains(&word);
    let pairs = words.windows(2).filter(|pair| is_word(pair[1]));
    let names = pairs.map(|pair| pair[0].trim_start_matches('"'));
    names.filter(|name| is_compound(name) && types.contains_key(name)).collect()
}

/// Renaming the type `Drive` once put `ComparedDrive` into a sentence on the page.
#[test]
fn no_type_was_renamed_in_a_sentence() {
    let damaged = "    let why = \"No wall was met. ComparedDrive straight at one.\";";
    assert_eq!(in_sentence(damaged, &BTreeMap::from([("ComparedDrive", Vec::new())])), ["ComparedDrive"]);
    let texts = texts();
    let types = types(&texts);
    for (place, text) in &texts {
        for line in text.lines() {
            assert!(in_sentence(line, &types).is_empty(), "{place}: a type in a sentence: {}", line.trim());
        }
    }
}

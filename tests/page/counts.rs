//! Numbers and lists that texts repeat are those of the code.

use robovac_app::compare::MOST_LANES;
use robovac_core::{floor_plan::TAKEN, robot::OdometryModel};
use std::{fs, path::Path};

const WORDS: [&str; 16] = [
    "no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve",
    "thirteen", "fourteen", "fifteen",
];

/// A file's text with single spaces.
fn text(file: &str) -> String {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Every text has its words around the number, and no other number between them.
fn assert_said(number: usize, texts: &[(&str, &str)]) {
    for (file, words) in texts {
        let text = text(file).to_lowercase();
        let said: Vec<usize> =
            (0..WORDS.len()).filter(|&n| text.contains(&words.replace("{}", WORDS[n]).to_lowercase())).collect();
        assert_eq!(said, [number], "{file}: {words}");
    }
}

#[test]
fn texts_know_how_many_lessons_there_are() {
    let list: Vec<serde_json::Value> = serde_json::from_str(&text("lessons/index.json")).unwrap();
    assert_said(
        list.len(),
        &[
            ("README.md", "**Learn**: {} lessons"),
            ("docs/index.md", "the {} lessons"),
            ("docs/teaching.md", "*Learn*: {} lessons"),
            ("www/help.html", "has {} lessons"),
            ("www/learn/list.js", "\"{} lessons"),
            ("www/learn/tour.js", "\"{} lessons"),
        ],
    );
}

#[test]
fn texts_know_how_many_robots_race() {
    assert_said(
        MOST_LANES,
        &[
            ("docs/compare.md", "up to {} robots"),
            ("docs/compare.md", "more than {};"),
            ("www/help.html", "up to {} planners"),
            ("www/compare/race.js", "at most {} robots"),
            ("crates/robovac-app/src/compare/view.rs", "{} race at most"),
        ],
    );
}

#[test]
fn the_page_offers_every_odometry_model() {
    let script = text("www/odometry.js");
    let offered: Vec<&str> = script.split("[\"").skip(1).filter_map(|entry| entry.split('"').next()).collect();
    assert_eq!(offered, OdometryModel::ALL.map(|(_, id)| id));
}

#[test]
fn the_page_accepts_the_same_formats() {
    assert!(text("www/shared/pictures.js").contains(&format!("TAKEN = \"{TAKEN}.\";")));
}

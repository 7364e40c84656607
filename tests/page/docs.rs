//! The documentation: links and paths lead somewhere, and the front page stays short.

use std::{
    fs,
    path::{Path, PathBuf},
};

/// Most bytes of the README.
const README: usize = 10 * 1024;
/// Folders whose files are named in code spans.
const FOLDERS: [&str; 7] = ["crates/", "src/", "www/", "tests/", "docs/", "scripts/", "examples/"];

/// The root of the repository, and its pages with their text.
fn pages() -> (PathBuf, Vec<(PathBuf, String)>) {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let docs = fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let top = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|name| root.join(name));
    let all = docs.chain(top).filter(|path| path.extension().is_some_and(|ending| ending == "md"));
    let read = all.map(|path| (path.clone(), fs::read_to_string(path).unwrap())).collect();
    (root, read)
}

/// The id that a heading gets on the web.
fn anchor(heading: &str) -> String {
    let kept = heading.trim_start_matches('#').trim().to_lowercase().replace(' ', "-");
    kept.chars().filter(|c| c.is_alphanumeric() || "-_".contains(*c)).collect()
}

/// Whether a link on the page `from` leads to a file and, behind `#`, to one of its headings.
fn leads_somewhere(from: &Path, link: &str) -> bool {
    let (file, heading) = link.split_once('#').unwrap_or((link, ""));
    let target = if file.is_empty() { from.to_owned() } else { from.with_file_name("").join(file) };
    let has = |text: String| text.lines().any(|line| line.starts_with('#') && anchor(line) == heading);
    target.exists() && (heading.is_empty() || fs::read_to_string(target).is_ok_and(has))
}

/// Those of the how-tos' own files, which are called `yours`, excepted.
#[test]
fn links_lead_somewhere() {
    for (path, text) in pages().1 {
        let links = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        for link in links.filter(|link| !link.contains("://") && !link.contains("yours")) {
            assert!(leads_somewhere(&path, link), "{}: {link}", path.display());
        }
    }
}

/// In the how-tos, a file to be written is called `yours`.
#[test]
fn files_that_are_named_exist() {
    let (root, pages) = pages();
    for (path, text) in pages {
        let spans = text.lines().flat_map(|line| line.split('`').skip(1).step_by(2));
        for name in
            spans.filter(|span| FOLDERS.iter().any(|folder| span.starts_with(folder)) && !span.contains("yours"))
        {
            assert!(root.join(name).exists(), "{}: {name}", path.display());
        }
    }
}

#[test]
fn terms_of_the_glossary_are_in_alphabetical_order() {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/glossary.md")).unwrap();
    let terms = text.lines().filter_map(|line| line.strip_prefix("- **")?.split("**").next());
    let terms: Vec<String> = terms.map(str::to_lowercase).collect();
    assert!(terms.len() > 100);
    for pair in terms.windows(2) {
        assert!(pair[0] < pair[1], "{} stands before {}", pair[0], pair[1]);
    }
}

#[test]
fn the_front_page_is_short() {
    assert!(fs::metadata(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md")).unwrap().len() <= README as u64);
}

/// The text of all Rust files below a folder.
fn sources(folder: &Path) -> String {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let texts = entries.filter(|path| !path.ends_with("target")).map(|path| match path.extension() {
        _ if path.is_dir() => sources(&path),
        Some(ending) if ending == "rs" => fs::read_to_string(&path).unwrap(),
        _ => String::new(),
    });
    texts.collect()
}

/// In docs/papers.md the last column names tests, by file or by name.
#[test]
fn tests_that_hold_us_to_the_papers_exist() {
    let (root, pages) = pages();
    let all = ["crates", "tests"].map(|folder| sources(&root.join(folder))).concat();
    let (_, text) = pages.iter().find(|(path, _)| path.ends_with("docs/papers.md")).unwrap();
    let rows = text.lines().filter_map(|line| line.strip_prefix('|')?.strip_suffix('|')?.rsplit_once('|'));
    let names = rows.flat_map(|(_, held_by)| held_by.split('`').skip(1).step_by(2));
    let names: Vec<&str> = names.filter(|name| !name.contains(['/', ':', ' '])).collect();
    assert!(names.len() > 10, "{names:?}");
    for name in names {
        assert!(all.contains(&format!("fn {name}(")), "there is no test {name}");
    }
}

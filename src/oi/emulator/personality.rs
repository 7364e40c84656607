//! What real robots do that the specification doesn't say.

/// A way in which a robot, or the line to it, differs from the specification.
#[derive(Debug, Clone, PartialEq)]
pub struct Personality {
    /// Name in links, menus and on the command line.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence: what it does, and how one meets it.
    pub summary: &'static str,
}

/// All personalities; the first is a robot as it should be.
pub const PERSONALITIES: &[Personality] =
    &[Personality { id: "model", title: "By the book", summary: "A Create 2 that does what the specification says." }];

/// The personality with that id.
pub fn personality(id: &str) -> Option<&'static Personality> {
    PERSONALITIES.iter().find(|p| p.id == id)
}

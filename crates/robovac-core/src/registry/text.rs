//! Text rules that can be checked at compile time.

/// Whether two texts are equal.
pub const fn is_same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut index = 0;
    while index < a.len() && index < b.len() && a[index] == b[index] {
        index += 1;
    }
    index == a.len() && index == b.len()
}

/// The name that was probably meant by `id`, of a list separated by commas: the one with fewest changes of letters, if they
/// are less than half of them.
pub fn nearest<'a>(id: &str, known: &'a str) -> Option<&'a str> {
    let nearest = known.split(", ").min_by_key(|name| changes(id, name))?;
    (2 * changes(id, nearest) < id.len()).then_some(nearest)
}

/// Letters to be put in, left out or replaced to make `b` of `a` (Levenshtein 1966).
fn changes(a: &str, b: &str) -> usize {
    let mut row: Vec<usize> = (0..=b.chars().count()).collect();
    for (i, from) in a.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, to) in b.chars().enumerate() {
            let replaced = diagonal + usize::from(from != to);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.chars().count()]
}

/// Number of sentences: full stops, exclamation and question marks at the end of a word.
pub(super) const fn sentences(text: &str) -> usize {
    let text = text.as_bytes();
    let (mut count, mut index) = (0, 0);
    while index < text.len() {
        let ends = index + 1 == text.len() || text[index + 1] == b' ';
        count += (ends && matches!(text[index], b'.' | b'!' | b'?')) as usize;
        index += 1;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_misspelt_name_is_nearest_to_what_was_meant() {
        assert_eq!(nearest("boustrophedn", "snake, boustrophedon_cells, boustrophedon, bounce"), Some("boustrophedon"));
        assert_eq!(nearest("wal_folow", "bounce, wall_follow, random_walk"), Some("wall_follow"));
        assert_eq!(nearest("nowhere", "flat, warehouse"), None);
        assert_eq!([changes("kitten", "sitting"), changes("", "dock"), changes("dock", "")], [3, 4, 4]);
    }

    #[test]
    fn sentences_end_with_a_mark_behind_a_word() {
        assert_eq!(sentences("Takes 0.5 s. Does it? Yes!"), 3);
        assert_eq!(sentences("Never ends"), 0);
        assert!(is_same("turn", "turn") && !is_same("turn", "turns") && !is_same("", "t"));
    }
}

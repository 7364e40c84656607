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
    fn sentences_end_with_a_mark_behind_a_word() {
        assert_eq!(sentences("Takes 0.5 s. Does it? Yes!"), 3);
        assert_eq!(sentences("Never ends"), 0);
        assert!(is_same("turn", "turn") && !is_same("turn", "turns") && !is_same("", "t"));
    }
}

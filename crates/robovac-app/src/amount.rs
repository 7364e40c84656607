//! Counts in words.

/// A number of things, e.g. "1 step" and "2 steps".
pub fn amount(number: i64, unit: &str) -> String {
    let s = if number == 1 { "" } else { "s" };
    format!("{number} {unit}{s}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_thing_is_singular() {
        let amounts = [0, 1, 2].map(|number| amount(number, "cliff"));
        assert_eq!(amounts, ["0 cliffs", "1 cliff", "2 cliffs"]);
    }
}

//! Counts in words.

/// A number of things, e.g. "1 step" and "2,000 steps".
pub fn amount(number: i64, unit: &str) -> String {
    let s = if number == 1 { "" } else { "s" };
    let sign = if number < 0 { "-" } else { "" };
    format!("{sign}{} {unit}{s}", grouped(number.unsigned_abs() as usize))
}

/// A number with commas between its thousands, as the page shows them.
pub(crate) fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_thing_is_singular() {
        let amounts = [0, 1, 2].map(|number| amount(number, "cliff"));
        assert_eq!(amounts, ["0 cliffs", "1 cliff", "2 cliffs"]);
        assert_eq!(amount(-1316, "step"), "-1,316 steps");
    }

    #[test]
    fn thousands_are_grouped() {
        assert_eq!([0, 999, 2000, 12_345, 1_234_567].map(grouped), ["0", "999", "2,000", "12,345", "1,234,567"]);
    }
}

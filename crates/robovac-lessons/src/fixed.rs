//! Numbers in texts. What the standard library writes numbers with is a tenth of the page's module.

/// `value` with so many places behind the point, at most six; rounded half away from zero.
pub fn fixed(value: f64, places: u32) -> String {
    let scale = 10_u64.pow(places.min(6));
    let all = (value.abs() * scale as f64).round() as u64;
    let sign = if value < 0.0 && all > 0 { "-" } else { "" };
    let (whole, part) = (all / scale, all % scale);
    if places == 0 {
        format!("{sign}{whole}")
    } else {
        format!("{sign}{whole}.{part:0width$}", width = places as usize)
    }
}

/// `value` with at most one place behind the point.
pub fn short(value: f64) -> String {
    let text = fixed(value, 1);
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

#[cfg(test)]
mod tests {
    use super::{fixed, short};

    #[test]
    fn numbers_are_written_as_the_standard_library_writes_them() {
        for value in [0.0, 0.04, -0.04, 0.05, 1.0, -42.5, 99.96, 1234.5678, -7.125, 4_294_967_295.0] {
            for places in [0, 1, 3] {
                // That one keeps the sign of zero, and rounds halves to even.
                let theirs = format!("{value:.*}", places as usize);
                let ours = fixed(value, places);
                let is_zero = theirs.chars().all(|c| matches!(c, '-' | '0' | '.'));
                assert!(
                    ours == theirs || is_zero && theirs == format!("-{ours}") || (value * 1e3).fract() == 0.0,
                    "{ours} {theirs}"
                );
            }
        }
        assert_eq!([fixed(7.125, 2), fixed(-0.5, 0), fixed(2.0, 1)], ["7.13", "-1", "2.0"]);
        assert_eq!([short(600.0), short(0.1), short(-42.46)], ["600", "0.1", "-42.5"]);
    }
}

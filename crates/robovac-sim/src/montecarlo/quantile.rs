//! Quantiles, also of censored values (only known to be large).

/// The `p` quantile (0 to 1) of `sorted` values, ascending; `None` without any.
///
/// Between the two values around the place `p (n - 1)`, counted from 0, it is interpolated linearly (definition 7 of
/// Hyndman & Fan 1996, Sample Quantiles in Statistical Packages; the default of R and `NumPy`).
///
/// Events after the end of a run are infinite. All runs of a study end at the same time, so a finite quantile is the
/// same as for unlimited runs.
pub fn quantile(sorted: &[f64], p: f64) -> Option<f64> {
    let place = p.clamp(0.0, 1.0) * sorted.len().checked_sub(1)? as f64;
    let (low, share) = (sorted[place.floor() as usize], place.fract());
    // Even a share of 0 of infinity must not be added.
    Some(if share == 0.0 || low.is_infinite() { low } else { low + share * (sorted[place.ceil() as usize] - low) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_definition() {
        let values = [1.0, 2.0, 4.0, 8.0, 16.0];
        for (p, expected) in [(0.0, 1.0), (0.1, 1.4), (0.25, 2.0), (0.5, 4.0), (0.9, 12.8), (1.0, 16.0)] {
            let found = quantile(&values, p).unwrap();
            assert!((found - expected).abs() < 1e-12, "{p}: {found}");
        }
        assert_eq!(quantile(&[3.0, 5.0], 0.5), Some(4.0));
        assert_eq!(quantile(&[7.0], 0.9), Some(7.0));
        assert_eq!(quantile(&[], 0.5), None);
    }

    #[test]
    fn what_was_not_reached_stays_unreached() {
        let never = f64::INFINITY;
        assert_eq!(quantile(&[1.0, 2.0, never], 0.5), Some(2.0));
        assert_eq!(quantile(&[1.0, never], 0.5), Some(never), "half of the runs aren't more than half");
        assert_eq!(quantile(&[never, never], 0.5), Some(never));
        assert_eq!(quantile(&[1.0, never], 0.0), Some(1.0));
    }
}

//! The one source of random numbers: a seeded PCG generator.
//!
//! Everything random takes a generator made here, so that a seed determines a run on every target.

/// Generator used everywhere. PCG XSL RR 128/64 (O'Neill 2014); its stream is fixed for all versions of `rand_pcg`.
pub type Rng = rand_pcg::Pcg64;

/// A generator for `seed`, on the stream with number `stream`.
///
/// Independent parts of one run (wheel slip, sensor noise, a planner) take different streams, so that drawing more
/// numbers in one of them doesn't change the others.
pub fn seeded(seed: u64, stream: u64) -> Rng {
    Rng::new(u128::from(seed), u128::from(stream))
}

/// A standard normal deviate by the polar method of Marsaglia and Bray (1964).
pub fn normal(rng: &mut Rng) -> f64 {
    use rand::RngExt;
    loop {
        let u = rng.random_range(-1.0..1.0_f64);
        let v = rng.random_range(-1.0..1.0_f64);
        let s = u * u + v * v;
        if s > 0.0 && s < 1.0 {
            return u * (-2.0 * crate::math::ln(s) / s).sqrt();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_has_zero_mean_and_unit_variance() {
        let mut rng = seeded(7, 0);
        let draws: Vec<f64> = (0..20_000).map(|_| normal(&mut rng)).collect();
        let mean = draws.iter().sum::<f64>() / 20_000.0;
        let variance = draws.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / 20_000.0;
        assert!(mean.abs() < 0.03, "mean {mean}");
        assert!((variance - 1.0).abs() < 0.05, "variance {variance}");
    }
}

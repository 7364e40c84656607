//! Clothoids: curves whose curvature grows in proportion to the way.

use crate::math;

/// Steps of the integration along a whole clothoid.
const STEPS: u32 = 24;

/// The end (ahead, to the left) of a clothoid from curvature 0 to 1 that turns by `turn` radians, 0 to 3.2: it begins at the
/// origin, looking ahead, and is 2 x turn long. Accurate to 1e-7.
pub(super) fn unit_end(turn: f64) -> [f64; 2] {
    let length = 2.0 * turn;
    let step = length / f64::from(STEPS);
    (0..STEPS).fold([0.0; 2], |[x, y], i| {
        let curvature = |i: f64| i / f64::from(STEPS);
        let from = f64::from(i);
        let heading = turn * curvature(from) * curvature(from);
        let [dx, dy] = advance(heading, step, [curvature(from), curvature(from + 1.0)]);
        [x + dx, y + dy]
    })
}

/// The way from one end to the other of a short stretch whose curvature changes linearly between two values, 1/m, and that
/// begins at `heading` (Simpson's rule).
pub(super) fn advance(heading: f64, length: f64, [from, to]: [f64; 2]) -> [f64; 2] {
    let turned = |share: f64| heading + length * share * (from + 0.5 * share * (to - from));
    let mut way = [0.0; 2];
    for (share, weight) in [(0.0, 1.0), (0.25, 4.0), (0.5, 2.0), (0.75, 4.0), (1.0, 1.0)] {
        let (sin, cos) = math::sin_cos(turned(share));
        way[0] += weight * cos * length / 12.0;
        way[1] += weight * sin * length / 12.0;
    }
    way
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_those_of_fresnel_integrals() {
        // Abramowitz & Stegun, table 7.7: C(1) = 0.7798934, S(1) = 0.4382591, where the clothoid has turned by pi / 2. Its
        // curvature there is pi, so that the unit clothoid is pi times as large.
        let [x, y] = unit_end(math::FRAC_PI_2);
        assert!((x - math::PI * 0.779_893_4).abs() < 1e-6 && (y - math::PI * 0.438_259_1).abs() < 1e-6, "{x} {y}");
        // C(sqrt 2) = 0.5288915, S(sqrt 2) = 0.7139721 at a turn of pi, where the curvature is pi sqrt 2.
        let [x, y] = unit_end(math::PI);
        let scale = math::PI * 2.0_f64.sqrt();
        assert!(
            (x - scale * 0.528_891_6).abs() < 1e-5 && (y - scale * 0.713_972_2).abs() < 1e-5,
            "{} {}",
            x / scale,
            y / scale
        );
    }

    #[test]
    fn a_stretch_of_constant_curvature_is_an_arc() {
        let [x, y] = advance(0.0, 0.01, [10.0, 10.0]);
        assert!((x - 0.1 * math::sin(0.1)).abs() < 1e-10 && (y - 0.1 * (1.0 - math::cos(0.1))).abs() < 1e-10);
    }
}

//! The fastest speeds along a path, by reachability analysis.

use super::{DriveLimits, Stretch};

/// Halvings in the search for the fastest speed of a node.
const HALVINGS: u32 = 40;
/// Curvatures below count as straight, 1/m.
const STRAIGHT: f64 = 1e-9;

/// The squares of the speeds at the ends of `stretches`, m²/s², one more than there are stretches; the path begins and ends with
/// the speeds whose squares are `ends`, or less if these are out of reach.
///
/// With x for the square of the speed v, u for the acceleration along the path and g = 1 ± h k for what a wheel's speed is to
/// that of the middle (h half the wheel base, k the curvature), a wheel accelerates by g u + g' x, which is linear in (u, x).
/// From the end backwards, the values of x from which the end can be reached are an interval from 0 to a limit; from the
/// start forwards, the greatest u that stays within the limits is the fastest.
pub(super) fn squares(stretches: &[Stretch], limits: &DriveLimits, ends: [f64; 2]) -> Vec<f64> {
    let count = stretches.len();
    let most = |curvature: f64| {
        let fastest = limits.fastest(curvature);
        fastest * fastest
    };
    let mut reach = vec![f64::MAX; count + 1];
    for (i, stretch) in stretches.iter().enumerate() {
        reach[i] = reach[i].min(most(stretch.curvature[0]));
        reach[i + 1] = reach[i + 1].min(most(stretch.curvature[1]));
    }
    reach[count] = reach[count].min(ends[1]);
    for i in (0..count).rev() {
        let next = reach[i + 1];
        reach[i] = furthest(&stretches[i], limits, reach[i], next);
    }
    let mut found = Vec::with_capacity(count + 1);
    let mut x = reach.first().map_or(0.0, |&most| most.min(ends[0]));
    found.push(x);
    for (stretch, &next) in stretches.iter().zip(&reach[1..]) {
        let (_, high) = accelerations(stretch, limits, x);
        x = (x + 2.0 * stretch.length * high).clamp(0.0, next);
        found.push(x);
    }
    found
}

/// Seconds for a stretch between two squares of speeds, which change linearly with the way.
pub(super) fn time(length: f64, from: f64, to: f64) -> f64 {
    let sum = from.sqrt() + to.sqrt();
    if sum > 0.0 { 2.0 * length / sum } else { 0.0 }
}

/// The greatest x at the start of a stretch, at most `most`, from which one of at most `next` at its end can be reached.
fn furthest(stretch: &Stretch, limits: &DriveLimits, most: f64, next: f64) -> f64 {
    if stretch.curvature[0].abs().max(stretch.curvature[1].abs()) < STRAIGHT {
        return most.min(next + 2.0 * limits.acceleration * stretch.length);
    }
    let can = |x: f64| {
        let (low, high) = accelerations(stretch, limits, x);
        low <= high && x + 2.0 * stretch.length * low <= next
    };
    if can(most) {
        return most;
    }
    let (mut good, mut bad) = (0.0, most);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (good + bad);
        if can(middle) { good = middle } else { bad = middle }
    }
    good
}

/// The least and greatest acceleration along a stretch that begins with x, such that no wheel accelerates too much at either
/// of its ends and the robot doesn't go back; the least is above the greatest if there is none.
fn accelerations(stretch: &Stretch, limits: &DriveLimits, x: f64) -> (f64, f64) {
    let Stretch { length, curvature: [from, to], .. } = *stretch;
    let (mut low, mut high) = (-x / (2.0 * length), f64::MAX);
    for half in [limits.half_base, -limits.half_base] {
        let slope = half * (to - from) / length;
        let by_rise = slope * x;
        // At the start g u + g' x; at the end, x has grown by 2 u length.
        for factor in [1.0 + half * from, 1.0 + half * to + 2.0 * length * slope] {
            if factor.abs() < 1e-12 {
                if by_rise.abs() > limits.acceleration {
                    return (1.0, 0.0);
                }
                continue;
            }
            let ends = [-1.0, 1.0].map(|sign| (sign * limits.acceleration - by_rise) / factor);
            low = low.max(ends[0].min(ends[1]));
            high = high.min(ends[0].max(ends[1]));
        }
    }
    (low, high)
}

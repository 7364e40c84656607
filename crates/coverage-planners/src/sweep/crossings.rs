//! Crossings of a path with itself.

use robovac_core::{geometry::Point, math};

/// Points nearer to each other than this are one, m.
const SAME: f64 = 1e-6;
/// Most rows of the list of neighbours.
const MAX_ROWS: f64 = 4096.0;

/// How often ways cross each other: where one passes from one side of another to its other side, also by a corner or
/// after a stretch along it. Ways that only touch, and those that meet at their ends, don't cross. A way isn't compared
/// with itself.
///
/// Ways are sorted into rows, so this takes time in proportion to the pairs that share a row.
pub(super) fn crossings(ways: &[&[Point]]) -> usize {
    let boxes: Vec<[f64; 4]> = ways
        .iter()
        .map(|way| {
            way.iter().fold([f64::MAX, f64::MAX, f64::MIN, f64::MIN], |[left, low, right, high], p| {
                [left.min(p.x), low.min(p.y), right.max(p.x), high.max(p.y)]
            })
        })
        .collect();
    let (low, high) = boxes.iter().fold((f64::MAX, f64::MIN), |(low, high), b| (low.min(b[1]), high.max(b[3])));
    let count = (ways.len() as f64).clamp(1.0, MAX_ROWS);
    let row = |y: f64| if high > low { ((y - low) / (high - low) * (count - 1.0)) as usize } else { 0 };
    let mut rows: Vec<Vec<usize>> = vec![Vec::new(); count as usize];
    for (way, b) in boxes.iter().enumerate().filter(|(way, _)| ways[*way].len() > 1) {
        rows[row(b[1])..=row(b[3])].iter_mut().for_each(|row| row.push(way));
    }
    let mut found = 0;
    for (number, row_ways) in rows.iter().enumerate() {
        for (index, &one) in row_ways.iter().enumerate() {
            for &other in &row_ways[index + 1..] {
                let (a, b) = (boxes[one], boxes[other]);
                let is_apart = a[0] > b[2] || b[0] > a[2] || a[1] > b[3] || b[1] > a[3];
                // Each pair once: in the first row that both share.
                if !is_apart && number == row(a[1]).max(row(b[1])) {
                    found += crossings_of(ways[one], ways[other]);
                }
            }
        }
    }
    found
}

/// How often one way crosses another: stretches that both share, often a single point, at which one comes from one side
/// of the other and leaves to its other side.
fn crossings_of(way: &[Point], other: &[Point]) -> usize {
    let (one, two) = (noded(way, other), noded(other, way));
    let is_same = |i: Option<usize>, j: Option<usize>| match (i.and_then(|i| one.get(i)), j.and_then(|j| two.get(j))) {
        (Some(a), Some(b)) => (a - b).norm() <= SAME,
        _ => false,
    };
    let beside = |j: usize, step: isize| j.checked_add_signed(step);
    let mut found = 0;
    for i in 0..one.len() {
        for j in (0..two.len()).filter(|&j| is_same(Some(i), Some(j))) {
            let goes_on = |step: isize| is_same(Some(i + 1), beside(j, step));
            let comes = |step: isize| is_same(i.checked_sub(1), beside(j, -step));
            // Where stretches begin: a way that comes along the other is on one already.
            let steps: &[isize] = match [1, -1].map(|step| (goes_on(step), comes(step))) {
                [(true, false), (true, false)] => &[1, -1],
                [(_, false), (false, false)] => &[1],
                [(false, false), (true, false)] => &[-1],
                _ => &[],
            };
            for &step in steps {
                let (mut end, mut other_end, mut on) = (i, j, step);
                loop {
                    if !is_same(Some(end + 1), beside(other_end, on)) {
                        // It can lead back along itself.
                        if end == i || !is_same(Some(end + 1), beside(other_end, -on)) {
                            break;
                        }
                        on = -on;
                    }
                    (end, other_end) = (end + 1, other_end.saturating_add_signed(on));
                }
                let get = |j: Option<usize>| j.and_then(|j| two.get(j));
                let (from, to) = (i.checked_sub(1).map(|i| one[i]), one.get(end + 1));
                // The other way before and behind both places.
                let [first, last] = [j, other_end].map(|j| (get(beside(j, -step)), get(beside(j, step))));
                // At an end of either they touch.
                let (Some(from), Some(to)) = (from, to) else { continue };
                let ((Some(before), Some(after)), (Some(last_before), Some(last_after))) = (first, last) else {
                    continue;
                };
                found += usize::from(
                    is_left(*before, one[i], *after, from) != is_left(*last_before, one[end], *last_after, *to),
                );
            }
        }
    }
    found
}

/// Whether a point is seen to the left from a corner of a line.
fn is_left(before: Point, corner: Point, after: Point, seen: Point) -> bool {
    let angle = |p: Point| math::atan2(p.y - corner.y, p.x - corner.x);
    let turned = |p: Point| (angle(p) - angle(after)).rem_euclid(math::TAU);
    turned(seen) < turned(before)
}

/// The corners of a way, with its points at which it meets another one.
fn noded(way: &[Point], other: &[Point]) -> Vec<Point> {
    let mut nodes = vec![way[0]];
    for side in way.windows(2) {
        let along = side[1] - side[0];
        let square = along.norm_squared();
        let mut shares = vec![1.0];
        for across in other.windows(2) {
            let way = across[1] - across[0];
            let perp = along.perp(&way);
            if perp != 0.0 {
                let off = across[0] - side[0];
                let (here, there) = (off.perp(&way) / perp, off.perp(&along) / perp);
                if (0.0..=1.0).contains(&here) && (0.0..=1.0).contains(&there) {
                    shares.push(here);
                }
            }
        }
        // Its own corners, too: a way can lead back along itself.
        for corner in other.iter().chain(way) {
            let share = (corner - side[0]).dot(&along) / square;
            if (0.0..=1.0).contains(&share) && (side[0] + share * along - corner).norm() <= SAME {
                shares.push(share);
            }
        }
        shares.sort_unstable_by(f64::total_cmp);
        for share in shares {
            let node = if share >= 1.0 { side[1] } else { side[0] + share * along };
            if nodes.last().is_none_or(|last: &Point| (node - last).norm() > SAME) {
                nodes.push(node);
            }
        }
    }
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(ways: &[&[(f64, f64)]]) -> usize {
        let ways: Vec<Vec<Point>> =
            ways.iter().map(|way| way.iter().map(|&(x, y)| Point::new(x, y)).collect()).collect();
        crossings(&ways.iter().map(Vec::as_slice).collect::<Vec<_>>())
    }

    #[test]
    fn ways_cross_where_they_change_sides() {
        let level: &[(f64, f64)] = &[(0.0, 0.0), (4.0, 0.0)];
        assert_eq!(count(&[level, &[(1.0, -1.0), (1.0, 1.0)]]), 1);
        assert_eq!(count(&[level, &[(1.0, -1.0), (1.0, 1.0), (2.0, -1.0)]]), 2);
        // By a corner, and after a stretch along it.
        assert_eq!(count(&[level, &[(1.0, -1.0), (1.5, 0.0), (1.0, 1.0)]]), 1);
        assert_eq!(count(&[level, &[(1.0, -1.0), (1.5, 0.0), (2.5, 0.0), (3.0, 1.0)]]), 1);
        assert_eq!(count(&[&[(1.0, -1.0), (1.5, 0.0), (2.5, 0.0), (3.0, 1.0)], level]), 1);
        // One that leads back along itself first.
        let back: &[(f64, f64)] = &[(1.0, 1.0), (1.0, 0.0), (2.0, 0.0), (0.5, 0.0), (0.5, -1.0)];
        assert_eq!(count(&[back, level]), 1);
        assert_eq!(count(&[level, back]), 1);
        // Through a corner of the other.
        assert_eq!(count(&[&[(0.0, 0.0), (2.0, 0.0), (4.0, 1.0)], &[(2.0, -1.0), (2.0, 1.0)]]), 1);
    }

    #[test]
    fn ways_that_touch_or_share_an_end_do_not_cross() {
        let level: &[(f64, f64)] = &[(0.0, 0.0), (4.0, 0.0)];
        assert_eq!(count(&[level, &[(1.0, -1.0), (1.5, 0.0), (2.0, -1.0)]]), 0);
        assert_eq!(count(&[level, &[(1.0, -1.0), (1.5, 0.0), (2.5, 0.0), (3.0, -1.0)]]), 0);
        assert_eq!(count(&[level, &[(4.0, 0.0), (4.0, 1.0), (0.0, 1.0)]]), 0);
        assert_eq!(count(&[level, &[(4.0, 0.0), (0.0, 0.0)], &[(2.0, 0.5), (3.0, 5.0)]]), 0);
        assert_eq!(count(&[level, &[(5.0, -1.0), (5.0, 1.0)]]), 0);
        // One leads back along itself before the other leaves.
        let back: &[(f64, f64)] = &[(1.0, 1.0), (1.0, 0.0), (9.0, 0.0), (0.0, 0.0)];
        assert_eq!(count(&[back, &[(0.0, 0.0), (4.0, 0.0), (4.0, -1.0)]]), 0);
        // One leads back along itself while the other goes on, and ends where that begins.
        let back: &[(f64, f64)] = &[(1.0, 1.0), (1.0, 0.0), (2.0, 0.0), (0.0, 0.0)];
        assert_eq!(count(&[back, level]), 0);
        assert_eq!(count(&[level, back]), 0);
        // One leads back along itself and leaves on the side from which it came.
        let back: &[(f64, f64)] = &[(1.0, 1.0), (1.0, 0.0), (2.0, 0.0), (0.5, 0.0), (0.5, 1.0)];
        assert_eq!(count(&[back, level]), 0);
        assert_eq!(count(&[level, back]), 0);
        assert_eq!(count(&[]), 0);
    }
}

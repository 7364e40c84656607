//! Crossings of a path with itself.

use robovac_core::geometry::Point;

/// Nearer than this, a corner lies on a line, m.
const ON: f64 = 1e-7;
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

/// How often one way crosses another.
fn crossings_of(way: &[Point], other: &[Point]) -> usize {
    let (first, last) = (other[0], other[other.len() - 1]);
    let mut found = 0;
    for side in other.windows(2) {
        let along = side[1] - side[0];
        let length = along.norm();
        if length < ON {
            continue;
        }
        let off = |p: Point| along.perp(&(p - side[0])) / length;
        // The last corner beside the line, and the first one on it since.
        let (mut beside, mut on): (Option<Point>, Option<Point>) = (None, None);
        for &corner in way {
            let height = off(corner);
            if height.abs() <= ON {
                on = on.or(Some(corner));
                continue;
            }
            if let Some(before) = beside.filter(|&before| (off(before) > 0.0) != (height > 0.0)) {
                let at = on.unwrap_or_else(|| before + (corner - before) * (off(before) / (off(before) - height)));
                let share = (at - side[0]).dot(&along) / length;
                let is_at_end = |end: Point| (at - end).norm() <= ON;
                // A corner of the other belongs to the side that begins there.
                let is_inside = share > -ON && share < length - ON;
                found += usize::from(is_inside && !is_at_end(first) && !is_at_end(last));
            }
            (beside, on) = (Some(corner), None);
        }
    }
    found
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
        assert_eq!(count(&[]), 0);
    }
}

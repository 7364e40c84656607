use super::Point;

/// Corners of the convex hull of some points, counter-clockwise (Andrew 1979), without those on its sides; fewer than three points
/// as they are, sorted.
///
/// ```
/// use robovac_core::geometry::{Point, convex_hull};
/// let points = [(2.0, 0.0), (1.0, 1.0), (0.0, 0.0), (1.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(|(x, y)| Point::new(x, y));
/// let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(|(x, y)| Point::new(x, y));
/// assert_eq!(convex_hull(points.into()), corners);
/// ```
pub fn convex_hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut hull: Vec<Point> = Vec::with_capacity(points.len() + 1);
    let mut least = 1;
    for (index, &point) in points.iter().chain(points.iter().rev().skip(1)).enumerate() {
        if index == points.len() {
            least = hull.len();
        }
        while hull.len() > least {
            let [.., before, last] = hull[..] else { break };
            if (last - before).perp(&(point - last)) > 0.0 {
                break;
            }
            hull.pop();
        }
        hull.push(point);
    }
    hull.pop();
    hull
}

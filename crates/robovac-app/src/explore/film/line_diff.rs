//! The change of a path in metres by one improvement.

use robovac_core::geometry::Point;

/// Corners nearer than this are the same, m.
const SAME: f64 = 1e-6;

/// The difference of two paths in metres, regardless of their direction.
#[derive(Debug, Clone, PartialEq)]
pub struct LineDiff {
    /// The parts of the former path that stay, in its order.
    pub parts: Vec<Vec<Point>>,
    /// The new parts of the latter path, in its order.
    pub links: Vec<Vec<Point>>,
}

impl LineDiff {
    /// From one path to another.
    pub fn between(former: &[Point], latter: &[Point]) -> Self {
        let mut both = [former, latter].map(|line| {
            let mut pieces: Vec<PieceKey> = line.windows(2).map(piece).collect();
            pieces.sort_unstable();
            pieces
        });
        let mut shared =
            |line: &[Point], other: usize| line.windows(2).map(|two| take(&mut both[other], &piece(two))).collect();
        let (stays, was): (Vec<bool>, Vec<bool>) = (shared(former, 1), shared(latter, 0));
        Self { parts: runs(former, &stays, true), links: runs(latter, &was, false) }
    }
}

/// A straight piece in either direction, to the precision of [`SAME`].
type PieceKey = [[i64; 2]; 2];

fn piece(ends: &[Point]) -> PieceKey {
    let mut ends = [ends[0], ends[1]].map(|end| [end.x, end.y].map(|metres| (metres / SAME).round() as i64));
    ends.sort_unstable();
    ends
}

/// Removes a piece from sorted ones; returns whether it was there.
fn take(pieces: &mut Vec<PieceKey>, piece: &PieceKey) -> bool {
    pieces.binary_search(piece).map(|at| pieces.remove(at)).is_ok()
}

/// The stretches of a line whose pieces all are so.
fn runs(line: &[Point], are: &[bool], so: bool) -> Vec<Vec<Point>> {
    let mut runs: Vec<Vec<Point>> = Vec::new();
    let mut goes_on = false;
    for (two, &is) in line.windows(2).zip(are) {
        match runs.last_mut().filter(|_| goes_on) {
            Some(run) if is == so => run.push(two[1]),
            _ if is == so => runs.push(two.to_vec()),
            _ => {}
        }
        goes_on = is == so;
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_that_stay_are_told_from_what_is_new() {
        let line = |corners: &[(f64, f64)]| corners.iter().map(|&(x, y)| Point::new(x, y)).collect::<Vec<_>>();
        let former = line(&[(0.0, 0.0), (0.0, 4.0), (0.2, 4.0), (0.2, 0.0), (0.4, 0.0), (0.4, 4.0)]);
        // The last lane is driven first, in the other direction, and the middle one is shorter.
        let latter = line(&[(0.4, 4.0), (0.4, 0.0), (0.0, 0.0), (0.0, 4.0), (0.2, 4.0), (0.2, 1.0)]);
        let change = LineDiff::between(&former, &latter);
        assert_eq!(change.parts, [former[..3].to_vec(), former[4..].to_vec()]);
        assert_eq!(change.links, [latter[1..3].to_vec(), latter[4..].to_vec()]);
        let backwards: Vec<Point> = former.iter().rev().copied().collect();
        let change = LineDiff::between(&former, &backwards);
        assert_eq!((change.parts, change.links), (vec![former.clone()], Vec::new()));
        // A piece that is driven twice stays once only.
        let twice = line(&[(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)]);
        assert_eq!(LineDiff::between(&twice, &twice[..2]).parts, [twice[..2].to_vec()]);
        assert_eq!(LineDiff::between(&[], &former).links, [former]);
    }
}

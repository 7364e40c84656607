//! A path in metres: what planners without cells plan, and what files and links carry.

use super::Point;
use serde::{Deserialize, Serialize};
use std::{fmt, sync::Arc};

/// Most corners of a path.
pub const MAX_PATH_CORNERS: usize = 100_000;
/// Corners lie on a lattice this fine, m: far finer than the clearance of a planned path, so that a path in a link or a
/// file is the very path that was planned.
const GRAIN: f64 = 1e-5;
/// Largest coordinate, m.
const FARTHEST: f64 = 1e6;
/// Digits of a link: none of them needs escaping (RFC 4648, section 5).
const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Corners in the order in which they are driven, straight from each to the next, m; from the room's lower left corner,
/// x to the right, y up. At least one; no two after each other are the same.
///
/// ```
/// use robovac_core::geometry::{MetricPath, Point};
/// let path = MetricPath::new(&[Point::new(0.2, 0.2), Point::new(1.5, 0.2), Point::new(1.5, 0.37)]).unwrap();
/// assert_eq!(path.to_string(), "ginBginBg99HAAwmhB");
/// assert_eq!(MetricPath::parse("ginBginBg99HAAwmhB"), Some(path));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<[f64; 2]>", into = "Vec<[f64; 2]>")]
pub struct MetricPath {
    corners: Arc<[Point]>,
}

/// Reasons why corners aren't a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum PathFault {
    /// There are none, or too many.
    #[error("a path can't have {0} corners; use 1 to {MAX_PATH_CORNERS}")]
    Count(usize),
    /// A corner, counted from 1, has no place.
    #[error("corner {0} of the path isn't a place; use metres from the room's lower left corner")]
    Corner(usize),
}

impl MetricPath {
    /// The path along `corners`, which are rounded to hundredths of a millimetre.
    pub fn new(corners: &[Point]) -> Result<Self, PathFault> {
        let is_place = |p: &Point| p.x.abs() <= FARTHEST && p.y.abs() <= FARTHEST;
        if let Some(wrong) = corners.iter().position(|corner| !is_place(corner)) {
            return Err(PathFault::Corner(wrong + 1));
        }
        let count = corners.len();
        if !(1..=MAX_PATH_CORNERS).contains(&count) {
            return Err(PathFault::Count(count));
        }
        Ok(Self::of_grains(
            corners.iter().map(|corner| [corner.x, corner.y].map(|metres| (metres / GRAIN).round() as i64)),
        ))
    }

    fn of_grains(corners: impl Iterator<Item = [i64; 2]>) -> Self {
        let mut corners: Vec<Point> = corners.map(|[x, y]| Point::new(x as f64 * GRAIN, y as f64 * GRAIN)).collect();
        corners.dedup();
        Self { corners: corners.into() }
    }

    /// Its corners.
    pub fn corners(&self) -> &Arc<[Point]> {
        &self.corners
    }

    /// Where it begins.
    pub fn start(&self) -> Point {
        // There is at least one corner.
        self.corners.first().copied().unwrap_or_else(Point::origin)
    }

    /// Its length, m.
    pub fn length(&self) -> f64 {
        self.corners.windows(2).map(|piece| (piece[1] - piece[0]).norm()).sum()
    }

    /// The path of a link: the inverse of its [`Display`](fmt::Display).
    pub fn parse(text: &str) -> Option<Self> {
        let (mut at, mut ways, mut bits, mut shift) = ([0; 2], Vec::new(), 0, 0);
        for digit in text.bytes() {
            let value = DIGITS.iter().position(|&known| known == digit)? as u64;
            bits |= (value & 31).checked_shl(shift)?;
            shift += 5;
            if value < 32 {
                // The sign is in the lowest bit.
                ways.push((bits >> 1) as i64 ^ -((bits & 1) as i64));
                (bits, shift) = (0, 0);
            }
        }
        let (pairs, []) = ways.as_chunks::<2>() else { return None };
        let most = (FARTHEST / GRAIN) as i64;
        let mut corners = Vec::with_capacity(pairs.len());
        for way in pairs {
            for (at, way) in at.iter_mut().zip(way) {
                *at = i64::checked_add(*at, *way).filter(|at| at.abs() <= most)?;
            }
            corners.push(at);
        }
        let is_whole = shift == 0 && (1..=MAX_PATH_CORNERS).contains(&corners.len());
        is_whole.then(|| Self::of_grains(corners.into_iter()))
    }
}

/// As in links: the way to each corner from the one before, in hundredths of a millimetre, five bits to a digit, the
/// lowest first; all but the last digit of a number have the sixth bit. About eight letters a corner.
impl fmt::Display for MetricPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = String::new();
        let mut before = [0; 2];
        for corner in &*self.corners {
            let at = [corner.x, corner.y].map(|metres| (metres / GRAIN).round() as i64);
            for (at, before) in at.iter().zip(before) {
                let way = at - before;
                let mut bits = (way << 1 ^ way >> 63) as u64;
                while bits >= 32 {
                    text.push(char::from(DIGITS[(32 | bits & 31) as usize]));
                    bits >>= 5;
                }
                text.push(char::from(DIGITS[bits as usize]));
            }
            before = at;
        }
        f.write_str(&text)
    }
}

impl TryFrom<Vec<[f64; 2]>> for MetricPath {
    type Error = PathFault;

    fn try_from(corners: Vec<[f64; 2]>) -> Result<Self, PathFault> {
        Self::new(&corners.into_iter().map(|[x, y]| Point::new(x, y)).collect::<Vec<_>>())
    }
}

impl From<MetricPath> for Vec<[f64; 2]> {
    fn from(path: MetricPath) -> Self {
        // Five decimals are the lattice; without rounding, files would show 1.5699999999999998.
        let plain = |metres: f64| (metres * 1e5).round() / 1e5;
        path.corners.iter().map(|corner| [plain(corner.x), plain(corner.y)]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::seeded;
    use rand::RngExt;

    #[test]
    fn links_and_files_hold_the_very_path() {
        let mut rng = seeded(1, 0);
        for count in [1, 2, 700] {
            let corners: Vec<Point> =
                (0..count).map(|_| Point::new(rng.random_range(-3.0..400.0), rng.random_range(0.0..30.0))).collect();
            let path = MetricPath::new(&corners).unwrap();
            assert!(path.corners().iter().zip(&corners).all(|(kept, given)| (kept - given).norm() < 1e-5));
            assert_eq!(MetricPath::parse(&path.to_string()), Some(path.clone()));
            let file = Vec::from(path.clone());
            assert_eq!(MetricPath::try_from(file), Ok(path.clone()));
            assert_eq!(MetricPath::new(path.corners()), Ok(path), "rounding once is enough");
        }
    }

    #[test]
    fn what_is_no_path_is_refused() {
        assert_eq!(MetricPath::new(&[]), Err(PathFault::Count(0)));
        let far = [Point::new(0.0, 0.0), Point::new(1e9, 0.0)];
        assert_eq!(MetricPath::new(&far), Err(PathFault::Corner(2)));
        let message = MetricPath::new(&[Point::new(f64::NAN, 0.0)]).unwrap_err().to_string();
        assert!(message.contains("corner 1"), "{message}");
        for text in ["", "A", "AAA", "A!", "g", "ggggggggggggggggA", "________________AA"] {
            assert_eq!(MetricPath::parse(text), None, "{text}");
        }
    }

    #[test]
    fn a_corner_that_comes_twice_counts_once() {
        let twice = [Point::new(1.0, 1.0), Point::new(1.0, 1.000_000_1), Point::new(2.0, 1.0)];
        let path = MetricPath::new(&twice).unwrap();
        assert_eq!((path.corners().len(), path.length()), (2, 1.0));
    }
}

//! Moves of a search: what is proposed, and whether it's made.

use super::{
    moves::{Edit, FewPoints, SweptPath},
    nearby::Nearby,
};
use rand::RngExt;
use robovac_core::{
    geometry::{Point, Vector, nearest_on_segment},
    math,
    rng::Rng,
};

/// Price of floor that isn't swept, s/m²: at first, and its limits.
pub(super) const PRICE: (f64, f64, f64) = (80.0, 20.0, 3000.0);
/// Largest shift, m, halved up to so many times.
const SHIFT: (f64, usize) = (0.4, 8);
/// Corners among which moves are drawn, and moves before others are: those near each other need the same memory.
const STRETCH: (usize, u32) = (64, 256);

/// The path at the present temperature.
pub(super) struct Walker<'a> {
    pub path: SweptPath<'a>,
    pub nearby: Nearby,
    rng: Rng,
    radius: f64,
    /// s/m².
    pub price: f64,
    /// Corners are drawn from a stretch of the path that begins at this one, so many times more before the next stretch.
    first: usize,
    stays: u32,
}

impl<'a> Walker<'a> {
    /// Along a path, with a tool of a radius, m.
    pub fn new(path: SweptPath<'a>, rng: Rng, radius: f64) -> Self {
        Self { path, nearby: Nearby::default(), rng, radius, price: PRICE.0, first: 0, stays: 0 }
    }

    /// Goes on with another path and price, s/m²; returns the path's time, s.
    pub fn begin(&mut self, path: SweptPath<'a>, price: f64) -> f64 {
        (self.path, self.price) = (path, price);
        self.nearby.rebuild(&self.path.points);
        self.path.seconds()
    }
}

impl Walker<'_> {
    /// Tries one move; returns by how much the path's time changes, s.
    pub fn try_move(&mut self, temperature: f64) -> f64 {
        let Some(edit) = self.propose() else { return 0.0 };
        if !self.path.is_valid(&edit) {
            return 0.0;
        }
        let limit = -temperature * math::ln(1.0 - self.rng.random::<f64>());
        let exchange = self.path.exchange(&edit);
        let mut seconds = self.path.seconds_by(&edit, &exchange, None);
        // So much may be missed, if as much more is swept anew as there is to sweep.
        let mut may_miss = (limit - seconds) / self.price;
        if may_miss + self.path.raster.unswept_area() < 0.0 {
            return 0.0;
        }
        let most = may_miss + self.path.could_win(&exchange);
        if most < 0.0 {
            return 0.0;
        }
        if !exchange.is_free(self.path.space) {
            return 0.0;
        }
        if self.path.times.has_curves() {
            // Now that it may be worth it.
            seconds = self.path.seconds_by(&edit, &exchange, Some(self.path.space));
            may_miss = (limit - seconds) / self.price;
        }
        let missed = self.path.missed_by(&exchange, most);
        if missed > may_miss {
            return 0.0;
        }
        self.path.apply(&edit);
        seconds
    }

    /// Makes unswept floor dearer or cheaper, so that as much stays as is allowed, m²; `all` is the floor.
    pub fn adjust(&mut self, allowed: f64, all: f64) {
        let missing = self.path.raster.unswept_area() - allowed;
        let rate = (missing / (0.004 * all)).clamp(-1.0, 1.0);
        self.price = (self.price * math::exp(0.05 * rate)).clamp(PRICE.1, PRICE.2);
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.rng.random::<f64>() * count as f64) as usize).min(count.saturating_sub(1))
    }

    /// A distance with either sign; small ones are as likely as large ones.
    fn shift(&mut self) -> f64 {
        let parts = 1_u32 << self.below(SHIFT.1);
        (2.0 * self.rng.random::<f64>() - 1.0) * SHIFT.0 / f64::from(parts)
    }

    fn propose(&mut self) -> Option<Edit> {
        // Where corners are rounded, more of them are worth it: they are shifted oftener, and left out less.
        if self.path.times.has_curves() {
            return match self.below(100) {
                0..22 => self.shift_corner(),
                22..30 => self.slide_corner(),
                30..46 => self.shift_piece(),
                46..58 => self.leave_out(),
                58..63 => self.join_corners(),
                63..68 => self.insert(),
                68..80 => self.reach_for_floor(),
                80..88 => self.reverse(),
                _ => self.carry(),
            };
        }
        // Corners are seldom worth leaving out, and parts worth carrying; a shift makes way for either.
        match self.below(80) {
            0..16 => self.shift_corner(),
            16..20 => self.slide_corner(),
            20..30 => self.shift_piece(),
            30..38 => self.leave_out(),
            38..41 => self.join_corners(),
            41..44 => self.insert(),
            44..60 => self.reach_for_floor(),
            60..72 => self.reverse(),
            _ => self.carry(),
        }
    }

    #[expect(clippy::unnecessary_wraps, reason = "every proposal is optional")]
    fn splice(from: usize, to: usize, new: &[Point]) -> Option<Edit> {
        Some(Edit::Splice { from, to, new: FewPoints::new(new) })
    }

    /// Any corner but the start.
    fn corner(&mut self) -> Option<usize> {
        let n = self.path.points.len();
        if n < 2 {
            return None;
        }
        if self.stays == 0 {
            (self.first, self.stays) = (self.below(n - 1), STRETCH.1);
        }
        self.stays -= 1;
        Some(1 + (self.first + self.below(STRETCH.0.min(n - 1))) % (n - 1))
    }

    fn shift_corner(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let by = Vector::new(self.shift(), self.shift());
        Self::splice(i - 1, i + 1, &[self.path.points[i] + by])
    }

    /// Along one of its pieces, which keeps its direction.
    fn slide_corner(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let p = &self.path.points;
        let other = if i + 1 < p.len() && self.rng.random::<f64>() < 0.5 { p[i + 1] } else { p[i - 1] };
        let along = self.path.points[i] - other;
        let length = along.norm();
        if length < 1e-6 {
            return None;
        }
        let by = along * (self.shift() / length);
        Self::splice(i - 1, i + 1, &[self.path.points[i] + by])
    }

    /// A piece sideways: both ends by the same vector, or along their other pieces.
    fn shift_piece(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let n = self.path.points.len();
        if i + 1 >= n {
            return None;
        }
        let (a, b) = (self.path.points[i], self.path.points[i + 1]);
        let along = b - a;
        let length = along.norm();
        if length < 1e-6 {
            return None;
        }
        let aside = Vector::new(-along.y, along.x) / length;
        let by = self.shift();
        let slides = self.rng.random::<f64>() < 0.5;
        // Along a neighbouring piece, so far that the shift across is the same.
        let slide = |end: Point, other: Option<Point>| {
            let way = other
                .map(|other| other - end)
                .filter(|way| slides && way.dot(&aside).abs() > 0.3 * way.norm() && way.norm() > 1e-6);
            way.map_or(aside * by, |way| way * (by / way.dot(&aside)))
        };
        let (before, after) = (self.path.points[i - 1], self.path.points.get(i + 2).copied());
        Self::splice(i - 1, i + 2, &[a + slide(a, Some(before)), b + slide(b, after)])
    }

    fn leave_out(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let count = [1, 1, 1, 2, 2, 3, 4][self.below(7)];
        Self::splice(i - 1, (i + count).min(self.path.points.len()), &[])
    }

    /// One corner instead of two or three.
    fn join_corners(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let count = 2 + self.below(2);
        if i + count > self.path.points.len() {
            return None;
        }
        let (a, b) = (self.path.points[i], self.path.points[i + count - 1]);
        let at = a + (b - a) * self.rng.random::<f64>() + Vector::new(self.shift(), self.shift()) * 0.3;
        Self::splice(i - 1, i + count, &[at])
    }

    fn insert(&mut self) -> Option<Edit> {
        let i = self.corner()?;
        let (a, b) = (self.path.points[i - 1], self.path.points[i]);
        let at = a + (b - a) * self.rng.random::<f64>() + Vector::new(self.shift(), self.shift());
        Self::splice(i - 1, i, &[at])
    }

    /// Floor that isn't swept, and a piece near it: a corner of it, a new corner, a spur or a short lane.
    fn reach_for_floor(&mut self) -> Option<Edit> {
        let goal = (0..60).find_map(|_| {
            let (word, sample) = (self.rng.random(), self.rng.random());
            self.path.raster.unswept_at(word, sample)
        })?;
        let choice = self.below(3);
        // Where the robot is when its tool is at the goal; then the piece, and the nearest point on it.
        let mut near: Option<(f64, Point, usize, Point)> = None;
        for &piece in self.nearby.around(goal) {
            let i = piece as usize;
            if i == 0 || i >= self.path.points.len() {
                continue;
            }
            let (a, b) = (self.path.points[i - 1], self.path.points[i]);
            let goal = goal - self.path.raster.tool.along(b - a);
            let at = nearest_on_segment(a, b, goal);
            // Not always the nearest piece.
            let distance = (at - goal).norm() * (1.0 + if choice == 0 { 0.0 } else { self.rng.random::<f64>() });
            if near.is_none_or(|(least, ..)| distance < least) {
                near = Some((distance, goal, i, at));
            }
        }
        let (_, goal, i, at) = near?;
        let way = goal - at;
        let distance = way.norm();
        if distance < 1e-6 {
            return None;
        }
        // Where the tool's edge reaches the floor, or goes beyond.
        let reach = at + way * (1.0 - self.radius * self.rng.random::<f64>() / distance);
        let (a, b) = (self.path.points[i - 1], self.path.points[i]);
        match self.below(6) {
            0 | 1 if i > 1 && (at - a).norm() < (at - b).norm() => Self::splice(i - 2, i, &[a + (reach - at)]),
            0 | 1 => Self::splice(i - 1, i + 1, &[b + (reach - at)]),
            2 => Self::splice(i - 1, i, &[reach]),
            3 => Self::splice(i - 1, i, &[at, reach, at]),
            4 => {
                let along = b - a;
                let length = along.norm();
                if length < 0.05 {
                    return None;
                }
                let half = along * ((0.05 + self.shift().abs()) / length);
                Self::splice(i - 1, i, &[reach - half, reach + half])
            }
            _ if i > 1 => Self::splice(i - 2, i + 1, &[a + (reach - at), b + (reach - at)]),
            _ => None,
        }
    }

    /// A corner, and one near it.
    fn two_near(&mut self) -> Option<(usize, usize)> {
        let i = self.corner()?;
        let at = self.path.points[i];
        let near = self.nearby.around(at);
        if near.is_empty() {
            return None;
        }
        let pick = ((self.rng.random::<f64>() * near.len() as f64) as usize).min(near.len() - 1);
        let j = near[pick] as usize;
        (j < self.path.points.len() && j != i).then_some((i, j))
    }

    fn reverse(&mut self) -> Option<Edit> {
        let (i, j) = self.two_near()?;
        if self.below(12) == 0 {
            return Some(Edit::Reverse { first: i, last: self.path.points.len() - 1 });
        }
        let (i, j) = (i.min(j), i.max(j));
        // The new pieces lead from i to j, or from i - 1 to j - 1.
        let (first, last) = if self.rng.random::<f64>() < 0.5 { (i + 1, j) } else { (i, j - 1) };
        Some(Edit::Reverse { first, last })
    }

    fn carry(&mut self) -> Option<Edit> {
        let (i, j) = self.two_near()?;
        let length = [1, 2, 2, 2, 3, 4, 4, 6, 8, 12][self.below(10)];
        // The part begins or ends at i.
        let (first, last) =
            if self.rng.random::<f64>() < 0.5 { (i, i + length - 1) } else { ((i + 1).checked_sub(length)?, i) };
        let after = if self.rng.random::<f64>() < 0.7 { j.checked_sub(1)? } else { j };
        Some(Edit::Carry { first, last, after, is_reversed: self.rng.random::<f64>() < 0.5 })
    }
}

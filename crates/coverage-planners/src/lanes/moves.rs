//! Changes of a path, with what they do to its time, its way and the floor that it sweeps.

use super::{cost::MotionTimes, free_space::FreeSpace, raster::SweptRaster};
use robovac_core::geometry::{Point, Vector};

/// Most new points of a splice.
pub(super) const MOST_NEW: usize = 5;

/// A few points.
#[derive(Debug, Clone, Copy)]
pub(super) struct FewPoints {
    points: [Point; MOST_NEW],
    count: usize,
}

/// A change of a path.
#[derive(Debug, Clone, Copy)]
pub(super) enum Edit {
    /// The points between `from` and `to` are replaced; if `to` is the number of points, all after `from`.
    Splice { from: usize, to: usize, new: FewPoints },
    /// The points from `first` to `last` come in the opposite order.
    Reverse { first: usize, last: usize },
    /// The points from `first` to `last` are carried to between point `after` and the next, and reversed if so wanted.
    Carry { first: usize, last: usize, after: usize, is_reversed: bool },
}

/// A path with what it sweeps.
pub(super) struct SweptPath<'a> {
    pub points: Vec<Point>,
    pub raster: SweptRaster,
    pub space: &'a FreeSpace,
    pub times: &'a MotionTimes,
    /// Where the robot would come from with its heading.
    before_start: Point,
    /// Seconds that each corner takes; 0 at the end.
    corner_s: Vec<f64>,
}

impl FewPoints {
    pub fn new(points: &[Point]) -> Self {
        let mut few = Self { points: [Point::origin(); MOST_NEW], count: points.len().min(MOST_NEW) };
        few.points[..few.count].copy_from_slice(&points[..few.count]);
        few
    }

    fn slice(&self) -> &[Point] {
        &self.points[..self.count]
    }
}

/// Straight pieces.
type Pieces = ([(Point, Point); MOST_NEW + 1], usize);

/// The pieces that an edit removes and adds.
pub(super) struct Exchange {
    old: Pieces,
    new: Pieces,
}

impl Exchange {
    fn removed(&self) -> &[(Point, Point)] {
        &self.old.0[..self.old.1]
    }

    fn added(&self) -> &[(Point, Point)] {
        &self.new.0[..self.new.1]
    }

    /// Whether all new pieces keep off the obstacles.
    pub fn is_free(&self, space: &FreeSpace) -> bool {
        self.added().iter().all(|stroke| self.removed().contains(stroke) || space.is_free(stroke.0, stroke.1))
    }
}

impl<'a> SweptPath<'a> {
    pub fn new(
        points: Vec<Point>,
        raster: SweptRaster,
        space: &'a FreeSpace,
        times: &'a MotionTimes,
        heading: Vector,
    ) -> Self {
        let before_start = MotionTimes::before_start(points[0], heading);
        let corner_s = vec![0.0; points.len()];
        let mut path = Self { points, raster, space, times, before_start, corner_s };
        for pair in path.points.windows(2) {
            path.raster.add(pair[0], pair[1]);
        }
        (0..path.points.len()).for_each(|i| path.update_corner(i));
        path
    }

    /// The path's time, s.
    pub fn seconds(&self) -> f64 {
        let pieces: f64 = self.points.windows(2).map(|pair| self.times.straight((pair[1] - pair[0]).norm())).sum();
        pieces + self.corner_s.iter().sum::<f64>()
    }

    /// The point before another one.
    #[inline]
    fn before(&self, i: usize) -> Point {
        if i == 0 { self.before_start } else { self.points[i - 1] }
    }

    fn update_corner(&mut self, i: usize) {
        self.corner_s[i] = match self.points.get(i + 1) {
            Some(&next) => self.times.corner(self.before(i), self.points[i], next, Some(self.space)),
            None => 0.0,
        };
    }

    /// Whether an edit can be made to this path.
    pub fn is_valid(&self, edit: &Edit) -> bool {
        let n = self.points.len();
        match *edit {
            Edit::Splice { from, to, ref new } => {
                from < to && to <= n && from < n && to - from <= MOST_NEW && (to < n || from + 1 + new.count > 1)
            }
            Edit::Reverse { first, last } => first > 0 && first < last && last < n,
            Edit::Carry { first, last, after, .. } => {
                // Neither end of the new place may be one of the old place's.
                first > 0 && first <= last && last + 1 < n && after + 1 < n && (after + 2 < first || after > last + 1)
            }
        }
    }

    /// How much longer the path takes after a valid edit that exchanges these pieces, s. Curves round new corners must fit into
    /// `space`; without one it's as if all did.
    pub fn seconds_by(&self, edit: &Edit, exchange: &Exchange, space: Option<&FreeSpace>) -> f64 {
        let pieces = |pieces: &[(Point, Point)]| -> f64 {
            pieces.iter().map(|(a, b)| self.times.straight((b - a).norm())).sum()
        };
        let mut change = pieces(exchange.added()) - pieces(exchange.removed());
        self.changed_corners(edit, |corner| change -= self.corner_s[corner]);
        self.new_corners(edit, |a, at, b| change += self.times.corner(a, at, b, space));
        change
    }

    /// Calls `tell` with the number of every corner that an edit changes.
    #[inline]
    fn changed_corners(&self, edit: &Edit, mut tell: impl FnMut(usize)) {
        match *edit {
            Edit::Splice { from, to, .. } => (from..=to.min(self.points.len() - 1)).for_each(tell),
            Edit::Reverse { first, last } => {
                for corner in [first - 1, first, last] {
                    tell(corner);
                }
                if last + 1 < self.points.len() {
                    tell(last + 1);
                }
            }
            Edit::Carry { first, last, after, .. } => {
                for corner in [first - 1, first, last + 1, after, after + 1] {
                    tell(corner);
                }
                if last > first {
                    tell(last);
                }
            }
        }
    }

    /// Calls `tell` with every corner that an edit makes: the point before it, the corner, the point behind it.
    #[inline]
    fn new_corners(&self, edit: &Edit, mut tell: impl FnMut(Point, Point, Point)) {
        let p = &self.points;
        // At the end of the path is no corner.
        let mut corner = |before: Point, at: Point, behind: usize| {
            if let Some(&behind) = p.get(behind) {
                tell(before, at, behind);
            }
        };
        match *edit {
            Edit::Splice { from, to, ref new } => {
                let (mut before, mut at) = (self.before(from), p[from]);
                for &point in new.slice().iter().chain(&p[to..(to + 2).min(p.len())]) {
                    tell(before, at, point);
                    (before, at) = (at, point);
                }
            }
            Edit::Reverse { first, last } => {
                let (a, b, y) = (p[first - 1], p[first], p[last]);
                corner(self.before(first - 1), a, last);
                corner(a, y, last - 1);
                corner(p[first + 1], b, last + 1);
                if let Some(&z) = p.get(last + 1) {
                    corner(b, z, last + 2);
                }
            }
            Edit::Carry { first, last, after, is_reversed } => {
                let (a, b) = (p[first - 1], p[last + 1]);
                corner(self.before(first - 1), a, last + 1);
                corner(a, b, last + 2);
                let (u, v) = (p[after], p[after + 1]);
                let (enter, leave) = if is_reversed { (last, first) } else { (first, last) };
                corner(self.before(after), u, enter);
                if last > first {
                    let (second, last_but_one) =
                        if is_reversed { (last - 1, first + 1) } else { (first + 1, last - 1) };
                    corner(u, p[enter], second);
                    corner(p[last_but_one], p[leave], after + 1);
                } else {
                    corner(u, p[enter], after + 1);
                }
                corner(p[leave], v, after + 2);
            }
        }
    }

    /// What a valid edit removes and adds.
    pub fn exchange(&self, edit: &Edit) -> Exchange {
        let p = &self.points;
        let mut old: Pieces = ([(Point::origin(), Point::origin()); MOST_NEW + 1], 0);
        let mut new = old;
        let push = |pieces: &mut Pieces, a: Point, b: Point| {
            pieces.0[pieces.1] = (a, b);
            pieces.1 += 1;
        };
        match *edit {
            Edit::Splice { from, to, new: ref points } => {
                for i in from..to.min(p.len() - 1) {
                    push(&mut old, p[i], p[i + 1]);
                }
                let mut at = p[from];
                for &point in points.slice().iter().chain(p.get(to)) {
                    push(&mut new, at, point);
                    at = point;
                }
            }
            Edit::Reverse { first, last } => {
                push(&mut old, p[first - 1], p[first]);
                push(&mut new, p[first - 1], p[last]);
                if let Some(&next) = p.get(last + 1) {
                    push(&mut old, p[last], next);
                    push(&mut new, p[first], next);
                }
            }
            Edit::Carry { first, last, after, is_reversed } => {
                push(&mut old, p[first - 1], p[first]);
                push(&mut old, p[last], p[last + 1]);
                push(&mut old, p[after], p[after + 1]);
                push(&mut new, p[first - 1], p[last + 1]);
                let (enter, leave) = if is_reversed { (p[last], p[first]) } else { (p[first], p[last]) };
                push(&mut new, p[after], enter);
                push(&mut new, leave, p[after + 1]);
            }
        }
        Exchange { old, new }
    }

    /// No more floor than this, m², does an exchange sweep anew.
    pub fn could_win(&self, exchange: &Exchange) -> f64 {
        self.raster.could_win(exchange.removed(), exchange.added())
    }

    /// How much more floor stays unswept after an exchange, m²; infinite if more than `most` is lost.
    pub fn missed_by(&mut self, exchange: &Exchange, most: f64) -> f64 {
        self.raster.missed_by(exchange.removed(), exchange.added(), most)
    }

    /// Makes a valid edit, the last one for which [`Self::missed_by`] was asked.
    pub fn apply(&mut self, edit: &Edit) {
        self.raster.make_exchange();
        match *edit {
            Edit::Splice { from, to, ref new } => {
                self.points.splice(from + 1..to, new.slice().iter().copied());
                self.corner_s.splice(from + 1..to, new.slice().iter().map(|_| 0.0));
                (from..(from + new.count + 2).min(self.points.len())).for_each(|i| self.update_corner(i));
            }
            Edit::Reverse { first, last } => {
                self.points[first..=last].reverse();
                self.corner_s[first..=last].reverse();
                for i in [first - 1, first, last, (last + 1).min(self.points.len() - 1)] {
                    self.update_corner(i);
                }
            }
            Edit::Carry { first, last, after, is_reversed } => {
                if is_reversed {
                    self.points[first..=last].reverse();
                    self.corner_s[first..=last].reverse();
                }
                let length = last - first + 1;
                // The part goes from one end of the range to the other; what lies between moves the other way.
                let (range, start, gap) = if after < first {
                    (after + 1..=last, after + 1, last + 1)
                } else {
                    (first..=after, after + 1 - length, first)
                };
                let places = if after < first { length } else { after + 1 - first - length };
                self.points[range.clone()].rotate_right(places);
                self.corner_s[range].rotate_right(places);
                for i in [start - 1, start, start + length - 1, start + length, gap - 1, gap] {
                    self.update_corner(i);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{super::curves::CurveTimes, *};
    use rand::RngExt;
    use robovac_core::{coverage::ReachableFloor, floor_plan::Sketch, rng::seeded, robot::model};

    #[test]
    fn edits_cost_and_sweep_what_the_whole_path_says() {
        let plan = Sketch::open(3.0, 2.0, 0.05).finish("", "");
        let robot = model("roomba600").unwrap();
        let floor = ReachableFloor::new(&plan, robot, None).unwrap();
        let space = FreeSpace::new(floor.limits(), 0.18);
        let mut rng = seeded(1, 0);
        let mut at = |_| Point::new(rng.random_range(0.2..2.8), rng.random_range(0.2..1.8));
        let points: Vec<Point> = (0..14).map(&mut at).collect();
        let more: Vec<Point> = (0..3).map(&mut at).collect();
        let raster = SweptRaster::new(&floor, &[Vector::new(1.0, 0.0)]);
        let heading = Vector::new(0.6, 0.8);
        let mut edits = Vec::new();
        for a in 0..14 {
            for b in 0..=14 {
                for count in 0..=3 {
                    edits.push(Edit::Splice { from: a, to: b, new: FewPoints::new(&more[..count]) });
                }
                edits.push(Edit::Reverse { first: a, last: b });
                for after in 0..14 {
                    edits.extend([false, true].map(|is_reversed| Edit::Carry {
                        first: a,
                        last: b,
                        after,
                        is_reversed,
                    }));
                }
            }
        }
        // A robot that stops at corners, and one that rounds them.
        for curves in [None, CurveTimes::of(robot)] {
            let times = MotionTimes::of(robot, curves);
            let path = |points: Vec<Point>| SweptPath::new(points, raster.clone(), &space, &times, heading);
            let mut kinds = [0; 3];
            for edit in &edits {
                let mut path = path(points.clone());
                if !path.is_valid(edit) {
                    continue;
                }
                let before = path.seconds();
                let exchange = path.exchange(edit);
                let by = path.seconds_by(edit, &exchange, Some(&space));
                assert!(
                    path.seconds_by(edit, &exchange, None) <= by + 1e-9,
                    "{edit:?}: fewer curves fit than if all did"
                );
                let left = path.raster.unswept_area() + path.missed_by(&exchange, 1e9);
                path.apply(edit);
                assert!((path.raster.unswept_area() - left).abs() < 1e-9, "{edit:?}");
                let after = path.seconds();
                assert!((after - before - by).abs() < 1e-9, "{edit:?}: {by} s, not {}", after - before);
                let fresh = SweptPath::new(path.points.clone(), raster.clone(), &space, &times, heading);
                assert!((after - fresh.seconds()).abs() < 1e-9, "{edit:?}");
                assert!((after - times.path(&path.points, heading, Some(&space))).abs() < 1e-9);
                assert_eq!(path.raster.unswept_area(), fresh.raster.unswept_area(), "{edit:?}");
                kinds[match edit {
                    Edit::Splice { .. } => 0,
                    Edit::Reverse { .. } => 1,
                    Edit::Carry { .. } => 2,
                }] += 1;
            }
            assert!(kinds.iter().all(|&count| count > 50), "{kinds:?}");
        }
    }
}

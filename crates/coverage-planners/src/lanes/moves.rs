//! Changes of a path, with what they do to its time, its way and the floor that it sweeps.

use super::{cost::MotionTimes, free_space::FreeSpace, raster::SweptRaster};
use robovac_core::geometry::{Point, Vector};

/// Most new points of a splice.
pub(super) const MOST_NEW: usize = 8;

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
    pub times: MotionTimes,
    pub heading: Vector,
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
        times: MotionTimes,
        heading: Vector,
    ) -> Self {
        let mut path = Self { points, raster, space, times, heading };
        for pair in path.points.windows(2) {
            path.raster.add(pair[0], pair[1]);
        }
        path
    }

    /// The path's time, s.
    pub fn seconds(&self) -> f64 {
        self.times.path(&self.points, self.heading)
    }

    /// The point before another one; before the first, one from which the robot would come with its heading.
    #[inline]
    fn before(&self, i: usize) -> Point {
        if i == 0 { self.points[0] - self.heading } else { self.points[i - 1] }
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

    /// How much longer the path takes after a valid edit, s.
    pub fn seconds_by(&self, edit: &Edit) -> f64 {
        let p = &self.points;
        let times = &self.times;
        match *edit {
            Edit::Splice { from, to, ref new } => {
                let mut old = Timed::new(times, self.before(from), p[from]);
                let mut made = old;
                p[from + 1..to].iter().for_each(|&point| old.go_to(point));
                new.slice().iter().for_each(|&point| made.go_to(point));
                for &point in &p[to..(to + 2).min(p.len())] {
                    old.go_to(point);
                    made.go_to(point);
                }
                made.seconds - old.seconds
            }
            Edit::Reverse { first, last } => {
                let (a, b) = (p[first - 1], p[first]);
                let (y, z) = (p[last], p.get(last + 1).copied());
                let mut change = times.straight((y - a).norm()) - times.straight((b - a).norm());
                let into = a - self.before(first - 1);
                change += times.turn(into, y - a) - times.turn(into, b - a);
                // Directions inside the part are those of the path now.
                let (begin, end) = (p[first + 1] - b, y - p[last - 1]);
                change += times.turn(y - a, -end) - times.turn(b - a, begin);
                if let Some(z) = z {
                    change += times.straight((z - b).norm()) - times.straight((z - y).norm());
                    change += times.turn(-begin, z - b) - times.turn(end, z - y);
                    if let Some(&next) = p.get(last + 2) {
                        change += times.turn(z - b, next - z) - times.turn(z - y, next - z);
                    }
                }
                change
            }
            Edit::Carry { first, last, after, is_reversed } => {
                let (a, b) = (p[first - 1], p[last + 1]);
                let (c, d) = (p[first], p[last]);
                let (u, v) = (p[after], p[after + 1]);
                let mut old = Timed::new(times, self.before(first - 1), a);
                let mut made = old;
                made.go_to(b);
                old.go_to(c);
                let mut inner = Timed::new(times, a, c);
                if last > first {
                    // The directions at both ends of the part.
                    inner = Timed::new(times, p[last - 1], d);
                    old.turn_only(p[first + 1] - c);
                }
                inner.go_to(b);
                if let Some(&next) = p.get(last + 2) {
                    inner.go_to(next);
                    made.go_to(next);
                    // Both count the piece after it.
                }
                let mut change = made.seconds - old.seconds - inner.seconds;
                let mut there = Timed::new(times, self.before(after), u);
                there.go_to(v);
                let mut way = Timed::new(times, self.before(after), u);
                let (enter, leave) = if is_reversed { (d, c) } else { (c, d) };
                way.go_to(enter);
                let mut out = Timed::new(times, u, enter);
                if last > first {
                    let (begin, end) = if is_reversed {
                        (p[last - 1] - d, c - p[first + 1])
                    } else {
                        (p[first + 1] - c, d - p[last - 1])
                    };
                    way.turn_only(begin);
                    out = Timed { times, at: leave, direction: end, seconds: 0.0 };
                }
                out.go_to(v);
                if let Some(&next) = p.get(after + 2) {
                    there.go_to(next);
                    out.go_to(next);
                }
                change += way.seconds + out.seconds - there.seconds;
                change
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

    /// Makes a valid edit, and counts what it exchanges.
    pub fn apply(&mut self, edit: &Edit, exchange: &Exchange) {
        self.raster.exchange(exchange.removed(), exchange.added());
        match *edit {
            Edit::Splice { from, to, ref new } => {
                self.points.splice(from + 1..to, new.slice().iter().copied());
            }
            Edit::Reverse { first, last } => self.points[first..=last].reverse(),
            Edit::Carry { first, last, after, is_reversed } => {
                if is_reversed {
                    self.points[first..=last].reverse();
                }
                let length = last - first + 1;
                if after < first {
                    self.points[after + 1..=last].rotate_right(length);
                } else {
                    self.points[first..=after].rotate_left(length);
                }
            }
        }
    }
}

/// Time along points, with the turns between them.
#[derive(Clone, Copy)]
struct Timed<'t> {
    times: &'t MotionTimes,
    at: Point,
    direction: Vector,
    seconds: f64,
}

impl<'t> Timed<'t> {
    /// At `at`, having come straight from `before`.
    #[inline]
    fn new(times: &'t MotionTimes, before: Point, at: Point) -> Self {
        Self { times, at, direction: at - before, seconds: 0.0 }
    }

    #[inline]
    fn go_to(&mut self, point: Point) {
        let step = point - self.at;
        self.turn_only(step);
        self.seconds += self.times.straight(step.norm());
        self.at = point;
    }

    #[inline]
    fn turn_only(&mut self, direction: Vector) {
        self.seconds += self.times.turn(self.direction, direction);
        self.direction = direction;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let raster = SweptRaster::new(&floor, Vector::new(1.0, 0.0));
        let heading = Vector::new(0.6, 0.8);
        let path = || SweptPath::new(points.clone(), raster.clone(), &space, MotionTimes::of(robot), heading);
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
        let mut kinds = [0; 3];
        for edit in edits {
            let mut path = path();
            if !path.is_valid(&edit) {
                continue;
            }
            let before = path.seconds();
            let by = path.seconds_by(&edit);
            let exchange = path.exchange(&edit);
            let left = path.raster.unswept_area() + path.missed_by(&exchange, 1e9);
            path.apply(&edit, &exchange);
            assert!((path.raster.unswept_area() - left).abs() < 1e-9, "{edit:?}");
            assert!((path.seconds() - before - by).abs() < 1e-9, "{edit:?}: {by} s, not {}", path.seconds() - before);
            let fresh = SweptPath::new(path.points.clone(), raster.clone(), &space, path.times, heading);
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

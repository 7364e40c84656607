//! A path with its speeds.

use super::{
    DriveLimits, RoundedLine, Stretch,
    profile::{squares, time},
    round::Part,
};
use crate::geometry::{Point, Pose, Vector, difference};

/// A moment of a trajectory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Knot {
    /// Time since the start, s.
    pub time_s: f64,
    /// Way since the start, m.
    pub distance_m: f64,
    /// Pose then.
    pub pose: Pose,
    /// Curvature, 1/m, positive to the left; linear from knot to knot.
    pub curvature: f64,
    /// Speed of the middle between the wheels, m/s; its square is linear in the way from knot to knot.
    pub speed: f64,
    /// Number of the corner of the line that the robot drives to or round.
    pub corner: usize,
}

/// Poses and speeds of a robot along a rounded line, from rest to rest. Two knots in a row in the same place are the begin and
/// the end of a turn on the spot.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trajectory {
    knots: Vec<Knot>,
    /// Seconds of all turns on the spot.
    turning_s: f64,
}

impl Trajectory {
    /// The fastest trajectory along `line` within `limits`.
    pub fn new(line: &RoundedLine, limits: &DriveLimits) -> Self {
        let mut trajectory = Self::default();
        let mut run: Vec<Stretch> = Vec::new();
        for part in &line.parts {
            match *part {
                Part::Go(stretch) => run.push(stretch),
                Part::Turn(at, turn, corner) => {
                    trajectory.go(&run, limits, at);
                    run.clear();
                    trajectory.turn(at, turn, corner, limits);
                }
            }
        }
        trajectory.go(&run, limits, line.end.unwrap_or(Pose::new(0.0, 0.0, 0.0)));
        trajectory
    }

    /// The same moments, as they were told elsewhere.
    pub fn of_knots(knots: Vec<Knot>) -> Self {
        let pairs = knots.windows(2).filter(|pair| pair[0].distance_m == pair[1].distance_m);
        let turning_s = pairs.map(|pair| pair[1].time_s - pair[0].time_s).sum();
        Self { knots, turning_s }
    }

    /// The same in the frame in which the present one's origin is at `origin`.
    pub fn in_frame(&self, origin: Pose) -> Self {
        let moved = |knot: &Knot| {
            let at = origin.to_world(knot.pose.position());
            Knot { pose: Pose::new(at.x, at.y, knot.pose.heading + origin.heading), ..*knot }
        };
        Self { knots: self.knots.iter().map(moved).collect(), turning_s: self.turning_s }
    }

    /// Adds a run from rest to rest that ends at `end`.
    fn go(&mut self, run: &[Stretch], limits: &DriveLimits, end: Pose) {
        let Some(last) = run.last() else { return };
        let found = squares(run, limits, [0.0; 2]);
        let (mut now, mut way) = self.now();
        for (i, stretch) in run.iter().enumerate() {
            self.knots.push(Knot {
                time_s: now,
                distance_m: way,
                pose: stretch.start,
                curvature: stretch.curvature[0],
                speed: found[i].sqrt(),
                corner: stretch.corner,
            });
            now += time(stretch.length, found[i], found[i + 1]);
            way += stretch.length;
        }
        let end = Pose { heading: last.start.heading, ..end };
        self.knots.push(Knot {
            time_s: now,
            distance_m: way,
            pose: end,
            curvature: 0.0,
            speed: 0.0,
            corner: last.corner,
        });
    }

    fn turn(&mut self, at: Pose, turn: f64, corner: usize, limits: &DriveLimits) {
        let (now, way) = self.now();
        let takes = limits.turn_time(turn);
        let after = Pose::new(at.x, at.y, at.heading + turn);
        for (time_s, pose) in [(now, at), (now + takes, after)] {
            self.knots.push(Knot { time_s, distance_m: way, pose, curvature: 0.0, speed: 0.0, corner });
        }
        self.turning_s += takes;
    }

    /// Time and way so far.
    fn now(&self) -> (f64, f64) {
        self.knots.last().map_or((0.0, 0.0), |knot| (knot.time_s, knot.distance_m))
    }

    /// All moments at which something changes, in order.
    pub fn knots(&self) -> &[Knot] {
        &self.knots
    }

    /// Seconds from rest to rest.
    pub fn duration_s(&self) -> f64 {
        self.now().0
    }

    /// Seconds of all turns on the spot.
    pub fn turning_s(&self) -> f64 {
        self.turning_s
    }

    /// The way of the middle between the wheels, points in metres: what the tool sweeps along.
    pub fn points(&self) -> Vec<Point> {
        let mut points: Vec<Point> = Vec::with_capacity(self.knots.len());
        for point in self.knots.iter().map(|knot| knot.pose.position()) {
            // Points on a straight piece aren't needed.
            if let [.., before, last] = points[..] {
                let (a, b): (Vector, Vector) = (last - before, point - last);
                if a.perp(&b).abs() < 1e-12 && a.dot(&b) >= 0.0 {
                    points.pop();
                }
            }
            points.push(point);
        }
        points
    }

    /// Sum of all turns, in curves and on the spot, rad.
    pub fn turned_rad(&self) -> f64 {
        let turned = |pair: &[Knot]| difference(pair[0].pose.heading, pair[1].pose.heading).abs();
        self.knots.windows(2).map(turned).sum()
    }

    /// Length, m.
    pub fn length_m(&self) -> f64 {
        self.now().1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        math,
        rng::seeded,
        robot::model,
        trajectory::{CornerShape, Rounding},
    };
    use rand::RngExt;

    fn limits() -> DriveLimits {
        DriveLimits::of(model("roomba600").unwrap()).unwrap()
    }

    /// A random line with as much rounding as fits, and with none.
    fn lines(seed: u64) -> [RoundedLine; 2] {
        let mut rng = seeded(seed, 3);
        let mut line = vec![Point::origin()];
        let mut heading: f64 = 0.0;
        for _ in 0..30 {
            heading += rng.random_range(-math::PI..math::PI);
            let length = if rng.random_bool(0.3) { 0.165 } else { rng.random_range(0.05..1.5) };
            let last = *line.last().unwrap();
            line.push(Point::new(last.x + length * math::cos(heading), last.y + length * math::sin(heading)));
        }
        let turns = RoundedLine::turns(&line);
        let mut roundings = vec![Rounding::Stop; line.len()];
        let room = |i: usize| 0.49 * (line[i + 1] - line[i]).norm();
        let mut i = 1;
        while i + 1 < line.len() {
            let pair = (i + 2 < line.len())
                .then(|| CornerShape::u_turn([turns[i], turns[i + 1]], (line[i + 1] - line[i]).norm()))
                .flatten()
                .filter(|[a, b]| {
                    a.tangents[0] < room(i - 1)
                        && b.tangents[1] < room(i + 1)
                        && a.tangents[1] > 0.0
                        && b.tangents[0] > 0.0
                });
            if pair.is_some() && rng.random_bool(0.7) {
                (roundings[i], roundings[i + 1]) = (Rounding::First, Rounding::Second);
                i += 2;
                continue;
            }
            if rng.random_bool(0.8) {
                roundings[i] = Rounding::Alone(room(i - 1).min(room(i)));
            }
            i += 1;
        }
        [RoundedLine::new(&line, 1.0, &roundings), RoundedLine::new(&line, 1.0, &[])]
    }

    #[test]
    fn wheels_never_exceed_speed_or_acceleration() {
        let limits = limits();
        for seed in 0..60 {
            let [rounded, _] = lines(seed);
            let trajectory = Trajectory::new(&rounded, &limits);
            for pair in trajectory.knots().windows(2) {
                let [a, b] = [pair[0], pair[1]];
                let wheels =
                    |knot: Knot| [-1.0, 1.0].map(|side| knot.speed * (1.0 + side * limits.half_base * knot.curvature));
                for (from, to) in wheels(a).into_iter().zip(wheels(b)) {
                    assert!(to.abs() <= limits.wheel_speed + 1e-9, "seed {seed}: {to} m/s");
                    let takes = b.time_s - a.time_s;
                    assert!(
                        (to - from).abs() <= limits.acceleration * takes * (1.0 + 1e-6) + 1e-9,
                        "seed {seed}: {from} to {to} in {takes}"
                    );
                }
                assert!(b.speed <= limits.speed + 1e-12 && b.time_s >= a.time_s);
            }
        }
    }

    #[test]
    fn rounding_never_takes_longer_than_stopping() {
        let limits = limits();
        let (mut smooth, mut stopped) = (0.0, 0.0);
        for seed in 0..60 {
            let [rounded, corners] = lines(seed).map(|line| Trajectory::new(&line, &limits).duration_s());
            assert!(rounded <= corners + 1e-9, "seed {seed}: {rounded} {corners}");
            smooth += rounded;
            stopped += corners;
        }
        assert!(smooth < 0.85 * stopped, "{smooth} {stopped}");
    }

    #[test]
    fn without_rounding_the_time_is_that_of_stop_turn_go() {
        let robot = model("roomba600").unwrap();
        let limits = DriveLimits { acceleration: robot.acceleration, ..limits() };
        let line = [[0.0, 0.0], [3.0, 0.0], [3.0, 0.12], [0.5, 0.12]].map(|[x, y]| Point::new(x, y));
        let trajectory = Trajectory::new(&RoundedLine::new(&line, 0.0, &[]), &limits);
        let straight: f64 = [3.0, 0.12, 2.5].map(|m| robot.straight_time(m)).iter().sum();
        let expected = straight + 2.0 * limits.turn_time(math::FRAC_PI_2);
        assert!((trajectory.duration_s() - expected).abs() < 1e-3 * expected, "{} {expected}", trajectory.duration_s());
        assert!((trajectory.length_m() - 5.62).abs() < 1e-9);
        let told = Trajectory::of_knots(trajectory.knots().to_vec());
        assert!((told.turning_s() - trajectory.turning_s()).abs() < 1e-9 && told.knots() == trajectory.knots());
    }

    /// Nothing faster: at every moment a wheel is at a limit, or the middle at its top speed.
    #[test]
    fn a_limit_is_reached_at_every_moment() {
        let limits = limits();
        let line = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.6, 1.3]].map(|[x, y]| Point::new(x, y));
        let roundings = [Rounding::Stop, Rounding::Alone(0.15), Rounding::Alone(0.1), Rounding::Stop];
        let trajectory = Trajectory::new(&RoundedLine::new(&line, 0.0, &roundings), &limits);
        let mut idle = 0.0;
        for pair in trajectory.knots().windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let takes = b.time_s - a.time_s;
            let at_speed = [a, b].iter().any(|knot| knot.speed > 0.99 * limits.fastest(knot.curvature));
            let wheels = [-1.0, 1.0].map(|side| {
                let wheel = |knot: Knot| knot.speed * (1.0 + side * limits.half_base * knot.curvature);
                ((wheel(b) - wheel(a)) / takes).abs()
            });
            if !at_speed && wheels[0].max(wheels[1]) < 0.9 * limits.acceleration {
                idle += takes;
            }
        }
        assert!(idle < 0.05 * trajectory.duration_s(), "{idle} s of {} s", trajectory.duration_s());
    }

    #[test]
    fn headings_turn_as_the_curvature_says() {
        for seed in 0..5 {
            let [rounded, _] = lines(seed);
            let trajectory = Trajectory::new(&rounded, &limits());
            let mut curves = 0;
            for pair in trajectory.knots().windows(2) {
                let way = pair[1].distance_m - pair[0].distance_m;
                if way > 0.0 {
                    let turned = 0.5 * way * (pair[0].curvature + pair[1].curvature);
                    let real = difference(pair[0].pose.heading, pair[1].pose.heading);
                    assert!((turned - real).abs() < 1e-6, "{turned} {real}");
                    curves += usize::from(turned.abs() > 1e-6);
                }
            }
            assert!(curves > 0, "seed {seed}: it never turns on its way");
        }
    }
}

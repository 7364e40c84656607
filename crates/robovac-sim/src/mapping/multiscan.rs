//! A multiscan: observations combined over a stretch of the path.
//!
//! Six short-range beams see too little at once to localise the robot. Beevers & Huang (2006, SLAM with sparse sensing,
//! ICRA) gather such readings over a stretch of the way, as long as odometry is accurate, and extract lines from them
//! as from one scan. So does this module. The distance of an echo depends on the angle of incidence, which a line
//! determines: so each line is tried with the distances that it implies, and the one that explains most echoes is
//! chosen, then the next (RANSAC, Fischler & Bolles 1981, with pairs picked in turn and not at random).

use super::{
    contact_lines::{Contact, ContactLine, contact_lines},
    observation::{BEAMS, COSINE, ContactPoint, Observation, REFLECTANCE, SensorModel},
    reckoning::Reckoning,
};
use robovac_core::{
    geometry::{Point, Pose, Vector, difference},
    math,
};

/// Farthest echo that is taken for a point of a boundary, m from the body's edge: beyond, unknown reflectance and angle
/// make it uncertain by centimetres.
const FAR: f64 = 0.12;
/// Farthest echo that counts without a line, m.
const NEAR: f64 = 0.05;
/// Distance of the points that a line is tried through, m.
const PAIR: (f64, f64) = (0.05, 0.3);
/// Lines that are tried for each that is found, and most that are found.
const TRIES: usize = 48;
const MOST_LINES: usize = 6;
/// Echoes that make a line, and how far they may be off it: m, and as a share of the distance.
const LEAST_ECHOES: usize = 5;
const OFF: (f64, f64) = (0.006, 0.05);
/// Widest gap in a line, m.
const GAP: f64 = 0.15;
/// Shortest line, and one long enough to be a wall, m.
const LINE: f64 = 0.06;
const WALL: f64 = 0.2;
/// Least cosine of the angle at which light meets a line.
const STEEP: f64 = 0.3;
/// Least uncertainty of a wall's direction, rad, as the way along it isn't quite straight.
const WALL_DEVIATION: f64 = 0.004;
/// Error of a contact's place, m: the play of the bumper and what odometry drifts on the way to the next.
const CONTACT: f64 = 0.003;
/// Distance of points that are added between contacts on a wall, m.
const BETWEEN: f64 = 0.04;
/// Distance of a sensor's source behind the body's edge, m, as in the law of light.
const SOURCE: f64 = 0.017;

/// A beam's echo, and the robot's pose at the time.
#[derive(Debug, Clone, Copy)]
struct Sighting {
    light: f64,
    /// Start of the beam on the body's edge, and its direction.
    edge: Point,
    sight: Vector,
    /// Distance without knowledge of the surface, m.
    distance: f64,
    deviation: f64,
}

/// Observations since the start of the stretch, in the frame of its first pose.
#[derive(Debug, Clone, Default)]
pub(super) struct Multiscan {
    sightings: Vec<Sighting>,
    contacts: Vec<(Pose, ContactPoint)>,
}

/// A point of a boundary, in the frame of the end of the stretch.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoundaryPoint {
    pub at: Point,
    /// Towards the robot.
    pub normal: Vector,
    /// Whether the normal is that of the surface, or just the direction from which it was seen.
    pub is_oriented: bool,
    /// Standard deviations along the normal: its own, and the one shared with its group, m.
    pub own: f64,
    pub shared: f64,
    /// Points of one line have the same number.
    pub group: usize,
    /// Middle of the robot, for contacts whose direction isn't known: their distance to a surface is that of the middle.
    pub middle: Option<Point>,
}

/// A straight wall.
#[derive(Debug, Clone, Copy)]
pub(super) struct WallLine {
    /// Direction in the frame of the end of the stretch, rad; ambiguous by half a turn.
    pub direction: f64,
    /// Its standard deviation, rad.
    pub deviation: f64,
    /// Length, m.
    pub length: f64,
}

/// Points and walls of a multiscan.
#[derive(Debug, Clone, Default)]
pub(super) struct Features {
    pub points: Vec<BoundaryPoint>,
    /// Points on walls between contacts, which weren't touched themselves.
    pub between: Vec<BoundaryPoint>,
    pub walls: Vec<WallLine>,
}

impl Multiscan {
    /// Adds the observations at a pose.
    pub fn add(&mut self, from: Pose, seen: &Observation, sensors: &SensorModel) {
        for (beam, echo) in seen.echoes.iter().enumerate().take(BEAMS) {
            let Some(echo) = echo.filter(|echo| echo.distance < FAR) else { continue };
            let sight = turned(sensors.direction(beam), from.heading);
            self.sightings.push(Sighting {
                light: echo.light,
                edge: from.position() + sight * sensors.radius(),
                sight,
                distance: echo.distance,
                deviation: echo.deviation,
            });
        }
        self.contacts.extend(seen.contact.map(|contact| (from, contact)));
    }

    /// Points and walls, in the frame of the end of `way`.
    pub fn features(mut self, way: &Reckoning, sensors: &SensorModel) -> Features {
        let mut features = Features::default();
        let mut lines: Vec<StraightLine> = Vec::new();
        while lines.len() < MOST_LINES {
            let Some(line) = self.find_line(sensors) else { break };
            let (on, off): (Vec<_>, Vec<_>) = self.sightings.iter().partition(|s| line.explains(s));
            self.sightings = off;
            features.add_line(&line, &on, sensors);
            lines.push(line);
        }
        features.add_lone(&self.sightings);
        if sensors.is_bumper_alone() {
            let (lines, alone) = contact_lines(&self.contacts, sensors.radius());
            for line in &lines {
                features.add_contact_line(line);
            }
            for contact in &alone {
                features.add_vague_contact(contact, sensors.radius());
            }
        } else {
            for (from, contact) in &self.contacts {
                features.add_contact(*from, *contact, &lines, sensors.radius());
            }
        }
        for point in features.points.iter_mut().chain(&mut features.between) {
            point.at = way.seen_from_here(point.at);
            point.normal = turned(point.normal, -way.at.heading);
            point.middle = point.middle.map(|middle| way.seen_from_here(middle));
        }
        for wall in &mut features.walls {
            wall.direction -= way.at.heading;
        }
        features
    }

    /// The line that explains most observations.
    fn find_line(&self, sensors: &SensorModel) -> Option<StraightLine> {
        let seen = &self.sightings;
        if seen.len() < LEAST_ECHOES {
            return None;
        }
        let mut best: Option<(usize, StraightLine)> = None;
        for i in 0..TRIES {
            let first = &seen[i * seen.len() / TRIES];
            let is_apart =
                |s: &&Sighting| (PAIR.0..PAIR.1).contains(&(s.point(COSINE.0) - first.point(COSINE.0)).norm());
            let second = seen.iter().cycle().skip(i * 29 % seen.len()).take(seen.len()).find(is_apart);
            let Some(line) = second.and_then(|second| StraightLine::between(first, second)) else { continue };
            let count = seen.iter().filter(|s| line.explains(s)).count();
            if count >= LEAST_ECHOES && best.is_none_or(|(most, _)| count > most) {
                best = Some((count, line));
            }
        }
        let mut line = best?.1;
        for _ in 0..3 {
            let on: Vec<Sighting> = seen.iter().copied().filter(|s| line.explains(s)).collect();
            line = StraightLine::through(&on, &line, sensors)?;
        }
        let count = seen.iter().filter(|s| line.explains(s)).count();
        (count >= LEAST_ECHOES && line.length >= LINE).then_some(line)
    }
}

impl Features {
    fn next_group(&self) -> usize {
        self.points.last().map_or(0, |point| point.group + 1)
    }

    fn add_line(&mut self, line: &StraightLine, on: &[Sighting], sensors: &SensorModel) {
        let group = self.next_group();
        let own = line.off.max(0.002) + 0.002;
        let mut points: Vec<BoundaryPoint> = Vec::with_capacity(on.len());
        for sighting in on {
            let Some(echo) = sensors.echo(sighting.light, line.cosine(sighting), 0.05) else { continue };
            let at = sighting.edge + sighting.sight * echo.distance;
            let shared = 0.5 * REFLECTANCE.1 * (echo.distance + SOURCE);
            points.push(BoundaryPoint { at, normal: line.normal, is_oriented: true, own, shared, group, middle: None });
        }
        // Echoes of several beams come from all over the line.
        points.sort_by(|a, b| line.along(a.at).total_cmp(&line.along(b.at)));
        if line.length >= WALL {
            let echoes = (points.len() as f64).min(12.0);
            let fit = line.off.max(0.002) * (12.0 / echoes).sqrt() / line.length;
            let deviation = (fit * fit + line.tilt * line.tilt + WALL_DEVIATION * WALL_DEVIATION).sqrt();
            let direction = math::atan2(-line.normal.x, line.normal.y);
            self.walls.push(WallLine { direction, deviation, length: line.length });
        }
        self.points.extend(points);
    }

    /// Adds points without a line: only those near enough to be accurate, and one per place.
    fn add_lone(&mut self, seen: &[Sighting]) {
        let mut near: Vec<&Sighting> = seen.iter().filter(|s| s.distance < NEAR).collect();
        near.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let mut taken: Vec<Point> = Vec::new();
        for sighting in near {
            let at = sighting.edge + sighting.sight * sighting.distance;
            if taken.iter().any(|other| (other - at).norm() < 0.06) {
                continue;
            }
            taken.push(at);
            let (group, normal) = (self.next_group(), -sighting.sight);
            let own = sighting.deviation;
            self.points.push(BoundaryPoint { at, normal, is_oriented: false, own, shared: 0.0, group, middle: None });
        }
    }

    /// Adds a contact. The direction is that of a line, if there is one.
    fn add_contact(&mut self, from: Pose, contact: ContactPoint, lines: &[StraightLine], radius: f64) {
        let direction = from.heading + contact.direction;
        let by_line = lines.iter().find(|line| {
            let off = difference(math::atan2(-line.normal.y, -line.normal.x), direction);
            let touched = from.position() - line.normal * radius;
            off.abs() < 0.35 && line.normal.dot(&(touched - line.middle)).abs() < 0.02
        });
        let (sin, cos) = math::sin_cos(direction);
        let normal = by_line.map_or(Vector::new(-cos, -sin), |line| line.normal);
        let group = self.next_group();
        self.points.push(BoundaryPoint {
            at: from.position() - normal * radius,
            normal,
            is_oriented: by_line.is_some() || contact.deviation < 0.15,
            own: if by_line.is_some() { 0.003 } else { 0.003 + 0.06 * contact.deviation },
            shared: 0.0,
            group,
            middle: None,
        });
    }

    /// Adds a wall that contacts touch.
    fn add_contact_line(&mut self, line: &ContactLine) {
        let group = self.next_group();
        let point = |at| BoundaryPoint {
            at,
            normal: line.normal,
            is_oriented: true,
            own: CONTACT + line.off,
            shared: CONTACT,
            group,
            middle: None,
        };
        self.points.extend(line.points.iter().map(|&at| point(at)));
        for pair in line.points.windows(2) {
            let way = pair[1] - pair[0];
            let pieces = (way.norm() / BETWEEN).ceil();
            self.between.extend((1..pieces as u32).map(|i| point(pair[0] + way * (f64::from(i) / pieces))));
        }
        if line.length >= WALL {
            let fit = (line.off + CONTACT) * 3.5 / ((line.points.len() as f64).sqrt() * line.length);
            let deviation = fit.max(WALL_DEVIATION);
            let direction = math::atan2(-line.normal.x, line.normal.y);
            self.walls.push(WallLine { direction, deviation, length: line.length });
        }
    }

    /// Adds a contact whose direction only the switches tell.
    fn add_vague_contact(&mut self, (from, contact): &Contact, radius: f64) {
        let (sin, cos) = math::sin_cos(from.heading + contact.direction);
        let normal = Vector::new(-cos, -sin);
        let (middle, group, own) = (from.position(), self.next_group(), 2.0 * CONTACT);
        let at = middle - normal * radius;
        self.points.push(BoundaryPoint {
            at,
            normal,
            is_oriented: false,
            own,
            shared: 0.0,
            group,
            middle: Some(middle),
        });
    }
}

impl Sighting {
    /// Distance for an angle of incidence with that cosine; near enough for a first estimate.
    #[inline]
    fn distance_at(&self, cosine: f64) -> f64 {
        (self.distance + SOURCE) * (cosine / COSINE.0).sqrt() - SOURCE
    }

    fn point(&self, cosine: f64) -> Point {
        self.edge + self.sight * self.distance_at(cosine)
    }
}

/// A straight line.
#[derive(Debug, Clone, Copy)]
struct StraightLine {
    middle: Point,
    /// Unit vector towards the robot.
    normal: Vector,
    /// From end to end, m; 0 while it is being tried.
    length: f64,
    /// Root mean square of its points' distances, m.
    off: f64,
    /// Possible error of its direction due to the unknown reflectance, rad.
    tilt: f64,
}

impl StraightLine {
    /// Through two echoes, whose distances depend on it.
    fn between(first: &Sighting, second: &Sighting) -> Option<Self> {
        let mut cosines = [COSINE.0; 2];
        let mut line = None;
        for _ in 0..3 {
            let [a, b] = [first.point(cosines[0]), second.point(cosines[1])];
            let along = (b - a).try_normalize(1e-3)?;
            let normal = Vector::new(-along.y, along.x);
            let normal = if normal.dot(&first.sight) > 0.0 { -normal } else { normal };
            let found = Self { middle: nalgebra::center(&a, &b), normal, length: 0.0, off: 0.0, tilt: 0.0 };
            cosines = [first, second].map(|s| found.cosine(s));
            if cosines.iter().any(|&cosine| cosine < STEEP) {
                return None;
            }
            line = Some(found);
        }
        line
    }

    /// The least-squares line of echoes; `before` gives their angles of incidence.
    fn through(seen: &[Sighting], before: &Self, sensors: &SensorModel) -> Option<Self> {
        let mut points = Vec::with_capacity(seen.len());
        for sighting in seen {
            let cosine = before.cosine(sighting);
            let echo = sensors.echo(sighting.light, cosine, 0.05)?;
            let bias = 0.5 * REFLECTANCE.1 * (echo.distance + SOURCE) * cosine;
            points.push((sighting.edge + sighting.sight * echo.distance, bias));
        }
        let count = points.len() as f64;
        let middle = Point::from(points.iter().fold(Vector::zeros(), |sum, (point, _)| sum + point.coords) / count);
        let [xx, xy, yy] = points.iter().fold([0.0; 3], |[xx, xy, yy], (point, _)| {
            let off = point - middle;
            [xx + off.x * off.x, xy + off.x * off.y, yy + off.y * off.y]
        });
        let (sin, cos) = math::sin_cos(0.5 * math::atan2(2.0 * xy, xx - yy));
        let normal = Vector::new(-sin, cos);
        let normal = if normal.dot(&before.normal) < 0.0 { -normal } else { normal };
        let mut line = Self { middle, normal, length: 0.0, off: 0.0, tilt: 0.0 };
        let mut along: Vec<f64> = points.iter().map(|(point, _)| line.along(*point)).collect();
        let spread: f64 = along.iter().map(|t| t * t).sum();
        let lean: f64 = points.iter().zip(&along).map(|((_, bias), t)| bias * t).sum();
        line.tilt = if spread > 1e-9 { (lean / spread).abs() } else { 1.0 };
        let heights = points.iter().map(|(point, _)| normal.dot(&(point - middle)));
        let squares: f64 = heights.map(|height| height * height).sum();
        line.off = (squares / count).sqrt();
        along.sort_by(f64::total_cmp);
        // The longest part without a gap.
        let (mut begin, mut longest) = (along.first().copied()?, (0.0, 0.0));
        for pair in along.windows(2) {
            if pair[1] - pair[0] > GAP {
                begin = pair[1];
            }
            if pair[1] - begin > longest.1 - longest.0 {
                longest = (begin, pair[1]);
            }
        }
        line.length = longest.1 - longest.0;
        let along = Vector::new(line.normal.y, -line.normal.x);
        line.middle += along * (0.5 * (longest.0 + longest.1));
        Some(line)
    }

    fn along(&self, point: Point) -> f64 {
        Vector::new(self.normal.y, -self.normal.x).dot(&(point - self.middle))
    }

    #[inline]
    fn cosine(&self, sighting: &Sighting) -> f64 {
        -self.normal.dot(&sighting.sight)
    }

    /// Whether an echo can come from this line.
    #[inline]
    fn explains(&self, sighting: &Sighting) -> bool {
        let cosine = self.cosine(sighting);
        if cosine < STEEP {
            return false;
        }
        let distance = sighting.distance_at(cosine);
        let height = self.normal.dot(&(sighting.edge - self.middle)) - cosine * distance;
        let point = sighting.edge + sighting.sight * distance;
        height.abs() < OFF.0 + OFF.1 * (distance + SOURCE) && self.is_beside(point)
    }

    fn is_beside(&self, point: Point) -> bool {
        self.length == 0.0 || self.along(point).abs() < 0.5 * self.length + GAP
    }
}

fn turned(vector: Vector, angle: f64) -> Vector {
    let (sin, cos) = math::sin_cos(angle);
    Vector::new(cos * vector.x - sin * vector.y, sin * vector.x + cos * vector.y)
}

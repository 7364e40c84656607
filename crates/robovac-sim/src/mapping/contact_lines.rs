//! Straight walls from contacts alone, for robots with nothing but a bumper.
//!
//! A switch shows the side of a contact, not its direction. But whatever the direction, a round body that touches a straight
//! wall has its middle a radius away from it. So the middles at several contacts lie on a line beside the wall, which gives
//! direction and place of the wall at once: a multiscan as sparse as it can be (Beevers & Huang 2006, see
//! [`multiscan`](super::multiscan)).

use super::observation::ContactPoint;
use robovac_core::{
    geometry::{Point, Pose, Vector, difference},
    math,
};

/// Contacts that make a wall, the shortest one, and the widest gap between two of them, m.
const LEAST: usize = 3;
const SHORTEST: f64 = 0.25;
const GAP: f64 = 0.45;
/// How far contacts may be off the line, m: what odometry drifts on the way.
const OFF: f64 = 0.01;
/// Most walls of a stretch.
const MOST: usize = 4;
/// Rounds of the fit, as the points that touch depend on the wall's direction.
const ROUNDS: usize = 2;

/// A contact, and the pose of the robot at the time.
pub(super) type Contact = (Pose, ContactPoint);

/// A straight wall that several contacts touch.
#[derive(Debug, Clone)]
pub(super) struct ContactLine {
    /// Unit vector from the wall towards the robot.
    pub normal: Vector,
    /// Touched points on the wall, in order along it.
    pub points: Vec<Point>,
    /// Standard deviation of their distances from the line, m.
    pub off: f64,
    /// From the first to the last point, m.
    pub length: f64,
}

/// The walls of the contacts of a stretch of a body of `radius` metres, and the contacts with none of them.
pub(super) fn contact_lines(contacts: &[Contact], radius: f64) -> (Vec<ContactLine>, Vec<Contact>) {
    let (mut lines, mut rest) = (Vec::new(), contacts.to_vec());
    while lines.len() < MOST {
        let tried = (0..rest.len()).flat_map(|i| (i + 1..rest.len()).map(move |j| (i, j)));
        let found = tried.flat_map(|(i, j)| through(&rest[i], &rest[j])).filter_map(|normal| {
            let on = on_line(&rest, normal, radius);
            (on.len() >= LEAST).then_some((normal, on))
        });
        let Some((normal, on)) = found.max_by_key(|(_, on)| on.len()) else { break };
        let touching: Vec<Contact> = on.iter().map(|&i| rest[i]).collect();
        let mut index = 0;
        rest.retain(|_| {
            index += 1;
            !on.contains(&(index - 1))
        });
        lines.extend(ContactLine::fit(&touching, normal, radius));
    }
    (lines, rest)
}

/// Both normals of the line through two poses.
fn through(a: &Contact, b: &Contact) -> impl Iterator<Item = Vector> {
    let along = (b.0.position() - a.0.position()).try_normalize(0.1);
    along.into_iter().flat_map(|along| [Vector::new(-along.y, along.x), Vector::new(along.y, -along.x)])
}

/// Indices of the most contacts that one line with that normal explains, none of them far from the next.
fn on_line(contacts: &[Contact], normal: Vector, radius: f64) -> Vec<usize> {
    let along = Vector::new(normal.y, -normal.x);
    let touched: Vec<(usize, Point)> =
        contacts.iter().enumerate().filter_map(|(i, contact)| Some((i, touched(contact, normal, radius)?))).collect();
    let mut best = Vec::new();
    for (_, through) in &touched {
        let mut on: Vec<(usize, f64)> = touched
            .iter()
            .filter(|(_, point)| normal.dot(&(point - through)).abs() < OFF)
            .map(|&(i, point)| (i, along.dot(&point.coords)))
            .collect();
        on.sort_by(|a, b| a.1.total_cmp(&b.1));
        for run in on.chunk_by(|a, b| b.1 - a.1 < GAP) {
            let length = run.last().map_or(0.0, |last| last.1 - run[0].1);
            if run.len() > best.len() && length >= SHORTEST {
                best = run.iter().map(|&(i, _)| i).collect();
            }
        }
    }
    best
}

/// The point of a wall with that normal that a contact touches; `None` if its switches exclude the direction.
fn touched((from, contact): &Contact, normal: Vector, radius: f64) -> Option<Point> {
    let direction = difference(from.heading, math::atan2(-normal.y, -normal.x));
    contact.allows(direction).then(|| from.position() - normal * radius)
}

impl ContactLine {
    /// The least-squares line of the contacts.
    fn fit(contacts: &[Contact], normal: Vector, radius: f64) -> Option<Self> {
        let mut line = Self { normal, points: Vec::new(), off: 0.0, length: 0.0 };
        for _ in 0..ROUNDS {
            let points: Vec<Point> =
                contacts.iter().filter_map(|contact| touched(contact, line.normal, radius)).collect();
            let count = points.len() as f64;
            if points.len() < LEAST {
                return None;
            }
            let middle = Point::from(points.iter().fold(Vector::zeros(), |sum, point| sum + point.coords) / count);
            let [xx, xy, yy] = points.iter().fold([0.0; 3], |[xx, xy, yy], point| {
                let off = point - middle;
                [xx + off.x * off.x, xy + off.x * off.y, yy + off.y * off.y]
            });
            let (sin, cos) = math::sin_cos(0.5 * math::atan2(2.0 * xy, xx - yy));
            let across = Vector::new(-sin, cos);
            line.normal = if across.dot(&line.normal) < 0.0 { -across } else { across };
            let squares: f64 = points.iter().map(|point| line.normal.dot(&(point - middle))).map(|off| off * off).sum();
            line.off = (squares / count).sqrt();
            line.points = points;
        }
        let along = Vector::new(line.normal.y, -line.normal.x);
        line.points.sort_by(|a, b| along.dot(&a.coords).total_cmp(&along.dot(&b.coords)));
        let [first, last] = [line.points.first(), line.points.last()].map(Option::<&_>::copied);
        line.length = along.dot(&(last? - first?));
        Some(line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mapping::observation::SensorModel;
    use robovac_core::robot::{SensorReadings, model};

    const RADIUS: f64 = 0.145;

    /// Contacts of DVR-1, which follows a wall on its right that lies in that direction, and meets a leg on the way.
    fn contacts(direction: f64) -> Vec<Contact> {
        let right = SensorReadings { bump_right: true, ..SensorReadings::default() };
        let contact = SensorModel::new(model("dvr1").unwrap()).contact(&right, false).unwrap();
        let normal = Vector::new(-math::cos(direction), -math::sin(direction));
        let along = Vector::new(normal.y, -normal.x);
        let mut contacts: Vec<Contact> = (0..6)
            .map(|i| {
                let at = Point::new(1.0, 2.0) + along * (0.2 * f64::from(i)) + normal * RADIUS;
                (Pose::new(at.x, at.y, direction + 0.9 - 0.05 * f64::from(i % 3)), contact)
            })
            .collect();
        contacts.insert(3, (Pose::new(1.3, 2.6, direction + 0.9), contact));
        contacts
    }

    #[test]
    fn a_wall_is_found_whatever_the_directions_of_the_contacts() {
        for direction in [-1.2, 0.4, 2.9] {
            let (lines, rest) = contact_lines(&contacts(direction), RADIUS);
            assert_eq!((lines.len(), rest.len()), (1, 1), "{direction}");
            let found = math::atan2(-lines[0].normal.y, -lines[0].normal.x);
            assert!(difference(found, direction).abs() < 1e-6, "{found} for {direction}");
            assert!(lines[0].off < 1e-6 && (lines[0].length - 1.0).abs() < 1e-6, "{:?}", lines[0]);
            let on = |point: &Point| lines[0].normal.dot(&(point - Point::new(1.0, 2.0))).abs() < 1e-6;
            assert!(lines[0].points.len() == 6 && lines[0].points.iter().all(on), "{:?}", lines[0]);
        }
    }

    #[test]
    fn contacts_all_over_are_no_wall() {
        let contact = contacts(0.4)[0].1;
        // Around a table's leg.
        let around: Vec<Contact> = (0..7)
            .map(|i| {
                let angle = 0.9 * f64::from(i);
                (Pose::new(0.3 * math::cos(angle), 0.3 * math::sin(angle), angle + 2.5), contact)
            })
            .collect();
        assert_eq!(contact_lines(&around, RADIUS).0.len(), 0);
    }
}

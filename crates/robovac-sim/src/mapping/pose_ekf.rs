//! Estimate of the pose, wheel parameters, wall directions and boundary: an extended Kalman filter with few states and
//! a map of boundary patches.

use super::{
    PoseCovariance,
    boundary::BoundaryPatches,
    multiscan::{BoundaryPoint, Features, WallLine},
    normal_equations::{Group, NormalEquations},
    reckoning::{Reckoning, WheelErrors},
    scan::{ScanFit, ScanPoint, SurfaceMap},
};
use nalgebra::{Matrix3, Matrix6, Vector2, Vector3, Vector6};
use robovac_core::{
    geometry::{Point, Pose, Vector, difference, normalize},
    math::{self, FRAC_PI_2},
};

/// Errors of the wheels, as standard deviations: between the simulator's levels *typical* and *harsh*.
const UNEQUAL: f64 = 0.003;
const BASE: f64 = 0.012;
/// Errors of points of the map: individual, and common to a wall, m (ours).
const MAP: (f64, f64) = (0.004, 0.008);
/// Deviation from parallel or right angles of walls of a room, rad (ours).
const SQUARE: f64 = 0.006;
/// Uncertainty of the walls' direction below which scans no longer change it in a straight building, rad: they share its errors, and
/// it would follow the heading.
const SETTLED: f64 = 0.002;
/// Share of new information in a point, for boundary just found and boundary found long ago, and the distance that
/// counts as long, m (ours, tuned on twelve seeds in the furnished flat and in the attic). A patch added from the
/// present pose can't correct it; and others can only once, not with every observation.
const NEWS: (f64, f64, f64) = (0.02, 0.3, 25.0);
/// Initial weight of the map frame's axes, as a length of wall, m, of one metre, and how well walls then follow them,
/// rad (ours). Plans are drawn along the walls, and a robot that leaves its dock or is put down usually faces straight
/// away from a wall; as this isn't accurate to a degree, the walls override it.
const FRAME: (f64, f64) = (0.8, 0.006);
/// Residuals of more than this many standard deviations count little.
const OUTLIER: f64 = 1.5;
/// Added to variances, so that they aren't singular.
const TINY: f64 = 1e-12;
/// Rounds of the search for the likeliest pose.
const ROUNDS: usize = 4;
/// Indices into the state: pose, wheels, and the direction of the room's walls modulo a right angle.
const HEADING: usize = 2;
const UNEQUAL_AT: usize = 3;
const BASE_AT: usize = 4;
const AXIS: usize = 5;

#[derive(Debug, Clone)]
pub(super) struct PoseEkf {
    state: Vector6<f64>,
    covariance: Matrix6<f64>,
    /// Covariance of the error in the room. That above is the uncertainty of the place on the map, which decides how much an
    /// observation counts; but the map itself is as wrong as the pose was when it was mapped.
    error: Matrix6<f64>,
    /// The error of the pose after some distances driven, m.
    errors: Vec<(f64, Matrix3<f64>)>,
    /// Length of walls along the room's axes, and of all, m; `None` while no axes are known.
    squared: Option<[f64; 2]>,
    /// Distance driven since the start, m.
    driven: f64,
    boundary: BoundaryPatches,
}

impl PoseEkf {
    pub fn new(start: Pose) -> Self {
        let state = Vector6::new(start.x, start.y, start.heading, 0.0, 0.0, 0.0);
        let deviations = Vector6::new(1e-3, 1e-3, 1e-3, UNEQUAL, BASE, FRAME.1);
        let covariance = Matrix6::from_diagonal(&deviations.component_mul(&deviations));
        Self {
            state,
            covariance,
            error: covariance,
            errors: Vec::new(),
            squared: Some([FRAME.0, 1.0]),
            driven: 0.0,
            boundary: BoundaryPatches::new(),
        }
    }

    /// The same without the boundary.
    pub fn bare(&self) -> Self {
        Self { boundary: BoundaryPatches::new(), errors: Vec::new(), ..*self }
    }

    /// Pose at the end of the last stretch.
    pub fn pose(&self) -> Pose {
        Pose::new(self.state[0], self.state[1], self.state[HEADING])
    }

    /// Pose after a further stretch.
    pub fn after(&self, way: &Reckoning) -> Pose {
        let begin = self.pose();
        let at = begin.to_world(way.at.position());
        Pose::new(at.x, at.y, self.state[HEADING] + way.turn)
    }

    /// Takes over another filter's estimate of the wheels, with its uncertainty increased by a factor.
    pub fn know_wheels(&mut self, other: &Self, unsure: f64) {
        for i in [UNEQUAL_AT, BASE_AT] {
            self.state[i] = other.state[i];
            let variance = unsure * unsure * other.covariance[(i, i)];
            self.covariance[(i, i)] = variance.min(self.covariance[(i, i)]);
            self.error[(i, i)] = self.covariance[(i, i)];
        }
    }

    pub fn wheels(&self) -> WheelErrors {
        WheelErrors { unequal: self.state[UNEQUAL_AT], base: self.state[BASE_AT] }
    }

    /// Uncertainty of the pose in the room: covariance of x, y and heading.
    pub fn pose_covariance(&self) -> Matrix3<f64> {
        self.error.fixed_view::<3, 3>(0, 0).into()
    }

    /// Sets another pose, with its uncertainty.
    pub fn relocate(&mut self, pose: Pose, spread: &PoseCovariance) {
        (self.state[0], self.state[1], self.state[HEADING]) = (pose.x, pose.y, pose.heading);
        self.loosen(spread);
        let [xx, xy, yy] = spread.position;
        for covariance in [&mut self.covariance, &mut self.error] {
            for i in 0..3 {
                covariance.row_mut(i).fill(0.0);
                covariance.column_mut(i).fill(0.0);
            }
            (covariance[(0, 0)], covariance[(1, 1)]) = (xx.max(1e-8), yy.max(1e-8));
            (covariance[(0, 1)], covariance[(1, 0)]) = (xy, xy);
            covariance[(HEADING, HEADING)] = (spread.heading * spread.heading).max(1e-8);
        }
    }

    /// Increases the uncertainty of the pose.
    pub fn loosen(&mut self, by: &PoseCovariance) {
        let [xx, xy, yy] = by.position;
        for covariance in [&mut self.covariance, &mut self.error] {
            covariance[(0, 0)] += xx;
            covariance[(0, 1)] += xy;
            covariance[(1, 0)] += xy;
            covariance[(1, 1)] += yy;
            covariance[(HEADING, HEADING)] += by.heading * by.heading;
        }
    }

    /// Advances by a stretch.
    pub fn advance(&mut self, way: &Reckoning) {
        self.driven += way.way;
        let (sin, cos) = math::sin_cos(self.state[HEADING]);
        let turn = Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0);
        let by_wheels = turn * way.by_wheels;
        let other = Vector2::new(self.state[UNEQUAL_AT] - way.wheels.unequal, self.state[BASE_AT] - way.wheels.base);
        let shift = turn * Vector3::new(way.at.x, way.at.y, way.turn) + by_wheels * other;
        let mut change = Matrix6::identity();
        change[(0, HEADING)] = -shift.y;
        change[(1, HEADING)] = shift.x;
        change.fixed_view_mut::<3, 2>(0, UNEQUAL_AT).copy_from(&by_wheels);
        for i in 0..3 {
            self.state[i] += shift[i];
        }
        let noise = turn * way.noise * turn.transpose();
        for covariance in [&mut self.covariance, &mut self.error] {
            *covariance = change * *covariance * change.transpose();
            let mut block = covariance.fixed_view_mut::<3, 3>(0, 0);
            block += noise;
        }
    }

    /// Corrects the state by the observations of the stretch that ends here: the likeliest state is searched for by
    /// Gauss and Newton's method (an iterated extended Kalman filter, Bell & Cathey 1993), as points match other
    /// patches from a better pose.
    pub fn correct(&mut self, features: &Features) {
        self.solve(|ekf, equations| {
            ekf.match_points(&features.points, equations);
            features.walls.iter().for_each(|wall| ekf.match_wall(wall, equations));
        });
    }

    /// How much a scan that fits like this contradicts the predicted pose: the squared innovation in standard deviations, which is 3
    /// on average.
    pub fn surprise(&self, fit: &ScanFit) -> f64 {
        let covariance = self.covariance.fixed_view::<3, 3>(0, 0);
        let information = &fit.information;
        // The identity stands for directions of which the scan tells nothing.
        let spread = information * covariance * information + information + Matrix3::identity();
        spread.try_inverse().map_or(0.0, |inverse| (fit.gradient.transpose() * inverse * fit.gradient)[0])
    }

    /// Corrects the state by a laser scan, matched to surfaces, and by the directions of its walls; returns how it fits then.
    ///
    /// Along a corridor the position is left to the wheels (Zhang, Kaess & Singh, On degeneracy of optimization-based state
    /// estimation problems, ICRA 2016): it is so uncertain there that each correction of the heading would shift it, and those
    /// to one side by more than those to the other.
    pub fn match_scan(
        &mut self,
        scan: &[ScanPoint],
        (walls, is_straight): (&[WallLine], bool),
        surfaces: &SurfaceMap,
    ) -> ScanFit {
        let (state, covariance) = (self.state, self.covariance);
        self.solve(|ekf, equations| {
            let fit = surfaces.compare(ekf.pose(), scan);
            equations.add_pose(&fit.information, &fit.gradient);
            for wall in walls {
                ekf.match_wall(wall, equations);
            }
        });
        let axis = covariance[(AXIS, AXIS)];
        if is_straight && axis < SETTLED * SETTLED {
            (self.state[AXIS], self.covariance[(AXIS, AXIS)]) = (state[AXIS], axis);
        }
        let fit = surfaces.compare(self.pose(), scan);
        let mut axes = fit.untold().peekable();
        if axes.peek().is_none() {
            self.error = self.covariance;
            return fit;
        }
        for axis in axes {
            let along = Vector6::new(axis.x, axis.y, 0.0, 0.0, 0.0, 0.0);
            self.state += along * along.dot(&(state - self.state));
            self.covariance += along * along.transpose() * along.dot(&((covariance - self.covariance) * along));
        }
        self.error = self.covariance;
        surfaces.compare(self.pose(), scan)
    }

    /// Moves the pose to where the map has been adjusted to; its uncertainty remains.
    pub fn shift(&mut self, pose: Pose) {
        (self.state[0], self.state[1], self.state[HEADING]) = (pose.x, pose.y, pose.heading);
    }

    /// Corrects the state by a known pose, with standard deviations in m and rad.
    pub fn meet(&mut self, pose: Pose, [position, heading]: [f64; 2]) {
        let deviations = [position, position, heading];
        self.solve(|ekf, equations| {
            let turn = difference(pose.heading, ekf.state[HEADING]);
            let off = [ekf.state[0] - pose.x, ekf.state[1] - pose.y, turn];
            for i in 0..3 {
                let mut row = Vector6::zeros();
                row[i] = 1.0;
                equations.add(&row, off[i], 1.0 / (deviations[i] * deviations[i]));
            }
        });
    }

    fn solve(&mut self, observe: impl Fn(&Self, &mut NormalEquations)) {
        let before = self.state;
        let mut shrinks = None;
        for _ in 0..ROUNDS {
            let mut equations = NormalEquations::default();
            observe(self, &mut equations);
            if equations.is_empty() {
                break;
            }
            // In this form the covariance can be singular: at the start the pose is known.
            let system = Matrix6::identity() + self.covariance * equations.information;
            let Some(inverse) = system.try_inverse() else { break };
            let off = self.state - before;
            let state = before + inverse * (self.covariance * (equations.information * off - equations.gradient));
            if !state.iter().all(|value| value.is_finite()) {
                self.state = before;
                return;
            }
            let change = (state - self.state).fixed_rows::<3>(0).norm();
            self.state = state;
            shrinks = Some((inverse, equations));
            if change < 1e-4 {
                break;
            }
        }
        if let Some((inverse, equations)) = shrinks {
            let covariance = inverse * self.covariance;
            self.covariance = 0.5 * (covariance + covariance.transpose());
            self.share_errors(&inverse, &equations);
        }
    }

    /// The error after a correction by the map, of which `keeps` is what remains of the one before.
    ///
    /// Both the pose's error and the map's are sums of what the wheels did wrong until then. So the smaller one is a part of the
    /// larger one, which no correction takes away: boundary that was just mapped corrects nothing, and older one at most to the
    /// error that the pose had when it was mapped.
    fn share_errors(&mut self, keeps: &Matrix6<f64>, equations: &NormalEquations) {
        let own = self.pose_covariance() + Matrix3::identity() * TINY;
        let (drift, weight) = equations.drift;
        let mut error = keeps * self.error * keeps.transpose();
        if weight > 0.0
            && let Some(root) = own.cholesky().map(|own| own.l())
            && let Some(inverse) = root.try_inverse()
        {
            let map = drift / weight;
            let compared = inverse * map * inverse.transpose();
            if !compared.iter().all(|value| value.is_finite()) {
                return;
            }
            let compared = compared.symmetric_eigen();
            let axes = root * compared.eigenvectors;
            let both =
                axes * Matrix3::from_diagonal(&compared.eigenvalues.map(|share| share.min(1.0))) * axes.transpose();
            // How the whole state's error goes with that of the pose.
            let goes = self.error.fixed_view::<6, 3>(0, 0) * (inverse.transpose() * inverse);
            let left = keeps * goes;
            let takes = self.covariance.fixed_view::<6, 3>(0, 0) * equations.mapped;
            error += (left + takes) * both * (left + takes).transpose() - left * both * left.transpose();
            error += takes * (map - both) * takes.transpose();
        }
        error += self.covariance * equations.noise * self.covariance;
        self.error = 0.5 * (error + error.transpose());
    }

    /// Covariance of the pose's error when it had driven that far, m.
    fn error_at(&self, driven: f64) -> Matrix3<f64> {
        let index = self.errors.partition_point(|(at, _)| *at < driven - 1e-3);
        self.errors.get(index).map_or_else(|| self.pose_covariance(), |(_, error)| *error)
    }

    /// Learns the room's axes from walls, after the pose is corrected.
    pub fn learn_axes(&mut self, walls: &[WallLine]) {
        for wall in walls {
            let direction = self.state[HEADING] + wall.direction;
            let Some([along, all]) = self.squared else {
                // The first wall: its direction is as uncertain as the heading, with the same error.
                self.state[AXIS] = direction;
                let own = wall.deviation * wall.deviation + SQUARE * SQUARE;
                for covariance in [&mut self.covariance, &mut self.error] {
                    for i in 0..5 {
                        let shared = covariance[(HEADING, i)];
                        (covariance[(AXIS, i)], covariance[(i, AXIS)]) = (shared, shared);
                    }
                    covariance[(AXIS, AXIS)] = covariance[(HEADING, HEADING)] + own;
                }
                self.squared = Some([wall.length, wall.length]);
                continue;
            };
            let off = quarter(direction - self.state[AXIS]).abs();
            let fits = if off < 0.06 { wall.length } else { 0.0 };
            let [along, all] = [along + fits, all + wall.length];
            // A room whose walls mostly disagree with the first one.
            self.squared = (all < 2.5 || along > 0.35 * all).then_some([along, all]);
        }
    }

    /// Directions of the room's walls, rad; none while most walls are at other angles.
    pub fn axes(&self) -> impl Iterator<Item = f64> {
        let quarters = if self.squareness() < 0.5 { 0 } else { 4 };
        (0..quarters).map(|i| self.state[AXIS] + FRAC_PI_2 * f64::from(i))
    }

    /// Probability that a wall is along the room's axes.
    fn squareness(&self) -> f64 {
        self.squared.map_or(0.0, |[along, all]| (along + 0.7) / (all + 1.0))
    }

    fn match_wall(&self, wall: &WallLine, equations: &mut NormalEquations) {
        let prior = self.squareness();
        if prior < 0.5 {
            return;
        }
        let off = quarter(self.state[HEADING] + wall.direction - self.state[AXIS]);
        let variance = wall.deviation * wall.deviation + SQUARE * SQUARE;
        let p = &self.covariance;
        let total = variance + (p[(HEADING, HEADING)] + p[(AXIS, AXIS)] - 2.0 * p[(HEADING, AXIS)]).max(0.0);
        // Along the axes, or at any angle.
        let aligned = prior * math::exp(-0.5 * off * off / total) / (math::TAU * total).sqrt();
        let other = (1.0 - prior) / FRAC_PI_2;
        let share = aligned / (aligned + other);
        if share > 0.05 {
            let mut row = Vector6::zeros();
            (row[HEADING], row[AXIS]) = (1.0, -1.0);
            equations.add(&row, off, share / variance);
        }
    }

    fn match_points(&self, points: &[BoundaryPoint], equations: &mut NormalEquations) {
        let (sin, cos) = math::sin_cos(self.state[HEADING]);
        let spread = (self.covariance[(0, 0)] + self.covariance[(1, 1)]).sqrt();
        let reach = if spread > 0.04 { 4 } else { 3 };
        let mut group = Group::default();
        let mut last: Option<&BoundaryPoint> = None;
        for point in points {
            if last.is_some_and(|last| last.group != point.group) {
                equations.add_group(&group);
                group = Group::default();
            } else if last.is_some_and(|last| (last.at - point.at).norm_squared() < 4e-4) {
                continue;
            }
            last = Some(point);
            let arm = Vector::new(cos * point.at.x - sin * point.at.y, sin * point.at.x + cos * point.at.y);
            let facing =
                Vector::new(cos * point.normal.x - sin * point.normal.y, sin * point.normal.x + cos * point.normal.y);
            let at = Point::new(self.state[0] + arm.x, self.state[1] + arm.y);
            let least = if point.is_oriented { 0.85 } else { 0.6 };
            let Some(surface) = self.boundary.nearest(at, facing, least, reach) else { continue };
            let normal = surface.normal;
            // The middle of a robot that touches a surface is a radius away from it, wherever it touches.
            let off = match point.middle {
                Some(middle) => {
                    let middle = self.pose().to_world(middle);
                    normal.dot(&(middle - surface.point)) - (middle - at).norm()
                }
                None => normal.dot(&(at - surface.point)),
            };
            let row = Vector3::new(normal.x, normal.y, -normal.perp(&arm));
            let own = point.own * point.own + MAP.0 * MAP.0;
            let shared = point.shared * point.shared + MAP.1 * MAP.1;
            let predicted = (row.transpose() * self.covariance.fixed_view::<3, 3>(0, 0) * row)[0].max(0.0);
            let ratio = off * off / (OUTLIER * OUTLIER * (own + shared + predicted));
            let trust = 1.0 / ((1.0 + ratio) * (1.0 + ratio));
            let age = ((self.driven - surface.found) / NEWS.2).min(1.0);
            let news = NEWS.0 + (NEWS.1 - NEWS.0) * age;
            group.add(&row, off, trust / own, shared, news);
            let (drift, weight) = &mut equations.drift;
            *drift += self.error_at(surface.found) * (news * trust / own);
            *weight += news * trust / own;
        }
        equations.add_group(&group);
    }

    /// Adds the points to the boundary patches.
    pub fn draw(&mut self, points: &[BoundaryPoint]) {
        if self.errors.last().is_none_or(|(driven, _)| *driven < self.driven) {
            self.errors.push((self.driven, self.pose_covariance()));
        }
        let pose = self.pose();
        let ahead = pose.direction();
        for point in points.iter().filter(|point| point.is_oriented) {
            let normal = Vector::new(
                ahead.x * point.normal.x - ahead.y * point.normal.y,
                ahead.y * point.normal.x + ahead.x * point.normal.y,
            );
            self.boundary.add(pose.to_world(point.at), normal, self.driven);
        }
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        self.boundary.bytes() + self.errors.len() * size_of::<(f64, Matrix3<f64>)>()
    }
}

/// An angle modulo a right angle, within an eighth of a turn.
pub(super) fn quarter(angle: f64) -> f64 {
    0.25 * normalize(4.0 * normalize(angle))
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::{OdometryModel, model};

    #[test]
    fn a_wall_tells_the_place_no_better_than_it_was_known_when_the_wall_was_mapped() {
        let known = 0.05;
        let mut ekf = PoseEkf::new(Pose::new(0.0, 0.0, 0.0));
        ekf.loosen(&PoseCovariance { position: [known * known, 0.0, known * known], heading: 0.0 });
        let point = |i| BoundaryPoint {
            at: Point::new(0.05 * f64::from(i), 0.3),
            normal: Vector::new(0.0, -1.0),
            is_oriented: true,
            own: 0.004,
            shared: 0.004,
            group: 0,
            middle: None,
        };
        let points: Vec<BoundaryPoint> = (-10..=10).map(point).collect();
        ekf.draw(&points);
        for _ in 0..60 {
            let mut way = Reckoning::new(model("roomba600").unwrap(), OdometryModel::Arc, ekf.wheels());
            for step in 0..24 {
                let ahead = if step < 12 { 0.02 } else { -0.02 };
                way.roll([ahead, ahead, 0.0], None);
            }
            way.settle();
            ekf.advance(&way);
            ekf.correct(&Features { points: points.clone(), ..Features::default() });
        }
        let [on_map, in_room] = [&ekf.covariance, &ekf.error].map(|covariance| covariance[(1, 1)].sqrt());
        assert!(on_map < 0.01, "{on_map}");
        assert!((0.9 * known..1.3 * known).contains(&in_room), "{in_room}");
    }

    #[test]
    fn angles_modulo_a_right_angle() {
        for (angle, expected) in
            [(0.1, 0.1), (FRAC_PI_2 + 0.1, 0.1), (-FRAC_PI_2 - 0.2, -0.2), (0.7, 0.7), (0.9, 0.9 - FRAC_PI_2)]
        {
            assert!((quarter(angle) - expected).abs() < 1e-12, "{angle}: {}", quarter(angle));
        }
    }
}
